#include "tests/unit/reference/scenes.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <numeric>

namespace lanthorn::reference::test {

Material lambertian(const vec3& albedo) {
    Material m;
    m.base_colour = vec4(albedo, 1);
    m.metallic = 0;
    m.specular = 0;
    return m;
}

Material lamp(const vec3& nits) {
    Material m = lambertian(vec3(0));
    m.emissive = nits;
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

Mesh sphere(const vec3& centre, float radius, int levels, bool inward, std::uint32_t material) {
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
            const std::uint32_t a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
        }
        triangles = std::move(finer);
    }
    Mesh mesh;
    mesh.material = material;
    for (const vec3& p : points) {
        Vertex vertex;
        vertex.position = centre + radius * p;
        vertex.normal = inward ? -p : p;
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(vertex.position);
    }
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const std::uint32_t a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
        mesh.indices.insert(mesh.indices.end(), {a, inward ? c : b, inward ? b : c});
    }
    return mesh;
}

LightInstance point_light(const vec3& position, float candela) {
    LightInstance light;
    light.light.type = LightType::point;
    light.light.intensity = candela;
    light.position = position;
    return light;
}

LightInstance spot_light(const vec3& position, const vec3& direction, float candela, float inner,
                         float outer) {
    LightInstance light = point_light(position, candela);
    light.light.type = LightType::spot;
    light.light.inner_cone = inner;
    light.light.outer_cone = outer;
    light.direction = glm::normalize(direction);
    return light;
}

LightInstance directional_light(const vec3& direction, float lux) {
    LightInstance light = point_light(vec3(0), lux);
    light.light.type = LightType::directional;
    light.direction = glm::normalize(direction);
    return light;
}

namespace {

void look(FrameScene& scene, const vec3& eye, const vec3& target) {
    const vec3 up = std::abs(glm::normalize(target - eye).y) > 0.99f ? vec3(0, 0, 1) : vec3(0, 1, 0);
    scene.camera.position = eye;
    scene.camera.view = glm::lookAt(eye, target, up);
}

}  // namespace

FrameScene scene_of(std::vector<Mesh> meshes, std::vector<Material> materials,
                    std::vector<LightInstance> lights, const vec3& eye, const vec3& target) {
    auto assets = std::make_shared<SceneAssets>();
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
    }
    scene.assets = assets;
    scene.lights = std::move(lights);
    scene.camera.camera.z_near = 0;
    look(scene, eye, target);
    return scene;
}

void look_closely(FrameScene& scene, const vec3& eye, const vec3& target, float half_width) {
    scene.camera.camera.orthographic = true;
    scene.camera.camera.x_mag = half_width;
    scene.camera.camera.y_mag = half_width;
    scene.camera.camera.z_far = 1e3f;
    look(scene, eye, target);
}

double mean_of(const FrameScene& scene, const PathSettings& settings, PathAov aov, ivec2 size) {
    PathTracer tracer(scene, size, settings,
                      {aov == PathAov::indirect, aov == PathAov::direct, aov == PathAov::radiance});
    tracer.render({});
    const std::vector<float> pixels = tracer.image(aov);
    return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

}  // namespace lanthorn::reference::test
