#include <cmath>
#include <optional>
#include <utility>

#include "lanthorn/core/turns.h"
#include "tools/scene_generator/building_rooms.h"
#include "tools/scene_generator/room.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

namespace {

// Rooms of 5 x 4 m in rows of five, five rows a floor. Each has half of every wall around it, so that rooms
// differ in colour; halves touch in planes that floats hold exactly.
constexpr int kColumns = 5, kRows = 5, kLamps = 10;
constexpr double kX = 2.5, kZ = 2.0;  // half a room and its walls
constexpr double kStorey = 3, kHeight = 2.7, kSlab = 0.15, kHalfWall = 0.5 * kWallThickness;
constexpr Doorway kDoor{0.9, 2.05};

struct Room {
    int index = 0;
    int column() const { return index % kColumns; }
    int row() const { return index / kColumns % kRows; }
    int floor() const { return index / (kColumns * kRows); }
    dvec3 origin() const { return {2 * kX * column(), kStorey * floor(), 2 * kZ * row()}; }
    bool stairs() const { return column() == kColumns - 1 && row() == kRows - 1; }
};

// Where along the wall towards the next column, or row, the middle of its doorway is; none: no doorway. The
// stairs stand along z > 0.8.
std::optional<double> doorway_x(const Room& r) {
    if (r.column() == kColumns - 1) {
        return {};
    }
    return r.row() == kRows - 1 ? -0.4 : 0.8 * ((3 * r.column() + 2 * r.row() + r.floor()) % 3 - 1);
}

std::optional<double> doorway_z(const Room& r, int rooms) {
    const int next = r.index + kColumns;
    if (r.row() == kRows - 1 || next >= rooms || (r.column() + r.row() + r.floor()) % 2 == 1) {
        return {};
    }
    return 0.7 * ((r.column() + r.row()) % 3 - 1);
}

// Of the plane y = 0 from `low` to `high` (x, z), but for the hole.
void add_slab(Shape& shape, double bottom, double top, bool hole) {
    const auto add = [&](double x0, double z0, double x1, double z1) {
        add_box(shape, {x0, bottom, z0}, {x1, top, z1});
    };
    if (!hole) {
        add(-kX, -kZ, kX, kZ);
        return;
    }
    constexpr double kLow = -1.3, kHigh = 1.44, kNear = 0.85, kFar = kZ - kHalfWall;
    add(-kX, -kZ, kX, kNear);
    add(-kX, kNear, kLow, kZ);
    add(kHigh, kNear, kX, kZ);
    add(kLow, kFar, kHigh, kZ);
}

// A wall along z from -`end` to `end` in x from `low` to `high`, with a doorway or without.
void add_wall(Shape& shape, double low, double high, double end, std::optional<double> doorway,
              bool along_x) {
    const auto add = [&](double x0, double y0, double z0, double x1, double y1, double z1) {
        along_x ? add_box(shape, {z0, y0, x0}, {z1, y1, x1}) : add_box(shape, {x0, y0, z0}, {x1, y1, z1});
    };
    if (!doorway) {
        add(low, 0, -end, high, kHeight, end);
        return;
    }
    const double a = *doorway - 0.5 * kDoor.width, b = *doorway + 0.5 * kDoor.width;
    add(low, 0, -end, high, kHeight, a);
    add(low, 0, b, high, kHeight, end);
    add(low, kDoor.height, a, high, kHeight, b);
}

class Building {
  public:
    explicit Building(int rooms) : rooms_(rooms) {}
    SceneData make();

  private:
    void shell(const Room& room, std::uint32_t node);
    void door(const std::string& name, const dvec3& hinge, double turn);
    void stairs(std::uint32_t parent);
    void railing(std::uint32_t parent);
    void lamp(const Room& room, int number);
    void camera(const std::string& name, int room, const dvec3& eye, const dvec3& to);

