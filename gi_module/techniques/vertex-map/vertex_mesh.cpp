#include "gi_module/techniques/vertex-map/vertex_mesh.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace lanthorn::gi {

namespace {

struct Place {
    std::array<std::uint32_t, 3> bits;
    bool operator==(const Place&) const = default;
};

std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// A point on an edge: between corners a < b, `step` / 2^`level` of the way to b, in lowest terms.
struct EdgePoint {
    std::uint32_t a, b;
    std::uint16_t step;
    std::uint8_t level;
    bool operator==(const EdgePoint&) const = default;
};

struct Hash {
    std::size_t operator()(const Place& p) const {
        return mixed(mixed(mixed(p.bits[0]) + p.bits[1]) + p.bits[2]);
    }
    std::size_t operator()(const EdgePoint& e) const {
        return mixed(mixed(static_cast<std::uint64_t>(e.a) << 32 | e.b) +
                     (static_cast<std::uint64_t>(e.step) << 8 | e.level));
    }
    std::size_t operator()(const std::pair<std::uint32_t, std::uint32_t>& e) const {
        return mixed(static_cast<std::uint64_t>(e.first) << 32 | e.second);
    }
};

class Builder {
  public:
    Builder(const MeshShape& shape, std::span<const std::uint8_t> levels, bool shared)
        : shape_(shape), levels_(levels), shared_(shared) {
        const std::size_t count = shape.indices.size() / 3;
        own_.resize(3 * count);
        for (std::size_t i = 0; i < own_.size(); ++i) {
            own_[i] = corner_of(shape.indices[i]);
        }
        for (std::size_t t = 0; t < count; ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [edge, fresh] = edge_levels_.try_emplace(
                    std::minmax(own_[3 * t + k], own_[3 * t + (k + 1) % 3]), levels[t]);
                edge->second = std::min(edge->second, levels[t]);
            }
        }
        for (std::size_t t = 0; t < count; ++t) {
            split(t);
        }
        for (HangingCorner& h : result.hanging) {
            find_ends(h);
        }
    }

    VertexMesh result;

  private:
    std::uint32_t add(const Corner& corner) {
        result.corners.push_back(corner);
        return static_cast<std::uint32_t>(result.corners.size() - 1);
    }

    std::uint32_t corner_of(std::uint32_t vertex) {
        const Corner corner{{vertex, vertex, vertex}, vec3(1, 0, 0)};
        if (!shared_) {
            return add(corner);
        }
        const vec3 p = shape_.positions[vertex] + 0.0f;  // -0 is 0
        auto& here = places_[Place{{std::bit_cast<std::uint32_t>(p.x), std::bit_cast<std::uint32_t>(p.y),
                                    std::bit_cast<std::uint32_t>(p.z)}}];
        for (const std::uint32_t known : here) {
            if (glm::dot(shape_.normals[result.corners[known].vertices[0]], shape_.normals[vertex]) >
                kSharedCorner) {
                return known;
            }
        }
        here.push_back(add(corner));
        return here.back();
    }

    // The corner at barycentric (i, j, n - i - j) / n of triangle t, weights of its vertices 0, 1 and 2.
    std::uint32_t grid_corner(std::size_t t, std::uint32_t i, std::uint32_t j, std::uint8_t level) {
        const std::uint32_t n = 1u << level, k = n - i - j;
        const std::array<std::uint32_t, 3> parts{i, j, k};
        for (std::size_t v = 0; v < 3; ++v) {
            if (parts[v] == n) {
                return own_[3 * t + v];
            }
        }
        const auto vertex = [&](std::size_t v) { return shape_.indices[3 * t + v]; };
        const auto corner = [&] {
            return add({{vertex(0), vertex(1), vertex(2)}, vec3(i, j, k) / static_cast<float>(n)});
        };
        for (std::size_t v = 0; v < 3; ++v) {
            if (parts[v] == 0) {
                return edge_corner(t, (v + 1) % 3, (v + 2) % 3, parts, level, corner);
            }
        }
        return corner();
    }

    // On the edge between vertices v and w.
    template <class Make>
    std::uint32_t edge_corner(std::size_t t, std::size_t v, std::size_t w,
                              const std::array<std::uint32_t, 3>& parts, std::uint8_t level,
                              const Make& make) {
        std::uint32_t a = own_[3 * t + v], b = own_[3 * t + w], step = parts[w];
        if (a > b) {
            std::swap(a, b);
            step = parts[v];
        }
        while (step % 2 == 0) {
            step /= 2;
            --level;
        }
        const EdgePoint point{a, b, static_cast<std::uint16_t>(step), level};
        const auto [known, fresh] = edge_points_.try_emplace(point, 0);
        if (fresh) {
            known->second = make();
            if (level > edge_levels_.at({a, b})) {
                result.hanging.push_back({known->second, 0, 0, 0});
                hanging_points_.push_back(point);
            }
        }
        return known->second;
    }

