#include "gi_module/carried_light.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "engine/scene/emissive_pieces.h"
#include "lanthorn/core/colour.h"
#include "lanthorn/scene/diffuse_reflectance.h"

namespace lanthorn::gi {

namespace {

constexpr std::size_t kMostInstances = 2048;
constexpr std::size_t kMostLamps = 16;   // the strongest; the others light as they do
constexpr std::size_t kMostPieces = 64;  // those that reflect most of the lamps' light; the others are one
constexpr float kSmall = 0.1f;           // of the scene's radius: a thing, not a room

struct Piece {
    Aabb box;
    vec3 centre{0};
    float radius = 0, area = 0, albedo = 0;
    float power = 0;      // that it emits
    double light = 0;     // that falls on it
    bool hollow = false;  // may light itself
};

struct Lamp {
    vec3 position{0}, direction{0};
    float power = 0;
    float range = 0;
    float cos_cone = -1;
    bool everywhere = false;  // shines on all alike
};

float box_area(const Aabb& box) {
    const vec3 size = box.upper - box.lower;
    return box.empty() ? 0.0f : 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
}

Piece piece_of(const FrameScene& scene, const Instance& instance) {
    const Material& material = scene.material(instance);
    Piece piece;
    piece.box = instance.bounds;
    piece.centre = instance.bounds.empty() ? vec3(0) : instance.bounds.centre();
    piece.radius = instance.bounds.empty() ? 0.0f : 0.5f * instance.bounds.diagonal();
    piece.area = box_area(instance.bounds);
    piece.albedo = material.unlit ? 0.0f : albedo_of(material);
    piece.power = kPi * piece.area * luminance(emitted(material));
    return piece;
}

Lamp lamp_of(const LightInstance& instance, float scene_area) {
    const Light& light = instance.light;
    Lamp lamp{instance.position, instance.direction, luminance(light.colour) * light.intensity, light.range};
    switch (light.type) {
        case LightType::point:
            lamp.power *= 4 * kPi;
            break;
        case LightType::spot:
            lamp.cos_cone = std::cos(light.outer_cone);
            lamp.power *= 2 * kPi * (1 - lamp.cos_cone);
            break;
        case LightType::directional:
            lamp.power *= 0.25f * scene_area;
            lamp.everywhere = true;
            break;
    }
    return lamp;
}

// In proportion to the solid angle: of what is nearer than its own size it is the largest there is.
float share(const vec3& from, const Piece& piece) {
    const vec3 way = piece.centre - from;
    const float squared = std::max(glm::dot(way, way), piece.radius * piece.radius);
    return squared > 0 ? piece.area / squared : 0.0f;
}

float share(const Lamp& lamp, const Piece& piece) {
    if (lamp.everywhere) {
        return piece.area;
    }
    const vec3 way = piece.centre - lamp.position;
    const float distance = glm::length(way);
    if (distance - piece.radius > lamp.range) {
        return 0;
    }
    if (lamp.cos_cone > -1 && distance > piece.radius) {
        // The cone is widened by the angle that the piece is seen at.
        const float off = std::acos(std::clamp(glm::dot(way, lamp.direction) / distance, -1.0f, 1.0f));
        if (off - std::asin(piece.radius / distance) > std::acos(lamp.cos_cone)) {
            return 0;
        }
    }
    return share(lamp.position, piece);
}

std::vector<Lamp> strongest_lamps(const FrameScene& scene, const std::vector<Piece>& pieces) {
    const float area = box_area(scene.bounds);
    std::vector<Lamp> lamps;
    for (const LightInstance& light : scene.lights) {
        lamps.push_back(lamp_of(light, area));
    }
    for (const Piece& piece : pieces) {
        if (piece.power > 0) {
            Lamp lamp{piece.centre, vec3(0), piece.power, std::numeric_limits<float>::infinity()};
            lamps.push_back(lamp);
        }
    }
    std::erase_if(lamps, [](const Lamp& lamp) { return !(lamp.power > 0); });
    std::ranges::stable_sort(lamps, std::greater(), &Lamp::power);
    lamps.resize(std::min(lamps.size(), kMostLamps));
    if (scene.sky) {
        Lamp sky;
        sky.everywhere = true;
        // As strong as all the others: how much comes through windows is not known.
        sky.power = std::accumulate(lamps.begin(), lamps.end(), 0.0f,
                                    [](float sum, const Lamp& lamp) { return sum + lamp.power; });
        sky.power = sky.power > 0 ? sky.power : 1;
        lamps.push_back(sky);
    }
    return lamps;
}

// Light of each lamp on the pieces. Returns that of all.
double shine(const std::vector<Lamp>& lamps, std::vector<Piece>& pieces) {
    double all = 0;
    std::vector<float> shares(pieces.size());
    for (const Lamp& lamp : lamps) {
        std::ranges::transform(pieces, shares.begin(), [&](const Piece& p) { return share(lamp, p); });
        const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
        if (!(sum > 0) || !std::isfinite(sum)) {
            continue;
        }
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            pieces[i].light += static_cast<double>(lamp.power) * static_cast<double>(shares[i]) / sum;
        }
        all += static_cast<double>(lamp.power);
    }
    return all;
}

// The pieces that reflect most, and all others as one.
void join_weak(std::vector<Piece>& pieces) {
    if (pieces.size() <= kMostPieces) {
        return;
    }
    std::ranges::stable_sort(pieces, std::greater(),
                             [](const Piece& p) { return p.light * static_cast<double>(p.albedo); });
    Piece rest;
    vec3 centres(0);
    double reflected = 0, areas = 0;
    for (std::size_t i = kMostPieces; i < pieces.size(); ++i) {
        const Piece& p = pieces[i];
        rest.box.add(p.box.lower);
        rest.box.add(p.box.upper);
        rest.area += p.area;
        rest.light += p.light;
        rest.hollow = true;
        centres += p.area * p.centre;
        reflected += static_cast<double>(p.area) * static_cast<double>(p.albedo);
        areas += static_cast<double>(p.area);
    }
    rest.albedo = areas > 0 ? static_cast<float>(reflected / areas) : 0.0f;
    rest.centre = rest.area > 0 ? centres / rest.area : vec3(0);
    rest.radius = 0.5f * rest.box.diagonal();
    pieces.resize(kMostPieces);
    pieces.push_back(rest);
}

bool inside(const vec3& point, const Aabb& box) {
    return glm::all(glm::greaterThanEqual(point, box.lower)) &&
           glm::all(glm::lessThanEqual(point, box.upper));
}

void find_hollows(std::vector<Piece>& pieces, const std::vector<Lamp>& lamps, float radius) {
    for (Piece& piece : pieces) {
        const auto holds = [&](const vec3& point) { return inside(point, piece.box); };
        piece.hollow =
            piece.hollow || piece.radius > kSmall * radius ||
            std::ranges::any_of(lamps, [&](const Lamp& l) { return !l.everywhere && holds(l.position); }) ||
            std::ranges::any_of(pieces, [&](const Piece& p) { return &p != &piece && holds(p.centre); });
    }
}

// What falls on each piece of what all reflect.
void reflect(std::vector<Piece>& pieces, const std::vector<std::vector<float>>& shares) {
    std::vector<double> next(pieces.size(), 0.0);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const double sum = std::accumulate(shares[i].begin(), shares[i].end(), 0.0);
        const double leaves = pieces[i].light * static_cast<double>(pieces[i].albedo);
        for (std::size_t j = 0; sum > 0 && j < pieces.size(); ++j) {
            next[j] += leaves * static_cast<double>(shares[i][j]) / sum;
        }
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        pieces[i].light = next[i];
    }
}

