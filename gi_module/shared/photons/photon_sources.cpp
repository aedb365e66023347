#include "gi_module/shared/photons/photon_sources.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gi_module/reference/emitters.h"
#include "gi_module/reference/random.h"
#include "gi_module/reference/sampling.h"

namespace lanthorn::gi {

namespace {

using std::numbers::pi;

constexpr double kChromaticities = 255;  // steps a channel, of the brightest channel
constexpr int kSkySamples = 256;         // that tell the sky's colour

double strongest(const dvec3& flux) {
    return std::max({flux.x, flux.y, flux.z});
}

std::uint64_t chromaticity(const dvec3& flux) {
    const dvec3 c = flux * (kChromaticities / strongest(flux)) + 0.5;
    return static_cast<std::uint64_t>(c.x) << 32 | static_cast<std::uint64_t>(c.y) << 16 |
           static_cast<std::uint64_t>(c.z);
}

vec3 about(const vec3& axis, double cosine, float turns) {
    const auto z = static_cast<float>(cosine);
    const float flat = std::sqrt(std::max(1 - z * z, 0.0f));
    const vec2 circle = reference::on_circle(turns);
    return reference::unit(reference::Basis(axis).to_world({flat * circle.x, flat * circle.y, z}));
}

}  // namespace

PhotonSources::SpotCone::SpotCone(const Light& light)
    : outer_(std::cos(static_cast<double>(light.outer_cone))),
      scale_(1 / std::max(1e-3, std::cos(static_cast<double>(light.inner_cone)) - outer_)),
      whole_(std::min(outer_ + 1 / scale_, 1.0)),
      ramp_(std::pow(whole_ - outer_, 3) * scale_ * scale_ / 3) {}

double PhotonSources::SpotCone::solid_angle() const {
    return 2 * pi * (ramp_ + 1 - whole_);
}

double PhotonSources::SpotCone::cosine(double u) const {
    const double chosen = u * (ramp_ + 1 - whole_);
    return chosen < ramp_ ? outer_ + std::cbrt(3 * chosen / (scale_ * scale_)) : whole_ + chosen - ramp_;
}

PhotonSources::Aim PhotonSources::aim(const LightInstance& instance) const {
    Aim result;
    switch (instance.light.type) {
        case LightType::directional:
            result.box = aim_beam(box_, dvec3(instance.direction));
            result.size = result.box.area();
            break;
        case LightType::point: {
            result.box = aim_at(box_, dvec3(instance.position));
            result.size = result.box.solid_angle();
            const reference::BasisOf<double> basis(result.box.axis);
            result.right = basis.tangent;
            result.up = basis.bitangent;
            break;
        }
        case LightType::spot:
            result.cone = SpotCone(instance.light);
            result.size = result.cone.solid_angle();
            break;
    }
    if (instance.light.type != LightType::directional && !(instance.light.range > 0)) {
        result.size = 0;
    }
    return result;
}

void PhotonSources::add(const dvec3& flux, Source source, std::vector<Colour>& colours) const {
    if (!(strongest(flux) > 0) || !std::isfinite(flux.x + flux.y + flux.z)) {
        return;
    }
    const std::uint64_t key = chromaticity(flux);
    auto found = std::ranges::find(colours, key, &Colour::key);
    if (found == colours.end()) {
        colours.push_back({key, dvec3(0), {}});
        found = colours.end() - 1;
    }
    found->flux += flux;
    source.end = strongest(found->flux);
    found->sources.push_back(source);
}

PhotonSources::PhotonSources(const reference::TraceScene& scene, const reference::MaterialTable& materials,
                             KeptEmissivePieces* kept)
    : scene_(&scene), materials_(&materials) {
    const FrameScene& frame = scene.frame();
    if (frame.bounds.empty()) {
        return;
    }
    // A little larger, so that what lies on it is not missed by rounding.
    const vec3 margin(1e-4f * frame.diagonal());
    box_ = Aabb{frame.bounds.lower - margin, frame.bounds.upper + margin};
    far_ = static_cast<double>(frame.diagonal());
    std::vector<Colour> colours;
    for (std::uint32_t i = 0; i < frame.lights.size(); ++i) {
        const Light& light = frame.lights[i].light;
        aims_.push_back(aim(frame.lights[i]));
        add(dvec3(light.colour) * (static_cast<double>(light.intensity) * aims_[i].size), {0, i, false},
            colours);
    }
    KeptEmissivePieces own;
    for (std::uint32_t i = 0; i < scene.instances().size(); ++i) {
        const reference::TraceInstance& instance = scene.instances()[i];
        const reference::MaterialConstants& material = materials[instance.material];
        if (!material.emits) {
            continue;
        }
        const mat4& transform = frame.instances[i].transform;
        const auto pieces = reference::pieces_of(scene, i, kept != nullptr ? *kept : own);
        const vec3 share = pieces ? mean_share(*instance.mesh, transform, *pieces) : vec3(1);
        const vec3 mean = material.emitted * share;
        const auto& indices = instance.mesh->indices;
        for (std::uint32_t k = 0; k < indices.size() / 3; ++k) {
            dvec3 p[3];
            for (std::size_t v = 0; v < 3; ++v) {
                const Vertex& vertex = instance.mesh->vertices[indices[3 * std::size_t{k} + v]];
                p[v] = dvec3(vec3(transform * vec4(vertex.position, 1)));
            }
            const double area = 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
            add(dvec3(mean) * (area * pi * (material.double_sided ? 2 : 1)),
                {0, static_cast<std::uint32_t>(triangles_.size()), true}, colours);
            const reference::TraceTriangle& traced = scene.triangles()[instance.first_triangle + k];
            triangles_.push_back({vec3(p[0]), vec3(p[1] - p[0]), vec3(p[2] - p[0]), traced.normal,
                                  traced.offset, i, k, material.double_sided, material.emits_evenly, mean});
        }
    }
    double total = 0;
    for (Colour& colour : colours) {
        total += strongest(colour.flux);
        groups_.push_back({vec3(colour.flux), total, false});
        sources_.push_back(std::move(colour.sources));
    }
    if (frame.sky) {
        auto sky = std::make_shared<const CausticSky>(*frame.sky);
        if (sky->flux_towards(box_) > 0) {
            sky_ = std::move(sky);
            dvec3 mean(0);
            for (std::uint32_t k = 0; k < kSkySamples; ++k) {
                const reference::RandomNumbers random(1, 0, k);
                mean += sky_->enter(box_, glm::dvec2(random.pair(0)), glm::dvec2(random.pair(1))).power;
            }
            mean /= kSkySamples;
            total += strongest(mean);
            groups_.push_back({vec3(mean), total, true});
            sources_.emplace_back();
        }
    }
    for (LightGroup& group : groups_) {
        group.end /= total;
    }
}

// Walks of the first so many groups among those before a block. 1024 shares of a double are exact enough for
// 2^40 walks.
std::uint64_t PhotonSources::before(std::size_t groups, std::uint64_t block) const {
    if (groups == groups_.size()) {
        return block * kBlock;
    }
    const double end = groups > 0 ? groups_[groups - 1].end : 0.0;
    return static_cast<std::uint64_t>(end * static_cast<double>(block * kBlock));
}

PhotonSources::Place PhotonSources::place(std::uint64_t number) const {
    const std::uint64_t block = number / kBlock;
    // By reversed bits, so that any few walks in a row are of all groups.
    const std::uint64_t within =
        reference::reverse_bits(static_cast<std::uint32_t>(number % kBlock)) >> (32 - 10);
    static_assert(kBlock == 1u << 10);
    std::uint64_t first = 0;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        const std::uint64_t end = before(g + 1, block + 1) - before(g + 1, block);
        if (within < end) {
            return {g, before(g + 1, block) - before(g, block) + within - first};
        }
        first = end;
    }
    return {};  // without groups
}

