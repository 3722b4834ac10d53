#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace SurfaceScalars::Truth
{

/// Tables in Markdown on the standard output, and whether all promises in them are kept.
class MarkdownReport
{
public:
  void head(const std::string& title, const std::vector<std::string>& columns) const
  {
    std::printf("\n### %s\n\n", title.c_str());
    this->row(columns);
    this->row(std::vector<std::string>(columns.size(), "---"));
  }

  void row(const std::vector<std::string>& cells) const
  {
    for (std::string cell : cells)
    {
      for (std::size_t i = cell.find('|'); i != std::string::npos; i = cell.find('|', i + 2))
      {
        cell.insert(i, 1, '\\'); // it separates columns
      }
      std::printf("| %s ", cell.c_str());
    }
    std::printf("|\n");
    std::fflush(stdout);
  }

  /// A cell that says whether a promise is kept, which also decides the exit code.
  std::string kept(bool promise)
  {
    this->allKept_ = this->allKept_ && promise;
    return promise ? "yes" : "**no**";
  }

  int exitCode() const { return this->allKept_ ? EXIT_SUCCESS : EXIT_FAILURE; }

private:
  bool allKept_ = true;
};

/// @param format of printf, for one double
inline std::string number(const char* format, double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

inline std::string ofAll(int count, int all)
{
  return std::to_string(count) + " of " + std::to_string(all);
}

} // namespace SurfaceScalars::Truth