CarriedLight bound(float brightest) {
    CarriedLight shares{};
    float share = 1;
    for (float& s : shares) {
        s = share *= brightest;
    }
    return shares;
}

}  // namespace

float albedo_of(const Material& m) {
    // Factors are all that a texture can reach: under one, some texel may be neither metal nor glass, or
    // a rough metal.
    const float transmission = m.transmission_texture.present() ? 0.0f : m.transmission;
    const MaterialReflectance reflects = MaterialReflectance::of(m);
    const float share = m.metallic_roughness_texture.present()
                            ? std::max((1 - transmission) * reflects.transmittance, reflects.evenly)
                            : base_reflectance(m.metallic, transmission, m.roughness, reflects.transmittance,
                                               reflects.evenly);
    const vec3 albedo = vec3(m.base_colour) * share + reflects.boundary;
    return std::clamp(std::max({albedo.x, albedo.y, albedo.z}), 0.0f, 1.0f);
}

CarriedLight carried_light(const FrameScene& scene, float brightest) {
    CarriedLight carried = bound(brightest);
    if (scene.instances.empty() || scene.instances.size() > kMostInstances) {
        return carried;
    }
    std::vector<Piece> pieces;
    for (const Instance& instance : scene.instances) {
        pieces.push_back(piece_of(scene, instance));
    }
    const std::vector<Lamp> lamps = strongest_lamps(scene, pieces);
    const double emitted = shine(lamps, pieces);
    if (!(emitted > 0) || !std::isfinite(emitted)) {
        return carried;
    }
    join_weak(pieces);
    find_hollows(pieces, lamps, 0.5f * scene.diagonal());
    std::vector<std::vector<float>> shares(pieces.size(), std::vector<float>(pieces.size()));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        for (std::size_t j = 0; j < pieces.size(); ++j) {
            shares[i][j] = i != j || pieces[i].hollow ? share(pieces[i].centre, pieces[j]) : 0.0f;
        }
    }
    for (float& share_now : carried) {
        double leaves = 0;
        for (const Piece& piece : pieces) {
            leaves += piece.light * static_cast<double>(piece.albedo);
        }
        share_now = std::min(share_now, static_cast<float>(leaves / emitted));
        reflect(pieces, shares);
    }
    return carried;
}

}  // namespace lanthorn::gi
