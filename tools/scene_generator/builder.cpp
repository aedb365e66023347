#include "tools/scene_generator/builder.h"

#include <cmath>

namespace lanthorn::scene_generator {

Transform at(const dvec3& position) {
    Transform result;
    result.translation = position;
    return result;
}

Transform looking(const dvec3& from, const dvec3& to) {
    Transform result = at(from);
    const dvec3 forward = glm::normalize(to - from);
    const dvec3 up = std::abs(forward.y) > 0.999 ? dvec3(0, 0, -1) : dvec3(0, 1, 0);
    result.rotation = quat(glm::quatLookAtRH(forward, up));
    return result;
}

std::uint32_t Builder::matte(const std::string& name, const vec3& reflectance, float specular) {
    Material material;
    material.name = name;
    material.base_colour = vec4(reflectance, 1);
    material.metallic = 0;
    material.roughness = 1;
    material.specular = specular;
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

std::uint32_t Builder::metal(const std::string& name, const vec3& reflectance, float roughness) {
    const std::uint32_t material = matte(name, reflectance);
    scene.materials[material].metallic = 1;
    scene.materials[material].roughness = roughness;
    return material;
}

std::uint32_t Builder::glass(const std::string& name, float ior, float thickness, const vec3& left,
                             float distance) {
    const std::uint32_t material = matte(name, vec3(1));
    Material& m = scene.materials[material];
    m.roughness = 0;
    m.transmission = 1;
    m.ior = ior;
    m.thickness = thickness;
    if (left != vec3(1)) {
        m.attenuation_colour = left;
        m.attenuation_distance = distance;
    }
    return material;
}

void Builder::texture(std::uint32_t material, int pixels, double metres,
                      const std::function<dvec3(double, double)>& colour) {
    Image image;
    image.name = scene.materials[material].name;
    image.width = image.height = static_cast<std::uint32_t>(pixels);
    for (int y = 0; y < pixels; ++y) {
        for (int x = 0; x < pixels; ++x) {
            const dvec3 value = colour((x + 0.5) / pixels, (y + 0.5) / pixels);
            for (int c = 0; c < 3; ++c) {
                image.rgba.push_back(
                    static_cast<std::uint8_t>(std::lround(255 * glm::clamp(value[c], 0.0, 1.0))));
            }
            image.rgba.push_back(255);
        }
    }
    scene.images.push_back(std::move(image));
    Texture sampled;
    sampled.image = static_cast<std::uint32_t>(scene.images.size() - 1);
    scene.textures.push_back(sampled);
    TextureRef& reference = scene.materials[material].base_colour_texture;
    reference.texture = static_cast<std::uint32_t>(scene.textures.size() - 1);
    const auto scale = static_cast<float>(1 / metres);
    reference.uv_transform = {vec3(scale, 0, 0), vec3(0, scale, 0)};
}

namespace {

// Of UVs in metres on flat faces (shapes.h): the way of growing u, and the side of falling v.
vec4 flat_tangent(const dvec3& normal) {
    const dvec3 n = glm::abs(normal);
    const bool level = n.y > n.x && n.y > n.z;
    const dvec3 along = !level && n.x > n.z ? dvec3(0, 0, 1) : dvec3(1, 0, 0);
    const dvec3 up = level ? dvec3(0, 0, -1) : dvec3(0, 1, 0);
    const dvec3 tangent = glm::normalize(along - normal * glm::dot(normal, along));
    return {vec3(tangent), glm::dot(glm::cross(normal, tangent), up) < 0 ? -1.0f : 1.0f};
}

}  // namespace

std::uint32_t Builder::mesh(const std::string& name, const Shape& shape, std::uint32_t material) {
    Mesh result;
    result.name = name;
    result.material = material;
    result.indices = shape.indices;
    const bool relief = scene.materials[material].normal_texture.present();
    for (const Shape::Corner& corner : shape.corners) {
        Vertex vertex;
        vertex.position = corner.position;
        vertex.normal = corner.normal;
        vertex.uv0 = corner.uv;
        if (relief) {
            vertex.tangent = flat_tangent(corner.normal);
        }
        result.vertices.push_back(vertex);
        result.bounds.add(vertex.position);
    }
    scene.meshes.push_back(std::move(result));
    return static_cast<std::uint32_t>(scene.meshes.size() - 1);
}

std::uint32_t Builder::node(const std::string& name, const Transform& local, std::uint32_t parent) {
    NodeData result;
    result.name = name;
    result.local = local;
    result.parent = parent;
    scene.nodes.push_back(result);
    return static_cast<std::uint32_t>(scene.nodes.size() - 1);
}

std::uint32_t Builder::solid(const std::string& name, const Shape& shape, std::uint32_t material,
                             const std::string& extras, const Transform& local, std::uint32_t parent) {
    const std::uint32_t index = node(name, local, parent);
    scene.nodes[index].meshes = {mesh(name, shape, material)};
    scene.nodes[index].extras = extras;
    return index;
}

std::uint32_t Builder::camera(const std::string& name, const Transform& local, float y_fov, float z_near) {
    Camera result;
    result.y_fov = y_fov;
    result.z_near = z_near;
    scene.cameras.push_back(result);
    const std::uint32_t index = node(name, local);
    scene.nodes[index].camera = static_cast<std::uint32_t>(scene.cameras.size() - 1);
    return index;
}

std::uint32_t Builder::light(const std::string& name, const Transform& local, const Light& light,
                             std::uint32_t parent) {
    scene.lights.push_back(light);
    const std::uint32_t index = node(name, local, parent);
    scene.nodes[index].light = static_cast<std::uint32_t>(scene.lights.size() - 1);
    return index;
}

std::uint32_t Builder::panel(const std::string& name, const dvec3& centre, const dvec3& towards, double width,
                             double height, const vec3& radiance) {
    const std::uint32_t material = matte(name, vec3(0), 0);
    scene.materials[material].emissive = radiance;
    const glm::dquat turned(looking(centre, towards).rotation);
    const dvec3 right = turned * dvec3(0.5 * width, 0, 0), up = turned * dvec3(0, 0.5 * height, 0);
    Shape shape;
    add_quad(shape, centre - right - up, centre + right - up, centre + right + up, centre - right + up,
             towards);
    return solid(name, shape, material);
}

void Builder::table(const std::string& name, const dvec3& centre, double width, double depth, double height,
                    std::uint32_t material, const std::string& extras) {
    constexpr double kTop = 0.05, kLeg = 0.06;
    const dvec3 half(0.5 * width, 0, 0.5 * depth);
    const std::uint32_t table = node(name, at(centre));
    solid(name + "-top", box(-half + dvec3(0, height - kTop, 0), half + dvec3(0, height, 0)), material,
          extras, {}, table);
    int leg = 0;
    for (const double x : {-half.x, half.x - kLeg}) {
        for (const double z : {-half.z, half.z - kLeg}) {
            solid(name + "-leg" + std::to_string(++leg), box({x, 0, z}, {x + kLeg, height - kTop, z + kLeg}),
                  material, extras, {}, table);
        }
    }
}

}  // namespace lanthorn::scene_generator
