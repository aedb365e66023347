#include "lanthorn/reference/scene_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <type_traits>

namespace lanthorn::reference {

namespace {

// Takes values field by field, so that padding never counts.
class Hash {
  public:
    Hash() { XXH3_64bits_reset(&state_); }

    void bytes(const void* data, std::size_t size) { XXH3_64bits_update(&state_, data, size); }
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) { bytes(&value, sizeof value); }
    template <glm::length_t n, class T>
    void add(const glm::vec<n, T>& v) {
        bytes(&v, sizeof v);
    }
    void add(const mat4& m) { bytes(&m, sizeof m); }
    template <class... Ts>
    void add_all(const Ts&... values) {
        (add(values), ...);
    }
    std::uint64_t value() const { return XXH3_64bits_digest(&state_); }

  private:
    XXH3_state_t state_;
};

void add(Hash& hash, const TextureRef& t) {
    hash.add_all(t.texture, t.uv_set, t.uv_transform[0], t.uv_transform[1]);
}

void add(Hash& hash, const Material& m) {
    hash.add_all(m.base_colour, m.metallic, m.roughness, m.emissive, m.normal_scale, m.occlusion_strength,
                 m.alpha_mode, m.alpha_cutoff, m.double_sided, m.unlit, m.ior, m.specular, m.specular_colour,
                 m.transmission);
    for (const TextureRef* t :
         {&m.base_colour_texture, &m.metallic_roughness_texture, &m.normal_texture, &m.occlusion_texture,
          &m.emissive_texture, &m.specular_texture, &m.specular_colour_texture, &m.transmission_texture}) {
        add(hash, *t);
    }
}

void add(Hash& hash, const SceneAssets& assets) {
    for (const Mesh& mesh : assets.meshes) {
        hash.add_all(mesh.vertices.size(), mesh.indices.size(), mesh.material);
        static_assert(sizeof(Vertex) == 18 * sizeof(float), "no padding");
        hash.bytes(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
        hash.bytes(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
    }
    for (const Material& m : assets.materials) {
        add(hash, m);
    }
    for (const Texture& t : assets.textures) {
        hash.add_all(t.image, t.sampler.wrap_s, t.sampler.wrap_t, t.sampler.mag);
    }
    for (const Image& image : assets.images) {
        hash.add_all(image.width, image.height);
        hash.bytes(image.rgba.data(), image.rgba.size());
    }
}

void add(Hash& hash, const FrameScene& scene) {
    add(hash, *scene.assets);
    for (const Instance& instance : scene.instances) {
        hash.add_all(instance.mesh, instance.transform);
        if (instance.deformed != Instance::kNotDeformed) {
            const auto& vertices = *scene.deformed[instance.deformed].vertices;
            static_assert(sizeof(VertexFrame) == 10 * sizeof(float), "no padding");
            hash.bytes(vertices.data(), vertices.size() * sizeof(VertexFrame));
        }
    }
    for (const LightInstance& light : scene.lights) {
        const Light& l = light.light;
        hash.add_all(l.type, l.colour, l.intensity, l.range, l.inner_cone, l.outer_cone, light.position,
                     light.direction);
    }
    const Camera& c = scene.camera.camera;
    hash.add_all(c.orthographic, c.y_fov, c.x_mag, c.y_mag, c.z_near, c.z_far, scene.camera.view,
                 scene.camera.position);
}

}  // namespace

std::uint64_t scene_hash(const FrameScene& scene) {
    Hash hash;
    add(hash, scene);
    return hash.value();
}

std::uint64_t sample_hash(const FrameScene& scene, ivec2 size, const PathSettings& settings) {
    Hash hash;
    add(hash, scene);
    hash.add_all(size, settings.transport, settings.unlimited, settings.antialias,
                 settings.unlimited ? 0 : settings.bounces, settings.seed);
    return hash.value();
}

}  // namespace lanthorn::reference
