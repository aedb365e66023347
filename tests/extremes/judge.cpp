#include "tests/extremes/judge.h"
#include "lanthorn/emc/emc_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "lanthorn/emc/emc_settings.h"
#include "tests/extremes/scenes.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::extremes {

namespace {

constexpr int kOrdinarySpp = 256;

struct OrdinaryScene {
    Truth truth;
    std::vector<float> lux;
    std::vector<float> direct;
    Difference off;
};

const OrdinaryScene& ordinary(Ordinary which, ivec2 size) {
    static std::map<std::tuple<Ordinary, int, int>, OrdinaryScene> made;
    const auto [entry, fresh] = made.try_emplace({which, size.x, size.y});
    OrdinaryScene& result = entry->second;
    if (fresh) {
        const float albedo = 0.5f;
        const FrameScene scene = frame_of(which == Ordinary::room ? room() : sphere(albedo), {});
        const int bounces = gi::GiSettings{}.bounces;
        result.truth = which == Ordinary::room ? traced_truth(scene, size, bounces, kOrdinarySpp)
                                               : constant_truth(sphere_irradiance(albedo, bounces), size);
        gi::test::Bench bench;
        result.lux = bench.frame(scene, size).pixels;
        result.direct = bench.renderer().read(render::Aov::direct).pixels;
        result.off = difference(result.lux, result.truth);
    }
    return result;
}

// Bulbs 4 pi I, single-sided panels pi L A, the sky what the box around the scene catches; lumen, green.
double emitted(const FrameScene& scene) {
    double flux = 0;
    for (const LightInstance& l : scene.lights) {
        flux += 4 * std::numbers::pi * static_cast<double>(l.light.intensity * l.light.colour.y);
    }
    if (scene.sky) {
        const SkyImage& image = *scene.sky->sky.lights_by();
        const vec3 size = scene.bounds.upper - scene.bounds.lower;
        for (std::uint32_t y = 0; y < image.height; ++y) {
            for (std::uint32_t x = 0; x < image.width; ++x) {
                const vec2 middle = (vec2(x, y) + 0.5f) / vec2(image.width, image.height);
                const vec3 d = glm::abs(glm::transpose(scene.sky->to_sky) * sky_direction(middle));
                const float across = d.x * size.y * size.z + d.y * size.z * size.x + d.z * size.x * size.y;
                flux += static_cast<double>(image.at(x, y).y * across) * image.pixel_solid_angle(y);
            }
        }
    }
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.assets->meshes[instance.mesh];
        const float nits = scene.assets->materials[mesh.material].emissive.y;
        for (std::size_t i = 0; nits > 0 && i < mesh.indices.size(); i += 3) {
            const auto corner = [&](std::size_t k) {
                return dvec3(mesh.vertices[mesh.indices[i + k]].position);
            };
            const double area = 0.5 * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
            flux += std::numbers::pi * static_cast<double>(nits) * area;
        }
    }
    return flux;
}

double gained(const gi::PhotonStatistics& photons, double albedo) {
    double most = 0;
    for (std::size_t b = 0; b < photons.flux_stored.size(); ++b) {
        const dvec3 bound = photons.flux_emitted * std::pow(albedo, static_cast<double>(b + 1));
        for (int c = 0; c < 3; ++c) {
            if (bound[c] > 0) most = std::max(most, photons.flux_stored[b][c] / bound[c]);
        }
    }
    return most;
}

Truth truth_of(const Row& row, const FrameScene& scene) {
    switch (row.right) {
        case Right::ordinary:
            return brighter(ordinary(row.ordinary, row.size).truth, row.gain);
        case Right::constant:
            return constant_truth(row.lux, row.size);
        case Right::traced:
            break;
    }
    return traced_truth(scene, row.size, row.settings.bounces, row.spp);
}

Outcome outcome_of_seed(const Row& row, const Stage& stage, const FrameScene& scene, const Truth& truth) {
    gi::test::Bench bench;
    bench.settings = row.settings;
    Outcome result;
    result.lux = bench.frame(scene, row.size).pixels;
    const auto not_finite = [](float v) { return !std::isfinite(v); };
    for (const render::Aov aov :
         {render::Aov::indirect, render::Aov::direct, render::Aov::radiance, render::Aov::final}) {
        const std::vector<float> pixels = bench.renderer().read(aov).pixels;
        result.not_finite += static_cast<std::uint64_t>(std::ranges::count_if(pixels, not_finite));
    }
    result.negative =
        static_cast<std::uint64_t>(std::ranges::count_if(result.lux, [](float v) { return v < 0; }));
    result.replaced = bench.renderer().nan_count();
    result.statistics = bench.technique().statistics(true);
    const gi::PhotonStatistics& photons = result.statistics.of<gi::PhotonStatistics>();
    result.gained = gained(photons, static_cast<double>(largest_albedo(stage)));
    if (photons.emitted > 0) {
        result.emission_off = std::abs(photons.flux_emitted.y / emitted(scene) - 1);
        result.lost = static_cast<double>(photons.lost) /
                      static_cast<double>(photons.emitted * photons.flux_stored.size());
    }
    result.off = difference(result.lux, truth);
    const OrdinaryScene& usual = ordinary(row.ordinary, row.size);
    result.ordinary_error = usual.off.rel_rmse;
    if (row.right == Right::ordinary) {
        const auto unlike = [&](const std::vector<float>& image, const std::vector<float>& usual_image) {
            return difference(image, brighter({usual_image, 0}, row.gain)).rel_rmse;
        };
        result.unlike = std::max(unlike(result.lux, usual.lux),
                                 unlike(bench.renderer().read(render::Aov::direct).pixels, usual.direct));
    }
    return result;
}

