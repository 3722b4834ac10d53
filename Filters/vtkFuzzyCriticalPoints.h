/**
 * @class   vtkFuzzyCriticalPoints
 * @brief   minima, saddles and maxima of a function known at the points of an unmeshed surface
 *
 * The input is a point set P sampled from a surface (cells are ignored) and a point array f, chosen
 * by SetInputArrayToProcess(0, ...), by default the active scalars. The outputs are the points of
 * the surface where the gradient of f~, which extends f, is zero, and for every point of P the
 * probability that it is one of them.
 *
 * Algorithm (Patane and Falcidieno, Defining, Contouring, and Visualizing Scalar Functions on
 * Point-Sampled Surfaces, sec. 5):
 *
 * - Surface and f are fitted locally around each point, with as many neighbors as the noise asks
 *   for.
 *
 * - A critical point is where the tangential part of the gradient, grad F - <grad F, n> n, is zero
 *   on the surface g = 0, found by Newton's iteration. (The paper's (15) asks for <grad F, n> = 0,
 *   the opposite.)
 *
 * - Its type is that of the Hessian of f~, or, where that is degenerate, of the changes of sign of
 *   f~ - f~(p) around it: 2 + 2 m for a saddle of multiplicity m.
 *
 * - The probability of a sample is exp(-g^T S^-1 g / 2): g is the fitted tangential gradient, S
 *   what noise and sampling make uncertain of it. (The paper's |<grad F, n>| / |grad F| cannot tell
 *   on samples of a surface, where the fitted gradient is tangential by construction; with the true
 *   F, given as VolumeFunction, it can.)
 *
 * Port 0 is the input with point arrays: CriticalProbability, 0 to 1; Gradient of f~, tangential;
 * Normals of the surface; CriticalType, that of a critical point at the point nearest to it, else 5
 * (regular), -1 at missing points. f is its active scalars. Polydata passes through with its cells;
 * other point sets come out as polydata with one vertex per point; the blocks of a composite
 * dataset are merged, with the arrays that all of them have.
 *
 * Port 1, CriticalPoints, has the critical points as vertices, by f~ ascending:
 *
 * - CriticalType: 0 minimum, 1 saddle, 3 maximum, 4 uncertain: noise or degeneracy hide which;
 *
 * - Multiplicity: m of a saddle, else 1;
 *
 * - CriticalProbability: the largest among the points of its cluster;
 *
 * - ScalarValue: f~ there;
 *
 * - PointId: the point of port 0 that is nearest;
 *
 * - Persistence: how much f has to change for it to vanish, in the unit of f; the range of f if it
 *   never does;
 *
 * - Residual: the norm of the tangential gradient there.
 *
 * Field data of both ports: IndexSum, minima and maxima less saddles with their multiplicity, which
 * is the Euler characteristic where the surface is closed; NeighborCount, what the local fits used
 * (0 with a search radius).
 *
 * Points at the same place share their values. Ghost points are left out. So are points with a NaN,
 * infinite or absent coordinate or value, which one warning counts; they get NaN. An input array
 * whose name is needed is renamed `<name>Input` with a warning. A constant function has no critical
 * points, which a warning says.
 *
 * @warning Within a neighborhood of the border of the samples nothing is reported as critical.
 *
 * @sa vtkPointSetContour vtkPointSetScalarFunction
 */

#ifndef vtkFuzzyCriticalPoints_h
#define vtkFuzzyCriticalPoints_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for the volume function

class vtkImplicitFunction;

class SURFACESCALARSFILTERS_EXPORT vtkFuzzyCriticalPoints : public vtkPolyDataAlgorithm
{
public:
  static vtkFuzzyCriticalPoints* New();
  vtkTypeMacro(vtkFuzzyCriticalPoints, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How f is extended off its samples. The numbers are fixed: state files keep them.
  enum SchemeType
  {
    EXPLICIT_MLS = 1,      ///< weighted average, (6)
    PARAMETERIZED_MLS = 2, ///< polynomial over the tangent plane, (4)(5)
    LOCAL_RBF = 3,         ///< radial functions through the neighbors' values, (8)-(10)
    HYBRID = 4             ///< EXPLICIT_MLS, and LOCAL_RBF where that misses the values (sec. 3.3)
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

  /// How probable it is that a point is critical. The numbers are fixed.
  enum ProbabilityModelType
  {
    GRADIENT = 0,    ///< exp(-g^T S^-1 g / 2)
    NORMAL_ANGLE = 1 ///< |cos| of the angle between the gradient of VolumeFunction and the normal
  };

  ///@{
  /**
   * How f is extended off its samples: a SchemeType. Default: PARAMETERIZED_MLS.
   */
  vtkSetMacro(Scheme, int);
  vtkGetMacro(Scheme, int);
  ///@}

  ///@{
  /**
   * Degree of the polynomials of PARAMETERIZED_MLS, 1 to 4. Default: 2.
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
   * The radial function of the schemes LOCAL_RBF and HYBRID: a KernelType. Default: CUBIC.
   */
  vtkSetMacro(Kernel, int);
  vtkGetMacro(Kernel, int);
  ///@}

  ///@{
  /**
   * Width h of the weights of EXPLICIT_MLS and of the radial function, a length. Default: 0, chosen
   * from the sampling.
   */
  vtkSetMacro(KernelWidth, double);
  vtkGetMacro(KernelWidth, double);
  ///@}

  ///@{
  /**
   * What CriticalProbability is: a ProbabilityModelType. Default: GRADIENT.
   */
  vtkSetMacro(ProbabilityModel, int);
  vtkGetMacro(ProbabilityModel, int);
  ///@}

  ///@{
  /**
   * A function of space of which f is the values, for NORMAL_ANGLE; others do not use it. Default:
   * none. It is evaluated from one thread at a time.
   */
  virtual void SetVolumeFunction(vtkImplicitFunction* function);
  vtkImplicitFunction* GetVolumeFunction();
  ///@}

  ///@{
  /**
   * Critical points none of whose samples has this probability, 0 to 1, are left out. Default: 0,
   * automatic.
   */
  vtkSetMacro(ProbabilityThreshold, double);
  vtkGetMacro(ProbabilityThreshold, double);
  ///@}

  ///@{
  /**
   * Critical points of less persistence are left out; a fraction of the range of f, 0 to 1.
   * Default: 0, all are kept.
   */
  vtkSetMacro(PersistenceThreshold, double);
  vtkGetMacro(PersistenceThreshold, double);
  ///@}

  ///@{
  /**
   * Whether critical points are moved off the samples to where the gradient is zero. Default: on.
   */
  vtkSetMacro(Refine, bool);
  vtkGetMacro(Refine, bool);
  vtkBooleanMacro(Refine, bool);
  ///@}

  /// Changes of the volume function count.
  vtkMTimeType GetMTime() override;

protected:
  vtkFuzzyCriticalPoints();
  ~vtkFuzzyCriticalPoints() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkFuzzyCriticalPoints(const vtkFuzzyCriticalPoints&) = delete;
  void operator=(const vtkFuzzyCriticalPoints&) = delete;

  int Scheme = PARAMETERIZED_MLS;
  int PolynomialDegree = 2;
  int NeighborCount = 0;
  double SearchRadius = 0.0;
  int Kernel = CUBIC;
  double KernelWidth = 0.0;
  int ProbabilityModel = GRADIENT;
  vtkSmartPointer<vtkImplicitFunction> VolumeFunction;
  double ProbabilityThreshold = 0.0;
  double PersistenceThreshold = 0.0;
  bool Refine = true;
};

#endif
