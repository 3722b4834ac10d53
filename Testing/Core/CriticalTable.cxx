// Prints how right and how accurate critical points are, as tables in Markdown for Documentation.
// The exit code tells whether the defaults keep their promises.

#include "CriticalTable.h"
#include "Arguments.h"

#include <string>

using namespace SurfaceScalars::Truth;

// usage: surface-scalars-critical-truth [reduced] [truth] [surfaces] [stability] [calibration]
//   [starts] [meshes FOLDER] [drawn SEED] [curve FILE.csv]
// Without names of parts, all that need no data.
int main(int argc, char** argv)
{
  const Arguments arguments(argc, argv,
    { "truth", "surfaces", "stability", "calibration", "starts", "meshes", "drawn" },
    { "meshes", "drawn", "curve" });
  MarkdownReport report;
  if (arguments.wants("truth"))
  {
    reportTruth(report, arguments.isReduced());
  }
  if (arguments.wants("surfaces"))
  {
    reportSurfaces(report, arguments.isReduced());
  }
  if (arguments.wants("stability"))
  {
    reportStability(report);
  }
  if (arguments.wants("calibration"))
  {
    reportCalibration(report, arguments.isReduced(), arguments.valueOf("curve"));
  }
  if (arguments.wants("starts"))
  {
    reportStarts(report);
  }
  if (arguments.has("meshes"))
  {
    reportMeshes(report, arguments.valueOf("meshes"));
  }
  if (arguments.has("drawn"))
  {
    reportDrawn(report, arguments.valueOf("meshes"),
      static_cast<unsigned>(std::stoul(arguments.valueOf("drawn"))));
  }
  return report.exitCode();
}
