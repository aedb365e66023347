// What a file may make of itself: a few kilobytes can state, pack or repeat as much as anybody likes, so each
// kind is counted over the whole file before memory is taken for it.
#pragma once

#include <cstdint>

namespace lanthorn {

// Defaults: far above what scenes have; together about 10 GB where a file takes all of every kind.
struct ImportBudget {
    // Bytes that EXT_meshopt_compression and KHR_draco_mesh_compression unpack to; more is refused.
    std::uint64_t unpacked = std::uint64_t{1} << 30;
    // Vertices and indices of primitives, whether or not they share accessors; primitives beyond are left
    // out.
    std::uint64_t corners = std::uint64_t{1} << 26;
    // Points and lines, eight triangles each; those beyond are left out.
    std::uint64_t strokes = 500000;
    // Primitives times the nodes and instances that show them, each an object of every frame; those beyond
    // are left out.
    std::uint64_t placements = 200000;
    // Morph weights of nodes and instances; those beyond have their mesh's.
    std::uint64_t weights = std::uint64_t{1} << 24;
    // Texels of images, 4 bytes each, as their headers state; images beyond are left out.
    std::uint64_t texels = std::uint64_t{1} << 30;
};

// Takes `amount` of what is left. False, and nothing is taken, if there is less.
constexpr bool take(std::uint64_t& left, std::uint64_t amount) {
    if (amount > left) {
        return false;
    }
    left -= amount;
    return true;
}

}  // namespace lanthorn
