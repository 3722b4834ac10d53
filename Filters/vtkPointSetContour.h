/**
 * @class   vtkPointSetContour
 * @brief   iso-curves of a function known at the points of an unmeshed surface
 *
 * The input is a point set P sampled from a surface (cells are ignored) and a point array f, chosen
 * by SetInputArrayToProcess(0, ...), by default the active scalars. The output is the curves where
 * f equals an iso-value alpha, as ordered polylines. No mesh is made.
 *
 * Algorithm (Patane and Falcidieno, Defining, Contouring, and Visualizing Scalar Functions on
 * Point-Sampled Surfaces, sec. 4):
 *
 * - The k-nearest neighbor graph of P stands for the surface (sec. 2.1).
 *
 * - Every edge of the graph whose ends lie on different sides of alpha gives a sample. It is put on
 *   the common zero of F - alpha and g, (14), where F extends f and g = 0 is the surface, both
 *   fitted locally (sec. 4.1).
 *
 * - From the samples each curve is traced, point by point, until it closes or meets a boundary of
 *   the surface. (The paper links samples that are closer than two sampling steps, which joins and
 *   breaks curves at random where the sampling is random.)
 *
 * - At an iso-value within 1e-6 of f's range from a saddle's value, or closer than the samples
 * tell, the 2 + 2m branches of a saddle of multiplicity m meet at one point (sec. 5.2;
 * ParameterizedMLS and Linear, no CutFunction). Those that return are closed curves that begin
 * there, those between different saddles closed curves around larger values; those that end at the
 * boundary are open.
 *
 * A sampling step is 1 / sqrt(density), density = k / (pi sigma_k^2); exact duplicates count once.
 *
 * Port 0, Contours, has one polyline per curve; a closed one ends with the id it starts with.
 *
 * - Cells: IsoValue; ComponentId, from 0 within an iso-value; Closed, 0 or 1; Length.
 *
 * - Points: an array with f's name that holds the iso-value; Normals of the surface; Residual, the
 *   first-order distance to the common zero of F - alpha and g, a length.
 *
 * - Field data: IsoValues, ascending and distinct; ComponentCounts, the number of curves of each:
 *   the evolution of the level sets (sec. 4.3); NeighborCount, what the local fits used (0 if f is
 *   constant and nothing was fitted).
 *
 * Port 1, Samples, has the samples as vertices with the same point arrays and Converged, 0 or 1.
 * Points and computed arrays are double.
 *
 * Larger values of f lie to the left of a polyline, seen with Normals pointing to the viewer. The
 * normals of a curve agree with each other; as a whole they point away from the center of P or,
 * where that does not tell, along their largest component (terrain: upwards).
 *
 * The blocks of a composite dataset are merged: curves cross the seams of tiles. Ghost points are
 * left out. So are points with a NaN, infinite or absent coordinate or value; one warning counts
 * them. Each time step is contoured on its own.
 *
 * @warning Iso-values outside the range of f give no curve and no error.
 *
 * @warning At a hole wider than LinkDistance (0: wider than the gaps of random sampling) and at the
 * edge of the samples curves end, about one sampling step beyond the last sample.
 *
 * @sa vtkPointSetScalarFunction vtkContourFilter vtkCutter
 */

#ifndef vtkPointSetContour_h
#define vtkPointSetContour_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the cut function

#include <vector> // for the iso-values

class vtkImplicitFunction;

