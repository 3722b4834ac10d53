#include "CriticalTable.h"
namespace SurfaceScalars::Truth
{
void reportStarts(MarkdownReport&) {}
}
