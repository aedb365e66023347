#include "engine/render/area_samples.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <span>

#include "engine/render/emissive_parts.h"
#include "engine/render/near_emitters.h"
#include "lanthorn/core/colour.h"

namespace lanthorn::render {

namespace {

// Of points, where there are more surfaces than `area_lights_max` times `area_lights_samples`.
constexpr std::size_t kMostSamples = 64;
// Of those, for all surfaces together that have none of their own.
constexpr int kMergedSamples = 16;
// Of all samples together that have nodes of their own. Nodes are 1 MiB then.
constexpr std::size_t kMostNearFaces = 8192;

using Surface = EmissiveTriangles::Surface;

EmissiveShape shape_of(const EmissiveTriangles& emissive, const Surface& surface) {
    return {emissive.triangles().subspan(surface.first, surface.count),
            emissive.at_rest().subspan(surface.first, surface.count)};
}

// How many points each surface has of `total`: what it wants, or at least one, and more to those of which
// each point stands for most light.
std::vector<int> shares_of(std::span<const Surface> surfaces, std::vector<int> wanted, std::size_t total) {
    std::vector<int> shares(surfaces.size(), 1);
    for (std::size_t left = total - std::min(total, surfaces.size()); left > 0; --left) {
        std::size_t best = surfaces.size();
        float most = 0;
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            const float each = luminance(surfaces[i].flux) / static_cast<float>(shares[i]);
            if (shares[i] < wanted[i] && (best == surfaces.size() || each > 1.0001f * most)) {
                best = i;
                most = each;
            }
        }
        if (best == surfaces.size()) {
            break;
        }
        ++shares[best];
    }
    return shares;
}

LightData describe(const EmissiveTriangleData& t, const EmissiveSample& sample, std::uint32_t id) {
    LightData light{};
    light.position = sample.point;
    light.range = 1e30f;
    light.direction = sample.normal;
    light.type = kLightAreaSample;
    light.intensity = sample.radiance;
    light.area = sample.area;
    light.cos_outer = -1;
    light.layers = 6;
    light.extent = 1;
    light.id = id;
    light.two_sided = t.p1.w > 0 ? 1 : 0;
    return light;
}

// The weakest surfaces: one-sided triangles and two-sided ones apart, as neither is a measure of the other.
void add_merged(const EmissiveTriangles& emissive, std::span<const Surface> surfaces,
                std::vector<LightData>& to) {
    struct Kind {
        std::vector<EmissiveTriangleData> shown;
        std::vector<EmissiveTriangles::Rest> rest;
    };
    std::array<Kind, 2> kinds;
    for (const Surface& surface : surfaces) {
        for (const EmissiveTriangleData& t : shape_of(emissive, surface).shown) {
            Kind& kind = kinds[t.p1.w > 0 ? 1 : 0];
            kind.shown.push_back(t);
            kind.rest.push_back({{vec3(t.p0), vec3(t.p1), vec3(t.p2)}});
        }
    }
    const bool both = !kinds[0].shown.empty() && !kinds[1].shown.empty();
    for (const Kind& kind : kinds) {
        if (!kind.shown.empty()) {
            for (const EmissiveSample& sample :
                 emissive_samples({kind.shown, kind.rest}, both ? kMergedSamples / 2 : kMergedSamples)) {
                to.push_back(describe(kind.shown.front(), sample, kMergedSurfaces));
            }
        }
    }
}

}  // namespace

AreaSamples make_area_samples(const EmissiveTriangles& emissive, const RenderSettings& settings) {
    const int flat = std::max(settings.area_lights_samples, 1);
    const auto points = static_cast<std::size_t>(std::max(settings.area_lights_max, 0) * flat);
    if (points == 0) {
        return {};
    }
    std::vector<Surface> surfaces(emissive.surfaces().begin(), emissive.surfaces().end());
    std::ranges::stable_sort(surfaces, std::ranges::greater{},
                             [](const Surface& s) { return luminance(s.flux); });
    const std::size_t most = std::max(points, kMostSamples);
    const std::size_t own = surfaces.size() <= most ? surfaces.size() : most - kMergedSamples;
    const std::span<const Surface> strongest(surfaces.data(), own), merged = std::span(surfaces).subspan(own);

    std::vector<int> wanted;
    for (const Surface& surface : strongest) {
        wanted.push_back(
            own < points ? samples_wanted(shape_of(emissive, surface), flat, static_cast<int>(points)) : 1);
    }
    const std::vector<int> shares = shares_of(strongest, std::move(wanted), points);
    const auto near_faces =
        kMostNearFaces /
        std::max<std::size_t>(1, std::accumulate(shares.begin(), shares.end(), std::size_t{0}));
    AreaSamples result;
    std::vector<LightData>& samples = result.lights;
    for (std::size_t i = 0; i < own; ++i) {
        const EmissiveShape shape = shape_of(emissive, strongest[i]);
        for (const EmissiveSample& sample : emissive_samples(shape, shares[i])) {
            samples.push_back(describe(shape.shown.front(), sample, strongest[i].instance_id));
            if (sample.connected) {
                add_near_emitter(sample, near_faces, samples.back(), result.nodes);
            }
        }
    }
    add_merged(emissive, merged, samples);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i].first_layer = static_cast<std::uint32_t>(i) * 6;
        samples[i].texel = 2.0f / static_cast<float>(settings.area_lights_resolution);
    }
    return result;
}

}  // namespace lanthorn::render
