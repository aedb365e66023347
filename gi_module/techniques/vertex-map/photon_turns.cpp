#include "gi_module/techniques/vertex-map/photon_turns.h"

#include <algorithm>
#include <vector>

#include "gi_module/shared/photons/copies.h"

namespace lanthorn::gi {

namespace {

// The walks that the photons `first` .. `first + count - 1` take, `shot` before them.
struct Walks {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

Walks next_walks(PhotonDistribution distribution, std::uint64_t photon, std::uint64_t shot,
                 std::uint64_t count, std::uint64_t per_frame) {
    switch (distribution) {
        case PhotonDistribution::random:
            return {shot, count};
        case PhotonDistribution::per_frame:
            return {photon % per_frame, std::min(count, per_frame - photon % per_frame)};
        case PhotonDistribution::total:
            break;
    }
    return {photon, count};
}

// By group of lights: how many of the photons that are kept are its.
std::vector<double> kept_by_group(const PhotonSources& sources, const VertexMapSettings& settings) {
    const auto total = static_cast<double>(settings.total);
    std::vector<double> kept;
    if (settings.distribution == PhotonDistribution::random) {
        double before = 0;
        for (const LightGroup& group : sources.groups()) {
            kept.push_back(total * (group.end - before));
            before = group.end;
        }
        return kept;
    }
    // The same walks over and over, the last time as many as there is room for.
    const int period = settings.distribution == PhotonDistribution::per_frame
                           ? std::min(settings.per_frame, settings.total)
                           : settings.total;
    const auto whole = sources.paths(static_cast<std::uint64_t>(period));
    const auto rest = sources.paths(static_cast<std::uint64_t>(settings.total % period));
    const int turns = settings.total / period;
    const auto times = static_cast<double>(turns);
    for (std::size_t g = 0; g < whole.size(); ++g) {
        kept.push_back(static_cast<double>(whole[g]) * times + static_cast<double>(rest[g]));
    }
    return kept;
}

}  // namespace

void PhotonTurns::begin_again() {
    *this = {};
}

std::uint64_t PhotonTurns::left(const VertexMapSettings& settings) const {
    return std::min(left_, static_cast<std::uint64_t>(settings.total));
}

PhotonTurns::Shot PhotonTurns::shoot(const PhotonTracer& tracer, const PhotonSources& sources,
                                     const FrameScene& scene, std::uint64_t count,
                                     const VertexMapSettings& settings, PhotonStore& store,
                                     reference::TileWorkers& workers) {
    Shot result;
    const auto total = static_cast<std::uint64_t>(settings.total);
    const auto per_frame = static_cast<std::uint64_t>(std::min(settings.per_frame, settings.total));
    left_ = left(settings);
    const std::vector<double> kept = kept_by_group(sources, settings);
    const std::vector<std::uint32_t> copies = first_of_copies(scene);
    std::vector<StoredPhoton> hits;
    for (count = std::min(count, left_); count > 0;) {
        const Walks walks =
            next_walks(settings.distribution, next_, shot_, std::min(count, total - next_), per_frame);
        const PhotonRun run = tracer.trace(walks.first, walks.count, workers);
        result.rays += run.rays;
        result.bad += run.bad;
        auto photon = run.photons.begin();
        for (std::uint64_t i = 0; i < walks.count; ++i) {
            hits.clear();
            const auto path = static_cast<std::uint32_t>(walks.first + i);
            for (; photon != run.photons.end() && photon->path == path; ++photon) {
                if (!photon->diffuse) {
                    continue;  // a mirror: fig. 16 marks its place unused; here it takes none
                }
                const Instance& instance = scene.instances[copies[photon->instance]];
                StoredPhoton& hit = hits.emplace_back();
                hit.from_lamp = !photon->indirect();
                hit.used = settings.direct || !hit.from_lamp;
                hit.position = photon->position;
                hit.normal = photon->normal;
                hit.flux = photon->flux / static_cast<float>(kept[photon->group]);
                hit.surface = surface_key(instance.id, instance.mesh);
            }
            store.replace(static_cast<std::size_t>(next_ + i), hits);
        }
        next_ = (next_ + walks.count) % total;
        shot_ += walks.count;
        left_ -= walks.count;
        count -= walks.count;
        result.photons += walks.count;
    }
    return result;
}

}  // namespace lanthorn::gi
