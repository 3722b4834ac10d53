#pragma once

#include "MarkdownReport.h"

#include <string>

namespace SurfaceScalars::Truth
{

// Each prints one part of Documentation/critical-points-accuracy.md.

/// Precision, recall and accuracy of what is found with and without noise. @param reduced fewer and
/// smaller samples
void reportTruth(MarkdownReport& report, bool reduced);

/// A surface of genus 2, degenerate saddles of a plane, and a surface with a boundary.
void reportSurfaces(MarkdownReport& report, bool reduced);

/// Whether half as many neighbors again find the same points.
void reportStability(MarkdownReport& report);

/// Whether index sums are Euler characteristics, and what is found of the critical points of
/// meshes.
/// @param folder with the meshes in OFF format
void reportMeshes(MarkdownReport& report, const std::string& folder);

/// Index sums of functions that were not chosen.
/// @param folder with the meshes in OFF format @param seed of the functions and of samples
void reportDrawn(MarkdownReport& report, const std::string& folder, unsigned seed);

/// What CriticalProbability means: 200 noisy repetitions. @param curveFile observed against stated
/// probability, as comma-separated values; empty = not written
void reportCalibration(MarkdownReport& report, bool reduced, const std::string& curveFile);

/// The point-set paper's Fig. 17 and the design paper's Table 3: one function, many starts.
void reportStarts(MarkdownReport& report);

} // namespace SurfaceScalars::Truth
