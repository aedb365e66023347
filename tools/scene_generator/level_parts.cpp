#include "tools/scene_generator/level_parts.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "tools/scene_generator/hero_figure.h"
#include "tools/scene_generator/lathe.h"

namespace lanthorn::scene_generator {

namespace {

// A six-sided crystal with its foot at `from` and its tip `length` along `along`.
void add_spike(Shape& shape, const dvec3& from, const dvec3& along, double radius, double length) {
    constexpr int kSides = 6;
    const dvec3 n = glm::normalize(along);
    const dvec3 u = glm::normalize(glm::cross(n, std::abs(n.y) > 0.8 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    const dvec3 v = glm::cross(n, u);
    const dvec3 foot = from, shoulder = from + 0.72 * length * n, tip = from + length * n;
    const auto rim = [&](const dvec3& centre, double r, int i) {
        const double a = 2 * std::numbers::pi * (i % kSides) / kSides;
        return centre + r * (std::cos(a) * u + std::sin(a) * v);
    };
    const auto triangle = [&](const dvec3& a, const dvec3& c, const dvec3& d) {
        const dvec3 normal = glm::normalize(glm::cross(c - a, d - a));
        for (const dvec3& p : {a, c, d}) {
            shape.indices.push_back(static_cast<std::uint32_t>(shape.corners.size()));
            shape.corners.push_back({p, normal, {}});
        }
    };
    for (int i = 0; i < kSides; ++i) {
        const dvec3 a = rim(foot, 0.8 * radius, i), c = rim(foot, 0.8 * radius, i + 1);
        const dvec3 d = rim(shoulder, radius, i + 1), e = rim(shoulder, radius, i);
        triangle(a, c, d);
        triangle(a, d, e);
        triangle(e, d, tip);
        triangle(foot, c, a);
    }
}

std::string collider() {
    return kBoxCollider;
}

}  // namespace

void add_player(Builder& b, const dvec3& feet, const dvec3& at_point) {
    const std::uint32_t node = b.node("player", at(feet));
    b.scene.nodes[node].extras = R"({"player":{},"character":{"radius":0.28,"height":1.75}})";
    const dvec3 eye(0, 1.62, 0);
    const std::uint32_t eyes = b.camera("player-eyes", looking(eye, at_point - feet), glm::radians(62.0f));
    b.scene.nodes[eyes].parent = node;
    b.scene.nodes[eyes].extras = R"({"eyes":{}})";
    add_hero(b, node);
}

std::uint32_t bronze(Builder& b) {
    return b.matte("bronze", {0.08f, 0.05f, 0.025f}, 0.5f);
}

void add_lantern(Builder& b, std::uint32_t metal, const dvec3& foot, const vec3& colour, float candela,
                 const std::string& fields) {
    Shape cage;
    add_box(cage, {-0.08, 0, -0.08}, {0.08, 0.02, 0.08});
    add_box(cage, {-0.08, 0.21, -0.08}, {0.08, 0.225, 0.08});
    add_box(cage, {-0.05, 0.225, -0.05}, {0.05, 0.25, 0.05});
    add_box(cage, {-0.008, 0.25, -0.03}, {0.008, 0.3, -0.018});
    add_box(cage, {-0.008, 0.25, 0.018}, {0.008, 0.3, 0.03});
    add_box(cage, {-0.008, 0.3, -0.03}, {0.008, 0.312, 0.03});
    for (const double x : {-0.075, 0.063}) {
        for (const double z : {-0.075, 0.063}) {
            add_box(cage, {x, 0.02, z}, {x + 0.012, 0.21, z + 0.012});
        }
    }
    const std::uint32_t node =
        b.solid("lantern", cage, metal,
                R"({"lantern":{"handle":0.31)" + (fields.empty() ? "" : "," + fields) + "}}", at(foot));
    add_flame(b, "lantern-light", {0, 0.12, 0}, colour, candela, 0.1, node);
}

void add_crystal(Builder& b, const Finishes& f, const std::string& name, const dvec3& place,
                 const dvec3& towards, const vec3& colour, const std::string& sensor,
                 const std::string& crystal) {
    const Transform facing = looking(place, place + towards);
    // The plate: a lathe turns about +Y, which is to look along the node's -Z.
    const std::uint32_t node = b.node(name + "-plate", facing);
    Transform lying;
    lying.rotation = quat(glm::angleAxis(-0.5 * std::numbers::pi, dvec3(1, 0, 0)));
    constexpr double kThick = 0.02, kSlope = 0.707;  // its edge is a slope: a step would be a dashed line
    constexpr double kInner = 0.44, kFoot = -0.002;
    const Outline plate = {{{0, kFoot}, {0, -1}},      {{kInner, kFoot}, {0, -1}}, {{kInner, kFoot}, {1, 0}},
                           {{kInner, kThick}, {1, 0}}, {{kInner, kThick}, {0, 1}}, {{0, kThick}, {0, 1}}};
    const Outline rim = {{{kInner, kFoot}, {0, -1}},       {{0.5, kFoot}, {0, -1}},
                         {{0.5, kFoot}, {kSlope, kSlope}}, {{0.5 - kThick, kThick}, {kSlope, kSlope}},
                         {{0.5 - kThick, kThick}, {0, 1}}, {{kInner, kThick}, {0, 1}},
                         {{kInner, kThick}, {-1, 0}},      {{kInner, kFoot}, {-1, 0}}};
    b.solid(name + "-disc", lathe(plate, 32), f.slate, {}, lying, node);
    b.solid(name + "-rim", lathe(rim, 32, true), f.brass, {}, lying, node);

    // Those that stand behind are of a deeper colour, and glow as much less.
    constexpr float kBehind = 0.45f;
    const auto gem = [&](const std::string& of, float bright) {
        const std::uint32_t material = b.matte(of, bright * colour, 0.6f);
        b.scene.materials[material].roughness = 0.6f;
        return material;
    };
    Shape before, behind;
    add_spike(before, {0, 0, -0.01}, {0.05, 0.12, -1}, 0.06, 0.3);
    add_spike(before, {-0.02, -0.06, -0.01}, {-0.2, -0.7, -1}, 0.045, 0.19);
    add_spike(behind, {0.06, 0.02, -0.01}, {0.65, 0.3, -1}, 0.042, 0.2);
    add_spike(behind, {-0.06, 0.03, -0.01}, {-0.6, 0.55, -1}, 0.045, 0.22);
    add_spike(behind, {0.05, -0.05, -0.01}, {0.6, -0.5, -1}, 0.035, 0.15);
    Transform on_plate = facing;
    on_plate.translation = place + 0.021 * glm::normalize(towards);
    const std::uint32_t at_plate = b.solid(
        name, before, gem(name, 1),
        R"({"light_sensor":{"radius":0.48,)" + sensor + R"(},"crystal":{)" + crystal + "}}", on_plate);
    b.scene.nodes[at_plate].meshes.push_back(
        b.mesh(name + "-behind", behind, gem(name + "-behind", kBehind)));
    Light light;
    light.type = LightType::point;
    light.colour = colour / std::max(colour.r, std::max(colour.g, colour.b));
    light.intensity = 4;
    b.light(name + "-light", at({0, 0, -0.6}), light, at_plate);
}

void add_room(Builder& b, const Finishes& f, const dvec3& half, const RoomWalls& walls) {
    const double t = kLevelWall, x = half.x + t, z = half.z + t;
    const auto wall = [&](const char* name, const dvec3& low, const dvec3& high, std::uint32_t material) {
        if (material != kNone) {
            b.solid(name, box(low, high), material, kBoxCollider);
        }
    };
    wall("floor", {-x, -t, -z}, {x, 0, z}, f.flags);
    wall("ceiling", {-x, half.y, -z}, {x, half.y + t, z}, f.plaster);
    wall("back-wall", {-x, 0, -z}, {x, half.y, -half.z}, walls.back);
    wall("front-wall", {-x, 0, half.z}, {x, half.y, z}, walls.front);
    wall("west-wall", {-x, 0, -half.z}, {-half.x, half.y, half.z}, walls.west);
    wall("east-wall", {half.x, 0, -half.z}, {x, half.y, half.z}, walls.east);
}

void add_spot(Builder& b, const std::string& name, const dvec3& from, const dvec3& to, const vec3& colour,
              float candela, float inner, float outer) {
    Light light;
    light.type = LightType::spot;
    light.colour = colour;
    light.intensity = candela;
    light.inner_cone = glm::radians(inner);
    light.outer_cone = glm::radians(outer);
    b.light(name, looking(from, to), light);
}

void add_turning_mirror(Builder& b, const Finishes& f, std::uint32_t silver, const std::string& name,
                        const dvec3& foot, double degrees, double speed) {
    constexpr double kWide = 0.4, kLow = 0.85, kHigh = 2.05, kRim = 0.05;
    Transform turned = at(foot);
    turned.rotation = quat(glm::angleAxis(glm::radians(degrees), dvec3(0, 1, 0)));
    const std::uint32_t node = b.node(name, turned);
    b.scene.nodes[node].extras = R"({"turntable":{"speed":)" + fmt::format("{}", speed) +
                                 R"(},"body":{"type":"kinematic","size":[0.9,2.1,0.3],"centre":[0,1.05,0]}})";
    b.solid(name + "-glass", box({-kWide, kLow, -0.01}, {kWide, kHigh, 0.01}), silver, {}, {}, node);
    Shape frame;
    add_box(frame, {-kWide - kRim, kLow - kRim, -0.03}, {kWide + kRim, kLow, 0.03});
    add_box(frame, {-kWide - kRim, kHigh, -0.03}, {kWide + kRim, kHigh + kRim, 0.03});
    add_box(frame, {-kWide - kRim, kLow, -0.03}, {-kWide, kHigh, 0.03});
    add_box(frame, {kWide, kLow, -0.03}, {kWide + kRim, kHigh, 0.03});
    b.solid(name + "-frame", frame, f.brass, {}, {}, node);
    const Outline post = {{{0, 0}, {0, -1}},
                          {{0.26, 0}, {0, -1}},
                          {{0.26, 0}, {1, 0}},
                          {{0.26, 0.06}, {1, 0}},
                          {{0.26, 0.06}, {0, 1}},
                          {{0.2, 0.06}, {0, 1}},
                          {{0.2, 0.06}, {1, 0}},
                          {{0.2, 0.1}, {1, 0}},
                          {{0.2, 0.1}, {0, 1}},
                          {{0.05, 0.1}, {0, 1}},
                          {{0.05, 0.1}, {1, 0}},
                          {{0.05, 0.74}, {1, 0}},
                          {{0.05, 0.74}, {0, -1}},
                          {{0.09, 0.74}, {0, -1}},
                          {{0.09, 0.74}, {1, 0}},
                          {{0.09, kLow - kRim}, {1, 0}},
                          {{0.09, kLow - kRim}, {0, 1}},
                          {{0, kLow - kRim}, {0, 1}}};
    b.solid(name + "-post", lathe(post, 24), f.oak, {}, {}, node);
}

void add_crate(Builder& b, const Finishes& f, const std::string& name, const dvec3& foot, double size,
               std::uint32_t paint, double mass) {
    const double h = 0.5 * size, rim = 0.1 * size, in = 0.04 * size;
    Shape rims;
    for (const double y : {0.0, size - rim}) {
        for (const double side : {-h, h - rim}) {
            add_box(rims, {-h, y, side}, {h, y + rim, side + rim});
            add_box(rims, {side, y, -h + rim}, {side + rim, y + rim, h - rim});
        }
    }
    for (const double x : {-h, h - rim}) {
        for (const double z : {-h, h - rim}) {
            add_box(rims, {x, rim, z}, {x + rim, size - rim, z + rim});
        }
    }
    const dvec3 core(h - in, 0, h - in);
    const std::uint32_t node = b.solid(
        name, rims, f.oak, fmt::format(R"({{"body":{{"type":"dynamic","mass":{}}}}})", mass), at(foot));
    b.scene.nodes[node].meshes.push_back(
        b.mesh(name + "-boards", box(-core + dvec3(0, in, 0), core + dvec3(0, size - in, 0)), paint));
}

void add_sconce(Builder& b, const Finishes& f, const std::string& name, const dvec3& wall,
                const dvec3& towards, float candela) {
    constexpr double kOut = 0.3, kBowl = 0.07;
    Shape iron;
    add_box(iron, {-0.05, -0.16, -0.02}, {0.05, 0.1, 0});
    add_box(iron, {-0.015, -0.06, kBowl - kOut}, {0.015, -0.03, -0.02});
    add_box(iron, {-kBowl, -0.06, -kOut - kBowl}, {kBowl, -0.03, kBowl - kOut});
    for (const double x : {-kBowl, kBowl - 0.015}) {
        add_box(iron, {x, -0.03, -kOut - kBowl}, {x + 0.015, 0.03, kBowl - kOut});
    }
    const std::uint32_t node = b.solid(name, iron, f.iron, collider(), looking(wall, wall + towards));
    add_flame(b, name + "-light", {0, 0.06, -kOut}, kLamplight, candela, 0.16, node);
}

void add_flame(Builder& b, const std::string& name, const dvec3& place, const vec3& colour, float candela,
               double height, std::uint32_t parent) {
    Light light;
    light.type = LightType::point;
    light.colour = colour;
    light.intensity = candela;
    const std::uint32_t node = b.light(name, at(place), light, parent);
    b.scene.nodes[node].extras = fmt::format(R"({{"flame":{{"height":{}}}}})", height);
}

void add_contract(Builder& b, const std::string& name, const dvec3& centre, const dvec3& size,
                  const std::string& fields) {
    b.scene.nodes[b.node(name, at(centre))].extras =
        fmt::format(R"({{"light_contract":{{"size":[{},{},{}],{}}}}})", size.x, size.y, size.z, fields);
}

void add_level(Builder& b, const std::string& fields) {
    b.scene.nodes[b.node("level", {})].extras = R"({"level":{)" + fields + "}}";
}

void add_mouldings(Builder& b, const Finishes& f, const dvec3& low, const dvec3& high) {
    Shape strips;
    // All the way round, mitred in the corners: a closed outline of places, metres from the wall and high.
    // Slopes instead of steps, which a picture of few pixels shows as dashes.
    const auto ring = [&](const std::vector<glm::dvec2>& outline) {
        glm::dvec2 middle(0);
        for (const glm::dvec2& p : outline) {
            middle += p / static_cast<double>(outline.size());
        }
        const auto corner = [&](const glm::dvec2& p, int i) {
            return dvec3(i == 0 || i == 3 ? low.x + p.x : high.x - p.x, p.y,
                         i < 2 ? low.z + p.x : high.z - p.x);
        };
        for (std::size_t k = 0; k < outline.size(); ++k) {
            const glm::dvec2 &p = outline[k], &q = outline[(k + 1) % outline.size()];
            const glm::dvec2 out = 0.5 * (p + q) + 1e3 * (0.5 * (p + q) - middle);
            for (int i = 0; i < 4; ++i) {
                const int next = (i + 1) % 4;
                add_quad(strips, corner(p, i), corner(p, next), corner(q, next), corner(q, i),
                         0.5 * (corner(out, i) + corner(out, next)));
            }
        }
    };
    ring({{0, low.y}, {0.05, low.y}, {0.04, low.y + 0.13}, {0, low.y + 0.17}});
    ring({{0, high.y - 0.2}, {0.05, high.y - 0.13}, {0.08, high.y - 0.06}, {0.14, high.y}, {0, high.y}});
    b.solid("mouldings", strips, f.trim);
}

void add_beams(Builder& b, const Finishes& f, const dvec3& low, const dvec3& high, bool along_x, int count) {
    constexpr double kHalf = 0.09, kDeep = 0.24;
    Shape beams;
    for (int i = 0; i < count; ++i) {
        const double share = (i + 0.5) / count;
        if (along_x) {
            const double z = glm::mix(low.z, high.z, share);
            add_box(beams, {low.x, high.y - kDeep, z - kHalf}, {high.x, high.y, z + kHalf});
        } else {
            const double x = glm::mix(low.x, high.x, share);
            add_box(beams, {x - kHalf, high.y - kDeep, low.z}, {x + kHalf, high.y, high.z});
        }
    }
    b.solid("beams", beams, f.oak, collider());
}

void add_pier(Builder& b, const Finishes& f, const std::string& name, const dvec3& foot, double half,
              double height) {
    const auto slab = [&](const std::string& part, double wider, double from, double to,
                          std::uint32_t material, const std::string& extras) {
        const dvec3 out(half + wider, 0, half + wider);
        b.solid(name + part, box(foot - out + dvec3(0, from, 0), foot + out + dvec3(0, to, 0)), material,
                extras);
    };
    slab("-plinth", 0.05, 0, 0.25, f.trim, {});
    slab("", 0, 0.25, height - 0.22, f.ashlar, collider());
    slab("-collar", 0.03, height - 0.22, height - 0.16, f.trim, {});
    slab("-cap", 0.07, height - 0.16, height, f.trim, {});
}

void add_wall_with_hole(Builder& b, const Finishes& f, const std::string& name, std::uint32_t material,
                        const dvec3& low, const dvec3& high, const dvec3& hole_low, const dvec3& hole_high,
                        int bars) {
    const int thin = high.x - low.x < high.z - low.z ? 0 : 2, wide = 2 - thin;
    const auto part = [&](const char* which, int axis, double from, double to, double bottom, double top) {
        dvec3 a = low, c = high;
        a[axis] = from;
        c[axis] = to;
        a.y = bottom;
        c.y = top;
        b.solid(name + which, box(a, c), material, collider());
    };
    part("-before", wide, low[wide], hole_low[wide], low.y, high.y);
    part("-behind", wide, hole_high[wide], high[wide], low.y, high.y);
    if (hole_low.y > low.y) {
        part("-below", wide, hole_low[wide], hole_high[wide], low.y, hole_low.y);
    }
    part("-above", wide, hole_low[wide], hole_high[wide], hole_high.y, high.y);
    if (hole_low.y > low.y) {
        const dvec3 size = hole_high - hole_low;
        const std::uint32_t opening = b.node(name + "-opening", at(0.5 * (hole_low + hole_high)));
        b.scene.nodes[opening].extras = fmt::format(
            R"({{"collider":{{"shape":"box","size":[{:.3f},{:.3f},{:.3f}]}}}})", size.x, size.y, size.z);
    }
    if (bars == 0) {
        return;
    }
    Shape grille;
    const double middle = 0.5 * (low[thin] + high[thin]);
    const auto bar = [&](double from, double to, double bottom, double top) {
        dvec3 a, c;
        a[wide] = from;
        c[wide] = to;
        a[thin] = middle - 0.012;
        c[thin] = middle + 0.012;
        a.y = bottom;
        c.y = top;
        add_box(grille, a, c);
    };
    for (int i = 1; i <= bars; ++i) {
        const double x = glm::mix(hole_low[wide], hole_high[wide], static_cast<double>(i) / (bars + 1));
        bar(x - 0.012, x + 0.012, hole_low.y, hole_high.y);
    }
    const double y = glm::mix(hole_low.y, hole_high.y, 0.5);
    bar(hole_low[wide], hole_high[wide], y - 0.014, y + 0.014);
    b.solid(name + "-bars", grille, f.iron);
}

}  // namespace lanthorn::scene_generator
