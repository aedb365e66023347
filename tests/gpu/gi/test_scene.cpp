#include "tests/gpu/gi/test_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi::test {

Mesh inward_sphere(float radius, int levels, std::uint32_t material) {
    return support::sphere(vec3(0), radius, levels, true, material);
}

FrameScene closed_sphere(float albedo, float radius) {
    FrameScene scene = scene_of({inward_sphere(radius, 4, 0)}, {lambertian(vec3(albedo))},
                                {point_light(vec3(0), kSphereLux * radius * radius)},
                                vec3(0, 0, 0.5f * radius), vec3(0, 0, -radius));
    scene.camera.camera.y_fov = 1.4f;
    return scene;
}

void hold_still(FrameScene& scene) {
    ++scene.frame;
    scene.changes = {};
    scene.changes.assets = scene.changes.geometry = scene.changes.lights = scene.changes.camera = false;
}

namespace {

void mark_moved(FrameScene& scene, std::uint32_t i) {
    if (std::ranges::find(scene.changes.moved, i) == scene.changes.moved.end()) {
        scene.changes.moved.push_back(i);
    }
}

}  // namespace

void deform_instance(FrameScene& scene, std::uint32_t i, std::uint64_t serial,
                     const std::function<vec3(const vec3&)>& bend) {
    static std::uint64_t version = 0;
    Instance& instance = scene.instances[i];
    const Mesh& mesh = scene.assets->meshes[instance.mesh];
    auto topology = std::make_shared<RefinedTopology>();
    topology->serial = serial;
    topology->indices = mesh.indices;
    auto vertices = std::make_shared<std::vector<VertexFrame>>();
    Aabb bounds;
    for (const Vertex& v : mesh.vertices) {
        vertices->push_back({bend(v.position), v.normal, v.tangent});
        bounds.add(vertices->back().position);
        topology->uv0.push_back(v.uv0);
        topology->uv1.push_back(v.uv1);
        topology->colours.push_back(v.colour);
    }
    if (instance.deformed == Instance::kNotDeformed) {
        instance.deformed = static_cast<std::uint32_t>(scene.deformed.size());
        scene.deformed.emplace_back();
    }
    instance.version = ++version;
    scene.deformed[instance.deformed] = {version, vertices, topology, bounds};
    scene.changes.dirty.add(instance.bounds);
    instance.bounds = transformed(bounds, instance.transform);
    scene.changes.dirty.add(instance.bounds);
    scene.changes.geometry = true;
    mark_moved(scene, i);
}

void move_instance(FrameScene& scene, std::uint32_t i, const mat4& transform) {
    Instance& moved = scene.instances[i];
    scene.changes.dirty.add(moved.bounds);
    moved.transform = transform;
    moved.bounds = transformed(scene.assets->meshes[moved.mesh].bounds, transform);
    scene.changes.dirty.add(moved.bounds);
    scene.changes.geometry = true;
    mark_moved(scene, i);
}

LightInstance spot_light(const vec3& position, const vec3& direction, float candela, float outer_cone) {
    return support::spot_light(position, direction, candela, 0.8f * outer_cone, outer_cone);
}

gpu::Context& context() {
    static const std::unique_ptr<gpu::Context> the_context = gpu::create_headless_context();
    return *the_context;
}

Bench::Bench(TechniqueKind kind) {
    settings.technique = kind;
    settings.edit<EmcSettings>().final_stage = EmcFinal::splat;  // the paper's; tests of the other say so
    app.add<RenderPlugin>().add<GiPlugin>();
    app.world().insert_resource(
        ActiveTechnique{make_technique(kind), kind});  // to be looked at before a frame
}

void Bench::add_irradiance(const FrameScene& scene, const render::SensorTargets& targets) {
    const Renderer& shown = app.world().resource<Renderer>();
    technique().add_irradiance(shown.frame->light_inputs(scene, *shown.timer), targets);
}

void Bench::show(const FrameScene& scene, ivec2 size, bool timed) {
    ecs::World& world = app.world();
    world.insert_resource(scene);
    world.insert_resource(settings);
    app.view().size = size;
    Renderer& renderer = world.resource_mut<Renderer>();
    if (renderer.timed != timed) {
        renderer.timed = timed;
        renderer.timer = std::make_unique<gpu::PassTimer>(timed, software);
    }
    app.show();
    spans = renderer.timer->end_frame();
}

ImageF Bench::frame(const FrameScene& scene, ivec2 size, bool timed) {
    show(scene, size, timed);
    return renderer().read(render::Aov::indirect);
}

ImageF radiance_of(Bench& bench, FrameScene scene, ivec2 size, int frames) {
    for (int f = 0; f < frames; ++f) {
        bench.show(scene, size);
        hold_still(scene);
    }
    EXPECT_EQ(bench.technique().statistics(false).nan_count, 0u);
    return bench.renderer().read(render::Aov::radiance);
}

double mean_of(const ImageF& image) {
    double sum = 0;
    for (const float v : image.pixels) {
        EXPECT_TRUE(std::isfinite(v));
        sum += static_cast<double>(v);
    }
    return sum / static_cast<double>(image.pixels.size());
}

Deviation deviation_of(const ImageF& image, const std::vector<double>& expected) {
    const auto channels = static_cast<std::size_t>(image.channels);
    EXPECT_EQ(image.pixels.size(), expected.size() * channels);
    double sum = 0;
    double squares = 0;
    double wanted = 0;
    std::size_t broken = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const auto got = static_cast<double>(image.pixels[i]);
        const double want = expected[i / channels];
        broken += std::isfinite(got) ? 0 : 1;
        sum += got;
        squares += (got - want) * (got - want);
        wanted += want;
    }
    EXPECT_EQ(broken, 0u);
    const auto n = static_cast<double>(image.pixels.size());
    return {sum / wanted, std::sqrt(squares / n) / (wanted / n)};
}

Deviation deviation_of(const ImageF& image, double expected) {
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    return deviation_of(image, std::vector<double>(pixels, expected));
}

}  // namespace lanthorn::gi::test
