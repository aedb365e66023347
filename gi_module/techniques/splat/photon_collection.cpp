#include "gi_module/techniques/splat/photon_collection.h"

#include <algorithm>

#include "gi_module/reference/random.h"
#include "lanthorn/core/error.h"

namespace lanthorn::gi {

namespace {

// Of a photon, for the part of its power that is left to chance.
float chance(const Photon& photon) {
    return reference::unit_float(
        reference::mix_bits(reference::mix_bits(photon.path) + 0x9e3779b9u * photon.bounces));
}

struct Filed {
    std::vector<PhotonRecord> records;
    std::vector<std::uint32_t> keys;  // by record: 2 * group, 1 more: caustic
};

}  // namespace

void PhotonCollection::clear() {
    store_.clear();
    walks_ = rays_ = 0;
    photons_ = {};
    all_ = {};
}

std::vector<vec3> PhotonCollection::powers(const PhotonSources& sources) const {
    const std::vector<std::uint64_t> paths = sources.paths(walks_);
    std::vector<vec3> result;
    for (std::size_t g = 0; g < paths.size(); ++g) {
        result.push_back(paths[g] > 0 ? sources.groups()[g].flux / static_cast<float>(paths[g]) : vec3(0));
    }
    return result;
}

bool PhotonCollection::grow(const PhotonScene& scene, const SplatSurfaces& surfaces,
                            const PhotonSettings& settings, std::uint64_t count,
                            reference::TileWorkers& workers) {
    if (2 * surfaces.count() >= PhotonRecord::kMostSides) {
        throw InputError("gi.technique: found a scene of " + std::to_string(surfaces.count()) +
                         " surfaces, expected fewer than " + std::to_string(PhotonRecord::kMostSides / 2) +
                         " for 'splat'");
    }
    for (auto& photons : photons_) {
        photons.resize(2 * surfaces.count(), 0);
    }
    while (count > 0) {
        const std::uint64_t now = std::min(count, kMostAtOnce);
        if (!grow_once(scene, surfaces, settings, now, workers)) {
            return false;
        }
        count -= now;
    }
    return true;
}

bool PhotonCollection::grow_once(const PhotonScene& scene, const SplatSurfaces& surfaces,
                                 const PhotonSettings& settings, std::uint64_t count,
                                 reference::TileWorkers& workers) {
    const PhotonSources& sources = scene.sources();
    std::vector<Filed> parts(
        static_cast<std::size_t>((count + PhotonTracer::kPart - 1) / PhotonTracer::kPart));
    const PhotonRun traced = scene.tracer(settings).trace(
        walks_, count, workers, [&](std::size_t part, std::span<const Photon> photons) {
            Filed& filed = parts[part];
            for (const Photon& photon : photons) {
                if (!photon.indirect()) {
                    continue;
                }
                add_records(photon, sources.groups()[photon.group].flux,
                            surfaces.side(photon.instance, photon.primitive, photon.front), chance(photon),
                            filed.records);
                filed.keys.resize(filed.records.size(), 2u * photon.group + (photon.caustic ? 1 : 0));
            }
        });
    std::array<std::vector<std::uint64_t>, 2> photons = photons_;
    std::array<std::uint64_t, 2> all = all_;
    std::array<std::vector<RecordRun>, 2> of_kinds;
    std::array<std::vector<std::vector<std::uint16_t>>, 2> groups;
    for (Filed& filed : parts) {
        for (std::size_t i = 0; i < filed.records.size(); ++i) {
            const PhotonRecord& record = filed.records[i];
            const std::size_t kind = filed.keys[i] & 1u;
            if (of_kinds[kind].empty() || of_kinds[kind].back().records.size() == SplatStore::kMostRecords) {
                of_kinds[kind].push_back({kind == 1, {}, {}});
                groups[kind].emplace_back();
            }
            of_kinds[kind].back().records.push_back(record);
            groups[kind].back().push_back(static_cast<std::uint16_t>(filed.keys[i] / 2));
            photons[kind][record.side()] += record.more() ? 0 : 1;
            all[kind] += record.more() ? 0 : 1;
        }
        filed = {};
    }
    std::vector<RecordRun> runs;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        workers.run(of_kinds[kind].size(),
                    [&](std::size_t r) { arrange(of_kinds[kind][r], groups[kind][r]); });
        std::ranges::move(of_kinds[kind], std::back_inserter(runs));
    }
    if (!store_.add(std::move(runs))) {
        return false;
    }
    photons_ = std::move(photons);
    all_ = all;
    walks_ += count;
    rays_ += traced.rays;
    bad_ += traced.bad;
    return true;
}

}  // namespace lanthorn::gi
