#include "tests/gpu/render/scenes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>

namespace lanthorn::testing {

gpu::Context& context() {
    static const std::unique_ptr<gpu::Context> shared = gpu::create_headless_context();
    return *shared;
}

SceneBuilder::SceneBuilder() {
    assets.serial = next_asset_version();
}

std::uint32_t SceneBuilder::add_material(const Material& material) {
    assets.materials.push_back(material);
    return static_cast<std::uint32_t>(assets.materials.size() - 1);
}

std::uint32_t SceneBuilder::add_lambert(const vec3& albedo) {
    Material m;
    m.base_colour = vec4(albedo, 1);
    m.metallic = 0;
    m.specular = 0;
    return add_material(m);
}

std::uint32_t SceneBuilder::add_image(const Image& image, const Sampler& sampler) {
    assets.images.push_back(image);
    assets.textures.push_back({static_cast<std::uint32_t>(assets.images.size() - 1), sampler});
    return static_cast<std::uint32_t>(assets.textures.size() - 1);
}

std::uint32_t SceneBuilder::add_mesh(Mesh mesh) {
    for (const Vertex& v : mesh.vertices) {
        mesh.bounds.add(v.position);
    }
    Instance instance;
    instance.id = static_cast<std::uint32_t>(scene.instances.size());
    instance.mesh = static_cast<std::uint32_t>(assets.meshes.size());
    instance.bounds = mesh.bounds;
    scene.instances.push_back(instance);
    assets.meshes.push_back(std::move(mesh));
    return instance.id;
}

namespace {
void append_quad(Mesh& mesh, const vec3& centre, const vec3& u, const vec3& v) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const vec3 normal = glm::normalize(glm::cross(glm::normalize(u), glm::normalize(v)));
    for (const vec2 corner : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1)}) {
        Vertex vertex;
        vertex.position = centre + u * (2 * corner.x - 1) + v * (2 * corner.y - 1);
        vertex.normal = normal;
        vertex.tangent = vec4(glm::normalize(u), 1);
        vertex.uv0 = corner;
        mesh.vertices.push_back(vertex);
    }
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) {
        mesh.indices.push_back(first + i);
    }
}
}  // namespace

std::uint32_t SceneBuilder::add_quad(std::uint32_t material, const vec3& centre, const vec3& u,
                                     const vec3& v) {
    Mesh mesh;
    mesh.material = material;
    append_quad(mesh, centre, u, v);
    return add_mesh(std::move(mesh));
}

void SceneBuilder::add_box(std::uint32_t material, const vec3& centre, const vec3& half, float turn_about_y) {
    Mesh mesh;
    mesh.material = material;
    const vec3 x(std::cos(turn_about_y) * half.x, 0, -std::sin(turn_about_y) * half.x);
    const vec3 y(0, half.y, 0);
    const vec3 z(std::sin(turn_about_y) * half.z, 0, std::cos(turn_about_y) * half.z);
    append_quad(mesh, centre + x, y, z);
    append_quad(mesh, centre - x, z, y);
    append_quad(mesh, centre + y, z, x);
    append_quad(mesh, centre - y, x, z);
    append_quad(mesh, centre + z, x, y);
    append_quad(mesh, centre - z, y, x);
    add_mesh(std::move(mesh));
}

void SceneBuilder::add_sphere(std::uint32_t material, const vec3& centre, float radius) {
    constexpr std::uint32_t kRings = 48;
    constexpr std::uint32_t kSides = 96;
    Mesh mesh;
    mesh.material = material;
    for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
        const float theta = kPi * static_cast<float>(ring) / kRings;
        for (std::uint32_t side = 0; side <= kSides; ++side) {
            const float phi = 2 * kPi * static_cast<float>(side) / kSides;
            Vertex v;
            v.normal =
                vec3(std::sin(theta) * std::cos(phi), std::cos(theta), -std::sin(theta) * std::sin(phi));
            v.position = centre + v.normal * radius;
            v.tangent = vec4(-std::sin(phi), 0, -std::cos(phi), 1);
            v.uv0 = vec2(static_cast<float>(side) / kSides, static_cast<float>(ring) / kRings);
            mesh.vertices.push_back(v);
            if (ring < kRings && side < kSides) {
                const std::uint32_t a = ring * (kSides + 1) + side;
                const std::uint32_t b = a + kSides + 1;
                mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
            }
        }
    }
    add_mesh(std::move(mesh));
}

void SceneBuilder::add_point(const vec3& position, float candela) {
    LightInstance light;
    light.id = 1000 + static_cast<std::uint32_t>(scene.lights.size());
    light.light.intensity = candela;
    light.position = position;
    scene.lights.push_back(light);
}

void SceneBuilder::add_spot(const vec3& position, const vec3& direction, float candela, float inner,
                            float outer) {
    add_point(position, candela);
    LightInstance& light = scene.lights.back();
    light.light.type = LightType::spot;
    light.light.inner_cone = inner;
    light.light.outer_cone = outer;
    light.direction = glm::normalize(direction);
}

