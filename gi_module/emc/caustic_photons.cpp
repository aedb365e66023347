#include "lanthorn/gi/emc/caustic_photons.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lanthorn/gi/emc/caustic_bandwidth.h"

namespace lanthorn::gi {

namespace {

// Targets and sources together: what a frame may spend on sharing photons out, whatever the scene holds.
constexpr std::size_t kMostTargets = 1024;
constexpr std::size_t kMostPairs = 131'072;
constexpr float kWidest = 0.05f;  // of the scene's diagonal: a splat's radius

bool is_finite(const PhotonHit& hit) {
    const vec3 all = hit.position + hit.power;
    return std::isfinite(all.x) && std::isfinite(all.y) && std::isfinite(all.z);
}

}  // namespace

std::vector<int> shared_out(const std::vector<double>& fluxes, int photons) {
    const double total = std::accumulate(fluxes.begin(), fluxes.end(), 0.0);
    std::vector<int> counts(fluxes.size(), 0);
    int left = photons;
    for (std::size_t i = 0; i < fluxes.size(); ++i) {
        if (!(fluxes[i] > 0)) {
            continue;
        }
        // A quarter of an octave: the next lower of 1, 2^(1/4), 2^(1/2), ...
        const double wanted = photons * (fluxes[i] / total);
        const double steps = std::floor(4 * std::log2(std::max(wanted, 1.0)) + 1e-9);
        counts[i] = std::min(static_cast<int>(std::exp2(steps / 4)), left);
        left -= counts[i];
    }
    return counts;
}

void CausticPhotons::trace(const render::LightInputs& inputs, ExactRays& rays, const GiSettings& settings,
                           bool keep) {
    const FrameScene& scene = inputs.scene;
    const auto surfaces = inputs.emissive.surfaces();
    const std::size_t source_count = scene.lights.size() + surfaces.size();
    const CausticTargets targets = CausticTargets::of(
        scene, std::clamp<std::size_t>(kMostPairs / std::max<std::size_t>(source_count, 1), 1, kMostTargets));
    std::vector<CausticSource> sources;
    sources.reserve(source_count);
    for (const LightInstance& light : scene.lights) {
        sources.emplace_back(light, targets);
    }
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        sources.emplace_back(inputs.emissive, s, targets);
    }
    std::vector<double> fluxes;
    for (const CausticSource& source : sources) {
        fluxes.push_back(source.flux());
    }
    const std::vector<int> counts = shared_out(fluxes, settings.caustic_photons);
    const float widest = kWidest * scene.diagonal();

    std::vector<Flown> before = std::exchange(flown_, {});
    hits_.clear();
    traced_ = 0;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        const auto same = std::ranges::find_if(
            before, [&](const Flown& f) { return keep && f.count == counts[s] && f.source == sources[s]; });
        if (same != before.end()) {
            flown_.push_back(std::move(*same));
            before.erase(same);
        } else {
            flown_.push_back({std::move(sources[s]), counts[s], {}});
            Flown& now = flown_.back();
            const std::vector<CausticPhoton> photons = now.source.emit(counts[s], settings.seed, 0);
            now.hits = rays.trace(photons, targets.of_instance, settings.seed);
            bad_values_ += std::erase_if(now.hits, [](const PhotonHit& hit) { return !is_finite(hit); });
            set_bandwidth(now.hits, settings.caustic_c0, widest);
            traced_ += counts[s];
        }
        hits_.insert(hits_.end(), flown_.back().hits.begin(), flown_.back().hits.end());
    }
    ++version_;
}

CausticStatistics CausticPhotons::statistics() const {
    CausticStatistics result;
    result.traced = static_cast<std::uint64_t>(traced_);
    for (const Flown& flown : flown_) {
        result.emitted += static_cast<std::uint64_t>(flown.count);
    }
    result.stored = hits_.size();
    result.bad_values = bad_values_;
    for (const PhotonHit& hit : hits_) {
        result.flux_stored += dvec3(hit.power);
    }
    return result;
}

}  // namespace lanthorn::gi
