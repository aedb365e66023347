// A room with a mirror, and how a technique's picture of it is held against what is known: what a camera
// behind the mirror sees, and what the path tracer finds.
#pragma once

#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

// A room of 4 x 2.6 x 3 m with a block in it and a mirror at x = 3.99, before the wall, which fills the
// picture. Neither that wall nor the mirror is there from behind.
FrameScene mirror_room(const Material& mirror);
// The same, seen from behind the mirror.
FrameScene behind_the_mirror(const Material& mirror);
// The same with a lamp of 1 x 1 m under its ceiling in place of the point, whose reflections the path tracer
// finds.
FrameScene mirror_room_with_a_lamp(const Material& mirror);

// What a mirror shows against what is seen from behind it, left and right exchanged.
Deviation against_flipped(const ImageF& shown, const ImageF& seen);
// Against the path tracer's radiance in full transport, whose own noise is taken off.
Deviation against_path(const ImageF& shown, const FrameScene& scene, int bounces, int spp);

// What a smooth mirror shows is what is seen from behind it, but for edges, which fall between other pixels.
// Two benches of one technique; `name`: printed.
void expect_the_view_from_behind(const char* name, Bench& before, Bench& behind, ivec2 size);
// What a smooth mirror shows is what the path tracer finds, and without rays it shows next to nothing of
// that. What is mirrored has been reflected once less than what is seen. `frames`: until the technique is
// done.
void expect_the_walls_that_the_path_tracer_finds(const char* name, Bench& bench, ivec2 size, int frames);
// A lamp moves: what a smooth mirror shows is what a technique that has known nothing else shows, bit for
// bit. Then nothing moves, and no pass is on.
void expect_a_lamp_to_be_followed(Bench& kept, Bench& fresh, ivec2 size,
                                  const std::function<void()>& after_the_move);

}  // namespace lanthorn::gi::test
