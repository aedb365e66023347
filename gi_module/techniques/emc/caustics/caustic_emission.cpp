#include "gi_module/techniques/emc/caustics/caustic_emission.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lanthorn::gi {

namespace {

using std::numbers::pi;

std::uint32_t mixed(std::uint32_t x) {  // Wellons 2018, "lowbias32"
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

// Low-discrepancy numbers of the j-th photon (Roberts 2018), exact in 32 bits for every j.
double sequence(std::uint32_t j, std::uint32_t step, std::uint32_t key) {
    const std::uint32_t bits = (j + 1) * step + mixed(key ^ step);
    return static_cast<double>(bits >> 8) * (1.0 / 16777216.0);
}

struct Numbers {
    glm::dvec2 u, v;
};

// R2, v unused.
Numbers plane_numbers(std::uint32_t j, std::uint32_t key) {
    return {{sequence(j, 3242174889u, key), sequence(j, 2447445414u, key)}, glm::dvec2(0)};
}

// R4.
Numbers surface_numbers(std::uint32_t j, std::uint32_t key) {
    return {{sequence(j, 3679390609u, key), sequence(j, 3152041523u, key)},
            {sequence(j, 2700274806u, key), sequence(j, 2313257605u, key)}};
}

// Attenuation of a spot as KHR_lights_punctual words it.
double cone(const Light& light, double cosine) {
    const double outer = std::cos(static_cast<double>(light.outer_cone));
    const double scale = 1 / std::max(0.001, std::cos(static_cast<double>(light.inner_cone)) - outer);
    const double a = std::clamp((cosine - outer) * scale, 0.0, 1.0);
    return a * a;
}

}  // namespace

CausticSource::CausticSource(const LightInstance& light, const CausticTargets& targets)
    : light_(light), id_(light.id), far_(targets.diagonal) {
    for (std::size_t t = 0; t < targets.targets.size(); ++t) {
        const double flux = flux_towards(light, targets.targets[t].bounds);
        if (flux > 0) {
            shares_.push_back({targets.targets[t], flux, static_cast<std::uint32_t>(t)});
            flux_ += flux;
        }
    }
}

CausticSource::CausticSource(const render::EmissiveTriangles& triangles, std::size_t surface,
                             const CausticTargets& targets)
    : punctual_(false) {
    const render::EmissiveTriangles::Surface& s = triangles.surfaces()[surface];
    const auto own = triangles.triangles().subspan(s.first, s.count);
    triangles_.assign(own.begin(), own.end());
    id_ = s.instance_id;
    double whole = 0;
    dvec3 centre(0);
    for (const render::EmissiveTriangleData& t : triangles_) {
        whole += static_cast<double>(t.p2.w);
        centre += dvec3(vec3(t.p0) + vec3(t.p1) + vec3(t.p2)) * (static_cast<double>(t.p2.w) / 3);
    }
    centre /= std::max(whole, 1e-300);
    double sum = 0;
    for (render::EmissiveTriangleData& t : triangles_) {
        sum += static_cast<double>(t.p2.w);
        t.p0.w = static_cast<float>(sum / whole);
    }
    for (std::size_t t = 0; t < targets.targets.size(); ++t) {
        const double half_space =
            std::min(aim_at(targets.targets[t].bounds, centre).solid_angle() / (2 * pi), 1.0);
        shares_.push_back({targets.targets[t], whole * half_space, static_cast<std::uint32_t>(t)});
        flux_ += whole * half_space;
    }
}

CausticSource::CausticSource(std::shared_ptr<const CausticSky> sky, const CausticTargets& targets)
    : sky_(std::move(sky)), punctual_(false), id_(0x7fffffffu), far_(targets.diagonal) {
    for (std::size_t t = 0; t < targets.targets.size(); ++t) {
        const double flux = sky_->flux_towards(targets.targets[t].bounds);
        if (flux > 0) {
            shares_.push_back({targets.targets[t], flux, static_cast<std::uint32_t>(t)});
            flux_ += flux;
        }
    }
}

bool CausticSource::operator==(const CausticSource& o) const {
    const auto same_share = [](const Share& a, const Share& b) {
        return a.target.bounds == b.target.bounds && a.target.key == b.target.key && a.index == b.index;
    };
    const auto same_triangle = [](const render::EmissiveTriangleData& a,
                                  const render::EmissiveTriangleData& b) {
        return a.p0 == b.p0 && a.p1 == b.p1 && a.p2 == b.p2 && a.radiance == b.radiance;
    };
    return sky_ == o.sky_ && punctual_ == o.punctual_ && id_ == o.id_ && light_ == o.light_ &&
           far_ == o.far_ && std::ranges::equal(shares_, o.shares_, same_share) &&
           std::ranges::equal(triangles_, o.triangles_, same_triangle);
}

CausticPhoton CausticSource::from_sky(const Share& share, double weight, const glm::dvec2& u,
                                      const glm::dvec2& v) const {
    const CausticSky::Entry entry = sky_->enter(share.target.bounds, u, v);
    CausticPhoton photon;
    photon.target = share.index;
    photon.range = 1e30f;
    photon.origin = vec3(entry.place + entry.to_sky * far_);
    photon.direction = vec3(-entry.to_sky);
    photon.power = vec3(entry.power / weight);
    return photon;
}

// `weight`: how many photons the share's flux is split over.
CausticPhoton CausticSource::emit_one(const Share& share, const CausticAim& aim, double weight,
                                      const glm::dvec2& u, const glm::dvec2& v) const {
    CausticPhoton photon;
    photon.target = share.index;
    photon.range = 1e30f;
    if (!punctual_) {
        const auto found = std::ranges::lower_bound(triangles_, static_cast<float>(v.x), {},
                                                    [](const auto& t) { return t.p0.w; });
        const std::size_t i =
            std::min(static_cast<std::size_t>(found - triangles_.begin()), triangles_.size() - 1);
        const render::EmissiveTriangleData& t = triangles_[i];
        const double before = i > 0 ? static_cast<double>(triangles_[i - 1].p0.w) : 0.0;
        const double chance = std::max(static_cast<double>(t.p0.w) - before, 1e-12);
        const double root = std::sqrt(std::clamp((v.x - before) / chance, 0.0, 1.0));
        const dvec3 p0{vec3(t.p0)}, p1{vec3(t.p1)}, p2{vec3(t.p2)};
        const dvec3 from = p0 * (1 - root) + p1 * (root * (1 - v.y)) + p2 * (root * v.y);
        const dvec3 normal = glm::normalize(glm::cross(p1 - p0, p2 - p0));
        const bool both = t.p1.w > 0.5f;
        CausticAim from_here = aim_at(share.target.bounds, from);
        double cosine = 0;
        dvec3 direction;
        if (from_here.one_less_cosine < 1) {
            direction = in_cone(from_here, u);
            cosine = glm::dot(normal, direction);
            cosine = both ? std::abs(cosine) : std::max(cosine, 0.0);
            cosine *= from_here.solid_angle();
        } else {  // so near that the half space is better, by the cosine; both sides by turns
            const bool back = both && u.x >= 0.5;
            const double w = both ? (back ? 2 * u.x - 1 : 2 * u.x) : u.x;
            CausticAim hemisphere;
            hemisphere.axis = back ? -normal : normal;
            const double z = std::sqrt(1 - w);
            hemisphere.one_less_cosine = 1 - z;
            direction = in_cone(hemisphere, {1, u.y});
            cosine = both ? 2 * pi : pi;
        }
        const dvec3 radiance{vec3(t.radiance)};
        photon.power = vec3(radiance * (cosine * static_cast<double>(t.radiance.w) / chance / weight));
        photon.direction = vec3(direction);
        // Off its own surface by what fp32 needs.
        const double off =
            1e-6 * std::max({glm::length(from), std::sqrt(static_cast<double>(t.radiance.w)), 1e-30});
        photon.origin = vec3(from + normal * (glm::dot(normal, direction) < 0 ? -off : off));
        return photon;
    }
    const Light& light = light_.light;
    const dvec3 intensity = dvec3(light.colour) * static_cast<double>(light.intensity);
    if (light.type == LightType::directional) {
        photon.origin = vec3(aim.corner + aim.right * u.x + aim.up * u.y - aim.axis * far_);
        photon.direction = light_.direction;
        photon.power = vec3(intensity * (aim.area() / weight));
        return photon;
    }
    const dvec3 direction = in_cone(aim, u);
    const double share_of_it =
        light.type == LightType::spot ? cone(light, glm::dot(direction, dvec3(light_.direction))) : 1.0;
    photon.origin = light_.position;
    photon.direction = vec3(direction);
    photon.power = vec3(intensity * (aim.solid_angle() * share_of_it / weight));
    photon.range = std::min(light.range, 1e30f);
    return photon;
}

std::vector<CausticPhoton> CausticSource::emit(int count, std::uint32_t seed, int pass) const {
    std::vector<CausticPhoton> photons;
    if (count <= 0 || !(flux_ > 0)) {
        return photons;
    }
    photons.reserve(static_cast<std::size_t>(count));
    // Systematic sampling: photon i serves the share that (i + start) / count of all flux falls on.
    const std::uint32_t own = mixed(seed * 0x9e3779b9u + mixed(id_ * 2 + (punctual_ ? 0 : 1)));
    const double start = sequence(static_cast<std::uint32_t>(pass), 2654435769u, own);
    double before = 0;
    int sent = 0;
    for (const Share& share : shares_) {
        const double wanted = share.flux / flux_ * count;
        before += wanted;
        const int end = std::clamp(static_cast<int>(std::ceil(before - start)), sent, count);
        const int here = &share == &shares_.back() ? count - sent : end - sent;
        const auto number_of = static_cast<std::uint32_t>(std::max(here, 1));
        // So many that none may be missed: of each is known how many there are. Else what each stands for.
        const double weight = wanted >= 1 ? number_of : wanted;
        const std::uint32_t key = mixed(own ^ mixed(static_cast<std::uint32_t>(share.target.key >> 32) * 31 +
                                                    static_cast<std::uint32_t>(share.target.key)));
        CausticAim aim;
        if (punctual_) {
            if (light_.light.type == LightType::directional) {
                aim = aim_beam(share.target.bounds, dvec3(light_.direction));
            } else {
                aim = aim_at(share.target.bounds, dvec3(light_.position));
                const double spot = 1 - std::cos(static_cast<double>(light_.light.outer_cone));
                if (light_.light.type == LightType::spot && spot < aim.one_less_cosine) {
                    aim.axis = dvec3(light_.direction);
                    aim.one_less_cosine = spot;
                }
            }
        }
        for (int i = 0; i < here; ++i) {
            const std::uint32_t j =
                static_cast<std::uint32_t>(i) + static_cast<std::uint32_t>(pass) * number_of;
            const Numbers n = punctual_ ? plane_numbers(j, key) : surface_numbers(j, key);
            CausticPhoton photon =
                sky_ ? from_sky(share, weight, n.u, n.v) : emit_one(share, aim, weight, n.u, n.v);
            photon.key = key;
            photon.number = j;
            photons.push_back(photon);
        }
        sent += here;
    }
    return photons;
}

}  // namespace lanthorn::gi
