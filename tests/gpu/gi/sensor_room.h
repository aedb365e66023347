// Scenes whose light sensors are known to read so much, for tests to hold a technique against.
#pragma once

#include "engine/render/light_sensors.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

inline constexpr ivec2 kSensorPicture(16, 12);  // that is drawn meanwhile

// What the sensors of `scene` read after its first frame.
std::vector<render::SensorLight> measured(const FrameScene& scene, Bench& bench,
                                          render::LightSensors& sensors);

// The lantern room with its door at `angle` as a sensor of `radius` on the far wall meets it.
FrameScene lantern_room(float angle, float radius);
// Mean indirect illuminance of the disc of the scene's first sensor, by the path tracer: luminance, lux. In
// the lantern room its own noise is below 0.01. Fails the test where it is 0.5 or less: too little to tell.
double sensor_truth(FrameScene scene);
// What it reads under a technique, with the direct light on it, of which the lantern room has none there.
double reading_of(Bench& bench, const FrameScene& scene);

// Walls of reflectance a inside of a sphere send E (a + a^2 + ...), so many terms, of the E that a lamp at
// its centre gives them, exactly, in every channel. The sensor's disc touches the wall with its rim. Fails
// the test where a channel is further off than `tolerance`, a share of it.
void expect_the_colour_of_bounced_light(Bench& bench, double tolerance, int bounces = 3);

// In the lantern room: light_version() grows when a lamp is brighter and not in a still frame, and a sensor
// that hangs in the air reads direct light alone. Two benches of one technique.
void expect_other_light_to_be_told(Bench& bench, Bench& fresh);

}  // namespace lanthorn::gi::test
