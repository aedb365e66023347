#include "tools/workbench/measure/scene_memory.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <set>

#include "engine/gpu/memory.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/render/gbuffer.h"
#include "lanthorn/render/light_maps.h"

namespace lanthorn::workbench {

namespace {

constexpr std::size_t kVertexOnGpu = sizeof(VertexFrame) + 32;  // what deforms, and what stays of a vertex
constexpr std::size_t kTexel = 4;
// Of Material::textures(): which are colours, stored as sRGB.
constexpr std::array<bool, 8> kIsColour{true, false, false, false, true, false, true, false};

std::uint64_t bytes_of(const Mesh& mesh) {
    std::uint64_t bytes = mesh.vertices.size() * sizeof(Vertex) +
                          mesh.indices.size() * sizeof(std::uint32_t) +
                          mesh.skin.size() * sizeof(SkinInfluences);
    for (const MorphTarget& morph : mesh.morphs) {
        bytes += morph.vertices.size() * sizeof(std::uint32_t) +
                 (morph.positions.size() + morph.normals.size() + morph.tangents.size()) * sizeof(vec3);
    }
    return bytes;
}

std::uint64_t with_mipmaps(const Image& image) {
    std::uint64_t texels = 0;
    for (std::uint64_t x = std::max(image.width, 1u), y = std::max(image.height, 1u);;
         x = std::max<std::uint64_t>(x / 2, 1), y = std::max<std::uint64_t>(y / 2, 1)) {
        texels += x * y;
        if (x == 1 && y == 1) {
            return texels * kTexel;
        }
    }
}

void sort_by_gpu(std::vector<AssetBytes>& assets) {
    std::ranges::stable_sort(assets, std::greater(), &AssetBytes::gpu);
}

std::uint64_t sum_of(const std::vector<AssetBytes>& assets) {
    std::uint64_t sum = 0;
    for (const AssetBytes& asset : assets) {
        sum += asset.gpu;
    }
    return sum;
}

std::uint64_t shadow_bytes(const render::LightMaps& maps) {
    std::uint64_t sum = maps.still_bytes();
    for (const gpu::Texture* texture :
         {&maps.distance(), &maps.normals(), &maps.albedo(), &maps.area_distance(), &maps.area_normals()}) {
        sum += texture->bytes();
    }
    return sum;
}

std::uint64_t gbuffer_bytes(const render::GBuffer& gbuffer) {
    std::uint64_t sum = 0;
    for (const gpu::Texture* texture : {&gbuffer.distance(), &gbuffer.normals(), &gbuffer.albedo(),
                                        &gbuffer.material(), &gbuffer.emissive(), &gbuffer.depth()}) {
        sum += texture->bytes();
    }
    return sum;
}

// As unsigned: what has been given back since may be more than what was taken.
std::uint64_t at_least_none(std::int64_t bytes) {
    return static_cast<std::uint64_t>(std::max<std::int64_t>(bytes, 0));
}

}  // namespace

std::vector<AssetBytes> mesh_bytes(const FrameScene& scene) {
    const AssetTable<Mesh>& meshes = scene.assets->meshes;
    std::map<std::uint32_t, std::uint64_t> deformed;  // by mesh
    std::set<std::uint64_t> topologies;
    for (const Instance& instance : scene.instances) {
        if (instance.deformed == Instance::kNotDeformed) {
            continue;
        }
        const DeformedMesh& shape = scene.deformed[instance.deformed];
        std::uint64_t& bytes = deformed[instance.mesh];
        bytes += shape.vertices->size() * kVertexOnGpu;
        if (shape.refined && topologies.insert(shape.refined->serial).second) {
            bytes += shape.refined->indices.size() * sizeof(std::uint32_t);
        }
    }
    std::vector<AssetBytes> list;
    for (std::uint32_t slot = 0; slot < meshes.size(); ++slot) {
        if (meshes.has(slot)) {
            const Mesh& mesh = meshes[slot];
            const auto more = deformed.find(slot);
            list.push_back({mesh.name.empty() ? fmt::format("mesh {}", slot) : mesh.name,
                            fmt::format("{} triangles{}", mesh.indices.size() / 3,
                                        more != deformed.end() ? ", deforms" : ""),
                            mesh.vertices.size() * kVertexOnGpu +
                                mesh.indices.size() * sizeof(std::uint32_t) +
                                (more != deformed.end() ? more->second : 0),
                            bytes_of(mesh)});
        }
    }
    sort_by_gpu(list);
    return list;
}

std::vector<AssetBytes> image_bytes(const SceneAssets& assets) {
    std::set<std::pair<std::uint32_t, bool>> used;  // by image, and whether it is colour
    for (std::uint32_t slot = 0; slot < assets.materials.size(); ++slot) {
        if (!assets.materials.has(slot)) {
            continue;
        }
        const auto textures = assets.materials[slot].textures();
        for (std::size_t i = 0; i < textures.size(); ++i) {
            if (textures[i]->present()) {
                used.emplace(assets.textures[textures[i]->texture].image, kIsColour[i]);
            }
        }
    }
    std::vector<AssetBytes> list;
    for (std::uint32_t slot = 0; slot < assets.images.size(); ++slot) {
        if (assets.images.has(slot)) {
            const Image& image = assets.images[slot];
            const std::uint64_t times = used.count({slot, true}) + used.count({slot, false});
            list.push_back({image.name.empty() ? fmt::format("image {}", slot) : image.name,
                            fmt::format("{}x{}{}", image.width, image.height,
                                        times == 0   ? ", unused"
                                        : times == 2 ? ", as colour and as data"
                                                     : ""),
                            times * with_mipmaps(image), image.rgba.size()});
        }
    }
    sort_by_gpu(list);
    return list;
}

SceneMemory scene_memory(const FrameScene& scene, const render::FrameRenderer& renderer,
                         const gi::GiStatistics& statistics, const FrameMeter::Held& held) {
    SceneMemory memory;
    memory.meshes = mesh_bytes(scene);
    memory.images = image_bytes(*scene.assets);
    memory.gpu = gpu::allocated_bytes();
    const auto& emc = statistics.of<gi::EmcStatistics>();
    const auto& gather = statistics.of<gi::GatherStatistics>();
    memory.lit_texels = gather.lit_texels;
    memory.remembered_rays = gather.remembered;
    memory.maps = emc.k + emc.reserved;
    const std::uint64_t of_maps = emc.map_bytes + emc.kept_bytes;
    memory.parts = {
        {"meshes", "vertices and triangles", sum_of(memory.meshes)},
        {"textures", "images with their mipmaps", sum_of(memory.images)},
        {"shadow maps", "what lamps see, which are photon emission maps too",
         shadow_bytes(renderer.light_maps())},
        {"G-buffer", "what the camera sees first", gbuffer_bytes(renderer.gbuffer())},
        {"environment maps", "what the technique's maps see", of_maps},
        {"light in the scene",
         "of the technique, without its maps: lit texels, their remembered rays, photons",
         at_least_none(held.scene - static_cast<std::int64_t>(of_maps))},
        {"light in the picture", "of the technique: the picture's remembered rays, filter, mirrors",
         at_least_none(held.picture)}};
    std::uint64_t named = 0;
    for (const SceneMemory::Part& part : memory.parts) {
        named += part.gpu;
    }
    memory.parts.push_back({"the rest", "the picture itself, direct light, sky, coarser shapes, tables",
                            memory.gpu - std::min(named, memory.gpu)});
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    memory.process = 1024 * static_cast<std::uint64_t>(usage.ru_maxrss);
    return memory;
}

}  // namespace lanthorn::workbench
