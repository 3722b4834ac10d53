/**
 * @class   vtkMeshCriticalPoints
 * @brief   minima, saddles and maxima of a function on a mesh, and how they vanish
 *
 * The input is a triangle mesh (quads and strips are cut up) and a point array f, chosen by
 * SetInputArrayToProcess(0, ...), by default the active scalars. f is linear on the triangles, so
 * that its critical points are vertices (Patane and Falcidieno, Computing Smooth Approximations of
 * Scalar Functions with Constraints, sec. 3).
 *
 * Algorithm:
 *
 * - In each triangle the vertex of the middle value counts one. An interior vertex that is never in
 *   the middle is an extremum, one that is twice is regular, one that is 2 + 2 m times is a saddle
 * of multiplicity m. Equal values are told apart by the ids of the points. A vertex on the boundary
 *   is what it would be on the mesh glued to its mirror image there.
 *
 * - As the level rises, components of {f <= t} begin at minima and end in saddles, the younger of
 *   two in each; those of {f >= t} likewise as it falls. Extremum and saddle are a pair, their
 *   difference of values is its persistence.
 *
 * - An extremum's delta is the least difference of values to a neighbor; a saddle's is the largest
 *   at which its neighbors, those of at most this difference left out, still change signs four
 *   times. (As printed in the paper nearly every vertex would be a maximum and a minimum for large
 *   delta.)
 *
 * Port 0 is the input with point arrays: CriticalType (0 minimum, 1 saddle, 3 maximum, 5 regular,
 * -1 at points without a triangle) and Multiplicity (m of a saddle, 1 of an extremum, 0 of others).
 * f is its active scalars.
 *
 * Port 1, CriticalPoints, has the critical points as vertices, by their ids: CriticalType,
 * Multiplicity, ScalarValue, PointId (the point of port 0) and Persistence (of a saddle the largest
 * of its pairs; the range of f for what is in no pair: global extrema, saddles of handles).
 *
 * Port 2, PersistencePairs, has the same points and a line from extremum to saddle for each pair,
 * with the cell arrays Persistence and PairType (0 of a minimum, 1 of a maximum).
 *
 * Port 3, Simplification, is a table: how many critical points of each kind, saddles with their
 * multiplicity, are left at each Threshold of delta and of persistence.
 *
 * Field data of ports 0 and 1: CriticalCounts, the minima, saddles (with their multiplicity) and
 * maxima of port 1; EulerCharacteristic of the mesh, which with both thresholds 0 is minima -
 * saddles + maxima if those on the boundary count half, and on a closed mesh whenever Delta is 0.
 *
 * If there is a Model (the second output of vtkRBFExtend), the function is that model u, a function
 * of space, and no array is needed (Patane, Mesh-based and Meshless Design and Approximation of
 * Scalar Functions, sec. 5). Its values at the points, added to port 0 under the model's name, are
 * classified as above; each critical vertex that is left and not on the boundary is then refined
 * off the vertices, by a trust-region Newton method on the smooth surface that the mesh samples.
 * Port 1 has the refined places with ScalarValue of u there, PointId of the nearest point and three
 * more arrays: Residual, the norm of the tangential gradient of u (-1 where it is not known),
 * Iterations and Refined; what is not refined remains at its point. Persistence is that of the
 * vertex. Minima and saddles, or saddles and maxima, that only the triangles made vanish in pairs.
 * Field data of ports 0 and 1: CandidateCount, the critical vertices that are left by both
 * thresholds; RefinedCount; MergedCount, candidates that led to the place of another one;
 * VanishedCount, candidates that led nowhere; GradientScale, the root mean square of the gradient
 * on the mesh, of which residuals are at most 1e-10; IndexSum, EulerCharacteristic if both
 * thresholds are 0, points of the boundary counted half.
 *
 * Vertices and lines, triangles with the same corner twice, points without a finite position or
 * value with their triangles, and points in no triangle are left out; a warning counts them. The
 * blocks of a composite dataset are worked on one by one. Refused, with the id of a point: an edge
 * of more than two triangles, a point whose triangles do not form one fan.
 *
 * @sa vtkRBFExtend vtkMorseComplex vtkConstrainedSmoothing vtkFuzzyCriticalPoints
 */

#ifndef vtkMeshCriticalPoints_h
#define vtkMeshCriticalPoints_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class SURFACESCALARSFILTERS_EXPORT vtkMeshCriticalPoints : public vtkPolyDataAlgorithm
{
public:
  static vtkMeshCriticalPoints* New();
  vtkTypeMacro(vtkMeshCriticalPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The function, if it is a model. Null or RemoveModel() returns to the point array.
   */
  void SetModelConnection(vtkAlgorithmOutput* connection);
  void SetModelData(vtkDataObject* data);
  void RemoveModel();
  ///@}

  ///@{
  /**
   * Pairs of less persistence are left out of ports 0 to 2; a fraction of the range of f, 0 to 1.
   * Default: 0, all are kept.
   */
  vtkSetMacro(PersistenceThreshold, double);
  vtkGetMacro(PersistenceThreshold, double);
  ///@}

  ///@{
  /**
   * Critical points of at most this delta are left out of ports 0 to 2; a fraction of the range of
   * f, 0 to 1. Default: 0, all are kept.
   */
  vtkSetMacro(Delta, double);
  vtkGetMacro(Delta, double);
  ///@}

protected:
  vtkMeshCriticalPoints();
  ~vtkMeshCriticalPoints() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkMeshCriticalPoints(const vtkMeshCriticalPoints&) = delete;
  void operator=(const vtkMeshCriticalPoints&) = delete;

  double PersistenceThreshold = 0.0;
  double Delta = 0.0;
};

#endif
