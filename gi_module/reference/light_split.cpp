#include "gi_module/reference/light_split.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "gi_module/reference/light_listeners.h"
#include "gi_module/reference/light_split_state.h"
#include "gi_module/reference/path_dimensions.h"
#include "gi_module/reference/sampling.h"
#include "lanthorn/core/colour.h"

namespace lanthorn::reference {

namespace {

using Occluders = std::vector<std::uint32_t>;

constexpr int kMostInTheWay = 64;  // surfaces, of one ray
using split::LampListener;
using split::SplitListener;
using split::SumListener;
using split::Tally;

}  // namespace

double Lux::value() const {
    return luminance(rgb);
}

Lux LightSplit::indirect() const {
    return {reflected.rgb + sky.rgb, std::hypot(reflected.noise, sky.noise)};
}

// The entities, each once, in order of their ids; more than kMostOccluders: none of them is told.
std::vector<std::uint32_t> LightSplitter::State::in_the_way(const DrawnLight& drawn) const {
    Occluders result;
    const float end = drawn.to_infinity ? std::numeric_limits<float>::infinity() : 1.0f;
    float nearest = 0;
    SurfaceHit hit;
    for (int layer = 0; layer < kMostInTheWay; ++layer) {
        if (!scene.intersect(drawn.from, drawn.span, nearest, end, Blended::by_chance, hit)) {
            std::ranges::sort(result);
            return result;
        }
        const std::uint32_t id = entity(hit.instance);
        if (std::ranges::find(result, id) == result.end()) {
            result.push_back(id);
        }
        if (result.size() > kMostOccluders) {
            return {};
        }
        nearest = std::nextafter(hit.t, std::numeric_limits<float>::infinity());
    }
    return {};
}

LightSplitter::LightSplitter(const FrameScene& scene, const PathSettings& settings)
    : state_(std::make_unique<State>(scene, settings)) {}
LightSplitter::~LightSplitter() = default;

bool LightSplitter::follow(const FrameScene& scene) {
    State& s = *state_;
    const auto same = [&](const Instance& a, const Instance& b) {
        const bool as_deformed = a.deformed == b.deformed &&
                                 (a.deformed == Instance::kNotDeformed ||
                                  s.frame.deformed[a.deformed].version == scene.deformed[b.deformed].version);
        return as_deformed && a.id == b.id && a.mesh == b.mesh && a.transform == b.transform;
    };
    if (scene.assets != s.frame.assets || scene.origin != s.frame.origin ||
        !std::ranges::equal(s.frame.instances, scene.instances, same)) {
        return false;
    }
    s.frame.lights = scene.lights;
    s.frame.camera = scene.camera;
    s.lights = PunctualLights(s.frame);
    if (s.frame.sky != scene.sky) {
        s.frame.sky = scene.sky;
        s.sky = SkyLight(s.frame);
    }
    s.integrator.emplace(s.scene, s.materials, s.emitters, s.lights, s.sky, s.settings);
    return true;
}

std::optional<LitPoint> LightSplitter::seen(const CameraView& camera, ivec2 size, ivec2 pixel) const {
    const CameraRays rays(camera, size);
    const auto first = state_->integrator->first_surface(
        rays.ray(static_cast<float>(pixel.x) + 0.5f, static_cast<float>(pixel.y) + 0.5f));
    if (!first) {
        return std::nullopt;
    }
    const SurfaceHit& hit = first->hit;
    return LitPoint{hit.position, hit.normal, state_->scene.triangles()[hit.triangle].offset,
                    state_->entity(hit.instance)};
}

template <class Visit>
void LightSplitter::State::visit_punctual(const LitPoint& point, const Visit& visit) const {
    const vec3 start = point.position + point.normal * point.offset;
    for (const PunctualLight& light : lights.all()) {
        const LightSample sample = PunctualLights::illuminance(light, point.position);
        const float cosine = glm::dot(point.normal, sample.to_light);
        const dvec3 lux = dvec3(sample.illuminance) * std::max(0.0, static_cast<double>(cosine));
        const DrawnLight drawn{{LightKind::punctual, light.index},
                               start,
                               sample.infinite ? sample.to_light : light.position - start,
                               sample.infinite};
        const bool reaches = luminance(lux) > 0;
        const bool open =
            reaches && !scene.occluded(drawn.from, drawn.span, drawn.to_infinity, Blended::by_chance);
        const float away = glm::length(light.position - point.position);
        visit(drawn, lux,
              open                                      ? Straight::lit
              : reaches                                 ? Straight::hidden
              : cosine <= 0                             ? Straight::behind
              : !sample.infinite && away >= light.range ? Straight::out_of_range
                                                        : Straight::out_of_cone);
    }
}

// By drawing one, for what paths' own directions bring as well (Veach 1997, sec. 9.2); `whole` without regard
// to that.
template <class Visit>
void LightSplitter::State::visit_emitter(const LitPoint& point, const RandomNumbers& random,
                                         const Visit& visit) const {
    const std::uint32_t dimension = vertex_dimension(kRadiancePath, 0);
    const vec2 choices = emitters.many() ? random.pair(dimension + kChoices) : vec2(0);
    vec2 u = random.pair(dimension + kEmitter);
    const EmitterTriangle& triangle = emitters.draw_triangle(choices.y, u);
    const vec3 at = triangle_point(u);
    const vec3 place = triangle.corner + triangle.edge1 * at.y + triangle.edge2 * at.z;
    const vec3 span = place - point.position;
    const float d2 = glm::dot(span, span);
    const vec3 l = d2 > 0 ? span / std::sqrt(d2) : vec3(0);
    const float facing = -glm::dot(triangle.normal, l);
    const float lit = glm::dot(point.normal, l);
    const float cosine = triangle.two_sided ? std::abs(facing) : facing;
    if (!(cosine > 0) || !(lit > 0)) {
        return;
    }
    const float inverse = cosine / (triangle.density * d2);
    const float ratio = lit / kPi * inverse;
    const dvec3 whole(emitters.radiance(triangle, {at.y, at.z}) * (lit * inverse));
    const vec3 start = point.position + point.normal * point.offset;
    const vec3 side = facing < 0 ? -triangle.normal : triangle.normal;
    const DrawnLight drawn{
        {LightKind::emitter, triangle.instance}, start, place + side * triangle.offset - start, false};
    visit(drawn, whole / (1 + static_cast<double>(ratio * ratio)), whole,
          !scene.occluded(drawn.from, drawn.span, false, Blended::by_chance));
}

// A batch of starts at the point, each with random numbers of its own: even numbers alone, one scrambled
// sequence a batch.
std::vector<IrradianceStart> LightSplitter::State::starts(const LitPoint& point, int batch,
                                                          int samples) const {
    std::vector<IrradianceStart> result;
    result.reserve(static_cast<std::size_t>(samples));
    for (int i = 0; i < samples; ++i) {
        result.push_back({point.position, point.normal, point.offset,
                          RandomNumbers(settings.seed, static_cast<std::uint32_t>(batch),
                                        2 * static_cast<std::uint32_t>(i))});
    }
    return result;
}

// The same paths in the scene without what promises most: what lamps then give by reflection is no guess.
template <class ReflectedOf>
void LightSplitter::State::look_without(const LitPoint& point, int samples, LightSplit& split,
                                        const ReflectedOf& reflected_of) const {
    std::map<Occluders, double> promised;
    for (const HiddenPart& part : split.hidden) {
        promised[part.occluders] += part.direct.value() + part.reflected.value();
    }
    std::vector<std::pair<double, Occluders>> most;
    most.reserve(promised.size());
    for (const auto& [occluders, lux] : promised) {
        most.emplace_back(lux, occluders);
    }
    std::ranges::stable_sort(most, std::greater(), &std::pair<double, Occluders>::first);
    most.resize(std::min(most.size(), kMostWithout));
    std::vector<vec3> lux(static_cast<std::size_t>(samples));
    for (const auto& [promise, occluders] : most) {
        std::vector<std::uint32_t> instances;
        for (std::uint32_t i = 0; i < frame.instances.size(); ++i) {
            if (std::ranges::find(occluders, entity(i)) != occluders.end()) {
                instances.push_back(i);
            }
        }
        Integrator without = *integrator;
        without.leave_out(std::move(instances));
        LampListener<State> listener(*this);
        for (int b = 0; b < kBatches; ++b) {
            listener.batch = b;
            without.irradiance(starts(point, b, samples), lux, &listener);
        }
        for (HiddenPart& part : split.hidden) {
            if (part.occluders == occluders) {
                Tally gain = reflected_of(part.source);
                for (int b = 0; b < kBatches; ++b) {
                    gain.sums[static_cast<std::size_t>(b)] =
                        listener.lamps[part.source].sums[static_cast<std::size_t>(b)] -
                        gain.sums[static_cast<std::size_t>(b)];
                }
                part.reflected = gain.mean(samples);
                part.whole = true;
            }
        }
    }
    std::ranges::stable_sort(split.hidden, std::greater(),
                             [](const HiddenPart& h) { return h.direct.value() + h.reflected.value(); });
}

LightSplit LightSplitter::split(const LitPoint& point, int paths) const {
    return split_parts(point, paths, true);
}

std::vector<LampPart> LightSplitter::lamps(const LitPoint& point, int paths) const {
    return split_parts(point, paths, false).lamps;
}

LightSplit LightSplitter::split_parts(const LitPoint& point, int paths, bool with_hidden) const {
    const State& s = *state_;
    const int samples = std::max(1, (paths + kBatches - 1) / kBatches);
    SplitListener<State> listener(s, point, static_cast<std::size_t>(samples), with_hidden);
    std::map<LightSource, Straight> dark;
    s.visit_punctual(point, [&](const DrawnLight& drawn, const dvec3& lux, Straight straight) {  // exact
        dark[drawn.source] = straight;
        for (int b = 0; b < kBatches; ++b) {
            listener.batch = b;
            listener.add(drawn.source, 0, 0,
                         straight == Straight::lit ? lux * static_cast<double>(samples) : dvec3(0));
            if (straight == Straight::hidden) {
                listener.hide(drawn, 0, lux * static_cast<double>(samples));
            }
        }
    });
    std::vector<vec3> lux(static_cast<std::size_t>(samples));
    for (int b = 0; b < kBatches; ++b) {
        listener.batch = b;
        const std::vector<IrradianceStart> starts = s.starts(point, b, samples);
        for (const IrradianceStart& start : starts) {
            if (s.emitters.empty()) {
                break;
            }
            s.visit_emitter(point, start.random,
                            [&](const DrawnLight& drawn, const dvec3& light, const dvec3& whole, bool open) {
                                open ? listener.add(drawn.source, 0, 0, light)
                                     : listener.hide(drawn, 0, whole);
                            });
        }
        s.integrator->irradiance(starts, lux, &listener);
    }
    LightSplit result = listener.result(samples);
    s.look_without(point, samples, result,
                   [&](const LightSource& lamp) { return listener.reflected_of(lamp); });
    for (LampPart& lamp : result.lamps) {
        if (const auto found = dark.find(lamp.source); found != dark.end()) {
            lamp.straight = found->second;
        }
    }
    return result;
}

Lux LightSplitter::light(const LitPoint& point, int paths) const {
    const State& s = *state_;
    const int samples = std::max(1, (paths + kBatches - 1) / kBatches);
    Tally tally;
    std::vector<vec3> lux(static_cast<std::size_t>(samples));
    dvec3 direct(0);
    s.visit_punctual(point, [&](const DrawnLight&, const dvec3& light, Straight straight) {
        direct += straight == Straight::lit ? light : dvec3(0);
    });
    for (int b = 0; b < kBatches; ++b) {
        SumListener listener;
        const std::vector<IrradianceStart> starts = s.starts(point, b, samples);
        for (const IrradianceStart& start : starts) {
            if (!s.emitters.empty()) {
                s.visit_emitter(point, start.random,
                                [&](const DrawnLight&, const dvec3& light, const dvec3&, bool open) {
                                    listener.sum += open ? light : dvec3(0);
                                });
            }
        }
        s.integrator->irradiance(starts, lux, &listener);
        tally.add(b, listener.sum + direct * static_cast<double>(samples));
    }
    return tally.mean(samples);
}

}  // namespace lanthorn::reference
