#include "lanthorn/render/scene_geometry.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "engine/render/coarse_shapes.h"

namespace lanthorn::render {

namespace {

struct VertexConstants {
    vec2 uv0, uv1;
    vec4 colour;
};
constexpr GLuint kBeforeBuffer = 3, kBeforeLocation = 8;  // of the vertex array
static_assert(sizeof(VertexFrame) == 40 && sizeof(VertexConstants) == 32);

// A buffer of `elements`, each of `size` bytes, that begins with what `before` holds.
gpu::Buffer grown(const gpu::Buffer& before, std::size_t elements, std::size_t size) {
    gpu::Buffer buffer(elements * size);
    if (before && before.bytes() > 0) {
        glCopyNamedBufferSubData(before.id(), buffer.id(), 0, 0, static_cast<GLsizeiptr>(before.bytes()));
    }
    return buffer;
}

}  // namespace

SceneGeometry::~SceneGeometry() {
    glDeleteVertexArrays(1, &vertex_array_);
}

std::vector<SceneGeometry::Deformed> SceneGeometry::list_deformed(const FrameScene& scene) {
    std::vector<Deformed> list;
    for (const Instance& instance : scene.instances) {
        if (instance.deformed == Instance::kNotDeformed) {
            continue;
        }
        const DeformedMesh& mesh = scene.deformed[instance.deformed];
        Deformed& entry = list.emplace_back();
        entry.id = instance.id;
        entry.mesh = instance.mesh;
        entry.mesh_version = scene.assets->meshes.version(instance.mesh).any;
        entry.topology = mesh.refined ? mesh.refined->serial : 0;
        entry.vertex_count = mesh.vertices->size();
    }
    return list;
}

void SceneGeometry::update(const FrameScene& scene) {
    uploaded_bytes_ = 0;
    const SceneAssets& assets = *scene.assets;
    const bool other_assets = assets.serial != serial_;
    const bool first = serial_ == 0;
    if (other_assets) {
        drop_meshes(assets);
        serial_ = assets.serial;
    }
    follow_deformed(scene);

    moved_.resize(meshes_.size(), false);
    if (!first) {
        follow_movers(scene);
    }
    std::vector<Wanted> wanted = follow_triangles(scene);

    // All that is missing, in one growth at most.
    std::size_t vertices = 0, indices = 0;
    const auto missing = [&](std::size_t slot) {
        return assets.meshes.has(slot) && meshes_[slot].version != assets.meshes.version(slot).any;
    };
    for (std::size_t slot = 0; other_assets && slot < meshes_.size(); ++slot) {
        vertices += missing(slot) ? assets.meshes[slot].vertices.size() : 0;
    }
    for (const Deformed& deformed : deformed_) {
        vertices += deformed.version == 0 ? deformed.vertex_count : 0;
    }
    for (const Wanted& list : wanted) {
        indices += list.indices.size();
    }
    reserve(vertices, indices);
    if (keeps_before_ && before_.bytes() < frames_.bytes()) {
        before_ = gpu::Buffer(frames_.bytes());
    }
    bent_.assign(scene.instances.size(), false);

    for (Wanted& list : wanted) {
        const std::size_t first = take_indices(list.indices.size());
        list.list->first = first;
        list.list->count = list.indices.size();
        for (Level& level : list.list->levels) {
            level.first_index += static_cast<std::uint32_t>(first);
        }
        indices_.write(first * sizeof(std::uint32_t), std::span<const std::uint32_t>(list.indices));
        uploaded_bytes_ += list.indices.size() * sizeof(std::uint32_t);
    }
    for (std::size_t slot = 0; other_assets && slot < meshes_.size(); ++slot) {
        if (missing(slot)) {
            const InstanceShape shape(assets.meshes[slot]);
            meshes_[slot].version = assets.meshes.version(slot).any;
            meshes_[slot].block = take_vertices(shape.vertex_count());
            upload(meshes_[slot].block, shape);
        }
    }
    auto deformed = deformed_.begin();
    ranges_.resize(scene.instances.size());
    levels_.resize(scene.instances.size());
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const bool deforms = instance.deformed != Instance::kNotDeformed;
        if (deforms && deformed->version == 0) {
            const InstanceShape shape(scene, instance);
            deformed->block = take_vertices(shape.vertex_count());
            upload(deformed->block, shape);
        } else if (deforms && deformed->version != instance.version) {
            const std::span<const VertexFrame> frames(*scene.deformed[instance.deformed].vertices);
            if (keeps_before_) {
                const auto first = static_cast<GLintptr>(deformed->block.first * sizeof(VertexFrame));
                glCopyNamedBufferSubData(frames_.id(), before_.id(), first, first,
                                         static_cast<GLsizeiptr>(frames.size_bytes()));
                bent_[i] = true;
            }
            frames_.write(deformed->block.first * sizeof(VertexFrame), frames);
            uploaded_bytes_ += frames.size_bytes();
        }
        const Block& block = deforms ? deformed->block : meshes_[instance.mesh].block;
        const IndexList& list = deforms ? *deformed->triangles : *meshes_[instance.mesh].triangles;
        ranges_[i] = {static_cast<std::uint32_t>(list.first), static_cast<std::uint32_t>(list.own),
                      static_cast<std::int32_t>(block.first)};
        levels_[i] = &list.levels;
        if (deforms) {
            deformed++->version = instance.version;
        }
    }
}

