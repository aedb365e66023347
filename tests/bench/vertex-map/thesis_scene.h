// The scene of Jozwowski 2002, sec. 5: a box that holds two smaller boxes, 16 square surfaces in all, and a
// point light that circles in it.
#pragma once

#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::bench {

// `side`: squares along each edge of a surface; 16 side^2 surfaces, each of two triangles and with four
// vertices of its own. Seen from within.
FrameScene thesis_scene(int side);
// Where the light is in a frame: once around in 200.
void circle_light(FrameScene& scene, int frame);

}  // namespace lanthorn::bench
