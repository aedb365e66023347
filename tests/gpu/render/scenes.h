// Scenes built by hand, whose light is known on paper, and a picture of them.
#pragma once

#include <memory>
#include <string>

#include "lanthorn/gpu/context.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::testing {

// One headless context for the whole test program.
gpu::Context& context();

// Collects meshes, materials, instances and lights into a FrameScene.
class SceneBuilder {
  public:
    SceneBuilder();

    // Materials: diffuse without any specular reflection; returns the index.
    std::uint32_t add_lambert(const vec3& albedo);
    std::uint32_t add_material(const Material& material);
    std::uint32_t add_image(const Image& image, const Sampler& sampler = {});  // the texture's index

    // A parallelogram centre +- u +- v, facing cross(u, v), uv 0..1; returns the instance's index.
    std::uint32_t add_quad(std::uint32_t material, const vec3& centre, const vec3& u, const vec3& v);
    // A box, faces outwards.
    void add_box(std::uint32_t material, const vec3& centre, const vec3& half, float turn_about_y);
    void add_sphere(std::uint32_t material, const vec3& centre, float radius);

    void add_point(const vec3& position, float candela);
    void add_spot(const vec3& position, const vec3& direction, float candela, float inner, float outer);
    void add_directional(const vec3& direction, float lux);

    void look(const vec3& from, const vec3& to, float y_fov);
    void look_orthographic(const vec3& from, const vec3& to, float half_width, float half_height);

    FrameScene build() const;  // frame 0, everything changed

    SceneAssets assets;
    FrameScene scene;

  private:
    std::uint32_t add_mesh(Mesh mesh);
};

// Renders once, all passes but those of indirect light, which is given.
void render_once(render::FrameRenderer& renderer, const FrameScene& scene, ivec2 size,
                 const render::IndirectLight& indirect = {});

// Cornell-like room of 1 unit with an emissive ceiling lamp or a point light, scaled about the origin.
SceneBuilder small_room(float scale, bool emissive_lamp);

// For looking at: a binary PPM in the build folder's `tests/gpu/pictures/`.
void save_picture(const ImageF& image, const std::string& name);

}  // namespace lanthorn::testing
