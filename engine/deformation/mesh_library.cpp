#include "engine/deformation/mesh_library.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <map>
#include <utility>

#include "engine/deformation/serials.h"

namespace lanthorn::deform {
namespace {

// Collects bytes; plain arrays of numbers alone, whose types have no padding.
class Digest {
  public:
    Digest() : state_(XXH3_createState(), &XXH3_freeState) { XXH3_128bits_reset(state_.get()); }
    template <class T>
    void add(const std::vector<T>& values) {
        const std::uint64_t count = values.size();
        XXH3_128bits_update(state_.get(), &count, sizeof count);
        XXH3_128bits_update(state_.get(), values.data(), values.size() * sizeof(T));
    }
    std::array<std::uint64_t, 2> value() const {
        const XXH128_hash_t hash = XXH3_128bits_digest(state_.get());
        return {hash.low64, hash.high64};
    }

  private:
    std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state_;
};

static_assert(sizeof(Vertex) == 18 * sizeof(float));
static_assert(sizeof(SkinInfluences) == SkinInfluences::kMost * (sizeof(std::uint16_t) + sizeof(float)));
static_assert(sizeof(SubdivisionCrease) == 3 * sizeof(float));

std::array<std::uint64_t, 2> key_of(const Mesh& mesh) {
    Digest digest;
    digest.add(mesh.vertices);
    digest.add(mesh.indices);
    digest.add(mesh.skin);
    digest.add(mesh.morph_weights);
    for (const MorphTarget& target : mesh.morphs) {
        digest.add(target.vertices);
        digest.add(target.positions);
        digest.add(target.normals);
        digest.add(target.tangents);
    }
    if (mesh.cage) {
        digest.add(
            std::vector<std::uint32_t>{static_cast<std::uint32_t>(mesh.cage->scheme), mesh.cage->level});
        digest.add(mesh.cage->face_sizes);
        digest.add(mesh.cage->creases);
    }
    return digest.value();
}

}  // namespace

void MeshLibrary::follow(const SceneAssets& assets) {
    if (serial_ == assets.serial) {
        return;
    }
    serial_ = assets.serial;
    std::map<std::array<std::uint64_t, 2>, std::shared_ptr<const PreparedMesh>> known;
    for (const Entry& entry : entries_) {
        if (entry.prepared) {
            known.emplace(entry.prepared->key, entry.prepared);
        }
    }
    entries_.resize(assets.meshes.size());
    for (std::size_t slot = 0; slot < entries_.size(); ++slot) {
        Entry& entry = entries_[slot];
        if (!assets.meshes.has(slot)) {
            entry = {};
            continue;
        }
        const std::uint64_t version = assets.meshes.version(slot).any;
        if (entry.version == version) {
            continue;
        }
        entry = {version, assets.meshes.handle(slot).generation, nullptr, nullptr, nullptr};
        const std::shared_ptr<const Mesh>& mesh = assets.meshes.shared(slot);
        if (!mesh->deforms() || mesh->vertices.empty() || mesh->indices.empty()) {
            continue;
        }
        ++looked_at_;
        const auto key = key_of(*mesh);
        auto& prepared = known[key];
        if (!prepared) {
            prepared = std::make_shared<const PreparedMesh>(
                PreparedMesh{key, mesh->name, pack(*mesh), mesh->bounds,
                             mesh->cage ? std::make_shared<SubdivisionSurface>(*mesh) : nullptr});
        }
        entry.mesh = mesh;
        entry.prepared = prepared;
    }
}

const std::shared_ptr<const PreparedMesh>& MeshLibrary::find(MeshHandle mesh) const {
    static const std::shared_ptr<const PreparedMesh> none;
    return mesh.slot < entries_.size() && entries_[mesh.slot].generation == mesh.generation
               ? entries_[mesh.slot].prepared
               : none;
}

std::shared_ptr<const RefinedTopology> MeshLibrary::turned(std::uint32_t slot) {
    auto& turned = entries_.at(slot).turned;
    if (turned) {
        return turned;
    }
    const Mesh& source = *entries_[slot].mesh;
    auto topology = std::make_shared<RefinedTopology>();
    topology->serial = next_serial();
    for (const Vertex& v : source.vertices) {
        topology->uv0.push_back(v.uv0);
        topology->uv1.push_back(v.uv1);
        topology->colours.push_back(v.colour);
    }
    topology->indices = source.indices;
    for (std::size_t i = 0; i + 2 < topology->indices.size(); i += 3) {
        std::swap(topology->indices[i + 1], topology->indices[i + 2]);
    }
    turned = std::move(topology);
    return turned;
}

}  // namespace lanthorn::deform
