// Puts scenes together: every function adds one thing to a SceneData and returns its index.
#pragma once

#include <functional>
#include <string>

#include "lanthorn/scene/scene_data.h"
#include "tools/scene_generator/shapes.h"

namespace lanthorn::scene_generator {

inline constexpr const char* kBoxCollider = R"({"collider":"box"})";

// Where a node is: metres, and for lights and cameras the point that it looks at.
Transform at(const dvec3& position);
Transform looking(const dvec3& from, const dvec3& to);

class Builder {
  public:
    SceneData scene;

    // A matte surface: metallic 0, roughness 1; linear Rec. 709 reflectance. `specular` 0 makes it purely
    // Lambertian.
    std::uint32_t matte(const std::string& name, const vec3& reflectance, float specular = 1);

    // Metallic 1; `reflectance` at normal incidence, perceptual roughness.
    std::uint32_t metal(const std::string& name, const vec3& reflectance, float roughness);

    // Clear smooth glass (or water) that fills what it bounds, as `thickness` says for renderers that do not
    // trace it. `left` of light after `distance` metres in it.
    std::uint32_t glass(const std::string& name, float ior, float thickness, const vec3& left = vec3(1),
                        float distance = 1);

    // A square image that repeats, `pixels` a side, as the base colour of a material whose UVs are in metres:
    // `metres` a side. colour(x, y): sRGB, 0 to 1, of a place in it, 0 to 1.
    void texture(std::uint32_t material, int pixels, double metres,
                 const std::function<dvec3(double, double)>& colour);

    std::uint32_t mesh(const std::string& name, const Shape& shape, std::uint32_t material);

    std::uint32_t node(const std::string& name, const Transform& local, std::uint32_t parent = kNone);
    // A node that shows a mesh of its own.
    std::uint32_t solid(const std::string& name, const Shape& shape, std::uint32_t material,
                        const std::string& extras = {}, const Transform& local = {},
                        std::uint32_t parent = kNone);
    std::uint32_t camera(const std::string& name, const Transform& local, float y_fov, float z_near = 0.05f);
    std::uint32_t light(const std::string& name, const Transform& local, const Light& light,
                        std::uint32_t parent = kNone);

    // A flat lamp that shines one way alone: `width` x `height` metres about `centre`, turned towards
    // `towards`; `radiance` in nits. Seen from behind it is not there.
    std::uint32_t panel(const std::string& name, const dvec3& centre, const dvec3& towards, double width,
                        double height, const vec3& radiance);

    // A table whose top is `height` above the floor: a slab on four legs, one closed mesh each part. Metres.
    void table(const std::string& name, const dvec3& centre, double width, double depth, double height,
               std::uint32_t material, const std::string& extras = {});
};

}  // namespace lanthorn::scene_generator
