// Prints how right and how accurate critical points are, as tables in Markdown for Documentation.
// The exit code tells whether the defaults keep their promises.

#include "CriticalTable.h"

#include <algorithm>
#include <string>
#include <vector>

using namespace SurfaceScalars::Truth;

// usage: surface-scalars-critical-truth [reduced] [truth] [surfaces] [stability] [calibration]
// [starts]
//   [meshes FOLDER] [drawn SEED] [curve FILE.csv]
// Without names of parts, all that need no data.
int main(int argumentCount, char** arguments)
{
  const std::vector<std::string> words(arguments + 1, arguments + argumentCount);
  const auto has = [&](const std::string& word)
  { return std::find(words.begin(), words.end(), word) != words.end(); };
  const auto after = [&](const std::string& word)
  {
    const auto found = std::find(words.begin(), words.end(), word);
    return found == words.end() || found + 1 == words.end() ? std::string() : *(found + 1);
  };
  const std::vector<std::string> parts{ "truth", "surfaces", "stability", "calibration", "starts",
    "meshes", "drawn" };
  const bool all = std::none_of(parts.begin(), parts.end(), has);
  const bool reduced = has("reduced");
  MarkdownReport report;
  if (all || has("truth"))
  {
    reportTruth(report, reduced);
  }
  if (all || has("surfaces"))
  {
    reportSurfaces(report, reduced);
  }
  if (all || has("stability"))
  {
    reportStability(report);
  }
  if (all || has("calibration"))
  {
    reportCalibration(report, reduced, after("curve"));
  }
  if (all || has("starts"))
  {
    reportStarts(report);
  }
  if (has("meshes"))
  {
    reportMeshes(report, after("meshes"));
  }
  if (has("drawn"))
  {
    reportDrawn(report, after("meshes"), static_cast<unsigned>(std::stoul(after("drawn"))));
  }
  return report.exitCode();
}