void SceneBuilder::add_directional(const vec3& direction, float lux) {
    add_point(vec3(0), lux);
    scene.lights.back().light.type = LightType::directional;
    scene.lights.back().direction = glm::normalize(direction);
}

void SceneBuilder::look(const vec3& from, const vec3& to, float y_fov) {
    const vec3 forward = glm::normalize(to - from);
    const vec3 up = std::abs(forward.y) > 0.99f ? vec3(0, 0, -1) : vec3(0, 1, 0);
    scene.camera.camera = {};
    scene.camera.camera.y_fov = y_fov;
    scene.camera.camera.z_near = 1e-3f * glm::distance(from, to);
    scene.camera.view = glm::lookAt(from, to, up);
    scene.camera.position = from;
}

void SceneBuilder::look_orthographic(const vec3& from, const vec3& to, float half_width, float half_height) {
    look(from, to, 1);
    scene.camera.camera.orthographic = true;
    scene.camera.camera.x_mag = half_width;
    scene.camera.camera.y_mag = half_height;
    scene.camera.camera.z_far = 10 * glm::distance(from, to);
}

FrameScene SceneBuilder::build() const {
    FrameScene result = scene;
    result.assets = std::make_shared<SceneAssets>(assets);
    for (const Instance& instance : result.instances) {
        result.bounds.add(instance.bounds);
        result.changes.moved.push_back(instance.id);
    }
    result.changes.dirty = result.bounds;
    return result;
}

void render_once(render::FrameRenderer& renderer, const FrameScene& scene, ivec2 size,
                 const render::IndirectLight& indirect) {
    gpu::PassTimer timer(false, true);
    renderer.begin(scene, size, timer);
    renderer.draw_light_maps(scene, timer);
    renderer.draw_gbuffer(scene, timer);
    renderer.draw_direct(scene, {}, timer);
    renderer.compose(scene, indirect, timer);
}

SceneBuilder small_room(float scale, bool emissive_lamp) {
    SceneBuilder b;
    const float s = scale;
    const auto white = b.add_lambert(vec3(0.75f));
    const auto red = b.add_lambert(vec3(0.6f, 0.05f, 0.05f));
    const auto green = b.add_lambert(vec3(0.1f, 0.45f, 0.1f));
    b.add_quad(white, s * vec3(0, 0, 0), s * vec3(0, 0, 0.5f), s * vec3(0.5f, 0, 0));         // floor
    b.add_quad(white, s * vec3(0, 1, 0), s * vec3(0.5f, 0, 0), s * vec3(0, 0, 0.5f));         // ceiling
    b.add_quad(white, s * vec3(0, 0.5f, -0.5f), s * vec3(0.5f, 0, 0), s * vec3(0, 0.5f, 0));  // back
    b.add_quad(red, s * vec3(-0.5f, 0.5f, 0), s * vec3(0, 0.5f, 0), s * vec3(0, 0, 0.5f));
    b.add_quad(green, s * vec3(0.5f, 0.5f, 0), s * vec3(0, 0, 0.5f), s * vec3(0, 0.5f, 0));
    b.add_box(white, s * vec3(0.17f, 0.15f, 0.17f), s * vec3(0.14f, 0.15f, 0.14f), 0.3f);
    b.add_box(white, s * vec3(-0.17f, 0.3f, -0.15f), s * vec3(0.14f, 0.3f, 0.14f), -0.35f);
    if (emissive_lamp) {
        Material lamp;
        lamp.base_colour = vec4(0.5f, 0.5f, 0.5f, 1);
        lamp.metallic = 0;
        lamp.emissive = vec3(17, 12, 6);
        b.add_quad(b.add_material(lamp), s * vec3(0, 0.99f, 0), s * vec3(0.12f, 0, 0), s * vec3(0, 0, 0.12f));
    } else {
        b.add_point(s * vec3(0, 0.85f, 0), s * s * 1.0f);
    }
    b.look(s * vec3(0, 0.5f, 1.9f), s * vec3(0, 0.5f, 0), 0.68f);
    return b;
}

void save_picture(const ImageF& image, const std::string& name) {
    const std::filesystem::path folder = LANTHORN_PICTURES;
    std::filesystem::create_directories(folder);
    std::ofstream out(folder / (name + ".ppm"), std::ios::binary);
    out << "P6\n" << image.width << " " << image.height << "\n255\n";
    for (std::size_t i = 0; i < image.pixels.size(); i += static_cast<std::size_t>(image.channels)) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float v = image.pixels[i + std::min(c, static_cast<std::size_t>(image.channels - 1))];
            out.put(static_cast<char>(std::lround(std::clamp(v, 0.0f, 1.0f) * 255)));
        }
    }
}

}  // namespace lanthorn::testing
