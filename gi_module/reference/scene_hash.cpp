#include "gi_module/reference/scene_hash.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <type_traits>
#include <vector>

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

void add(Hash& hash, const Material& m, const std::vector<std::uint32_t>& texture_ranks) {
    hash.add_all(m.base_colour, m.metallic, m.roughness, m.emissive, m.normal_scale, m.occlusion_strength,
                 m.alpha_mode, m.alpha_cutoff, m.double_sided, m.unlit, m.ior, m.specular, m.specular_colour,
                 m.transmission, m.thickness, m.attenuation_distance, m.attenuation_colour);
    for (const TextureRef* t : m.textures()) {
        hash.add_all(t->present() ? texture_ranks[t->texture] : kNoTexture, t->uv_set, t->uv_transform[0],
                     t->uv_transform[1]);
    }
}

// Slots are counted without the free ones, so that only content matters.
template <class T>
std::vector<std::uint32_t> ranks(const AssetTable<T>& table) {
    std::vector<std::uint32_t> ranks(table.size());
    std::uint32_t next = 0;
    for (std::size_t slot = 0; slot < table.size(); ++slot) {
        ranks[slot] = table.has(slot) ? next++ : next;
    }
    return ranks;
}

template <class T, class Add>
void add_each(const AssetTable<T>& table, const Add& add) {
    for (std::size_t slot = 0; slot < table.size(); ++slot) {
        if (table.has(slot)) {
            add(table[slot]);
        }
    }
}

void add(Hash& hash, const SceneAssets& assets) {
    const std::vector<std::uint32_t> materials = ranks(assets.materials);
    const std::vector<std::uint32_t> textures = ranks(assets.textures);
    const std::vector<std::uint32_t> images = ranks(assets.images);
    add_each(assets.meshes, [&](const Mesh& mesh) {
        hash.add_all(mesh.vertices.size(), mesh.indices.size(), materials[mesh.material]);
        static_assert(sizeof(Vertex) == 18 * sizeof(float), "no padding");
        hash.bytes(mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
        hash.bytes(mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
    });
    add_each(assets.materials, [&](const Material& m) { add(hash, m, textures); });
    add_each(assets.textures, [&](const Texture& t) {
        hash.add_all(images[t.image], t.sampler.wrap_s, t.sampler.wrap_t, t.sampler.mag);
    });
    add_each(assets.images, [&](const Image& image) {
        hash.add_all(image.width, image.height);
        hash.bytes(image.rgba.data(), image.rgba.size());
    });
}

void add(Hash& hash, const FrameScene& scene) {
    add(hash, *scene.assets);
    const std::vector<std::uint32_t> meshes = ranks(scene.assets->meshes);
    for (const Instance& instance : scene.instances) {
        hash.add_all(meshes[instance.mesh], instance.transform);
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
    if (scene.sky) {
        const SkyInstance& sky = *scene.sky;
        hash.add_all(sky.scale(), sky.to_sky[0], sky.to_sky[1], sky.to_sky[2]);
        for (const auto& image : {sky.sky.image, sky.sky.lights_by()}) {
            hash.add_all(image->width, image->height);
            hash.bytes(image->radiance.data(), image->radiance.size() * sizeof(vec3));
        }
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
    hash.add_all(size, settings.transport, settings.caustics, settings.unlimited, settings.antialias,
                 settings.unlimited ? 0 : settings.bounces, settings.seed);
    return hash.value();
}

}  // namespace lanthorn::reference
