#include "engine/scene/scene_digest.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <cstddef>
#include <cstring>
#include <type_traits>

namespace lanthorn {

namespace {

// Takes values field by field, so that padding never counts; vectors with their lengths.
class Digest {
  public:
    Digest() { XXH3_128bits_reset(&state_); }

    template <class... Ts>
    void add_all(const Ts&... values) {
        (add(values), ...);
    }
    template <class T>
    requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) void add(T value) { bytes(&value, sizeof value); }
    void add(const std::string& text) {
        add(text.size());
        bytes(text.data(), text.size());
    }
    template <glm::length_t n, class T>
    void add(const glm::vec<n, T>& v) {
        bytes(&v, sizeof v);
    }
    template <glm::length_t n, class T>
    void add(const glm::mat<n, n, T>& m) {
        bytes(&m, sizeof m);
    }
    void add(const quat& q) { bytes(&q, sizeof q); }
    template <class T>
    void add(const std::vector<T>& values) {
        add(values.size());
        if constexpr (kPlain<T>) {
            bytes(values.data(), values.size() * sizeof(T));
        } else {
            for (const T& value : values) {
                add(value);
            }
        }
    }

    void add(const TextureRef& t) { add_all(t.texture, t.uv_set, t.uv_transform[0], t.uv_transform[1]); }
    void add(const Material& m) {
        add_all(m.name, m.base_colour, m.metallic, m.roughness, m.emissive, m.normal_scale,
                m.occlusion_strength, m.alpha_mode, m.alpha_cutoff, m.double_sided, m.unlit, m.ior,
                m.specular, m.specular_colour, m.transmission, m.thickness, m.attenuation_distance,
                m.attenuation_colour);
        for (const TextureRef* t : m.textures()) {
            add(*t);
        }
    }
    void add(const Sampler& s) { add_all(s.wrap_s, s.wrap_t, s.mag, s.min, s.mipmaps); }
    void add(const Texture& t) { add_all(t.image, t.sampler); }
    void add(const Image& i) { add_all(i.name, i.width, i.height, i.rgba); }
    void add(const MorphTarget& t) { add_all(t.vertices, t.positions, t.normals, t.tangents); }
    void add(const SubdivisionCage& c) { add_all(c.scheme, c.level, c.face_sizes, c.creases); }
    void add(const Mesh& m) {
        add_all(m.name, m.vertices, m.indices, m.material, m.bounds.lower, m.bounds.upper, m.skin, m.morphs,
                m.morph_weights, m.cage.has_value());
        if (m.cage) {
            add(*m.cage);
        }
    }
    void add(const NodeData& n) {
        add_all(n.name, n.parent, n.local.translation, n.local.rotation, n.local.scale, n.shear, n.meshes,
                n.camera, n.light, n.skin, n.sky, n.morph_weights, n.extras);
    }
    void add(const FileMap::Primitive& p) { add_all(p.mesh, p.primitive); }
    void add(const FileMap& f) {
        add_all(f.nodes, f.cameras, f.lights, f.materials, f.textures, f.images, f.meshes);
    }
    void add(const Camera& c) { add_all(c.orthographic, c.y_fov, c.x_mag, c.y_mag, c.z_near, c.z_far); }
    void add(const Light& l) { add_all(l.type, l.colour, l.intensity, l.range, l.inner_cone, l.outer_cone); }
    void add(const std::shared_ptr<const SkyImage>& image) {
        add(image != nullptr);
        if (image) {
            add_all(image->name, image->width, image->height, image->radiance);
        }
    }
    void add(const Sky& s) { add_all(s.image, s.light, s.colour, s.intensity); }
    void add(const Skin& s) { add_all(s.name, s.joints, s.inverse_binds); }
    void add(const AnimationChannel& c) {
        add_all(c.node, c.path, c.interpolation, c.width, c.times, c.values);
    }
    void add(const PropertyChannel& c) {
        add_all(c.property, c.object, c.nodes, c.keys);
        bytes(c.rest.data(), sizeof c.rest);
    }
    void add(const AnimationClip& c) { add_all(c.name, c.duration, c.channels, c.properties); }

    SceneDigest value() {
        flush();
        const XXH128_hash_t hash = XXH3_128bits_digest(&state_);
        return {hash.low64, hash.high64};
    }

  private:
    // Numbers without padding between them.
    template <class T>
    static constexpr bool kPlain =
        std::is_arithmetic_v<T> || std::is_same_v<T, vec2> || std::is_same_v<T, vec3> ||
        std::is_same_v<T, vec4> || std::is_same_v<T, mat4> || std::is_same_v<T, Vertex> ||
        std::is_same_v<T, SkinInfluences> || std::is_same_v<T, SubdivisionCrease>;
    static_assert(sizeof(Vertex) == 18 * sizeof(float));
    static_assert(sizeof(SkinInfluences) == SkinInfluences::kMost * (sizeof(std::uint16_t) + sizeof(float)));
    static_assert(sizeof(SubdivisionCrease) == 3 * sizeof(float));

    // Most values are a few bytes, and update() is a call: they go to it by the kilobyte.
    void bytes(const void* data, std::size_t size) {
        if (size > gathered_.size() - used_) {
            flush();
        }
        if (size > gathered_.size()) {
            XXH3_128bits_update(&state_, data, size);
        } else if (size > 0) {
            std::memcpy(gathered_.data() + used_, data, size);
            used_ += size;
        }
    }
    void flush() {
        XXH3_128bits_update(&state_, gathered_.data(), used_);
        used_ = 0;
    }

    XXH3_state_t state_;
    std::array<std::byte, 1024> gathered_;
    std::size_t used_ = 0;
};

}  // namespace

SceneDigest scene_digest(const SceneData& scene) {
    Digest digest;
    digest.add_all(scene.file, scene.nodes, scene.meshes, scene.materials, scene.textures, scene.images,
                   scene.cameras, scene.lights, scene.skies, scene.skins, scene.animations);
    return digest.value();
}

}  // namespace lanthorn
