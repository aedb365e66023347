// What LightSplitter listens to paths with: sums by what their light comes from.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "gi_module/reference/light_split.h"
#include "gi_module/reference/path_listener.h"
#include "lanthorn/core/colour.h"

namespace lanthorn::reference::split {

inline constexpr std::size_t kMostWays = 8;
inline constexpr int kBatches = LightSplitter::kBatches;

inline constexpr double kPiD = 3.14159265358979323846;

// Sums by batch.
struct Tally {
    std::array<dvec3, kBatches> sums{};

    void add(int batch, const dvec3& light) { sums[static_cast<std::size_t>(batch)] += light; }
    // Of batches of so many samples each.
    Lux mean(double samples) const {
        Lux result;
        for (const dvec3& sum : sums) {
            result.rgb += sum / (samples * kBatches);
        }
        double variance = 0;
        for (const dvec3& sum : sums) {
            const double off = luminance(sum) / samples - result.value();
            variance += off * off;
        }
        result.noise = std::sqrt(variance / (kBatches * (kBatches - 1.0)));
        return result;
    }
};

struct WayTally {
    double lux = 0, strongest = 0;
    std::vector<vec3> places;
};

// What the paths of one point bring, sorted.
template <class State>
class SplitListener final : public PathListener {
  public:
    SplitListener(const State& state, const LitPoint& point, std::size_t paths, bool with_hidden)
        : state_(state), point_(point), with_hidden_(with_hidden), vertices_(paths) {}

    int batch = 0;

    void begin(std::size_t first) override { first_ = first; }
    void meets(int sample, int number, const SurfaceHit& hit) override {
        std::vector<Vertex>& path = of(sample);
        path.resize(static_cast<std::size_t>(number) - 1);
        path.push_back({hit.position, state_.entity(hit.instance)});
    }
    void arrives(int sample, int reflections, const DrawnLight& drawn, const vec3& light) override {
        add(drawn.source, sample, reflections, dvec3(light) * kPiD);
        if (reflections > 0) {
            add_way(drawn, sample, reflections, luminance(dvec3(light)) * kPiD);
        }
    }
    void blocked(int sample, int reflections, const DrawnLight& drawn, const vec3& light) override {
        (void)sample;
        hide(drawn, reflections, dvec3(light) * kPiD);
    }
    void hide(const DrawnLight& drawn, int reflections, const dvec3& lux) {
        if (!with_hidden_) {
            return;
        }
        const std::vector<std::uint32_t> occluders = state_.in_the_way(drawn);
        if (!occluders.empty()) {
            auto& both = hidden_[{state_.lamp(drawn.source), occluders}];
            both[reflections > 0 ? 1 : 0].add(batch, lux);
        }
    }
    void add(const LightSource& source, int sample, int reflections, const dvec3& lux) {
        std::vector<Tally>& lamp = lamps_[state_.lamp(source)];
        lamp.resize(std::max(lamp.size(), static_cast<std::size_t>(reflections) + 1));
        lamp[static_cast<std::size_t>(reflections)].add(batch, lux);
        if (reflections > 0) {
            surfaces_[of(sample).front().entity].add(batch, lux);
            reflected_.add(batch, lux);
        } else {
            (source.kind == LightKind::sky ? sky_ : direct_).add(batch, lux);
        }
    }

    LightSplit result(double samples) const;
    // Reflected light of a lamp so far.
    Tally reflected_of(const LightSource& lamp) const {
        Tally sum;
        if (const auto found = lamps_.find(lamp); found != lamps_.end()) {
            for (std::size_t n = 1; n < found->second.size(); ++n) {
                for (int b = 0; b < kBatches; ++b) {
                    sum.add(b, found->second[n].sums[static_cast<std::size_t>(b)]);
                }
            }
        }
        return sum;
    }

  private:
    struct Vertex {
        vec3 place;
        std::uint32_t entity;
    };
    std::vector<Vertex>& of(int sample) { return vertices_[first_ + static_cast<std::size_t>(sample)]; }

    void add_way(const DrawnLight& drawn, int sample, int reflections, double lux) {
        if (!(lux > 0)) {
            return;
        }
        const std::vector<Vertex>& path = of(sample);
        const auto count = static_cast<std::size_t>(reflections);
        std::vector<std::uint32_t> entities;
        for (std::size_t i = 0; i < count; ++i) {
            entities.push_back(path[i].entity);
        }
        WayTally& way = ways_[{state_.lamp(drawn.source), std::move(entities)}];
        way.lux += lux;
        if (lux > way.strongest) {
            way.strongest = lux;
            way.places = {point_.position};
            for (std::size_t i = 0; i < count; ++i) {
                way.places.push_back(path[i].place);
            }
            const float reach = drawn.to_infinity ? state_.frame.diagonal() / glm::length(drawn.span) : 1.0f;
            way.places.push_back(drawn.from + drawn.span * reach);
        }
    }

