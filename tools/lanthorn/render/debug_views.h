// Debug views of techniques (gi/technique.h) on the command line.
#pragma once

#include <string>

#include "lanthorn/core/image.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::tools {

// Display-encoded, 0..1. Amounts go from black over violet and orange to white at the largest but
// for a few.
ImageF shown_as(ImageF image, gi::DebugView::Shown shown);

// Those of every technique, a line each.
std::string list_debug_views();

}  // namespace lanthorn::tools
