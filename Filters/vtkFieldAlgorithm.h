/**
 * @class   vtkFieldAlgorithm
 * @brief   superclass of filters that extend a function off its samples
 *
 * Reads points and a point array f, chosen by SetInputArrayToProcess(0, ...), by default the active
 * scalars, and makes f~, a function of all of space, from them (Patane and Falcidieno, Defining,
 * Contouring, and Visualizing Scalar Functions on Point-Sampled Surfaces, sec. 3).
 *
 * - EXPLICIT_MLS: the average of the neighbors' values with Gaussian weights, (6).
 *
 * - PARAMETERIZED_MLS: a polynomial over the tangent plane of the neighbors, (4)(5); constant
 * across that plane.
 *
 * - LOCAL_RBF: radial functions at the neighbors and a linear polynomial, through their values,
 *   (8)-(10).
 *
 * - HYBRID: EXPLICIT_MLS, and LOCAL_RBF where that misses the samples by more than HybridThreshold.
 *
 * - GLOBAL_RBF: radial functions at all samples; smooth everywhere, and costly beyond some thousand
 *   of them.
 *
 * The blocks of a composite input are merged. Ghost points are left out. So are points with a NaN,
 * infinite or absent coordinate or value; one warning counts them. Samples at the same place count
 * once, with the mean of their values; one warning counts the places where they contradict each
 * other.
 *
 * The last f~ is kept: where only the target, the derivatives or, as in a time series, the values
 * change, what depends on the points is not computed again.
 *
 * @sa vtkRBFExtend vtkOsculatingParaboloid
 */

#ifndef vtkFieldAlgorithm_h
#define vtkFieldAlgorithm_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the last field

namespace SurfaceScalars
{
class Field;
class FieldMemory;
class FilterRun;
struct Execution;
struct Samples;
}

class SURFACESCALARSFILTERS_EXPORT vtkFieldAlgorithm : public vtkPolyDataAlgorithm
{
public:
  vtkTypeMacro(vtkFieldAlgorithm, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// How f is extended off its samples. The numbers are fixed: state files and models keep them.
  enum SchemeType
  {
    EXPLICIT_MLS = 1,
    PARAMETERIZED_MLS = 2,
    LOCAL_RBF = 3,
    HYBRID = 4,
    GLOBAL_RBF = 5
  };

  /// The radial functions, with t = r / h. The numbers are fixed.
  enum KernelType
  {
    GAUSSIAN = 0,             ///< exp(-t^2)
    EXPONENTIAL = 1,          ///< exp(-t): not differentiable at samples
    LINEAR = 2,               ///< r: not differentiable at samples
    CUBIC = 3,                ///< t^3
    THIN_PLATE = 4,           ///< t^2 log t: no second derivatives at samples
    MULTIQUADRIC = 5,         ///< sqrt(1 + t^2)
    INVERSE_MULTIQUADRIC = 6, ///< 1 / sqrt(1 + t^2)
    WENDLAND = 7,             ///< (1 - t)^4 (4 t + 1), 0 from t = 1 on
    WU = 8                    ///< (1 - t)^4 (4 + 16 t + 12 t^2 + 3 t^3), 0 from t = 1 on
  };

  ///@{
  /**
   * How f is extended off its samples: a SchemeType. Default: LOCAL_RBF.
   */
  vtkSetMacro(Scheme, int);
  vtkGetMacro(Scheme, int);
  ///@}

  ///@{
  /**
   * The radial function of LOCAL_RBF, HYBRID and GLOBAL_RBF: a KernelType. Default: CUBIC.
   */
  vtkSetMacro(Kernel, int);
  vtkGetMacro(Kernel, int);
  ///@}

  ///@{
  /**
   * Width h of the radial function and of the weights of (6), a length. Default: 0, chosen from the
   * sampling, for GLOBAL_RBF by the leave-one-out error.
   */
  vtkSetMacro(KernelWidth, double);
  vtkGetMacro(KernelWidth, double);
  ///@}

  ///@{
  /**
   * Number k of samples in a neighborhood of the local schemes. Default: 0, chosen by the scheme.
   */
  vtkSetMacro(NeighborCount, int);
  vtkGetMacro(NeighborCount, int);
  ///@}

  ///@{
  /**
   * If positive, neighborhoods have all samples closer than this length instead of NeighborCount.
   * Default: 0.
   */
  vtkSetMacro(SearchRadius, double);
  vtkGetMacro(SearchRadius, double);
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
   * What is added to the diagonal of the kernel matrix: 0, the default, goes through the samples;
   * larger values smooth.
   */
  vtkSetMacro(Regularization, double);
  vtkGetMacro(Regularization, double);
  ///@}

  ///@{
  /**
   * From which error of the weighted average on HYBRID takes radial functions, a fraction of f's
   * range. Default: 0.01.
   */
  vtkSetMacro(HybridThreshold, double);
  vtkGetMacro(HybridThreshold, double);
  ///@}

protected:
  vtkFieldAlgorithm();
  ~vtkFieldAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;

  /// f~ through the samples by the properties above; valid until the next call.
  const SurfaceScalars::Field& FieldOf(SurfaceScalars::Samples&& samples,
    SurfaceScalars::FilterRun& run, const SurfaceScalars::Execution& execution);

private:
  vtkFieldAlgorithm(const vtkFieldAlgorithm&) = delete;
  void operator=(const vtkFieldAlgorithm&) = delete;

  int Scheme = LOCAL_RBF;
  int Kernel = CUBIC;
  double KernelWidth = 0.0;
  int NeighborCount = 0;
  double SearchRadius = 0.0;
  int PolynomialDegree = 2;
  double Regularization = 0.0;
  double HybridThreshold = 0.01;
  std::unique_ptr<SurfaceScalars::FieldMemory> Memory;
};

#endif