    void split(std::size_t t) {
        result.firsts.push_back(static_cast<std::uint32_t>(result.sources.size()));
        const std::uint8_t level = levels_[t];
        const std::uint32_t n = 1u << level;
        const auto at = [&](std::uint32_t i, std::uint32_t j) { return grid_corner(t, i, j, level); };
        if (n == 1) {
            emit(t, own_[3 * t], own_[3 * t + 1], own_[3 * t + 2]);
            return;
        }
        // Row by row; inner corners are made once.
        std::vector<std::uint32_t> row, above;
        for (std::uint32_t i = 0; i <= n; ++i) {
            row.resize(n - i + 1);
            for (std::uint32_t j = 0; j <= n - i; ++j) {
                row[j] = at(i, j);
            }
            for (std::uint32_t j = 0; i > 0 && j + i <= n; ++j) {
                emit(t, row[j], above[j + 1], above[j]);
                if (j + i < n) {
                    emit(t, row[j], row[j + 1], above[j + 1]);
                }
            }
            std::swap(row, above);
        }
    }

    void emit(std::size_t t, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        result.triangles.insert(result.triangles.end(), {a, b, c});
        result.sources.push_back(static_cast<std::uint32_t>(t));
    }

    // The corners of the coarser edge about a hanging one: no triangle there is coarser, so they are no
    // hanging ones.
    void find_ends(HangingCorner& h) {
        const EdgePoint& point = hanging_points_[static_cast<std::size_t>(&h - result.hanging.data())];
        const std::uint8_t coarse = edge_levels_.at({point.a, point.b});
        const std::uint32_t steps = 1u << (point.level - coarse);
        const std::uint32_t below = point.step / steps;
        h.from = on_edge(point, below, coarse);
        h.to = on_edge(point, below + 1, coarse);
        h.share = static_cast<float>(point.step % steps) / static_cast<float>(steps);
    }

    std::uint32_t on_edge(const EdgePoint& edge, std::uint32_t step, std::uint8_t level) const {
        if (step == 0) {
            return edge.a;
        }
        if (step == 1u << level) {
            return edge.b;
        }
        while (step % 2 == 0) {
            step /= 2;
            --level;
        }
        return edge_points_.at({edge.a, edge.b, static_cast<std::uint16_t>(step), level});
    }

    const MeshShape& shape_;
    std::span<const std::uint8_t> levels_;
    bool shared_;
    std::vector<std::uint32_t> own_;  // corners of the mesh's own triangles
    std::unordered_map<Place, std::vector<std::uint32_t>, Hash> places_;
    std::unordered_map<std::pair<std::uint32_t, std::uint32_t>, std::uint8_t, Hash> edge_levels_;
    std::unordered_map<EdgePoint, std::uint32_t, Hash> edge_points_;
    std::vector<EdgePoint> hanging_points_;
};

}  // namespace

VertexMesh make_vertex_mesh(const MeshShape& shape, std::span<const std::uint8_t> levels, bool shared) {
    return std::move(Builder(shape, levels, shared).result);
}

// Rows of pieces as Builder::split() emits them: from vertex 0's opposite side on, in pairs of one that
// points towards it and, but for the last, one that points away.
PieceAt piece_at(std::uint8_t level, const vec3& weights) {
    const std::uint32_t n = 1u << level;
    const float a = std::clamp(weights.x, 0.0f, 1.0f) * static_cast<float>(n);
    const float b = std::clamp(weights.y, 0.0f, 1.0f) * static_cast<float>(n);
    const std::uint32_t row = std::min(static_cast<std::uint32_t>(a), n - 1);
    const std::uint32_t place = std::min(static_cast<std::uint32_t>(b), n - 1 - row);
    const float u = std::min(a - static_cast<float>(row), 1.0f);
    const float v = std::min(b - static_cast<float>(place), 1.0f);
    const std::uint32_t before = row * (2 * n - row) + 2 * place;
    if (u + v <= 1 || row + place + 1 == n) {
        const float rest = std::max(1 - u - v, 0.0f);
        return {before, vec3(u, v, rest) / (u + v + rest)};
    }
    return {before + 1, {1 - v, u + v - 1, 1 - u}};
}

std::uint8_t level_for_edge(float longest, float edge) {
    std::uint8_t level = 0;
    while (level < kMostLevels && longest > edge) {
        longest *= 0.5f;
        ++level;
    }
    return level;
}

}  // namespace lanthorn::gi
