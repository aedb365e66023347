// A frame rendered of a scene made in memory, with a technique: what the tests of the indirect light share.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/app.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/scene/frame_scene.h"
#include "tests/support/scenes.h"
#include "tests/support/shapes.h"

namespace lanthorn::gi::test {

using support::box;
using support::lambertian;
using support::lamp;
using support::look_closely;
using support::metal;
using support::point_light;
using support::quad;
using support::scene_of;

// As support::sphere, about the origin, fronts facing the inside.
Mesh inward_sphere(float radius, int levels, std::uint32_t material);

// Inside of a sphere of one albedo with a lamp at its centre that gives kSphereLux everywhere: after b
// reflections albedo^b of it arrive, exactly, wherever one looks (support::sphere_irradiance).
constexpr float kSphereLux = 100;
FrameScene closed_sphere(float albedo, float radius = 1);

// Marks nothing as changed, for a second frame.
void hold_still(FrameScene& scene);

// Bends an instance's mesh: where each of its vertices goes. `serial`: of the topology, which stays the
// mesh's own.
void deform_instance(FrameScene& scene, std::uint32_t i, std::uint64_t serial,
                     const std::function<vec3(const vec3&)>& bend);

// Puts an instance elsewhere and marks what that changes.
void move_instance(FrameScene& scene, std::uint32_t i, const mat4& transform);

// The inner cone is 0.8 of the outer one.
LightInstance spot_light(const vec3& position, const vec3& direction, float candela, float outer_cone);

// The one context of a test program; made at the first call.
gpu::Context& context();

// An App that renders scenes made in memory, by one technique.
class Bench {
  public:
    explicit Bench(TechniqueKind kind = TechniqueKind::first);
    // Renders and returns the indirect irradiance, three floats a pixel, rows from the top.
    ImageF frame(const FrameScene& scene, ivec2 size, bool timed = false);
    // Renders alone: nothing is read.
    void show(const FrameScene& scene, ivec2 size, bool timed = false);

    // Technique::add_irradiance() of the frame that has been rendered last.
    void add_irradiance(const FrameScene& scene, const render::SensorTargets& targets);

    Technique& technique() { return *app.world().resource<ActiveTechnique>().technique; }
    render::FrameRenderer& renderer() { return *app.world().resource<Renderer>().frame; }

    const bool software = context().info().software;  // first: the rest needs a current context
    GiSettings settings;
    App app;
    std::vector<gpu::PassTimer::Span> spans;  // of the last timed frame
};

// The last of so many still frames: radiance, nits, three floats a pixel, rows from the top. Fails the test
// where anything was not a number.
ImageF radiance_of(Bench& bench, FrameScene scene, ivec2 size, int frames = 1);

// Over all pixels and channels. Fails the test at a value that is not finite.
double mean_of(const ImageF& image);

// An image against what it should be.
struct Deviation {
    double mean = 0;      // mean / expected mean: 1 without bias
    double rel_rmse = 0;  // root of the mean square error / expected mean
};

// `expected`: lux by pixel, rows from the top; every channel is held against it. Fails the test at a pixel
// that is not finite.
Deviation deviation_of(const ImageF& image, const std::vector<double>& expected);
Deviation deviation_of(const ImageF& image, double expected);

}  // namespace lanthorn::gi::test