class SURFACESCALARSFILTERS_EXPORT vtkPointSetContour : public vtkPolyDataAlgorithm
{
public:
  static vtkPointSetContour* New();
  vtkTypeMacro(vtkPointSetContour, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How f is extended off its samples. The numbers are fixed: state files keep them.
  enum SchemeType
  {
    LINEAR = 0,            ///< linear along the edges of the neighbor graph
    EXPLICIT_MLS = 1,      ///< weighted average, (6)
    PARAMETERIZED_MLS = 2, ///< polynomial over the tangent plane, (4)(5)
    LOCAL_RBF = 3,         ///< radial functions through the neighbors' values, (8)-(10)
    HYBRID = 4             ///< EXPLICIT_MLS, and LOCAL_RBF where that misses the values (sec. 3.3)
  };

  /// What samples and curves are put on.
  enum SurfaceModelType
  {
    MLS = 0,        ///< the moving least-squares surface, (2)
    RBF = 1,        ///< the zeros of radial functions with offset constraints (sec. 2.1)
    UNPROJECTED = 2 ///< nothing: they stay on the edges of the neighbor graph
  };

  /// Radial functions phi(r), t = r / h. The numbers are fixed: state files keep them.
  enum KernelType
  {
    GAUSSIAN = 0,             ///< exp(-t^2)
    EXPONENTIAL = 1,          ///< exp(-t)
    LINEAR_KERNEL = 2,        ///< r
    CUBIC = 3,                ///< t^3
    THIN_PLATE = 4,           ///< t^2 log t
    MULTIQUADRIC = 5,         ///< sqrt(1 + t^2)
    INVERSE_MULTIQUADRIC = 6, ///< 1 / sqrt(1 + t^2)
    WENDLAND = 7,             ///< (1 - t)^4 (4 t + 1), 0 from t = 1 on
    WU = 8                    ///< (1 - t)^4 (4 + 16 t + 12 t^2 + 3 t^3), 0 from t = 1 on
  };

  enum FitType
  {
    INTERPOLATE = 0,  ///< curves through the points found
    LEAST_SQUARES = 1 ///< a smooth spline near them (sec. 4.2)
  };

  ///@{
  /**
   * The iso-values, in f's unit and any order; duplicates count once. With none given there is one,
   * in the middle of f's range (of the cut function's range if there is one: give 0 for the cut
   * itself).
   */
  void SetNumberOfContourValues(int number);
  int GetNumberOfContourValues();
  void SetContourValues(int i, double value); ///< adds values up to i if there are fewer
  double GetContourValues(int i);
  ///@}

  ///@{
  /**
   * How f is extended off its samples: a SchemeType. Default: PARAMETERIZED_MLS.
   */
  vtkSetMacro(Scheme, int);
  vtkGetMacro(Scheme, int);
  ///@}

  ///@{
  /**
   * What samples and curves are put on: a SurfaceModelType. Default: MLS.
   */
  vtkSetMacro(SurfaceModel, int);
  vtkGetMacro(SurfaceModel, int);
  ///@}

  ///@{
  /**
   * Degree of the polynomials of surface and f over the tangent plane, 1 to 4. Default: 2.
   */
  vtkSetMacro(PolynomialDegree, int);
  vtkGetMacro(PolynomialDegree, int);
  ///@}

  ///@{
  /**
   * Number k of neighbors in a local fit, the point itself not counted. Default: 0, chosen from
   * sampling and noise.
   */
  vtkSetMacro(NeighborCount, int);
  vtkGetMacro(NeighborCount, int);
  ///@}

  ///@{
  /**
   * If positive, a local fit takes all points closer than this length instead of NeighborCount.
   * Default: 0.
   */
  vtkSetMacro(SearchRadius, double);
  vtkGetMacro(SearchRadius, double);
  ///@}

  ///@{
  /**
   * The radial function of the schemes LOCAL_RBF and HYBRID and of the surface model RBF: a
   * KernelType. Default: CUBIC, which needs no width.
   */
  vtkSetMacro(Kernel, int);
  vtkGetMacro(Kernel, int);
  ///@}

  ///@{
  /**
   * Width h of the weights exp(-(r/h)^2) of (2) and (6) and of the radial function, a length.
   * Default: 0, chosen from the sampling.
   */
  vtkSetMacro(KernelWidth, double);
  vtkGetMacro(KernelWidth, double);
  ///@}

  ///@{
  /**
   * If set, F is this function exactly: its level sets on the surface are traced, no array is read,
   * and the iso-values are written as CutFunctionValue (sec. 4.3). Default: none. It is evaluated
   * from one thread at a time.
   */
  virtual void SetCutFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetCutFunction();
  ///@}

  ///@{
  /**
   * The widest hole of the sampling that a curve crosses, in sampling steps. Default: 0, the widest
   * gap to be expected of random sampling, so that no closed curve breaks at one.
   */
  vtkSetMacro(LinkDistance, double);
  vtkGetMacro(LinkDistance, double);
  ///@}

  ///@{
  /**
   * When the iteration (14) ends: at a residual of Tolerance sampling steps (default 1e-7) or after
   * MaximumIterations (20).
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  vtkSetMacro(MaximumIterations, int);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /**
   * Whether curves go through the points found or are smooth splines near them: a FitType. Default:
   * INTERPOLATE.
   */
  vtkSetMacro(Fit, int);
  vtkGetMacro(Fit, int);
  ///@}

  ///@{
  /**
   * Distance of the points along a curve, a length. Default: 0, the points as traced, about a
   * sampling step apart.
   */
  vtkSetMacro(SampleSpacing, double);
  vtkGetMacro(SampleSpacing, double);
  ///@}

  /// Changes of the cut function count.
  vtkMTimeType GetMTime() override;

protected:
  vtkPointSetContour();
  ~vtkPointSetContour() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkPointSetContour(const vtkPointSetContour&) = delete;
  void operator=(const vtkPointSetContour&) = delete;

  std::vector<double> ContourValues;
  int Scheme = PARAMETERIZED_MLS;
  int SurfaceModel = MLS;
  int PolynomialDegree = 2;
  int NeighborCount = 0;
  double SearchRadius = 0.0;
  int Kernel = CUBIC;
  double KernelWidth = 0.0;
  vtkSmartPointer<vtkImplicitFunction> CutFunction;
  double LinkDistance = 0.0;
  double Tolerance = 1e-7;
  int MaximumIterations = 20;
  int Fit = INTERPOLATE;
  double SampleSpacing = 0.0;
};

#endif
