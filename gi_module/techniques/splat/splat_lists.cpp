#include "gi_module/techniques/splat/splat_lists.h"

#include <algorithm>

namespace lanthorn::gi {

namespace {

// Squared, between the boxes.
float gap(const Aabb& a, const vec3& lower, const vec3& upper) {
    const vec3 d = glm::max(glm::max(a.lower - upper, lower - a.upper), vec3(0));
    return glm::dot(d, d);
}

struct Found {
    std::uint32_t tile;
    SplatEntry entry;
};

}  // namespace

std::size_t blocks_at_once(std::span<const PhotonBlock> blocks, const PictureSurfaces& picture,
                           std::size_t most) {
    std::size_t entries = 0, of_side = 0;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (i == 0 || blocks[i].side != blocks[i - 1].side) {  // a tile has one patch of a side
            const auto patches = picture.patches();
            const auto first = std::ranges::lower_bound(patches, blocks[i].side, {}, &SurfacePatch::side);
            const auto end = std::ranges::upper_bound(patches, blocks[i].side, {}, &SurfacePatch::side);
            of_side = static_cast<std::size_t>(end - first);
        }
        entries += of_side;
        if (i > 0 && entries > most) {
            return i;
        }
    }
    return blocks.size();
}

SplatLists splat_lists(std::span<const PhotonBlock> blocks, const PictureSurfaces& picture,
                       std::span<const float> bandwidths, std::span<const std::uint32_t> open,
                       reference::TileWorkers& workers) {
    const auto groups = picture.groups();
    const auto patches = picture.patches();
    std::vector<std::vector<Found>> found(groups.size());
    workers.run(groups.size(), [&](std::size_t g) {
        const PatchGroup& group = groups[g];
        const float h = bandwidths[group.side], square = h * h;
        const auto first = std::ranges::lower_bound(blocks, group.side, {}, &PhotonBlock::side);
        const auto last = std::ranges::upper_bound(blocks, group.side, {}, &PhotonBlock::side);
        if (!(h > 0)) {
            return;
        }
        for (const PhotonBlock& block : std::span(first, last)) {
            if (gap(group.bounds, block.lower, block.upper) >= square) {
                continue;
            }
            for (const SurfacePatch& patch : patches.subspan(group.first, group.count)) {
                if ((open.empty() || open[patch.tile] != 0) &&
                    gap(patch.bounds, block.lower, block.upper) < square) {
                    const float reach = h + 0.5001f * patch.bounds.diagonal();
                    found[g].push_back({patch.tile,
                                        {block.first, static_cast<std::uint16_t>(block.count), block.group,
                                         block.side, square, patch.bounds.centre(), reach * reach}});
                }
            }
        }
    });
    SplatLists lists;
    const ivec2 tiles = picture.tiles();
    lists.firsts.assign(static_cast<std::size_t>(tiles.x * tiles.y) + 1, 0);
    for (const auto& of_group : found) {
        for (const Found& f : of_group) {
            ++lists.firsts[f.tile + 1];
        }
    }
    for (std::size_t t = 1; t < lists.firsts.size(); ++t) {
        lists.firsts[t] += lists.firsts[t - 1];
    }
    lists.entries.resize(lists.firsts.back());
    std::vector<std::uint32_t> next(lists.firsts.begin(), lists.firsts.end() - 1);
    for (const auto& of_group : found) {
        for (const Found& f : of_group) {
            lists.entries[next[f.tile]++] = f.entry;
        }
    }
    return lists;
}

}  // namespace lanthorn::gi
