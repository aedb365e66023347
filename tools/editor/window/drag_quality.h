// What a picture is drawn with while a hand edits, on a CPU: coarser where a step costs the most, but lit by
// the same light on its same ways.
#pragma once

#include "lanthorn/core/math.h"
#include "lanthorn/core/settings.h"

namespace lanthorn::edit_window {

// Maps of lamps with half the texels a side; half the points that rays of the picture start from; and
// up-scaling by the picture's own pixels alone, since those before had other light: where the camera rests,
// what it sees is then drawn once for all steps.
Settings drag_settings(const Settings& chosen);

// Pixels of the picture that is made of one of `drawn` pixels, where that at rest has `whole`: the panels
// stretch it.
ivec2 drag_whole(ivec2 drawn, ivec2 whole);

}  // namespace lanthorn::edit_window
