#pragma once

#include "Field.h"

#include <string>

class vtkDataObject;
class vtkPolyData;

namespace SurfaceScalars
{

/// A field as it is kept in a file: with the name of its function.
struct NamedModel
{
  FieldModel model;
  std::string valueName;
};

/**
 * Writes a model as polydata: a vertex at each center with its Coefficient, all else as field data
 * in plain arrays. Nothing in it is NaN or infinite, so that every file format can keep it.
 */
void writeModel(const NamedModel& named, vtkPolyData* output);

/// @throws InvalidInput if someone takes a model for samples
void refuseModel(vtkDataObject* input);

/// Reads it back, to the same bits. @throws InvalidInput that says what is missing, of another
/// version or inconsistent
NamedModel readModel(vtkPolyData* input);

} // namespace SurfaceScalars
