#pragma once

#include "Field.h"

#include <string>

namespace SurfaceScalars
{

/// What Field::fit() does not work on, but for what depends on the cloud. @throws InvalidInput
void checkFieldParameters(const FieldParameters& parameters);
void checkFieldValues(const ValuesRef& values, std::size_t pointCount);

/// Whether there are samples enough, and spread enough, for the scheme. @throws InvalidInput
void checkFieldSamples(const PointCloud& cloud, const FieldParameters& parameters);

/// Whether a system of this many samples is small enough to be solved for one place.
/// @throws InvalidInput
void checkNeighborhood(std::size_t sampleCount);

/// @throws InvalidInput unless the numbers of a model fit together
void checkFieldModel(const FieldModel& model);

void checkEvaluation(const EvaluationParameters& parameters);

} // namespace SurfaceScalars
