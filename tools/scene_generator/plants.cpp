#include "tools/scene_generator/plants.h"

#include <cmath>
#include <numbers>

#include "tools/scene_generator/lathe.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

namespace {

// A flat leaflet from `foot` to `tip`, `wide` metres across, its upper side turned to `up`: an octahedron
// that is almost flat.
void add_leaflet(Shape& shape, const dvec3& foot, const dvec3& tip, const dvec3& up, double wide) {
    const dvec3 along = tip - foot;
    const dvec3 side = glm::normalize(glm::cross(up, along)) * (0.5 * wide);
    const dvec3 above = glm::normalize(glm::cross(along, side));
    const dvec3 middle = foot + 0.4 * along;
    const dvec3 rim[] = {foot, middle + side, tip, middle - side};
    for (const double half : {1.0, -1.0}) {
        const auto first = static_cast<std::uint32_t>(shape.corners.size());
        for (const dvec3& p : rim) {
            shape.corners.push_back({p, half * above, {}});
        }
        shape.corners.push_back({middle + half * 0.06 * wide * above, half * above, {}});
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t a = first + i, c = first + (i + 1) % 4;
            shape.indices.insert(shape.indices.end(), {half > 0 ? c : a, half > 0 ? a : c, first + 4});
        }
    }
}

// A frond that leaves `foot` in the direction `turn` (radians about +Y), rises by `rise` radians from the
// level and bends down along its `length`.
void add_frond(Shape& shape, const dvec3& foot, double turn, double rise, double length) {
    constexpr int kPairs = 9;
    constexpr double kBend = 1.9;  // radians from foot to tip
    const dvec3 out(std::cos(turn), 0, std::sin(turn)), side(-out.z, 0, out.x);
    dvec3 place = foot;
    for (int i = 0; i < kPairs; ++i) {
        const double share = (i + 1.0) / kPairs;
        const double slope = rise - kBend * share * share;
        const dvec3 along = std::cos(slope) * out + std::sin(slope) * dvec3(0, 1, 0);
        const dvec3 up = std::cos(slope) * dvec3(0, 1, 0) - std::sin(slope) * out;
        const dvec3 next = place + along * (length / kPairs);
        add_leaflet(shape, place, next, up, 0.02 * length);  // the stalk
        const double leaf = 0.3 * length * std::sin(std::numbers::pi * (0.12 + 0.8 * share));
        for (const double left : {1.0, -1.0}) {
            const dvec3 to = place + leaf * glm::normalize(left * side + 0.45 * along - 0.15 * up);
            add_leaflet(shape, place, to, up, 0.13 * length);
        }
        place = next;
    }
}

constexpr double kPot = 0.2, kHigh = 0.3;  // metres: the pot's radius and height

Shape leaves() {
    constexpr int kFronds = 11;
    Shape shape;
    for (int i = 0; i < kFronds; ++i) {
        const auto n = static_cast<std::uint64_t>(i);
        const double turn = 2.39996323 * i + 0.6 * uniform(7, n);
        const double rise = 1.45 - 0.75 * i / kFronds;
        const dvec3 from(0.3 * kPot * std::cos(turn), kHigh, 0.3 * kPot * std::sin(turn));
        add_frond(shape, from, turn, rise, 0.62 + 0.2 * uniform(8, n));
    }
    return shape;
}

}  // namespace

Fern fern(Builder& b) {
    const glm::dvec2 flare = glm::normalize(glm::dvec2(0.82 * kHigh, -0.3 * kPot));
    const double rim = 0.82 * kHigh;
    const Outline pot = {
        {{0, 0}, {0, -1}},           {{0.65 * kPot, 0}, {0, -1}},   {{0.65 * kPot, 0}, flare},
        {{0.95 * kPot, rim}, flare}, {{0.95 * kPot, rim}, {0, -1}}, {{1.1 * kPot, rim}, {0, -1}},
        {{1.1 * kPot, rim}, {1, 0}}, {{1.1 * kPot, kHigh}, {1, 0}}, {{1.1 * kPot, kHigh}, {0, 1}},
        {{0, kHigh}, {0, 1}}};
    const Outline soil = {{{0, kHigh}, {0, -1}},
                          {{0.9 * kPot, kHigh}, {0, -1}},
                          {{0.9 * kPot, kHigh}, {1, 0}},
                          {{0.9 * kPot, kHigh + 0.015}, {1, 0}},
                          {{0.9 * kPot, kHigh + 0.015}, {0, 1}},
                          {{0, kHigh + 0.015}, {0, 1}}};
    return {b.mesh("fern-pot", lathe(pot, 20), b.matte("terracotta", {0.4f, 0.17f, 0.09f}, 0.5f)),
            b.mesh("fern-soil", lathe(soil, 16), b.matte("soil", {0.035f, 0.025f, 0.02f}, 0.5f)),
            b.mesh("fern-leaves", leaves(), b.matte("leaf", {0.07f, 0.19f, 0.045f}, 0.5f))};
}

void add_fern(Builder& b, const Fern& fern, const std::string& name, const dvec3& foot, double size,
              double turn) {
    Transform stands = at(foot);
    stands.rotation = quat(glm::angleAxis(turn, dvec3(0, 1, 0)));
    stands.scale = vec3(static_cast<float>(size));
    const std::uint32_t node = b.node(name, stands);
    const std::uint32_t pot = b.node(name + "-pot", {}, node);
    b.scene.nodes[pot].meshes = {fern.pot};
    b.scene.nodes[pot].extras = kBoxCollider;
    b.scene.nodes[b.node(name + "-plant", {}, node)].meshes = {fern.soil, fern.leaves};
}

}  // namespace lanthorn::scene_generator
