#include "gi_module/techniques/splat/sensor_splats.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gi_module/techniques/splat/kernel_areas.h"
#include "lanthorn/core/colour.h"

namespace lanthorn::gi {

namespace {

constexpr std::size_t kLevels = 9;  // bandwidths, each three quarters of the one before: a tenth in the end
constexpr double kBeyondChance = 1.5;  // standard deviations; 1 reads noise, 2 the blur

// A point of a disc and its kernels.
struct Point {
    vec3 position{0};
    SurfaceSide side = kNoSide;
    std::array<float, kLevels> squares{};  // h^2
    std::array<float, kLevels> shares{};   // of the sensor's reading, 1 / m^2
};

// Photons of one kind on and about one sensor's disc.
class Disc {
  public:
    Disc(std::span<const SensorPoint> points, const SplatSurfaces& surfaces, const SplatSettings& settings,
         std::span<const float> widest)
        : epanechnikov_(settings.kernel == PhotonKernel::epanechnikov) {
        const float share = 1.0f / static_cast<float>(points.size());
        for (const SensorPoint& p : points) {
            Point point{p.position, surfaces.side(p.instance, p.primitive, p.front), {}, {}};
            float h = widest[point.side];
            reach_ = std::max(reach_, h);
            for (std::size_t level = 0; level < kLevels; ++level, h *= 0.75f) {
                point.squares[level] = h * h;
                point.shares[level] = share * inverse_kernel_area({p.position, point.side}, surfaces, h,
                                                                  settings.kernel, settings.boundaries);
            }
            bounds_.add(p.position);
            points_.push_back(point);
        }
    }

    void add(const PhotonBlock& block, std::span<const PhotonRecord> records, const vec3& power) {
        const vec3 gap =
            glm::max(glm::max(block.lower - bounds_.upper, bounds_.lower - block.upper), vec3(0));
        if (glm::dot(gap, gap) > reach_ * reach_) {
            return;
        }
        // A photon of several records is one.
        for (std::size_t i = 0; i < records.size();) {
            const vec3& at = records[i].position;
            vec3 copies(0);
            do {
                copies += vec3(records[i].copies(0), records[i].copies(1), records[i].copies(2));
                ++i;
            } while (i < records.size() && records[i].more());
            add(at, block.side, dvec3(copies * power));
        }
    }

    std::span<const SensorLevel> levels() const { return levels_; }

  private:
    void add(const vec3& at, SurfaceSide side, const dvec3& lumen) {
        std::array<float, kLevels> weights{};
        for (const Point& point : points_) {
            if (point.side != side) {
                continue;
            }
            const vec3 d = at - point.position;
            const float square = glm::dot(d, d);
            for (std::size_t level = 0; level < kLevels && square < point.squares[level]; ++level) {
                weights[level] +=
                    point.shares[level] * (epanechnikov_ ? 1 - square / point.squares[level] : 1.0f);
            }
        }
        for (std::size_t level = 0; level < kLevels && weights[level] > 0; ++level) {
            const dvec3 lux = lumen * static_cast<double>(weights[level]);
            levels_[level].lux += lux;
            levels_[level].variance += luminance(lux) * luminance(lux);
            ++levels_[level].photons;
        }
    }

    bool epanechnikov_;
    float reach_ = 0;
    Aabb bounds_;
    std::vector<Point> points_;
    std::array<SensorLevel, kLevels> levels_{};
};

}  // namespace

std::size_t sensor_level(std::span<const SensorLevel> levels, std::uint64_t least) {
    const auto contradicts = [&](const SensorLevel& narrow, const SensorLevel& wide) {
        if (narrow.photons < least || narrow.photons == 0) {
            return false;
        }
        // Few photons that are too few by chance also vary too little: as many would of the wide one's light.
        const double expected =
            luminance(wide.lux) * luminance(wide.lux) / static_cast<double>(narrow.photons);
        return std::abs(luminance(narrow.lux) - luminance(wide.lux)) >
               kBeyondChance * std::sqrt(std::max(narrow.variance, expected));
    };
    std::size_t level = 0;
    while (level + 1 < levels.size() && levels[level + 1].photons >= least &&
           std::any_of(levels.begin() + static_cast<std::ptrdiff_t>(level) + 1, levels.end(),
                       [&](const SensorLevel& narrow) { return contradicts(narrow, levels[level]); })) {
        ++level;
    }
    return level;
}

bool SensorSplats::light(std::span<const SensorPoint> points, const SplatSurfaces& surfaces,
                         PhotonCollection& photons, std::span<const vec3> powers,
                         const SplatSettings& settings, reference::TileWorkers& workers,
                         std::vector<vec4>& irradiances) {
    irradiances.assign(points.size(), vec4(0));
    std::array<std::vector<Disc>, 2> discs;  // by kind, sensor after sensor
    std::vector<std::size_t> firsts;         // by sensor, and one more
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i == 0 || points[i].sensor != points[i - 1].sensor) {
            firsts.push_back(i);
        }
    }
    firsts.push_back(points.size());
    const std::size_t count = firsts.size() - 1;
    for (const bool caustic : {false, true}) {
        const std::vector<float> widest = bandwidths(
            surfaces, photons.photons(caustic), caustic ? settings.caustic_bandwidth : settings.bandwidth);
        for (std::size_t s = 0; s < count && photons.all(caustic) > 0; ++s) {
            discs[caustic].emplace_back(points.subspan(firsts[s], firsts[s + 1] - firsts[s]), surfaces,
                                        settings, widest);
        }
    }
    const bool read = photons.store().each([&](const RecordRun& run) {
        std::vector<Disc>& of_kind = discs[run.caustic];
        workers.run(of_kind.size(), [&](std::size_t s) {
            for (const PhotonBlock& block : run.blocks) {
                of_kind[s].add(block, std::span(run.records).subspan(block.first, block.count),
                               powers[block.group]);
            }
        });
    });
    if (!read) {
        return false;
    }
    const auto least = static_cast<std::uint64_t>(settings.least);
    for (std::size_t s = 0; s < count; ++s) {
        vec3 lux(0);
        for (const std::vector<Disc>& of_kind : discs) {
            if (!of_kind.empty()) {
                const auto levels = of_kind[s].levels();
                lux += vec3(levels[sensor_level(levels, least)].lux);
            }
        }
        if (glm::any(glm::isnan(lux)) || glm::any(glm::isinf(lux))) {
            ++bad_;
            lux = vec3(0);
        }
        std::fill(irradiances.begin() + static_cast<std::ptrdiff_t>(firsts[s]),
                  irradiances.begin() + static_cast<std::ptrdiff_t>(firsts[s + 1]), vec4(lux, 0));
    }
    return true;
}

}  // namespace lanthorn::gi
