#include "gi_module/techniques/splat/photon_record.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gi_module/techniques/splat/space_curve.h"

namespace lanthorn::gi {

glm::uvec3 copies_of(const vec3& flux, const vec3& power, float u) {
    glm::uvec3 result(0);
    for (glm::length_t c = 0; c < 3; ++c) {
        if (power[c] > 0 && flux[c] > 0) {
            result[c] = static_cast<std::uint32_t>(std::min(std::floor(flux[c] / power[c] + u), 1e4f));
        }
    }
    return result;
}

void add_records(const Photon& photon, const vec3& power, SurfaceSide side, float u,
                 std::vector<PhotonRecord>& records) {
    glm::uvec3 left = copies_of(photon.flux, power, u);
    for (bool more = false; left != glm::uvec3(0); more = true) {
        const glm::uvec3 here = glm::min(left, glm::uvec3(PhotonRecord::kMostCopies));
        records.push_back({photon.position, PhotonRecord::pack(here, side, more)});
        left -= here;
    }
}

void arrange(RecordRun& run, std::span<const std::uint16_t> groups) {
    const auto group_of = [&](std::uint32_t i) { return groups.empty() ? std::uint16_t{0} : groups[i]; };
    Aabb box;
    for (const PhotonRecord& r : run.records) {
        box.add(r.position);
    }
    const SpaceCurve curve(box, 8);
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order(run.records.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        const PhotonRecord& r = run.records[i];
        order[i] = {
            std::uint64_t{r.side()} << 40 | std::uint64_t{group_of(i)} << 24 | curve.place(r.position), i};
    }
    std::ranges::sort(order);
    std::vector<PhotonRecord> sorted(run.records.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        sorted[i] = run.records[order[i].second];
    }
    run.records = std::move(sorted);
    run.blocks.clear();
    for (std::uint32_t i = 0; i < run.records.size(); ++i) {
        const PhotonRecord& r = run.records[i];
        const std::uint16_t group = group_of(order[i].second);
        if (run.blocks.empty() || run.blocks.back().side != r.side() || run.blocks.back().group != group ||
            run.blocks.back().count == PhotonBlock::kMost) {
            run.blocks.push_back({r.position, i, r.position, 0, r.side(), group});
        }
        PhotonBlock& block = run.blocks.back();
        block.lower = glm::min(block.lower, r.position);
        block.upper = glm::max(block.upper, r.position);
        ++block.count;
    }
}

}  // namespace lanthorn::gi
