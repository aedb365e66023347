#include "lanthorn/workbench/measure_coverage.h"
#include "lanthorn/emc/emc_statistics.h"
#include "lanthorn/scene/instance_shape.h"

#include <algorithm>
#include <cmath>

#include "gi_module/reference/emitters.h"
#include "gi_module/reference/lights.h"
#include "gi_module/reference/random.h"
#include "gi_module/reference/sampling.h"
#include "tools/workbench/measure/measured_scene.h"

namespace lanthorn::workbench {

namespace {

using namespace reference;

constexpr std::uint32_t kChoices = 0xffffffff;  // instead of a point's number
constexpr std::size_t kMostCandidates = 64;     // gi.emc.candidates
constexpr int kLightSamples = 4;  // a vertex of a walk, of punctual lights and of emissive triangles each

// Dimensions of the random numbers: of a point, of each vertex of a walk.
enum Dimension : std::uint32_t { kPlace, kVertex };
constexpr std::uint32_t kVertexDimensions = 2 + kLightSamples;

// The `i`-th of kLightSamples evenly spread choices.
float turned(float u, int i) {
    return glm::fract(u + static_cast<float>(i) / kLightSamples);
}

// One side of a triangle.
struct Side {
    std::uint32_t instance, primitive;
    bool front;
    double cumulative;  // m^2
};

// A point on a surface, and the side of it that is meant.
struct SurfacePoint {
    SurfaceHit hit;
    vec3 off{0};  // where rays start
};

class Reach {
  public:
    explicit Reach(const FrameScene& frame)
        : surfaces_(frame), emitters_(surfaces_.scene, surfaces_.materials), lights_(frame) {
        list_sides();
    }

    double area() const { return sides_.empty() ? 0 : sides_.back().cumulative; }

    // The point at share `u` of the area, at `place` on its triangle; false: a masked material leaves it out.
    bool point(double u, const vec2& place, SurfacePoint& result) const {
        const auto side = std::ranges::upper_bound(sides_, u * area(), {}, &Side::cumulative);
        const Side& s = side == sides_.end() ? sides_.back() : *side;
        const TraceInstance& instance = surfaces_.scene.instances()[s.instance];
        const vec3 weights = triangle_point(place);
        SurfaceHit& hit = result.hit;
        hit.instance = s.instance;
        hit.primitive = s.primitive;
        hit.triangle = instance.first_triangle + s.primitive;
        hit.front = s.front;
        hit.barycentric = vec2(weights.y, weights.z);
        const mat4& to_render = surfaces_.scene.frame().instances[s.instance].transform;
        hit.position = vec3(0);
        for (int corner = 0; corner < 3; ++corner) {
            const std::uint32_t v =
                instance.mesh->indices[3 * s.primitive + static_cast<std::uint32_t>(corner)];
            hit.position += weights[corner] * vec3(to_render * vec4(instance.mesh->vertices[v].position, 1));
        }
        const TraceTriangle& triangle = surfaces_.scene.triangles()[hit.triangle];
        hit.normal = s.front ? triangle.normal : -triangle.normal;
        result.off = off_surface(hit, hit.normal, triangle);
        return !surfaces_.materials.cut_out(instance, s.primitive, hit.barycentric);
    }

    bool reached(const SurfacePoint& from, int bounces, std::uint32_t seed, std::uint32_t number) const {
        for (std::uint32_t walk = 0; walk < kReachWalks; ++walk) {
            if (walk_meets_light(from, bounces, RandomNumbers(seed, number, walk))) {
                return true;
            }
        }
        return false;
    }

    bool seen_from(const SurfacePoint& p, const vec3& centre) const {
        const vec3 span = centre - p.off;
        return glm::dot(span, p.hit.normal) > 0 &&
               !surfaces_.scene.occluded(p.off, span, false, Blended::by_chance);
    }

  private:
    void list_sides() {
        double total = 0;
        const FrameScene& frame = surfaces_.scene.frame();
        for (std::uint32_t i = 0; i < frame.instances.size(); ++i) {
            const InstanceShape shape(frame, frame.instances[i]);
            const mat3 linear(frame.instances[i].transform);
            for (std::uint32_t t = 0; 3 * t + 2 < shape.indices().size(); ++t) {
                const double size = static_cast<double>(glm::length(shape.half_cross(t, linear)));
                for (const bool front : {true, false}) {
                    if (size > 0 && surfaces_.receives(i, front)) {
                        total += size;
                        sides_.push_back({i, t, front, total});
                    }
                }
            }
        }
    }

    bool walk_meets_light(const SurfacePoint& from, int bounces, const RandomNumbers& random) const {
        vec3 origin = from.off;
        vec3 normal = from.hit.normal;
        for (int b = 0; b < bounces; ++b) {
            const std::uint32_t dimension = kVertex + static_cast<std::uint32_t>(b) * kVertexDimensions;
            const auto next = surfaces_.arrival(origin, cosine_direction(normal, random.pair(dimension)));
            if (!next || !next->receives) {
                return false;
            }
            const SurfaceHit& hit = next->hit;
            const TraceInstance& instance = surfaces_.scene.instances()[hit.instance];
            if (is_black(surfaces_.materials.reflectance(instance, hit.primitive, hit.barycentric))) {
                return false;
            }
            origin = off_surface(hit, hit.normal, surfaces_.scene.triangles()[hit.triangle]);
            normal = hit.normal;
            if (lit(origin, normal, random, dimension + 1)) {
                return true;
            }
        }
        return false;
    }

