#pragma once

#include "MarkdownReport.h"

namespace SurfaceScalars::Truth
{

/// Table 3 and Figs. 12 and 13 of the design paper: where searches from random places of the plane
/// lead, and how fast. What must be found is what is searched for from critical vertices.
void reportGuesses(MarkdownReport& report, bool isReduced);

} // namespace SurfaceScalars::Truth
