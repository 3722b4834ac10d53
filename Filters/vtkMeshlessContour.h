/**
 * @class   vtkMeshlessContour
 * @brief   iso-curves of a model on a mesh, to any resolution
 *
 * Input (port 0) is a Model of vtkRBFExtend or vtkMeshlessApproximation: a function u of space,
 * known by its centers. Surface (port 1) is a triangle mesh (quads and strips are cut up), of which
 * no array is needed. The output is the curves on the mesh where u equals an iso-value alpha, as
 * ordered polylines, however coarse or fine the mesh is beside u.
 *
 * Algorithm (Patane, Mesh-based and Meshless Design and Approximation of Scalar Functions,
 * sec. 6.1):
 *
 * - Triangles that the level set meets are cut in four, those beside them edge to edge, until each
 *   segment is closer to the level set than Tolerance. Halving edges divides the error by four.
 *
 * - A point of a curve is the root of u - alpha on an edge, by Newton's method on u itself.
 *
 * - Where the Taylor polynomial of u at the center of a ball, which may hold many triangles,
 * excludes the level set, u is not evaluated. Components no edge crosses are found if they are
 * wider than the finest pieces, which MaximumRefinement limits.
 *
 * - At an iso-value within 1e-6 of u's range from a saddle's value, of u restricted to the mesh,
 * the 2 + 2m branches of a saddle of multiplicity m meet at one point. Those that return are closed
 *   curves that begin there, those between different saddles closed curves around larger values;
 *   those that end at the boundary are open.
 *
 * The output has one polyline per curve; a closed one ends with the id it starts with.
 *
 * - Cells: IsoValue; ComponentId, from 0 within an iso-value; Closed, 0 or 1; Length.
 *
 * - Points: an array with the name of the model's function that holds the iso-value; Normals of the
 *   mesh; Residual, the first-order distance to the level set, a length.
 *
 * - Field data: IsoValues, ascending and distinct; ComponentCounts, the number of curves of each;
 *   Tolerance, that was used; LargestDeviation of a segment from the level set, to first order;
 *   EvaluatedShare, of the vertices at which u was needed; Evaluations of u in all.
 *
 * Larger values of u lie to the left of a polyline, seen with Normals pointing to the viewer. The
 * normals of a curve agree with each other and with most of its triangles.
 *
 * The blocks of a composite Surface are contoured one by one. Points with a NaN or infinite
 * coordinate are left out with their triangles. The mesh need not be a manifold: curves end at
 * edges of more than two triangles, and at the boundary.
 *
 * @warning Models of local schemes jump a little where their neighborhoods change: a segment closes
 * the gap, and LargestDeviation may exceed the tolerance.
 *
 * @sa vtkRBFExtend vtkRBFEvaluate vtkPointSetContour
 */

#ifndef vtkMeshlessContour_h
#define vtkMeshlessContour_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // for the iso-values

class SURFACESCALARSFILTERS_EXPORT vtkMeshlessContour : public vtkPolyDataAlgorithm
{
public:
  static vtkMeshlessContour* New();
  vtkTypeMacro(vtkMeshlessContour, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The mesh: polydata, or a composite dataset of it.
   */
  void SetSurfaceConnection(vtkAlgorithmOutput* connection);
  void SetSurfaceData(vtkDataObject* data);
  ///@}

  ///@{
  /**
   * The iso-values, in any order; duplicates count once. With none given there is one, in the
   * middle of the range of the samples the model was made of.
   */
  void SetNumberOfContourValues(int number);
  int GetNumberOfContourValues();
  void SetContourValues(int i, double value); ///< adds values up to i if there are fewer
  double GetContourValues(int i);
  ///@}

  ///@{
  /**
   * How far curves may be from the level set, a length. Default: 0, a thousandth of the median
   * edge.
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * How often a triangle may be cut in four, 0 to 20. Default: 8.
   */
  vtkSetMacro(MaximumRefinement, int);
  vtkGetMacro(MaximumRefinement, int);
  ///@}

protected:
  vtkMeshlessContour();
  ~vtkMeshlessContour() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkMeshlessContour(const vtkMeshlessContour&) = delete;
  void operator=(const vtkMeshlessContour&) = delete;

  std::vector<double> ContourValues;
  double Tolerance = 0.0;
  int MaximumRefinement = 8;
};

#endif