    int rooms_;
    Builder b_;
    std::vector<std::uint32_t> walls_, floors_;
    std::uint32_t white_ = 0, door_mesh_ = 0, shade_ = 0;
    AnimationClip doors_;
};

void Building::shell(const Room& room, std::uint32_t node) {
    const std::string name = std::to_string(room.index);
    const auto add = [&](const std::string& what, const Shape& shape, std::uint32_t material) {
        b_.solid(what + '-' + name, shape, material, {}, {}, node);
    };
    const bool lower = room.floor() == 0, two_floors = rooms_ > kColumns * kRows;
    Shape floor, ceiling, walls;
    add_slab(floor, -kSlab, 0, room.stairs() && !lower);
    add_slab(ceiling, kHeight, kStorey - kSlab, room.stairs() && lower && two_floors);
    const auto west = room.column() > 0 ? doorway_x({room.index - 1}) : std::nullopt;
    const auto north = room.row() > 0 ? doorway_z({room.index - kColumns}, rooms_) : std::nullopt;
    add_wall(walls, -kX, -kX + kHalfWall, kZ, west, false);
    add_wall(walls, kX - kHalfWall, kX, kZ, doorway_x(room), false);
    add_wall(walls, -kZ, -kZ + kHalfWall, kX - kHalfWall, north, true);
    add_wall(walls, kZ - kHalfWall, kZ, kX - kHalfWall, doorway_z(room, rooms_), true);
    add("floor", floor, floors_[static_cast<std::size_t>(room.row() + room.column()) % floors_.size()]);
    add("ceiling", ceiling, white_);
    add("walls", walls, walls_[static_cast<std::size_t>(7 * room.index) % walls_.size()]);
    if (room.stairs() && two_floors) {
        lower ? stairs(node) : railing(node);
    }
}

// A leaf that hangs in its hinge and swings open and shut, 12 s a round, each at another time.
void Building::door(const std::string& name, const dvec3& hinge, double turn) {
    constexpr double kOpen = 1.7, kSeconds = 12;
    const auto number = static_cast<int>(doors_.channels.size());
    Transform place = at(hinge);
    place.rotation = quat(about_y(turn));
    const std::uint32_t frame = b_.node(name + "-frame", place);
    const std::uint32_t leaf = b_.node(name, {}, frame);
    b_.scene.nodes[leaf].meshes = {door_mesh_};
    AnimationChannel channel;
    channel.node = leaf;
    channel.path = AnimationPath::rotation;
    channel.width = 4;
    // Every third begins open. Closed at the ends of the round or open, it moves for 1.5 s twice.
    const bool begins_open = number % 3 == 0;
    const double starts = 1 + 0.6 * (number % 8), shut = begins_open ? kOpen : 0, wide = kOpen - shut;
    const std::pair<double, double> keys[] = {{0, shut},          {starts, shut},       {starts + 1.5, wide},
                                              {starts + 4, wide}, {starts + 5.5, shut}, {kSeconds, shut}};
    for (const auto& [time, angle] : keys) {
        channel.times.push_back(static_cast<float>(time));
        for (const double v : {0.0, std::sin(0.5 * angle), 0.0, std::cos(0.5 * angle)}) {
            channel.values.push_back(static_cast<float>(v));
        }
    }
    b_.scene.nodes[leaf].local.rotation = quat(about_y(shut));
    doors_.duration = static_cast<float>(kSeconds);
    doors_.channels.push_back(std::move(channel));
}

void Building::stairs(std::uint32_t parent) {
    constexpr double kTread = 0.26, kRise = 0.2;
    Shape steps;
    for (int i = 0; i < 14; ++i) {
        const double x = -2.2 + kTread * i;
        add_box(steps, {x, 0, 0.9}, {x + kTread, kRise * (i + 1), kZ - kHalfWall});
    }
    b_.solid("stairs", steps, floors_[1], {}, {}, parent);
}

void Building::railing(std::uint32_t parent) {
    Shape rail;
    add_box(rail, {-1.4, 0.9, 0.74}, {1.44, 0.95, 0.8});
    add_box(rail, {-1.4, 0.9, 0.8}, {-1.34, 0.95, kZ - kHalfWall});
    for (const double x : {-1.4, -0.7, 0.0, 0.7, 1.38}) {
        add_box(rail, {x, 0, 0.74}, {x + 0.06, 0.9, 0.8});
    }
    b_.solid("railing", rail, floors_[1], {}, {}, parent);
}

// Hangs from the ceiling, under a shade that keeps light off it.
void Building::lamp(const Room& room, int number) {
    constexpr vec3 kColours[kLamps] = {
        {1, 0.86f, 0.68f}, {1, 0.72f, 0.42f}, {0.75f, 0.85f, 1}, {1, 0.6f, 0.5f},   {0.7f, 1, 0.75f},
        {1, 0.92f, 0.8f},  {0.62f, 0.7f, 1},  {1, 0.78f, 0.55f}, {0.95f, 0.65f, 1}, {1, 1, 0.72f}};
    const dvec3 place = room.origin() + dvec3(-0.5, 2.1, room.stairs() ? -0.6 : 0.1);
    Light light;
    light.type = LightType::point;
    light.colour = kColours[number];
    light.intensity = static_cast<float>(170 + 15 * (number % 4));
    const std::uint32_t node = b_.light("lamp-" + std::to_string(number), at(place), light);
    b_.scene.nodes[node].meshes = {shade_};
}

void Building::camera(const std::string& name, int room, const dvec3& eye, const dvec3& to) {
    if (room < rooms_) {
        const dvec3 origin = Room{room}.origin();
        b_.camera(name, looking(origin + eye, origin + to), glm::radians(65.0f));
    }
}

SceneData Building::make() {
    white_ = b_.matte("ceiling", {0.78f, 0.77f, 0.74f});
    for (const vec3& colour : {vec3(0.74f, 0.72f, 0.66f), vec3(0.62f, 0.3f, 0.22f), vec3(0.42f, 0.55f, 0.4f),
                               vec3(0.7f, 0.58f, 0.32f), vec3(0.3f, 0.42f, 0.6f), vec3(0.72f, 0.7f, 0.7f),
                               vec3(0.55f, 0.4f, 0.52f), vec3(0.35f, 0.55f, 0.55f)}) {
        walls_.push_back(b_.matte("plaster-" + std::to_string(walls_.size()), colour));
    }
    floors_ = {b_.matte("boards", {0.5f, 0.37f, 0.25f}), b_.matte("dark-boards", {0.3f, 0.19f, 0.12f}),
               b_.matte("tiles", {0.5f, 0.5f, 0.47f})};
    constexpr double kLap = 0.004, kThick = 0.05;
    door_mesh_ =
        b_.mesh("door", box({-kThick, kLap, -kLap}, {-0.001, kDoor.height + kLap, kDoor.width + kLap}),
                b_.matte("door", {0.42f, 0.27f, 0.15f}));
    Shape shade;
    add_box(shade, {-0.2, 0.12, -0.2}, {0.2, 0.14, 0.2});
    add_box(shade, {-0.01, 0.14, -0.01}, {0.01, kHeight - 2.1, 0.01});
    shade_ = b_.mesh("shade", shade, b_.matte("iron", {0.1f, 0.1f, 0.11f}));

    RoomFurniture furniture(b_);
    int doorways = 0;
    for (int i = 0; i < rooms_; ++i) {
        const Room room{i};
        const std::uint32_t node = b_.node("room-" + std::to_string(i), at(room.origin()));
        shell(room, node);
        const bool back = room.row() == 0 || !doorway_z({i - kColumns}, rooms_);
        if (!room.stairs()) {
            furniture.put(static_cast<std::uint32_t>(i), node, {kX - kHalfWall, 0, kZ - kHalfWall}, back,
                          i % 7 != 5);
        }
        // Two doorways of three have doors.
        if (const auto z = doorway_x(room); z && ++doorways % 3 != 0) {
            door("door-" + std::to_string(i) + "-x",
                 room.origin() + dvec3(kX + kHalfWall, 0, *z - 0.5 * kDoor.width), 0);
        }
        if (const auto x = doorway_z(room, rooms_); x && ++doorways % 3 != 0) {
            door("door-" + std::to_string(i) + "-z",
                 room.origin() + dvec3(*x + 0.5 * kDoor.width, 0, kZ + kHalfWall), -0.5 * kPi);
        }
    }
    doors_.name = "doors";
    b_.scene.animations.push_back(doors_);
    for (int i = 0; i < kLamps; ++i) {
        lamp({7 * i % rooms_}, i);
    }
    camera("camera", 0, {-2.2, 1.6, 1.6}, {1.6, 1.0, -0.6});
    camera("dark", 1, {2.2, 1.6, 1.7}, {-1.8, 1.0, -0.6});
    camera("far", 13, {2.2, 1.6, -1.6}, {-1.6, 0.9, 0.6});
    camera("stairs", 24, {-2.2, 1.5, -1.6}, {0.6, 1.4, 1.2});
    camera("landing", 49, {-2.2, 1.6, -1.7}, {0.8, 0.8, 1.0});
    camera("upper", 28, {2.2, 1.6, 1.6}, {-1.6, 0.9, -0.8});
    return b_.scene;
}

}  // namespace

SceneData building() {
    return Building(50).make();
}
SceneData building_of_25() {
    return Building(25).make();
}
SceneData building_of_10() {
    return Building(10).make();
}

}  // namespace lanthorn::scene_generator
