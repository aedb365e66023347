#include "tools/scene_generator/water.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace lanthorn::scene_generator {

namespace {

double omega(const Wave& wave, double seconds) {
    return 2 * std::numbers::pi * wave.rounds / seconds;
}

// cos(k.p - wt) = cos(k.p) cos(wt) + sin(k.p) sin(wt): two targets carry a wave that travels, exactly. So do
// their normals: those of a height field add up like its slopes.
MorphTarget half_wave(const Mesh& water, const Wave& wave, bool sine) {
    MorphTarget target;
    for (std::size_t v = 0; v < water.vertices.size(); ++v) {
        const dvec3 p = water.vertices[v].position;
        const double at = wave.k_x * p.x + wave.k_z * p.z;
        const double height = wave.amplitude * (sine ? std::sin(at) : std::cos(at));
        const double slope = wave.amplitude * (sine ? std::cos(at) : -std::sin(at));
        target.vertices.push_back(static_cast<std::uint32_t>(v));
        target.positions.push_back(vec3(dvec3(0, height, 0)));
        target.normals.push_back(vec3(dvec3(-slope * wave.k_x, 0, -slope * wave.k_z)));
    }
    return target;
}

constexpr int kKeys = 48;

// Keys with their tangents: value(seconds) and its derivative, `width` numbers each.
template <class Value, class Slope>
AnimationChannel spline(std::uint32_t node, AnimationPath path, std::uint32_t width, double seconds,
                        const Value& value, const Slope& slope) {
    AnimationChannel channel;
    channel.node = node;
    channel.path = path;
    channel.interpolation = Interpolation::cubic_spline;
    channel.width = width;
    for (int k = 0; k <= kKeys; ++k) {
        const double t = seconds * k / kKeys;
        channel.times.push_back(static_cast<float>(t));
        const std::vector<double> tangent = slope(t);
        for (const auto& part : {tangent, value(t), tangent}) {
            for (const double v : part) {
                channel.values.push_back(static_cast<float>(v));
            }
        }
    }
    return channel;
}

// How high the waves are at a place, and how fast they rise there.
double wave_height(std::span<const Wave> waves, double x, double z, double seconds, double t) {
    double y = 0;
    for (const Wave& w : waves) {
        y += w.amplitude * std::cos(w.k_x * x + w.k_z * z - omega(w, seconds) * t);
    }
    return y;
}

double wave_rise(std::span<const Wave> waves, double x, double z, double seconds, double t) {
    double y = 0;
    for (const Wave& w : waves) {
        y += w.amplitude * omega(w, seconds) * std::sin(w.k_x * x + w.k_z * z - omega(w, seconds) * t);
    }
    return y;
}

}  // namespace

Mesh water_mesh(std::uint32_t material, double half_x, double half_z, int cells_x, int cells_z,
                std::span<const Wave> waves) {
    Mesh water;
    water.name = "water";
    water.material = material;
    for (int z = 0; z <= cells_z; ++z) {
        for (int x = 0; x <= cells_x; ++x) {
            Vertex vertex;
            vertex.position =
                vec3(dvec3(half_x * (2.0 * x / cells_x - 1), 0, half_z * (2.0 * z / cells_z - 1)));
            vertex.normal = {0, 1, 0};
            water.vertices.push_back(vertex);
            water.bounds.add(vertex.position);
        }
    }
    for (int z = 0; z < cells_z; ++z) {
        for (int x = 0; x < cells_x; ++x) {
            const auto a = static_cast<std::uint32_t>(z * (cells_x + 1) + x);
            const std::uint32_t b = a + 1, c = a + static_cast<std::uint32_t>(cells_x) + 1, d = c + 1;
            water.indices.insert(water.indices.end(), {a, c, b, b, c, d});
        }
    }
    for (const Wave& wave : waves) {
        water.morphs.push_back(half_wave(water, wave, false));
        water.morphs.push_back(half_wave(water, wave, true));
        water.morph_weights.insert(water.morph_weights.end(), {1, 0});
    }
    return water;
}

AnimationChannel wave_channel(std::uint32_t node, std::span<const Wave> waves, double seconds) {
    const auto values = [&](double t) {
        std::vector<double> result;
        for (const Wave& wave : waves) {
            result.insert(result.end(),
                          {std::cos(omega(wave, seconds) * t), std::sin(omega(wave, seconds) * t)});
        }
        return result;
    };
    const auto slopes = [&](double t) {
        std::vector<double> result;
        for (const Wave& wave : waves) {
            const double w = omega(wave, seconds);
            result.insert(result.end(), {-w * std::sin(w * t), w * std::cos(w * t)});
        }
        return result;
    };
    return spline(node, AnimationPath::weights, static_cast<std::uint32_t>(2 * waves.size()), seconds, values,
                  slopes);
}

AnimationChannel float_channel(std::uint32_t node, const dvec3& place, std::span<const Wave> waves,
                               double seconds) {
    const auto values = [&](double t) {
        return std::vector<double>{place.x, place.y + wave_height(waves, place.x, place.z, seconds, t),
                                   place.z};
    };
    const auto slopes = [&](double t) {
        return std::vector<double>{0, wave_rise(waves, place.x, place.z, seconds, t), 0};
    };
    return spline(node, AnimationPath::translation, 3, seconds, values, slopes);
}

}  // namespace lanthorn::scene_generator
