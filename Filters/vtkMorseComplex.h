/**
 * @class   vtkMorseComplex
 * @brief   steepest paths from the saddles of a function on a mesh to its minima and maxima
 *
 * The input is a triangle mesh (quads and strips are cut up) and a point array f, chosen by
 * SetInputArrayToProcess(0, ...), by default the active scalars. The 1-skeleton of the Morse
 * complex of f divides the mesh into regions in which f rises from one minimum to one maximum.
 *
 * Algorithm: critical points as those of vtkMeshCriticalPoints; from each saddle a path down along
 * the steepest edges for each part of its neighbors that lies lower, and one up for each that lies
 * higher. With a PersistenceThreshold, what is less persistent is removed from f first.
 *
 * Port 0, Separatrices, has the paths as polylines from the saddle to the extremum, with the cell
 * arrays:
 *
 * - SourceId, DestinationId: the saddle and the extremum among the points of port 1, counted from
 * 0;
 *
 * - SeparatrixType: 0 descending, to a minimum; 1 ascending, to a maximum;
 *
 * - Persistence: the difference of f between the two ends.
 *
 * Paths that meet go on together; each point of the mesh is there once, with f (without what was
 * removed), CriticalType and Multiplicity (as those of vtkMeshCriticalPoints) and PointId.
 *
 * Port 1, Nodes, has the critical points as vertices, with the arrays of the port CriticalPoints of
 * vtkMeshCriticalPoints. Field data of both: CriticalCounts and EulerCharacteristic, as there.
 *
 * Warnings and refusals are those of vtkMeshCriticalPoints.
 *
 * @sa vtkMeshCriticalPoints vtkConstrainedSmoothing
 */

#ifndef vtkMorseComplex_h
#define vtkMorseComplex_h

#include "SurfaceScalarsFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class SURFACESCALARSFILTERS_EXPORT vtkMorseComplex : public vtkPolyDataAlgorithm
{
public:
  static vtkMorseComplex* New();
  vtkTypeMacro(vtkMorseComplex, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Pairs of critical points of less persistence are cancelled; a fraction of the range of f, 0 to
   * 1. Default: 0, all are kept.
   */
  vtkSetMacro(PersistenceThreshold, double);
  vtkGetMacro(PersistenceThreshold, double);
  ///@}

protected:
  vtkMorseComplex();
  ~vtkMorseComplex() override;

  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkMorseComplex(const vtkMorseComplex&) = delete;
  void operator=(const vtkMorseComplex&) = delete;

  double PersistenceThreshold = 0.0;
};

#endif
