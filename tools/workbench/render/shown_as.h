// Values of a debug view or of a part of a picture as colours that a screen shows.
#pragma once

#include "lanthorn/core/image.h"
#include "lanthorn/core/math.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::workbench {

// Display-encoded, 0..1. Amounts go from black over violet and orange to white at the largest but
// for a few.
ImageF shown_as(ImageF image, gi::DebugView::Shown shown);

// Display-encoded, from none (0) to most (1); its luminance grows evenly.
vec3 heat(float share);

}  // namespace lanthorn::workbench
