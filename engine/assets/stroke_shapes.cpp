#include "engine/assets/stroke_shapes.h"

#include <array>
#include <cmath>

namespace lanthorn {

namespace {

class Strokes {
  public:
    Strokes(Mesh& mesh, float radius) : mesh_(mesh), from_(std::move(mesh.vertices)), radius_(radius) {
        mesh_.vertices.clear();
        mesh_.indices.clear();
    }
    const vec3& position(std::uint32_t vertex) const { return from_[vertex].position; }
    void add_point(std::uint32_t vertex) {
        const std::uint32_t first = begin();
        for (const vec3& direction :
             {vec3(1, 0, 0), vec3(0, 1, 0), vec3(-1, 0, 0), vec3(0, -1, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
            add_vertex(vertex, direction);
        }
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t a = first + i, b = first + (i + 1) % 4;
            add_triangle(a, b, first + 4);
            add_triangle(b, a, first + 5);
        }
    }
    void add_rod(const Stroke& ends, const vec3& along) {
        const vec3 other = std::abs(along.x) < 0.6f ? vec3(1, 0, 0) : vec3(0, 1, 0);
        const vec3 u = glm::normalize(glm::cross(along, other)), v = glm::cross(along, u);
        const std::uint32_t first = begin();
        for (const std::uint32_t end : {ends.first, ends.second}) {
            for (const vec3& direction : {u, v, -u, -v}) {
                add_vertex(end, direction);
            }
        }
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t a = first + i, b = first + (i + 1) % 4;
            add_triangle(a, b, b + 4);
            add_triangle(a, b + 4, a + 4);
        }
    }
    VertexSources sources() && { return std::move(sources_); }

  private:
    std::uint32_t begin() const { return static_cast<std::uint32_t>(mesh_.vertices.size()); }
    void add_vertex(std::uint32_t source, const vec3& direction) {
        Vertex vertex = from_[source];
        vertex.position += radius_ * direction;
        vertex.normal = direction;
        mesh_.vertices.push_back(vertex);
        sources_.push_back(source);
    }
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
    }

    Mesh& mesh_;
    std::vector<Vertex> from_;
    float radius_;
    VertexSources sources_;
};

}  // namespace

float stroke_radius(const Mesh& mesh) {
    Aabb box;
    for (const Vertex& vertex : mesh.vertices) {
        box.add(vertex.position);
    }
    const double extent = glm::length(dvec3(box.upper) - dvec3(box.lower));
    return extent > 0 ? static_cast<float>(extent / 500) : 0.005f;
}

VertexSources make_strokes(Mesh& mesh, const std::vector<Stroke>& strokes, float radius) {
    Strokes shapes(mesh, radius);
    for (const Stroke& stroke : strokes) {
        const dvec3 along = dvec3(shapes.position(stroke.second)) - dvec3(shapes.position(stroke.first));
        const double length = glm::length(along);
        if (length > 0) {
            shapes.add_rod(stroke, vec3(along / length));
        } else {
            shapes.add_point(stroke.first);
        }
    }
    make_any_tangents(mesh);
    return std::move(shapes).sources();
}

}  // namespace lanthorn
