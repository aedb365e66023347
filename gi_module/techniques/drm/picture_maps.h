// What lights see that have no light map to be looked at through: maps of distance, normal and albedo, drawn
// here. Six layers of a cube a light, in its hemisphere alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "gi_module/techniques/drm/light_pictures.h"
#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/program.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/render/light_map_array.h"
#include "lanthorn/render/scene_program.h"

namespace lanthorn::gi {

class PictureMaps {
  public:
    // Uploads the lights and draws those whose shape says so (LightPicture::drawn_here; first_layer is
    // assigned), `resolution` texels a side of a face. Returns the faces that something was drawn on. Cost:
    // the triangles in a light's hemisphere, up to five times, and 12 bytes a texel.
    int draw(const render::LightInputs& inputs, const LightPictures& pictures, int resolution);

    // For shaders that include picture_look.glsl: lights, shapes, materials and six maps, on units 0 to 5.
    // Uses the program.
    void bind(const gpu::Program& program, const render::LightInputs& inputs) const;

    const gpu::Texture& distance() const { return maps_.distance(); }
    const gpu::Texture& normals() const { return maps_.normals(); }

  private:
    bool draw_face(const render::LightInputs& inputs, const render::LightData& light, int face);

    render::SceneProgram program_{"engine/render/light_map.vert",
                                  "gi_module/techniques/drm/lamp_picture.frag"};
    render::LightMapArray maps_{true};
    gpu::Buffer lights_;
    gpu::Buffer shapes_;
    std::vector<render::DrawnInstance> visible_;
};

// Writes all of `data`; a buffer of less than `least` elements, or than there are, is replaced by a larger
// one.
template <class T>
void upload(gpu::Buffer& buffer, const std::vector<T>& data, std::size_t least) {
    const std::size_t bytes = std::max(data.size(), least) * sizeof(T);
    if (buffer.bytes() < bytes) {
        buffer = gpu::Buffer(bytes);
    }
    buffer.write(0, std::span<const T>(data));
}

}  // namespace lanthorn::gi