    bool lit(const vec3& p, const vec3& normal, const RandomNumbers& random, std::uint32_t dimension) const {
        const vec2 choices = random.pair(dimension);
        for (int i = 0; i < kLightSamples && !lights_.empty(); ++i) {
            const PunctualLight& light = lights_.draw(turned(choices.y, i));
            const LightSample sample = PunctualLights::illuminance(light, p);
            const vec3 span = sample.infinite ? sample.to_light : light.position - p;
            if (!is_black(sample.illuminance) && glm::dot(sample.to_light, normal) > 0 &&
                !surfaces_.scene.occluded(p, span, sample.infinite, Blended::by_chance)) {
                return true;
            }
        }
        for (int i = 0; i < kLightSamples && !emitters_.empty(); ++i) {
            const vec2 place = random.pair(dimension + 1 + static_cast<std::uint32_t>(i));
            const EmitterSample sample = emitters_.draw(turned(choices.x, i), place);
            const vec3 span = sample.position - p;
            const float facing = -glm::dot(sample.normal, span);
            const vec3 end = span + sample.normal * (facing < 0 ? -sample.offset : sample.offset);
            if ((sample.two_sided || facing > 0) && glm::dot(span, normal) > 0 &&
                !surfaces_.scene.occluded(p, end, false, Blended::by_chance)) {
                return true;
            }
        }
        return false;
    }

    ExactSurfaces surfaces_;
    Emitters emitters_;
    PunctualLights lights_;
    std::vector<Side> sides_;
};

// `k` of the candidates, each choice as likely as another.
std::vector<std::uint64_t> random_choice(int candidates, int k, const RandomNumbers& random) {
    std::vector<std::uint64_t> left;
    left.reserve(static_cast<std::size_t>(candidates));
    for (int c = 0; c < candidates; ++c) {
        left.push_back(std::uint64_t{1} << c);
    }
    std::vector<std::uint64_t> chosen;
    for (int i = 0; i < std::min(k, candidates); ++i) {
        const float u = random.pair(static_cast<std::uint32_t>(i)).x;
        const auto at =
            std::min(static_cast<std::size_t>(u * static_cast<float>(left.size())), left.size() - 1);
        chosen.push_back(left[at]);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(at));
    }
    return chosen;
}

// `seen`: by point that light reaches, the candidates that see it, a bit each.
void draw_at_random(CoverageFigures& figures, const std::vector<std::uint64_t>& seen, int candidates, int k,
                    std::uint32_t seed) {
    RandomCoverage& random = figures.random;
    random.least = 1;
    double squares = 0;
    for (std::uint32_t draw = 0; draw < kRandomDraws; ++draw) {
        std::uint64_t chosen = 0;
        for (const std::uint64_t c : random_choice(candidates, k, RandomNumbers(seed, kChoices, draw))) {
            chosen |= c;
        }
        const auto covered = std::ranges::count_if(seen, [&](std::uint64_t s) { return (s & chosen) != 0; });
        const double share =
            static_cast<double>(covered) / static_cast<double>(std::max<std::size_t>(seen.size(), 1));
        random.mean += share / kRandomDraws;
        squares += share * share / kRandomDraws;
        random.least = std::min(random.least, share);
        random.most = std::max(random.most, share);
    }
    random.deviation = std::sqrt(std::max(squares - random.mean * random.mean, 0.0));
}

}  // namespace

CoverageFigures measure_coverage(const PhotonFlights& flights, int points, std::uint32_t seed,
                                 const std::function<void(std::uint64_t)>& done) {
    const Reach reach(flights.frame);
    CoverageFigures figures;
    figures.area = reach.area();
    figures.by_eq1 = flights.statistics.of<gi::EmcStatistics>().coverage;
    const std::size_t maps = flights.map_centres.size();
    std::vector<int> seen(maps, 0), alone(maps, 0);
    const std::size_t candidates = std::min(flights.candidates.size(), kMostCandidates);
    std::vector<std::uint64_t> seen_by_candidates;
    int covered = 0;
    for (int i = 0; i < points && figures.area > 0; ++i) {
        const auto number = static_cast<std::uint32_t>(i);
        SurfacePoint p;
        const vec2 place = RandomNumbers(seed, number, 0).pair(kPlace);
        done(static_cast<std::uint64_t>(i) + 1);
        if (!reach.point((i + 0.5) / points, place, p)) {
            continue;
        }
        ++figures.points;
        if (!reach.reached(p, flights.statistics.plan.bounces, seed, number)) {
            continue;
        }
        ++figures.reached;
        std::vector<std::size_t> viewers;
        for (std::size_t m = 0; m < maps; ++m) {
            if (reach.seen_from(p, flights.map_centres[m])) {
                viewers.push_back(m);
                ++seen[m];
            }
        }
        std::uint64_t by_candidates = 0;
        for (std::size_t c = 0; c < candidates; ++c) {
            by_candidates |= std::uint64_t{reach.seen_from(p, flights.candidates[c])} << c;
        }
        seen_by_candidates.push_back(by_candidates);
        covered += viewers.empty() ? 0 : 1;
        if (viewers.size() == 1) {
            ++alone[viewers.front()];
        }
    }
    const double reached = std::max(figures.reached, 1);
    figures.coverage = covered / reached;
    figures.standard_error = std::sqrt(figures.coverage * (1 - figures.coverage) / reached);
    figures.reached_area = figures.area * figures.reached / std::max(points, 1);
    for (std::size_t m = 0; m < maps; ++m) {
        figures.seen_by_map.push_back(seen[m] / reached);
        figures.alone_by_map.push_back(alone[m] / reached);
    }
    if (candidates > 0) {
        draw_at_random(figures, seen_by_candidates, static_cast<int>(candidates), static_cast<int>(maps),
                       seed);
    }
    return figures;
}

}  // namespace lanthorn::workbench
