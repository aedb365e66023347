// What part of a scene lies about its camera and its lamps.
#pragma once

#include <span>
#include <vector>

#include "gi_module/techniques/emc/maps/coverage.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::gi {

// Whether `bulk` may be so large that its part about the camera is to be looked for: some thing that is near
// the camera for its size is much smaller. O(instances).
bool may_have_surroundings(const FrameScene& scene, const Aabb& bulk);

// Where to look from: the camera, then the lamps that give most light there, seven at most. Far and dim ones
// that give a twentieth of it together are left out. Render space. O(lamps log lamps).
std::vector<vec3> eyes_of_surroundings(const FrameScene& scene);

// The box of eyes and of what each sees near it: see surroundings().
Aabb seen_near(std::span<const vec3> eyes, std::span<const Sight> sights);

// Whether there are no surroundings if such a box is part of them.
bool too_large(const Aabb& near, const Aabb& bulk);

// The box of those eyes and of what each of them sees near it: within four times the distance within which
// two fifths of all that it sees lies, by solid angle. That is the walls of a room, whatever a window shows.
// Empty if that part says too little of the rest: unless `bulk` is 64 times as large; or 4 times, and nothing
// as fine lies beyond it and the outsides of its walls (no more rooms); or 2.5 times, and besides nothing
// that is seen goes on from it (a room in a sky dome). O(triangles).
Aabb surroundings(const FrameScene& scene, std::span<const vec3> eyes, std::span<const Sight> sights,
                  const Aabb& bulk);

// The same, looked for with `meter`: a drawing of the scene from the camera, and from the lamps where the
// camera alone does not tell that there are none.
Aabb find_surroundings(const FrameScene& scene, const render::GpuScene& gpu_scene, const Aabb& bulk,
                       CoverageMeter& meter);

// Square metres of surface within a box. O(triangles).
double area_within(const FrameScene& scene, const Aabb& box);

}  // namespace lanthorn::gi
