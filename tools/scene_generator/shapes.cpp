#include "tools/scene_generator/shapes.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <utility>

namespace lanthorn::scene_generator {

namespace {

void add_triangle(Shape& shape, const dvec3& normal, const std::array<dvec3, 3>& p,
                  const std::array<glm::dvec2, 3>& uv) {
    const auto first = static_cast<std::uint32_t>(shape.corners.size());
    for (int i = 0; i < 3; ++i) {
        shape.corners.push_back({p[i], normal, uv[i]});
        shape.indices.push_back(first + static_cast<std::uint32_t>(i));
    }
}

// The longest horizontal edge direction of a face gives u, so that bricks lie level on every wall.
glm::dvec2 face_uv(const dvec3& normal, const dvec3& p) {
    const dvec3 n = glm::abs(normal);
    if (n.y > n.x && n.y > n.z) {
        return {p.x, p.z};
    }
    return n.x > n.z ? glm::dvec2(p.z, -p.y) : glm::dvec2(p.x, -p.y);
}

}  // namespace

void add_quad(Shape& shape, const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d,
              const dvec3& towards) {
    std::array<dvec3, 4> p{a, b, c, d};
    dvec3 normal = glm::cross(p[2] - p[0], p[3] - p[1]);
    if (glm::dot(normal, towards - 0.25 * (a + b + c + d)) < 0) {
        std::swap(p[1], p[3]);
        normal = -normal;
    }
    normal = glm::normalize(normal);
    std::array<glm::dvec2, 4> uv;
    for (int i = 0; i < 4; ++i) {
        uv[i] = face_uv(normal, p[i]);
    }
    const double size = glm::length(p[2] - p[0]);
    if (std::abs(glm::dot(normal, p[1] - p[0])) > 1e-9 * size) {
        add_triangle(shape, glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0])), {p[0], p[1], p[2]},
                     {uv[0], uv[1], uv[2]});
        add_triangle(shape, glm::normalize(glm::cross(p[2] - p[0], p[3] - p[0])), {p[0], p[2], p[3]},
                     {uv[0], uv[2], uv[3]});
        return;
    }
    const auto first = static_cast<std::uint32_t>(shape.corners.size());
    for (int i = 0; i < 4; ++i) {
        shape.corners.push_back({p[i], normal, uv[i]});
    }
    for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) {
        shape.indices.push_back(first + i);
    }
}

void add_box(Shape& shape, const dvec3& lower, const dvec3& upper) {
    const dvec3 centre = 0.5 * (lower + upper);
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (const double side : {lower[axis], upper[axis]}) {
            dvec3 p[4];
            for (int i = 0; i < 4; ++i) {
                p[i][axis] = side;
                p[i][u] = (i == 1 || i == 2) ? upper[u] : lower[u];
                p[i][v] = i >= 2 ? upper[v] : lower[v];
            }
            dvec3 outside = centre;
            outside[axis] += side > centre[axis] ? 1e3 : -1e3;
            add_quad(shape, p[0], p[1], p[2], p[3], outside);
        }
    }
}

Shape box(const dvec3& lower, const dvec3& upper) {
    Shape shape;
    add_box(shape, lower, upper);
    return shape;
}

Shape prism(const dvec3 (&base)[4], double height) {
    Shape shape;
    const dvec3 up(0, height, 0);
    const dvec3 centre = 0.25 * (base[0] + base[1] + base[2] + base[3]) + 0.5 * up;
    const auto add = [&](const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
        const dvec3 middle = 0.25 * (a + b + c + d);
        add_quad(shape, a, b, c, d, middle + (middle - centre));
    };
    add(base[0] + up, base[1] + up, base[2] + up, base[3] + up);
    for (int i = 0; i < 4; ++i) {
        const dvec3& a = base[i];
        const dvec3& b = base[(i + 1) % 4];
        add(a, a + up, b + up, b);
    }
    add(base[0], base[1], base[2], base[3]);
    return shape;
}

Shape cylinder(double radius, double height, int sides) {
    Shape shape;
    const auto rim = [&](int i) {
        const double angle = 2 * std::numbers::pi * (i % sides) / sides;
        return dvec3(std::cos(angle), 0, std::sin(angle));
    };
    const dvec3 up(0, height, 0);
    for (int i = 0; i <= sides; ++i) {
        const dvec3 n = rim(i);
        const double u = 2 * std::numbers::pi * radius * i / sides;
        shape.corners.push_back({radius * n, n, {u, 0}});
        shape.corners.push_back({radius * n + up, n, {u, -height}});
    }
    for (int i = 0; i < sides; ++i) {
        const auto a = static_cast<std::uint32_t>(2 * i);
        for (const std::uint32_t k : {a, a + 1, a + 3, a, a + 3, a + 2}) {
            shape.indices.push_back(k);
        }
    }
    for (const double y : {0.0, height}) {
        const dvec3 normal(0, y > 0 ? 1 : -1, 0);
        const auto centre = static_cast<std::uint32_t>(shape.corners.size());
        shape.corners.push_back({{0, y, 0}, normal, {0, 0}});
        for (int i = 0; i < sides; ++i) {
            const dvec3 p = radius * rim(i) + dvec3(0, y, 0);
            shape.corners.push_back({p, normal, {p.x, p.z}});
        }
        for (int i = 0; i < sides; ++i) {
            const auto a = centre + 1 + static_cast<std::uint32_t>(i);
            const auto b = centre + 1 + static_cast<std::uint32_t>((i + 1) % sides);
            shape.indices.push_back(centre);
            shape.indices.push_back(y > 0 ? b : a);
            shape.indices.push_back(y > 0 ? a : b);
        }
    }
    return shape;
}

Shape icosphere(double radius, int levels, bool inward) {
    const double g = std::numbers::phi;
    std::vector<dvec3> points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    for (dvec3& p : points) {
        p = glm::normalize(p);
    }
    std::vector<std::uint32_t> faces = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                        4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                        6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
    for (int level = 0; level < levels; ++level) {
        using Edge = std::pair<std::uint32_t, std::uint32_t>;
        std::map<Edge, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [place, is_new] =
                middles.try_emplace(Edge(std::minmax(a, b)), static_cast<std::uint32_t>(points.size()));
            if (is_new) {
                points.push_back(glm::normalize(points[a] + points[b]));
            }
            return place->second;
        };
        std::vector<std::uint32_t> finer;
        for (std::size_t f = 0; f < faces.size(); f += 3) {
            const std::uint32_t a = faces[f], b = faces[f + 1], c = faces[f + 2];
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const std::uint32_t k : {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca}) {
                finer.push_back(k);
            }
        }
        faces = std::move(finer);
    }
    Shape shape;
    for (const dvec3& p : points) {
        shape.corners.push_back(
            {radius * p,
             inward ? -p : p,
             {0.5 + std::atan2(p.x, p.z) / (2 * std::numbers::pi), std::acos(p.y) / std::numbers::pi}});
    }
    if (inward) {
        for (std::size_t f = 0; f < faces.size(); f += 3) {
            std::swap(faces[f + 1], faces[f + 2]);
        }
    }
    shape.indices = std::move(faces);
    return shape;
}

Shape rounded_box(const dvec3& half, double radius, int levels) {
    Shape shape = icosphere(1, levels);
    for (Shape::Corner& corner : shape.corners) {
        corner.position = glm::sign(corner.normal) * (half - radius) + radius * corner.normal;
    }
    return shape;
}

}  // namespace lanthorn::scene_generator