// Which meshes have things that move: rigid ones have coarser levels from then on.
void SceneGeometry::follow_movers(const FrameScene& scene) {
    std::vector<bool> arrived(scene.instances.size(), false);
    for (const std::uint32_t i : scene.changes.arrived) {
        arrived[i] = true;
    }
    for (const std::uint32_t i : scene.changes.moved) {
        const std::uint32_t mesh = scene.instances[i].mesh;
        moved_[mesh] = moved_[mesh] || !arrived[i];
    }
}

SceneGeometry::IndexList* SceneGeometry::list_for(const FrameScene& scene, const InstanceShape& shape,
                                                  const Topology& topology, bool coarsened,
                                                  std::vector<Wanted>& wanted) {
    IndexList& list = triangles_[topology];
    list.used = true;
    const bool present = list.count > 0 || list.own > 0;
    if (present && (list.has_levels || !coarsened)) {
        return &list;
    }
    index_places_.give_back(list.first, list.count);
    list = {};
    list.own = shape.indices().size();
    list.has_levels = coarsened;
    list.used = true;
    std::vector<std::uint32_t> indices(shape.indices().begin(), shape.indices().end());
    if (coarsened) {
        const auto textures = scene.assets->materials[shape.mesh().material].textures();
        const bool textured = std::ranges::any_of(textures, [](const auto* t) { return t->present(); });
        for (const CoarseLevel& level : coarser_levels(shape, textured)) {
            list.levels.push_back({static_cast<std::uint32_t>(indices.size()),
                                   static_cast<std::uint32_t>(level.indices.size()), level.error,
                                   level.edge});
            indices.insert(indices.end(), level.indices.begin(), level.indices.end());
        }
    }
    std::erase_if(wanted, [&](const Wanted& w) { return w.list == &list; });
    wanted.push_back({&list, std::move(indices)});
    return &list;
}

std::vector<SceneGeometry::Wanted> SceneGeometry::follow_triangles(const FrameScene& scene) {
    for (auto& [topology, list] : triangles_) {
        list.used = false;
    }
    std::vector<Wanted> wanted;
    const SceneAssets& assets = *scene.assets;
    for (std::uint32_t slot = 0; slot < meshes_.size(); ++slot) {
        if (assets.meshes.has(slot)) {
            const Topology topology(0, slot, assets.meshes.version(slot).any);
            meshes_[slot].triangles =
                list_for(scene, InstanceShape(assets.meshes[slot]), topology, moved_[slot], wanted);
        }
    }
    auto deformed = deformed_.begin();
    for (const Instance& instance : scene.instances) {
        if (instance.deformed == Instance::kNotDeformed) {
            continue;
        }
        // Of the mesh's own triangles the bind pose decides, not the first one that is seen.
        const bool own = deformed->topology == 0;
        const InstanceShape shape =
            own ? InstanceShape(scene.mesh(instance)) : InstanceShape(scene, instance);
        deformed->triangles = list_for(
            scene, shape,
            own ? Topology(0, deformed->mesh, deformed->mesh_version) : Topology(deformed->topology, 0, 0),
            true, wanted);
        ++deformed;
    }
    for (auto it = triangles_.begin(); it != triangles_.end();) {
        if (it->second.used) {
            ++it;
        } else {
            index_places_.give_back(it->second.first, it->second.count);
            it = triangles_.erase(it);
        }
    }
    return wanted;
}

// Gives back the places of meshes that are gone or of another version.
void SceneGeometry::drop_meshes(const SceneAssets& assets) {
    meshes_.resize(std::max(meshes_.size(), assets.meshes.size()));
    for (std::size_t slot = 0; slot < meshes_.size(); ++slot) {
        Kept& kept = meshes_[slot];
        const bool same = assets.meshes.has(slot) && assets.meshes.version(slot).any == kept.version;
        if (kept.version != 0 && !same) {
            give_back(kept.block);
            kept = {};
        }
    }
    meshes_.resize(assets.meshes.size());
}

// Lists those of this frame; what has kept its topology keeps its place.
void SceneGeometry::follow_deformed(const FrameScene& scene) {
    std::vector<Deformed> before = std::exchange(deformed_, list_deformed(scene));
    auto old = before.begin();
    for (Deformed& now : deformed_) {
        const std::pair key(now.id, now.mesh);
        for (; old != before.end() && std::pair(old->id, old->mesh) < key; ++old) {
            give_back(old->block);
        }
        if (old != before.end() && std::pair(old->id, old->mesh) == key) {
            if (now.same_topology(*old)) {
                now = *old;
            } else {
                give_back(old->block);
            }
            ++old;
        }
    }
    for (; old != before.end(); ++old) {
        give_back(old->block);
    }
}

