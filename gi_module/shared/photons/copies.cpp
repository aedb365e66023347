#include "gi_module/shared/photons/copies.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

#include "lanthorn/scene/instance_shape.h"

namespace lanthorn::gi {

namespace {

bool in_the_same_place(const FrameScene& scene, const Instance& a, const Instance& b) {
    const InstanceShape p(scene, a), q(scene, b);
    if (p.vertex_count() != q.vertex_count() || !std::ranges::equal(p.indices(), q.indices())) {
        return false;
    }
    for (std::size_t v = 0; v < p.vertex_count(); ++v) {
        const vec3 here(a.transform * vec4(p.position(v), 1)), there(b.transform * vec4(q.position(v), 1));
        if (here != there) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<std::uint32_t> first_of_copies(const FrameScene& scene) {
    std::vector<std::uint32_t> order(scene.instances.size()), first(order.size());
    std::iota(order.begin(), order.end(), 0u);
    std::iota(first.begin(), first.end(), 0u);
    const auto box = [&](std::uint32_t i) {
        const Aabb& b = scene.instances[i].bounds;
        return std::tuple(b.lower.x, b.lower.y, b.lower.z, b.upper.x, b.upper.y, b.upper.z);
    };
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple_cat(box(a), std::tuple(a)) < std::tuple_cat(box(b), std::tuple(b));
    });
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin + 1;
        while (end < order.size() && box(order[end]) == box(order[begin])) {
            ++end;
        }
        for (std::size_t k = begin + 1; k < end; ++k) {
            for (std::size_t earlier = begin; earlier < k; ++earlier) {
                if (first[order[earlier]] == order[earlier] &&
                    in_the_same_place(scene, scene.instances[order[earlier]], scene.instances[order[k]])) {
                    first[order[k]] = order[earlier];
                    break;
                }
            }
        }
        begin = end;
    }
    return first;
}

std::vector<std::uint32_t> first_of_copies(std::span<const std::uint32_t> indices,
                                           std::span<const std::uint32_t> places) {
    using Corners = std::array<std::uint32_t, 3>;
    const auto count = static_cast<std::uint32_t>(indices.size() / 3);
    std::vector<std::pair<Corners, std::uint32_t>> order;
    order.reserve(count);
    for (std::uint32_t t = 0; t < count; ++t) {
        Corners corners{places[indices[3 * t]], places[indices[3 * t + 1]], places[indices[3 * t + 2]]};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        order.emplace_back(corners, t);
    }
    std::ranges::sort(order);
    std::vector<std::uint32_t> first(count);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool copy = i > 0 && order[i].first == order[i - 1].first;
        first[order[i].second] = copy ? first[order[i - 1].second] : order[i].second;
    }
    return first;
}

std::vector<std::uint32_t> vertex_places(std::span<const vec3> positions) {
    std::vector<std::uint32_t> order(positions.size()), place(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t i) {
        return std::tuple(positions[i].x, positions[i].y, positions[i].z);
    };
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? place[order[i - 1]] : order[i];
    }
    return place;
}

}  // namespace lanthorn::gi
