#include "gi_module/techniques/emc/caustics/caustic_photons.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "gi_module/techniques/emc/caustics/caustic_bandwidth.h"
#include "lanthorn/emc/emc_settings.h"

namespace lanthorn::gi {

namespace {

// Targets and sources together: what a frame may spend on sharing photons out, whatever the scene holds.
constexpr std::size_t kMostTargets = 1024;
constexpr std::size_t kMostPairs = 131'072;
constexpr float kWidest = 0.05f;  // of the scene's diagonal: a splat's radius

// Of the photons, those that are sent everywhere: one in so many. Their light lies widely spread.
constexpr int kAroundShare = 4;
// Splats of scattered light are wider than gi.caustics.c0 says by this: there is no edge in it.
constexpr float kSmoother = 1.5f;

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

void CausticPhotons::trace(const render::LightInputs& inputs, ExactRays* rays, const EnvironmentMaps& maps,
                           const GiSettings& settings, bool keep) {
    const FrameScene& scene = inputs.scene;
    const auto surfaces = inputs.emissive.surfaces();
    if (scene.sky != sky_) {
        sky_ = scene.sky;
        sky_source_ = sky_ ? std::make_shared<const CausticSky>(*sky_) : nullptr;
    }
    const std::size_t source_count = scene.lights.size() + surfaces.size() + (sky_ ? 1 : 0);
    const CausticTargets targets = CausticTargets::of(
        scene, std::clamp<std::size_t>(kMostPairs / std::max<std::size_t>(source_count, 1), 1, kMostTargets));
    const CausticTargets everything = CausticTargets::everything(scene);
    std::vector<Flown> sources;
    sources.reserve(source_count);
    for (const LightInstance& light : scene.lights) {
        sources.push_back({{light, targets}, {light, everything}});
    }
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
        sources.push_back({{inputs.emissive, s, targets}, {inputs.emissive, s, everything}});
    }
    if (sky_) {
        sources.push_back({{sky_source_, targets}, {sky_source_, everything}});
    }
    const auto counts_of = [&](CausticSource Flown::*which, int photons) {
        std::vector<double> fluxes;
        fluxes.reserve(sources.size());
        for (const Flown& flown : sources) {
            fluxes.push_back((flown.*which).flux());
        }
        return shared_out(fluxes, photons);
    };
    const int around = rays != nullptr ? settings.of<EmcSettings>().caustic_photons / kAroundShare : 0;
    const std::vector<int> aimed_counts =
        counts_of(&Flown::aimed, settings.of<EmcSettings>().caustic_photons - around);
    const std::vector<int> around_counts = counts_of(&Flown::around, around);
    const float widest = kWidest * scene.diagonal();

    if (rays == nullptr) {
        maps_.follow(inputs, maps, targets);
    }
    std::vector<Flown> before = std::exchange(flown_, {});
    hits_.clear();
    traced_ = 0;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        Flown& now = sources[s];
        now.aimed_count = aimed_counts[s];
        now.around_count = around_counts[s];
        const auto same = std::ranges::find_if(before, [&](const Flown& f) {
            return keep && f.aimed_count == now.aimed_count && f.around_count == now.around_count &&
                   f.aimed == now.aimed && f.around == now.around;
        });
        if (same != before.end()) {
            now.arrived = std::move(same->arrived);
            before.erase(same);
        } else {
            fly(now, inputs, rays, maps, targets, settings, widest);
        }
    }
    flown_ = std::move(sources);
    for (const Flown& flown : flown_) {
        hits_.insert(hits_.end(), flown.arrived.straight.begin(), flown.arrived.straight.end());
    }
    straight_hits_ = hits_.size();
    for (const Flown& flown : flown_) {
        hits_.insert(hits_.end(), flown.arrived.scattered.begin(), flown.arrived.scattered.end());
    }
    ++version_;
}

void CausticPhotons::fly(Flown& flown, const render::LightInputs& inputs, ExactRays* rays,
                         const EnvironmentMaps& maps, const CausticTargets& targets,
                         const GiSettings& settings, float widest) {
    std::vector<CausticPhoton> photons = flown.aimed.emit(flown.aimed_count, settings.seed, 0);
    for (CausticPhoton photon : flown.around.emit(flown.around_count, settings.seed, 0)) {
        photon.target = CausticPhoton::kAround;
        photons.push_back(photon);
    }
    if (rays != nullptr) {
        flown.arrived = rays->trace_caustics(photons, targets, settings.bounces, settings.seed);
    } else {
        flown.arrived.straight = maps_.trace(inputs, maps, settings, photons);
        bad_values_ += maps_.take_bad_values();
    }
    for (std::vector<PhotonHit>* hits : {&flown.arrived.straight, &flown.arrived.scattered}) {
        bad_values_ += std::erase_if(*hits, [](const PhotonHit& hit) { return !is_finite(hit); });
    }
    set_bandwidth(flown.arrived.straight, settings.of<EmcSettings>().caustic_c0, widest);
    set_bandwidth(flown.arrived.scattered, kSmoother * settings.of<EmcSettings>().caustic_c0, widest);
    traced_ += flown.aimed_count + flown.around_count;
}

CausticStatistics CausticPhotons::statistics() const {
    CausticStatistics result;
    result.traced = static_cast<std::uint64_t>(traced_);
    result.stored = hits_.size();
    result.bad_values = bad_values_;
    for (const Flown& flown : flown_) {
        result.emitted += static_cast<std::uint64_t>(flown.aimed_count + flown.around_count);
        for (const PhotonHit& hit : flown.arrived.straight) {
            result.flux_stored += dvec3(hit.power);
        }
        for (const PhotonHit& hit : flown.arrived.scattered) {
            result.flux_scattered += dvec3(hit.power);
        }
    }
    return result;
}

}  // namespace lanthorn::gi
