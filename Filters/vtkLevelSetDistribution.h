/**
 * @class   vtkLevelSetDistribution
 * @brief   how the level sets of a function are spread over a surface or volume
 *
 * The input is a surface (triangles, quads, strips; a flat image) or a volume (tetrahedra, voxels,
 * hexahedra, wedges, pyramids; an image) and a point array f, chosen by
 * SetInputArrayToProcess(0, ...), by default the active scalars (Patane, Mesh-based and Meshless
 * Design and Approximation of Scalar Functions, sec. 4).
 *
 * Algorithm:
 *
 * - The range of f is divided into 2^k equal parts for k = 1, 2, ... The coverage c_k is the share
 * of the area (of volumes: the volume) of the triangles or tetrahedra that at least one of the
 * 2^k - 1 values between the parts meets. Where no further halving changes it by CoverageTolerance
 * times its limit it is stationary: the global coverage, and the values are the optimal ones.
 *
 * - The distortion map is the distance between the level sets of consecutive values, each the
 * points in which edges cross its value. Intervals that contain the value of a critical point are
 * left out.
 *
 * Port 0 is the input with the cell array Covered: 1 where one of the optimal values meets a
 * triangle or tetrahedron of the cell, else 0. Field data:
 *
 * - GlobalCoverage, 0 to 1;
 * - OptimalIsoValues, ascending, as a contour filter takes them;
 * - DistortionIntervals, between the values of the distortion map, and LeftOutIntervals of these.
 *
 * Port 1, Coverage, is a table: IsoValueCount (2^k - 1) and Coverage (c_k). Port 2, Distortion, has
 * IsoValue, NextIsoValue and the Distortion between their level sets, length units.
 *
 * f is taken as it is: its coverage tends to 1 whatever it is, unless it has plateaus. How many
 * values it takes is what tells functions apart. Of a constant nothing is covered, and there are no
 * values; a warning says so.
 *
 * What is left out and refused is as of vtkMeshCriticalPoints for surfaces, and hidden cells are
 * left out. Duplicates of cells of another piece do not count in the coverage and are not covered.
 * Volumes need not be manifolds. The blocks of a composite dataset are worked on one by one.
 *
 * @sa vtkMeshlessApproximation vtkMeshCriticalPoints
 */

#ifndef vtkLevelSetDistribution_h
#define vtkLevelSetDistribution_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkDataSetAlgorithm.h"

class SURFACESCALARSFILTERS_EXPORT vtkLevelSetDistribution : public vtkDataSetAlgorithm
{
public:
  static vtkLevelSetDistribution* New();
  vtkTypeMacro(vtkLevelSetDistribution, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How far level sets are from each other. The numbers are fixed.
  enum DistanceMeasureType
  {
    HAUSDORFF = 0, ///< through space
    GEODESIC = 1   ///< along the surface; not in volumes
  };

  ///@{
  /**
   * What a halving has to add to the coverage to count, a share of the area without plateaus; above
   * 0, below 1. The one that adds most always counts. Default: 1e-4.
   */
  vtkSetMacro(CoverageTolerance, double);
  vtkGetMacro(CoverageTolerance, double);
  ///@}

  ///@{
  /**
   * The distance of the distortion map: a DistanceMeasureType. Default: HAUSDORFF.
   */
  vtkSetMacro(DistanceMeasure, int);
  vtkGetMacro(DistanceMeasure, int);
  ///@}

  ///@{
  /**
   * Critical points of less persistence do not make the distortion map leave an interval out; a
   * fraction of the range of f, 0 to 1. Default: 0, all do.
   */
  vtkSetMacro(PersistenceThreshold, double);
  vtkGetMacro(PersistenceThreshold, double);
  ///@}

  ///@{
  /**
   * Into at most how many parts the distortion map divides the range of f, never more than the
   * optimal values do: a power of 2 is taken; at least 4. Default: 0, as many as take some seconds.
   */
  vtkSetMacro(MaximumIntervals, int);
  vtkGetMacro(MaximumIntervals, int);
  ///@}

protected:
  vtkLevelSetDistribution();
  ~vtkLevelSetDistribution() override;

  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkLevelSetDistribution(const vtkLevelSetDistribution&) = delete;
  void operator=(const vtkLevelSetDistribution&) = delete;

  double CoverageTolerance = 1e-4;
  int DistanceMeasure = HAUSDORFF;
  double PersistenceThreshold = 0.0;
  int MaximumIntervals = 0;
};

#endif
