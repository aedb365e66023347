#include "lanthorn/render/scene_geometry.h"

#include <algorithm>
#include <cstddef>

#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::render {

namespace {

struct VertexConstants {
    vec2 uv0, uv1;
    vec4 colour;
};
static_assert(sizeof(VertexFrame) == 40 && sizeof(VertexConstants) == 32);

// Buffers as they are filled, from the front.
struct Upload {
    gpu::Buffer& frames;
    gpu::Buffer& constants;
    gpu::Buffer& indices;
    std::size_t vertices = 0, index_count = 0;

    template <class VertexOf>
    SceneGeometry::Range add(std::size_t count, std::span<const std::uint32_t> triangles,
                             const VertexOf& vertex_of) {
        std::vector<VertexFrame> f;
        std::vector<VertexConstants> c;
        f.reserve(count);
        c.reserve(count);
        for (std::size_t v = 0; v < count; ++v) {
            const Vertex& vertex = vertex_of(v);
            f.push_back({vertex.position, vertex.normal, vertex.tangent});
            c.push_back({vertex.uv0, vertex.uv1, vertex.colour});
        }
        frames.write(vertices * sizeof(VertexFrame), std::span<const VertexFrame>(f));
        constants.write(vertices * sizeof(VertexConstants), std::span<const VertexConstants>(c));
        indices.write(index_count * sizeof(std::uint32_t), triangles);
        const SceneGeometry::Range range{static_cast<std::uint32_t>(index_count),
                                         static_cast<std::uint32_t>(triangles.size()),
                                         static_cast<std::int32_t>(vertices)};
        vertices += count;
        index_count += triangles.size();
        return range;
    }
};

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
        list.push_back({instance.id,
                        instance.mesh,
                        mesh.refined ? mesh.refined->serial : 0,
                        mesh.vertices->size(),
                        0,
                        {}});
    }
    return list;
}

void SceneGeometry::update(const FrameScene& scene) {
    std::vector<Deformed> now = list_deformed(scene);
    if (scene.assets->serial != serial_ ||
        !std::ranges::equal(now, deformed_,
                            [](const Deformed& a, const Deformed& b) { return a.same_topology(b); })) {
        deformed_ = std::move(now);
        upload_all(scene);
        serial_ = scene.assets->serial;
    }
    ranges_.resize(scene.instances.size());
    auto deformed = deformed_.begin();
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        if (instance.deformed == Instance::kNotDeformed) {
            ranges_[i] = meshes_[instance.mesh];
            continue;
        }
        if (deformed->version != instance.version) {
            frames_.write(static_cast<std::size_t>(deformed->range.base_vertex) * sizeof(VertexFrame),
                          std::span<const VertexFrame>(*scene.deformed[instance.deformed].vertices));
            deformed->version = instance.version;
        }
        ranges_[i] = (deformed++)->range;
    }
}

void SceneGeometry::upload_all(const FrameScene& scene) {
    std::size_t vertices = 0, indices = 0;
    const AssetTable<Mesh>& meshes = scene.assets->meshes;
    for (std::size_t slot = 0; slot < meshes.size(); ++slot) {
        vertices += meshes.has(slot) ? meshes[slot].vertices.size() : 0;
        indices += meshes.has(slot) ? meshes[slot].indices.size() : 0;
    }
    for (const Instance& instance : scene.instances) {
        if (instance.deformed != Instance::kNotDeformed) {
            const InstanceShape shape(scene, instance);
            vertices += shape.vertex_count();
            indices += shape.indices().size();
        }
    }
    frames_ = gpu::Buffer(vertices * sizeof(VertexFrame));
    constants_ = gpu::Buffer(vertices * sizeof(VertexConstants));
    indices_ = gpu::Buffer(indices * sizeof(std::uint32_t));
    Upload upload{frames_, constants_, indices_};
    meshes_.clear();
    for (std::size_t slot = 0; slot < meshes.size(); ++slot) {
        const Mesh none;
        const Mesh& mesh = meshes.has(slot) ? meshes[slot] : none;
        meshes_.push_back(upload.add(mesh.vertices.size(), mesh.indices,
                                     [&](std::size_t v) -> const Vertex& { return mesh.vertices[v]; }));
    }
    auto deformed = deformed_.begin();
    for (const Instance& instance : scene.instances) {
        if (instance.deformed == Instance::kNotDeformed) {
            continue;
        }
        const InstanceShape shape(scene, instance);
        deformed->version = instance.version;
        (deformed++)->range =
            upload.add(shape.vertex_count(), shape.indices(), [&](std::size_t v) { return shape.vertex(v); });
    }
    make_vertex_array();
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
