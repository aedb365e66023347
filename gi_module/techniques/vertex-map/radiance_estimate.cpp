#include "gi_module/techniques/vertex-map/radiance_estimate.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace lanthorn::gi {

namespace {

// Photons that all lie in one point are taken to lie on a circle of this share of the distance.
constexpr float kLeastRadius = 0.01f;

bool counts(const StoredPhoton& photon, const EstimatePoint& point, const EstimateSettings& settings) {
    return settings.any_surface ||
           (photon.surface == point.surface && glm::dot(photon.normal, point.normal) > kSameSurface);
}

// By distance, and those at one distance by place: one comparison of their bits, as distances are positive.
struct Nearer {
    static std::uint64_t key(const NearPhoton& p) {
        return static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(p.distance2)) << 32 | p.place;
    }
    bool operator()(const NearPhoton& a, const NearPhoton& b) const { return key(a) < key(b); }
};

// What weights of photons at distances within `radius` add up to over the surface, per photon a square metre:
// the kernel's integral over rings of it.
float kernel_area(const SurfaceShares& shares, float radius, float largest, EstimateKernel kernel) {
    const float area = kPi * radius * radius;
    if (kernel == EstimateKernel::constant) {
        return area * shares.at(radius / largest);
    }
    float sum = 0, within = 0;
    constexpr int kRings = 16;
    for (int ring = 0; ring < kRings; ++ring) {
        const float outer = static_cast<float>(ring + 1) / kRings;
        const float next = outer * outer * shares.at(outer * radius / largest);
        const float middle = (static_cast<float>(ring) + 0.5f) / kRings;
        sum += (next - within) * (1 - middle * middle);
        within = next;
    }
    return area * std::max(sum, 0.0f);
}

}  // namespace

float SurfaceShares::at(float u) const {
    const float step = std::sqrt(std::clamp(u, 0.0f, 1.0f)) * static_cast<float>(kSteps) - 1;
    if (!(step > 0)) {
        return shares[0];
    }
    const auto below = std::min(static_cast<std::size_t>(step), kSteps - 2);
    return glm::mix(shares[below], shares[below + 1], step - static_cast<float>(below));
}

bool nearest_photons(const EstimatePoint& point, const PhotonTree& tree, const PhotonStore& store,
                     const EstimateSettings& settings, float radius, std::vector<NearPhoton>& found) {
    for (float within = std::min(radius, settings.distance);;
         within = std::min(1.5f * within, settings.distance)) {
        found.clear();
        tree.within(point.surface, point.position, within, found);
        std::erase_if(found, [&](const NearPhoton& p) { return !counts(store[p.place], point, settings); });
        if (found.size() > settings.nearest) {
            const auto last = found.begin() + static_cast<std::ptrdiff_t>(settings.nearest);
            std::nth_element(found.begin(), last - 1, found.end(), Nearer());
            found.erase(last, found.end());
            return false;
        }
        if (found.size() == settings.nearest || !(within < settings.distance)) {
            return !(within < settings.distance);
        }
    }
}

LightEstimate RadianceEstimate::at(const EstimatePoint& point, const SurfaceShares& shares,
                                   const PhotonTree& tree, const PhotonStore& store,
                                   const EstimateSettings& settings, float first_radius) {
    const float first = first_radius > 0 ? first_radius : settings.distance / 8;
    nearest_photons(point, tree, store, settings, first, found_);
    LightEstimate result;
    if (found_.empty()) {
        result.radius = settings.distance;
        return result;
    }
    const bool enough = found_.size() == settings.nearest && settings.nearest > 1;
    const auto furthest = std::ranges::max_element(found_, Nearer());
    result.radius = enough ? std::max(std::sqrt(furthest->distance2), kLeastRadius * settings.distance)
                           : settings.distance;
    if (enough) {  // the one that the circle goes through does not count
        *furthest = found_.back();
        found_.pop_back();
    }
    const float area = kernel_area(shares, result.radius, settings.distance, settings.kernel);
    const float inverse2 = 1 / (result.radius * result.radius);
    // Sums of floats of about one size are exact in doubles, and so the same in any order.
    dvec3 flux(0), from_lamps(0);
    for (const NearPhoton& near : found_) {
        const float weight = settings.kernel == EstimateKernel::constant
                                 ? 1.0f
                                 : std::max(1 - near.distance2 * inverse2, 0.0f);
        const StoredPhoton& photon = store[near.place];
        (photon.from_lamp ? from_lamps : flux) += dvec3(weight * photon.flux);
    }
    result.photons = static_cast<std::uint32_t>(found_.size());
    if (area > 0) {
        result.irradiance = flux / static_cast<double>(area);
        result.from_lamps = from_lamps / static_cast<double>(area);
    }
    return result;
}

}  // namespace lanthorn::gi