std::vector<std::uint64_t> PhotonSources::paths(std::uint64_t count) const {
    std::vector<std::uint64_t> result(groups_.size(), 0);
    if (empty()) {
        return result;
    }
    const std::uint64_t block = count / kBlock;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        result[g] = before(g + 1, block) - before(g, block);
    }
    for (std::uint64_t number = block * kBlock; number < count; ++number) {
        ++result[place(number).group];
    }
    return result;
}

PhotonStart PhotonSources::from_light(std::uint32_t index, const vec3& flux, const vec2& u) const {
    const LightInstance& instance = scene_->frame().lights[index];
    const Light& light = instance.light;
    const Aim& aim = aims_[index];
    PhotonStart start{instance.position, {}, flux, std::min(light.range, 1e30f)};
    if (light.type == LightType::directional) {
        start.origin = vec3(aim.box.corner + aim.box.right * static_cast<double>(u.x) +
                            aim.box.up * static_cast<double>(u.y) - aim.box.axis * far_);
        start.direction = instance.direction;
        start.range = 1e30f;
    } else if (light.type == LightType::point) {
        const double less = static_cast<double>(u.x) * aim.box.one_less_cosine;
        const glm::dvec2 circle =
            glm::dvec2(reference::on_circle(u.y)) * std::sqrt(std::max(less * (2 - less), 0.0));
        start.direction = vec3(aim.box.axis * (1 - less) + aim.right * circle.x + aim.up * circle.y);
    } else {
        start.direction = about(instance.direction, aim.cone.cosine(static_cast<double>(u.x)), u.y);
    }
    return start;
}

PhotonStart PhotonSources::from_triangle(const Triangle& t, const vec3& flux, const Pairs& u) const {
    const vec3 b = reference::triangle_point(u[0]);
    const vec3 normal = t.both && u[2].x < 0.5f ? -t.normal : t.normal;
    PhotonStart start;
    start.origin = t.corner + t.edge1 * b.y + t.edge2 * b.z;
    start.normal = normal;
    start.offset = t.offset;
    start.flux = flux;
    if (!t.even) {
        const reference::TraceInstance& instance = scene_->instances()[t.instance];
        const vec3 here = materials_->emission(instance, t.primitive, {b.y, b.z});
        for (glm::length_t c = 0; c < 3; ++c) {
            start.flux[c] *= t.mean[c] > 0 ? here[c] / t.mean[c] : 0.0f;
        }
    }
    return start;
}

PhotonStart PhotonSources::from_sky(const Pairs& u) const {
    const CausticSky::Entry entry = sky_->enter(box_, glm::dvec2(u[0]), glm::dvec2(u[kDirectionPair]));
    return {vec3(entry.place + entry.to_sky * far_), vec3(-entry.to_sky), vec3(entry.power), 1e30f};
}

PhotonStart PhotonSources::start(std::size_t group, const Pairs& u) const {
    const LightGroup& g = groups_[group];
    if (g.sky) {
        return from_sky(u);
    }
    const std::vector<Source>& sources = sources_[group];
    const double chosen = static_cast<double>(u[3].x) * sources.back().end;
    const auto found = std::ranges::upper_bound(sources, chosen, {}, &Source::end);
    const Source& source = found == sources.end() ? sources.back() : *found;
    return source.triangle ? from_triangle(triangles_[source.light], g.flux, u)
                           : from_light(source.light, g.flux, u[0]);
}

}  // namespace lanthorn::gi
