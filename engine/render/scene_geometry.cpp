#include "lanthorn/render/scene_geometry.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace lanthorn::render {

namespace {

struct VertexConstants {
    vec2 uv0, uv1;
    vec4 colour;
};
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
    if (other_assets) {
        drop_meshes(assets);
        serial_ = assets.serial;
    }
    follow_deformed(scene);

    // All that is missing, in one growth at most.
    std::size_t vertices = 0, indices = 0;
    const auto missing = [&](std::size_t slot) {
        return assets.meshes.has(slot) && meshes_[slot].version != assets.meshes.version(slot).any;
    };
    for (std::size_t slot = 0; other_assets && slot < meshes_.size(); ++slot) {
        if (missing(slot)) {
            vertices += assets.meshes[slot].vertices.size();
            indices += assets.meshes[slot].indices.size();
        }
    }
    const auto deformed_instances = [&](const auto& use) {
        auto deformed = deformed_.begin();
        for (const Instance& instance : scene.instances) {
            if (instance.deformed != Instance::kNotDeformed) {
                use(instance, *deformed++);
            }
        }
    };
    deformed_instances([&](const Instance& instance, const Deformed& deformed) {
        if (deformed.version == 0) {
            vertices += deformed.vertex_count;
            indices += InstanceShape(scene, instance).indices().size();
        }
    });
    reserve(vertices, indices);

    for (std::size_t slot = 0; other_assets && slot < meshes_.size(); ++slot) {
        if (missing(slot)) {
            const InstanceShape shape(assets.meshes[slot]);
            meshes_[slot] = {assets.meshes.version(slot).any,
                             take(shape.vertex_count(), shape.indices().size())};
            upload(meshes_[slot].block, shape);
        }
    }
    deformed_instances([&](const Instance& instance, Deformed& deformed) {
        if (deformed.version == 0) {
            const InstanceShape shape(scene, instance);
            deformed.block = take(shape.vertex_count(), shape.indices().size());
            upload(deformed.block, shape);
        } else if (deformed.version != instance.version) {
            const std::span<const VertexFrame> frames(*scene.deformed[instance.deformed].vertices);
            frames_.write(deformed.block.first_vertex * sizeof(VertexFrame), frames);
            uploaded_bytes_ += frames.size_bytes();
        }
        deformed.version = instance.version;
    });

    ranges_.resize(scene.instances.size());
    auto deformed = deformed_.begin();
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        ranges_[i] = instance.deformed == Instance::kNotDeformed ? meshes_[instance.mesh].block.range()
                                                                 : (deformed++)->block.range();
    }
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
SceneGeometry::Block SceneGeometry::take(std::size_t vertices, std::size_t indices) {
    std::optional<std::size_t> vertex = vertices_.take(vertices);
    if (!vertex) {
        grow(vertices_.capacity() + vertices, index_places_.capacity());
        vertex = vertices_.take(vertices);
    }
    std::optional<std::size_t> index = index_places_.take(indices);
    if (!index) {
        grow(vertices_.capacity(), index_places_.capacity() + indices);
        index = index_places_.take(indices);
    }
    return {*vertex, vertices, *index, indices};
}

void SceneGeometry::give_back(const Block& block) {
    vertices_.give_back(block.first_vertex, block.vertices);
    index_places_.give_back(block.first_index, block.indices);
}

void SceneGeometry::upload(const Block& block, const InstanceShape& shape) {
    std::vector<VertexFrame> frames;
    std::vector<VertexConstants> constants;
    frames.reserve(block.vertices);
    constants.reserve(block.vertices);
    for (std::size_t v = 0; v < block.vertices; ++v) {
        const Vertex vertex = shape.vertex(v);
        frames.push_back({vertex.position, vertex.normal, vertex.tangent});
        constants.push_back({vertex.uv0, vertex.uv1, vertex.colour});
    }
    frames_.write(block.first_vertex * sizeof(VertexFrame), std::span<const VertexFrame>(frames));
    constants_.write(block.first_vertex * sizeof(VertexConstants),
                     std::span<const VertexConstants>(constants));
    indices_.write(block.first_index * sizeof(std::uint32_t), shape.indices());
    uploaded_bytes_ += block.vertices * (sizeof(VertexFrame) + sizeof(VertexConstants)) +
                       block.indices * sizeof(std::uint32_t);
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
    glVertexArrayElementBuffer(vertex_array_, indices_.id());
}

}  // namespace lanthorn::render