void SceneGeometry::reserve(std::size_t vertices, std::size_t indices) {
    const auto wanted = [](const RangeAllocator& places, std::size_t count) {
        if (count <= places.free()) {
            return places.capacity();
        }
        const std::size_t least = places.capacity() + count - places.free();
        return std::max(least, places.capacity() + places.capacity() / 2);
    };
    grow(wanted(vertices_, vertices), wanted(index_places_, indices));
}

void SceneGeometry::grow(std::size_t vertices, std::size_t indices) {
    const bool more_vertices = !frames_ || vertices > vertices_.capacity();
    const bool more_indices = !indices_ || indices > index_places_.capacity();
    if (more_vertices) {
        frames_ = grown(frames_, vertices, sizeof(VertexFrame));
        constants_ = grown(constants_, vertices, sizeof(VertexConstants));
        if (keeps_before_) {
            before_ = grown(before_, vertices, sizeof(VertexFrame));
        }
        vertices_.grow(vertices);
    }
    if (more_indices) {
        indices_ = grown(indices_, indices, sizeof(std::uint32_t));
        index_places_.grow(indices);
    }
    if (more_vertices || more_indices) {
        make_vertex_array();
    }
}

// What is free may lie in pieces that are too small: then the buffer grows by what is wanted.
SceneGeometry::Block SceneGeometry::take_vertices(std::size_t count) {
    std::optional<std::size_t> first = vertices_.take(count);
    if (!first) {
        grow(vertices_.capacity() + count, index_places_.capacity());
        first = vertices_.take(count);
    }
    return {*first, count};
}

std::size_t SceneGeometry::take_indices(std::size_t count) {
    std::optional<std::size_t> first = index_places_.take(count);
    if (!first) {
        grow(vertices_.capacity(), index_places_.capacity() + count);
        first = index_places_.take(count);
    }
    return *first;
}

void SceneGeometry::upload(const Block& block, const InstanceShape& shape) {
    std::vector<VertexFrame> frames;
    std::vector<VertexConstants> constants;
    frames.reserve(block.count);
    constants.reserve(block.count);
    for (std::size_t v = 0; v < block.count; ++v) {
        const Vertex vertex = shape.vertex(v);
        frames.push_back({vertex.position, vertex.normal, vertex.tangent});
        constants.push_back({vertex.uv0, vertex.uv1, vertex.colour});
    }
    frames_.write(block.first * sizeof(VertexFrame), std::span<const VertexFrame>(frames));
    constants_.write(block.first * sizeof(VertexConstants), std::span<const VertexConstants>(constants));
    uploaded_bytes_ += block.count * (sizeof(VertexFrame) + sizeof(VertexConstants));
}

void SceneGeometry::make_vertex_array() {
    struct Attribute {
        GLint components;
        GLuint binding;
        std::size_t offset;
    };
    constexpr Attribute kAttributes[] = {
        {3, 0, offsetof(VertexFrame, position)}, {3, 0, offsetof(VertexFrame, normal)},
        {4, 0, offsetof(VertexFrame, tangent)},  {2, 1, offsetof(VertexConstants, uv0)},
        {2, 1, offsetof(VertexConstants, uv1)},  {4, 1, offsetof(VertexConstants, colour)}};
    glDeleteVertexArrays(1, &vertex_array_);
    glCreateVertexArrays(1, &vertex_array_);
    GLuint location = 0;
    for (const Attribute& a : kAttributes) {
        glEnableVertexArrayAttrib(vertex_array_, location);
        glVertexArrayAttribFormat(vertex_array_, location, a.components, GL_FLOAT, GL_FALSE,
                                  static_cast<GLuint>(a.offset));
        glVertexArrayAttribBinding(vertex_array_, location++, a.binding);
    }
    glVertexArrayVertexBuffer(vertex_array_, 0, frames_.id(), 0, sizeof(VertexFrame));
    glVertexArrayVertexBuffer(vertex_array_, 1, constants_.id(), 0, sizeof(VertexConstants));
    glVertexArrayAttribFormat(vertex_array_, kBeforeLocation, 3, GL_FLOAT, GL_FALSE,
                              offsetof(VertexFrame, position));
    glVertexArrayAttribBinding(vertex_array_, kBeforeLocation, kBeforeBuffer);
    glVertexArrayElementBuffer(vertex_array_, indices_.id());
}

void SceneGeometry::bind_before(bool bent) const {
    glVertexArrayVertexBuffer(vertex_array_, kBeforeBuffer, (bent ? before_ : frames_).id(), 0,
                              sizeof(VertexFrame));
    glEnableVertexArrayAttrib(vertex_array_, kBeforeLocation);
}

void SceneGeometry::unbind_before() const {
    glDisableVertexArrayAttrib(vertex_array_, kBeforeLocation);
}

}  // namespace lanthorn::render