// Means of what is bounded, sums of what must be nought, the worst of what must hold for each.
void add(Outcome& sum, const Outcome& o, double share) {
    sum.not_finite += o.not_finite;
    sum.negative += o.negative;
    sum.replaced += o.replaced;
    sum.statistics.nan_count += o.statistics.nan_count;
    sum.gained = std::max(sum.gained, o.gained);
    sum.emission_off = std::max(sum.emission_off, o.emission_off);
    sum.unlike = std::max(sum.unlike, o.unlike);
    sum.lost += share * o.lost;
    sum.off.rel_rmse += share * o.off.rel_rmse;
    sum.off.flux_ratio += share * o.off.flux_ratio;
    sum.off.leak += share * o.off.leak;
}

}  // namespace

Outcome outcome_of(const Row& row) {
    const Stage stage = row.stage();
    const FrameScene scene = frame_of(stage, row.placement);
    static std::map<std::string, Truth> known;  // both final stages have the same
    const auto [entry, fresh] = known.try_emplace(row.name);
    if (fresh) {
        entry->second = truth_of(row, scene);
    }
    const Truth& truth = entry->second;
    Outcome result = outcome_of_seed(row, stage, scene, truth);
    const double share = 1.0 / row.seeds;
    for (double* mean : {&result.lost, &result.off.rel_rmse, &result.off.flux_ratio, &result.off.leak}) {
        *mean *= share;
    }
    Row next = row;
    for (int i = 1; i < row.seeds; ++i) {
        ++next.settings.seed;
        add(result, outcome_of_seed(next, stage, scene, truth), share);
    }
    return result;
}

std::vector<std::string> complaints(const Row& row, const Outcome& o) {
    std::vector<std::string> lines;
    const auto at_most = [&](Bound bound, const char* what, double value, double limit) {
        const auto defect = std::ranges::find(row.defects, bound, &Defect::bound);
        if (defect == row.defects.end()) {
            if (!(value <= limit)) {
                lines.push_back(fmt::format("{} is {:.4g}, at most {:.4g}", what, value, limit));
            }
            return;
        }
        if (!(value <= defect->ceiling)) {
            lines.push_back(fmt::format("{} is {:.4g}, and known to be at most {:.4g}: {}", what, value,
                                        defect->ceiling, defect->why));
        }
        if (value <= limit) {
            lines.push_back(fmt::format("{} is {:.4g}, within {:.4g} again: this defect can go: {}", what,
                                        value, limit, defect->why));
        }
    };
    const auto at_least = [&](const char* what, double value, double bound) {
        if (!(value >= bound)) {
            lines.push_back(fmt::format("{} is {:.4g}, at least {:.4g}", what, value, bound));
        }
    };
    at_most(Bound::error, "relRMSE", o.off.rel_rmse, row.error * o.ordinary_error);
    at_most(Bound::flux, "flux ratio's distance from 1", std::abs(o.off.flux_ratio - 1), row.flux);
    at_most(Bound::leak, "light in the dark", o.off.leak, row.leak);
    at_least("share of the picture in the dark", o.off.dark, row.dark);
    at_least("maps", o.statistics.of<gi::EmcStatistics>().k, row.bounces > 0 ? row.least_maps : 0);
    if (row.settings.of<gi::EmcSettings>().final_stage == gi::EmcFinal::gather) {
        return lines;  // it has no photons
    }
    at_most(Bound::unlike, "relRMSE against the ordinary image", o.unlike, row.unlike);
    at_most(Bound::lost, "share of photons lost a bounce", o.lost, row.lost);
    at_least("arrivals", static_cast<double>(o.statistics.of<gi::PhotonStatistics>().stored),
             row.bounces > 0 ? static_cast<double>(row.least_stored) : 0);
    return lines;
}

Difference ordinary_difference(Ordinary which, ivec2 size) {
    return ordinary(which, size).off;
}

}  // namespace lanthorn::extremes
