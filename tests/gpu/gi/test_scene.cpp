#include "tests/gpu/gi/test_scene.h"

#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

namespace lanthorn::gi::test {

Material lambertian(const vec3& albedo) {
    Material m;
    m.base_colour = vec4(albedo, 1);
    m.metallic = 0;
    m.specular = 0;
    return m;
}

Mesh quad(const vec3& p, const vec3& u, const vec3& v, std::uint32_t material) {
    Mesh mesh;
    mesh.material = material;
    const vec3 n = glm::normalize(glm::cross(u, v));
    for (const vec3& q : {p, p + u, p + u + v, p + v}) {
        Vertex vertex;
        vertex.position = q;
        vertex.normal = n;
        vertex.tangent = vec4(glm::normalize(u), 1);
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(q);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3};
    return mesh;
}

Mesh box(const vec3& lower, const vec3& upper, bool inward, std::uint32_t material) {
    const vec3 s = upper - lower;
    const vec3 x(s.x, 0, 0);
    const vec3 y(0, s.y, 0);
    const vec3 z(0, 0, s.z);
    // Outward faces: corner and two edges whose product points out.
    const std::array<std::array<vec3, 3>, 6> faces{{{lower, z, y},
                                                    {lower + x, y, z},
                                                    {lower, x, z},
                                                    {lower + y, z, x},
                                                    {lower, y, x},
                                                    {lower + z, x, y}}};
    Mesh mesh;
    mesh.material = material;
    for (const auto& [p, u, v] : faces) {
        const Mesh face = inward ? quad(p, v, u, material) : quad(p, u, v, material);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.insert(mesh.vertices.end(), face.vertices.begin(), face.vertices.end());
        for (std::uint32_t i : face.indices) {
            mesh.indices.push_back(first + i);
        }
    }
    mesh.bounds = {lower, upper};
    return mesh;
}

Mesh inward_sphere(float radius, int levels, std::uint32_t material) {
    const float g = 0.5f * (1.0f + std::sqrt(5.0f));
    std::vector<vec3> points{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                             {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (vec3& p : points) {
        p = glm::normalize(p);
    }
    std::vector<std::uint32_t> triangles{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                         4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                         6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [entry, fresh] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
            if (fresh) {
                points.push_back(glm::normalize(points[a] + points[b]));
            }
            return entry->second;
        };
        std::vector<std::uint32_t> finer;
        for (std::size_t i = 0; i < triangles.size(); i += 3) {
            const std::uint32_t a = triangles[i];
            const std::uint32_t b = triangles[i + 1];
            const std::uint32_t c = triangles[i + 2];
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        triangles = std::move(finer);
    }
    Mesh mesh;
    mesh.material = material;
    for (const vec3& p : points) {
        Vertex vertex;
        vertex.position = radius * p;
        vertex.normal = -p;
        vertex.tangent = vec4(glm::normalize(std::abs(p.x) < 0.5f ? glm::cross(p, vec3(1, 0, 0))
                                                                  : glm::cross(p, vec3(0, 1, 0))),
                              1);
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(vertex.position);
    }
    for (std::size_t i = 0; i < triangles.size(); i += 3) {  // the other way round: fronts face the inside
        mesh.indices.insert(mesh.indices.end(), {triangles[i], triangles[i + 2], triangles[i + 1]});
    }
    return mesh;
}

FrameScene scene_of(std::vector<Mesh> meshes, std::vector<Material> materials,
                    std::vector<LightInstance> lights, const vec3& eye, const vec3& target) {
    static std::uint64_t serial = 0;
    auto assets = std::make_shared<SceneAssets>();
    assets->serial = ++serial;
    assets->meshes = std::move(meshes);
    assets->materials = std::move(materials);
    FrameScene scene;
    for (std::uint32_t i = 0; i < assets->meshes.size(); ++i) {
        Instance instance;
        instance.id = i;
        instance.mesh = i;
        instance.bounds = assets->meshes[i].bounds;
        scene.bounds.add(instance.bounds);
        scene.instances.push_back(instance);
        scene.changes.moved.push_back(i);
    }
    scene.changes.dirty = scene.bounds;
    scene.assets = assets;
    scene.lights = std::move(lights);
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        scene.lights[i].id = 1000 + i;
    }
    scene.camera.position = eye;
    const vec3 up = std::abs(glm::normalize(target - eye).y) > 0.99f ? vec3(0, 0, 1) : vec3(0, 1, 0);
    scene.camera.view = glm::lookAt(eye, target, up);
    return scene;
}

void hold_still(FrameScene& scene) {
    ++scene.frame;
    scene.changes = {false, false, false, false, {}, {}};
}

LightInstance point_light(const vec3& position, float candela) {
    LightInstance light;
    light.light.type = LightType::point;
    light.light.intensity = candela;
    light.position = position;
    return light;
}

LightInstance spot_light(const vec3& position, const vec3& direction, float candela, float outer_cone) {
    LightInstance light = point_light(position, candela);
    light.light.type = LightType::spot;
    light.light.outer_cone = outer_cone;
    light.light.inner_cone = 0.8f * outer_cone;
    light.direction = glm::normalize(direction);
    return light;
}

gpu::Context& context() {
    static const std::unique_ptr<gpu::Context> the_context = gpu::create_headless_context();
    return *the_context;
}

Bench::Bench(TechniqueKind kind) : technique(make_technique(kind)) {}

render::FloatImage Bench::frame(const FrameScene& scene, ivec2 size, bool timed) {
    gpu::PassTimer timer(timed, software);
    renderer.render(
        scene, size, [&](const render::FrameInputs& inputs) { return technique->render(inputs, settings); },
        timer);
    spans = timer.end_frame();
    return renderer.read(render::Aov::indirect);
}

}  // namespace lanthorn::gi::test