    const State& state_;
    LitPoint point_;
    bool with_hidden_;
    std::size_t first_ = 0;
    std::vector<std::vector<Vertex>> vertices_;  // by path of the batch
    std::map<LightSource, std::vector<Tally>> lamps_;
    std::map<std::uint32_t, Tally> surfaces_;
    std::map<std::pair<LightSource, std::vector<std::uint32_t>>, std::array<Tally, 2>> hidden_;
    std::map<std::pair<LightSource, std::vector<std::uint32_t>>, WayTally> ways_;
    Tally direct_, reflected_, sky_;
};

// Reflected light by lamp.
template <class State>
class LampListener final : public PathListener {
  public:
    explicit LampListener(const State& state) : state_(state) {}

    int batch = 0;
    std::map<LightSource, Tally> lamps;

    void begin(std::size_t) override {}
    void meets(int, int, const SurfaceHit&) override {}
    void arrives(int, int reflections, const DrawnLight& drawn, const vec3& light) override {
        if (reflections > 0) {
            lamps[state_.lamp(drawn.source)].add(batch, dvec3(light) * kPiD);
        }
    }
    void blocked(int, int, const DrawnLight&, const vec3&) override {}

  private:
    const State& state_;
};

// All light that arrives, whatever its way.
class SumListener final : public PathListener {
  public:
    dvec3 sum{0};

    void begin(std::size_t) override {}
    void meets(int, int, const SurfaceHit&) override {}
    void arrives(int, int, const DrawnLight&, const vec3& light) override { sum += dvec3(light) * kPiD; }
    void blocked(int, int, const DrawnLight&, const vec3&) override {}
};

template <class State>
LightSplit SplitListener<State>::result(double samples) const {
    LightSplit split;
    split.direct = direct_.mean(samples);
    split.reflected = reflected_.mean(samples);
    split.sky = sky_.mean(samples);
    split.paths = static_cast<int>(samples) * kBatches;
    for (const auto& [source, tallies] : lamps_) {
        LampPart& lamp = split.lamps.emplace_back();
        lamp.source = source;
        lamp.entity = state_.entity_of(source);
        Tally sum;
        for (std::size_t n = 0; n < tallies.size(); ++n) {
            (n == 0 ? lamp.direct : lamp.reflected.emplace_back()) = tallies[n].mean(samples);
            for (int b = 0; b < kBatches; ++b) {
                sum.add(b, tallies[n].sums[static_cast<std::size_t>(b)]);
            }
        }
        lamp.sum = sum.mean(samples);
        lamp.straight = lamp.direct.value() > 0 ? Straight::lit : Straight::no_light;
    }
    for (const auto& [entity, tally] : surfaces_) {
        split.surfaces.push_back({entity, tally.mean(samples)});
    }
    for (const auto& [key, both] : hidden_) {
        split.hidden.push_back({key.first, state_.entity_of(key.first), key.second, both[0].mean(samples),
                                both[1].mean(samples), false});
        const auto lamp = std::ranges::find(split.lamps, key.first, &LampPart::source);
        if (lamp != split.lamps.end() && lamp->straight == Straight::no_light &&
            split.hidden.back().direct.value() > 0) {
            lamp->straight = Straight::hidden;
        }
    }
    for (const auto& [key, way] : ways_) {
        split.ways.push_back(
            {key.first, state_.entity_of(key.first), key.second, way.lux / (samples * kBatches), way.places});
    }
    std::ranges::stable_sort(split.lamps, std::greater(), [](const LampPart& l) { return l.sum.value(); });
    std::ranges::stable_sort(split.surfaces, std::greater(),
                             [](const SurfacePart& s) { return s.reflected.value(); });
    std::ranges::stable_sort(split.hidden, std::greater(),
                             [](const HiddenPart& h) { return h.direct.value() + h.reflected.value(); });
    std::ranges::stable_sort(split.ways, std::greater(), &LightWay::lux);
    split.ways.resize(std::min(split.ways.size(), kMostWays));
    return split;
}

}  // namespace lanthorn::reference::split
