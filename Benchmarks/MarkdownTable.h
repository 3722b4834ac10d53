#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace SurfaceScalars::Benchmark
{

inline void writeRow(const std::vector<std::string>& cells)
{
  for (const std::string& cell : cells)
  {
    std::printf("| %s ", cell.c_str());
  }
  std::printf("|\n");
  std::fflush(stdout);
}

inline void writeHead(const std::string& title, const std::vector<std::string>& columns)
{
  std::printf("\n### %s\n\n", title.c_str());
  writeRow(columns);
  writeRow(std::vector<std::string>(columns.size(), "---"));
}

/// @param format of printf, for one double
inline std::string number(const char* format, double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

} // namespace SurfaceScalars::Benchmark
