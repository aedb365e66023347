#include "tools/scene_generator/building_rooms.h"

#include "lanthorn/core/turns.h"
#include "tools/scene_generator/furniture.h"
#include "tools/scene_generator/uniform.h"

namespace lanthorn::scene_generator {

namespace {

constexpr std::uint64_t kSeed = 50;
const dvec3 kShelf(1.2, 1.9, 0.32);
constexpr double kTable = 0.73;  // high

std::vector<Part> table_parts() {
    constexpr double kTop = 0.05, kLeg = 0.06, kX = 0.65, kZ = 0.4;
    std::vector<Part> parts = {{"top", {-kX, kTable - kTop, -kZ}, {kX, kTable, kZ}}};
    for (const double x : {-kX, kX - kLeg}) {
        for (const double z : {-kZ, kZ - kLeg}) {
            parts.push_back({"leg", {x, 0, z}, {x + kLeg, kTable - kTop, z + kLeg}});
        }
    }
    return parts;
}

}  // namespace

RoomFurniture::RoomFurniture(Builder& b) : b_(b) {
    const Kinds wood = {b.matte("oak", {0.52f, 0.36f, 0.2f}), b.matte("walnut", {0.25f, 0.15f, 0.09f})};
    const Kinds cloth = {b.matte("red-cloth", {0.55f, 0.13f, 0.12f}),
                         b.matte("green-cloth", {0.16f, 0.4f, 0.22f}),
                         b.matte("blue-cloth", {0.14f, 0.22f, 0.5f})};
    const Kinds paint = {
        b.matte("red-paint", {0.7f, 0.12f, 0.1f}), b.matte("yellow-paint", {0.75f, 0.6f, 0.15f}),
        b.matte("blue-paint", {0.1f, 0.25f, 0.65f}), b.matte("white-paint", {0.8f, 0.8f, 0.77f})};
    shelf_ = add("shelf", whole(shelf_parts(kShelf, 4, &boards_)), wood);
    table_ = add("table", whole(table_parts()), wood);
    chair_ = add("chair", whole(chair_parts()), wood);
    bed_ = add("bed", box({-0.95, 0, 0}, {0.95, 0.45, 0.95}), cloth);
    pillow_ = add("pillow", box({-0.9, 0.45, 0.2}, {-0.55, 0.56, 0.75}), {paint[3]});
    chest_ = add("chest", box({-0.45, 0, 0}, {0.45, 0.55, 0.45}), wood);
    crate_ = add("crate", box({-0.25, 0, -0.25}, {0.25, 0.5, 0.25}), {wood[0], cloth[2]});
    box_ = add("box", box({-0.06, 0, -0.09}, {0.06, 0.22, 0.09}), paint);
    jar_ = add("jar", cylinder(0.07, 0.2, 16), paint);
    ball_ = add("ball", icosphere(0.09, 2), paint);
    globe_ = add("globe", icosphere(0.3, 3), paint);
    column_ = add("pedestal", cylinder(0.22, 0.8, 24), {paint[3]});
    rug_ = add("rug", box({-1.1, 0, -0.8}, {1.1, 0.01, 0.8}), cloth);
    bowl_ = add("bowl", cylinder(0.14, 0.07, 24), paint);
}

RoomFurniture::Kinds RoomFurniture::add(const std::string& name, const Shape& shape, const Kinds& materials) {
    Kinds kinds;
    for (const std::uint32_t material : materials) {
        kinds.push_back(b_.mesh(name + "-" + b_.scene.materials[material].name, shape, material));
    }
    return kinds;
}

void RoomFurniture::place(const std::string& name, const Kinds& kinds, std::uint64_t pick,
                          const dvec3& position, double degrees, std::uint32_t parent) {
    Transform where = at(position);
    where.rotation = quat(about_y(glm::radians(degrees)));
    const std::uint32_t node = b_.node(name, where, parent);
    b_.scene.nodes[node].meshes = {kinds[pick % kinds.size()]};
}

void RoomFurniture::shelf(std::uint32_t room, std::uint32_t parent, const dvec3& position) {
    const std::string name = "shelf-" + std::to_string(room);
    place(name, shelf_, room, position, 0, parent);
    std::uint64_t counter = std::uint64_t{64} * room;
    for (const double y : boards_) {
        for (int i = 0; i < 3; ++i, counter += 3) {
            const auto kind = static_cast<int>(3 * uniform(kSeed, counter));
            const auto paint = static_cast<std::uint64_t>(4 * uniform(kSeed, counter + 1));
            const dvec3 on(position.x - 0.36 + 0.36 * i + 0.1 * (uniform(kSeed, counter + 2) - 0.5), y,
                           position.z + 0.17);
            place(name + "-thing",
                  kind == 0   ? box_
                  : kind == 1 ? jar_
                              : ball_,
                  paint, on + dvec3(0, kind == 2 ? 0.09 : 0, 0), 0, parent);
        }
    }
}

void RoomFurniture::table(std::uint32_t room, std::uint32_t parent) {
    const std::string name = std::to_string(room);
    place("rug-" + name, rug_, room, {0, 0, 0}, 0, parent);
    place("table-" + name, table_, room, {0, 0.01, 0}, 0, parent);
    place("bowl-" + name, bowl_, room, {0.2, 0.01 + kTable, 0.1}, 0, parent);
    place("chair-" + name + "-1", chair_, room + 1, {-0.3, 0.01, 0.55}, 7, parent);
    place("chair-" + name + "-2", chair_, room + 1, {0.25, 0.01, -0.5}, 174, parent);
}

void RoomFurniture::put(std::uint32_t room, std::uint32_t parent, const dvec3& half, bool back, bool centre) {
    const std::string name = std::to_string(room);
    if (back) {
        switch (room % 3) {
            case 0:
                shelf(room, parent, {-0.7, 0, -half.z});
                shelf(room + 100, parent, {0.6, 0, -half.z});
                break;
            case 1:
                place("bed-" + name, bed_, room, {-0.2, 0, -half.z}, 0, parent);
                place("pillow-" + name, pillow_, 0, {-0.2, 0, -half.z}, 0, parent);
                break;
            default:
                place("chest-" + name, chest_, room, {-0.6, 0, -half.z}, 0, parent);
                place("chest-ball-" + name, ball_, room, {-0.5, 0.64, -half.z + 0.2}, 0, parent);
        }
    }
    // A corner that no door swings through.
    place("crate-" + name, crate_, room, {half.x - 0.35, 0, half.z - 0.35}, 10.0 * (room % 5), parent);
    if (!centre) {
        return;
    }
    if (room % 4 == 3) {
        place("pedestal-" + name, column_, 0, {0.2, 0, 0.1}, 0, parent);
        place("globe-" + name, globe_, room / 4, {0.2, 1.1, 0.1}, 0, parent);
    } else {
        table(room, parent);
    }
}

}  // namespace lanthorn::scene_generator
