// Handles in the viewport: where they are, and what a hand does with them.
#include "tools/editor/window/handles.h"

#include <gtest/gtest.h>

#include "lanthorn/scene/view.h"

namespace lanthorn::edit_window {
namespace {

// Looks along -Z from `distance` metres, around a place that may be far from the world's origin.
struct Eye {
    explicit Eye(const dvec3& around = dvec3(0), double distance = 5) : origin(around) {
        dmat4 world(1);
        world[3] = dvec4(around + dvec3(0, 0, distance), 1);
        projector = Projector(camera_view(Camera{}, world, origin), origin, Box{100, 50, 800, 600});
    }
    dvec3 origin;
    Projector projector;
};

TEST(Projector, ThereAndBackAlsoFarFromTheOrigin) {
    for (const dvec3& around : {dvec3(0), dvec3(1e5, -2e4, 3e5)}) {
        const Eye eye(around);
        EXPECT_NEAR(eye.projector.at(around)->x, 500, 1e-2);
        EXPECT_NEAR(eye.projector.at(around)->y, 350, 1e-2);
        const dvec3 place = around + dvec3(0.7, -0.4, 1.1);
        const vec2 pixel = *eye.projector.at(place);
        const PickRay ray = eye.projector.ray(pixel);
        const double along_it = glm::dot(place - ray.origin, ray.direction);
        EXPECT_LT(glm::length(ray.origin + along_it * ray.direction - place), 2e-3);
    }
    const Eye eye;
    EXPECT_FALSE(eye.projector.at({0, 0, 6}));  // behind it
    EXPECT_TRUE(eye.projector.line({0, 0, 0}, {0, 0, 6}));
    EXPECT_FALSE(eye.projector.line({0, 0, 6}, {0, 1, 7}));
}

struct Drag {
    Drag(Tool tool, Part part, const dvec3& from_place, const dvec3& to_place, bool snap = false,
         std::optional<double> typed = {}, const HandlePlace& at = {}) {
        const Eye eye;
        handles.place(at, tool, eye.projector, 1);
        handles.begin(part, *eye.projector.at(from_place));
        change = handles.change(*eye.projector.at(to_place), snap, {}, typed);
    }
    Handles handles;
    HandleChange change;
};

TEST(Handles, KeepTheirSizeOnTheScreenAndCanBeHit) {
    for (const double distance : {1.0, 20.0}) {
        const Eye eye(dvec3(0), distance);
        Handles handles;
        handles.place({}, Tool::move, eye.projector, 1);
        const vec2 middle = *eye.projector.at(dvec3(0));
        EXPECT_EQ(handles.hit(middle), Part::view);
        EXPECT_EQ(handles.hit(middle + vec2(60, 0)), Part::x);
        EXPECT_EQ(handles.hit(middle + vec2(0, -60)), Part::y);
        EXPECT_EQ(handles.hit(middle + vec2(32, -32)), Part::xy);
        EXPECT_EQ(handles.hit(middle + vec2(300, 0)), Part::none);
        handles.place({}, Tool::select, eye.projector, 1);
        EXPECT_EQ(handles.hit(middle + vec2(60, 0)), Part::none);
    }
}

TEST(Handles, MoveAlongAnAxisAPlaneAndByATypedNumber) {
    const Drag along_x(Tool::move, Part::x, {0.2, 0, 0}, {1.53, 0.7, 0});
    EXPECT_NEAR(along_x.change.move.x, 1.33, 5e-2);  // the place on the axis nearest to the ray
    EXPECT_EQ(along_x.change.move.y, 0);
    const Drag snapped(Tool::move, Part::x, {0.2, 0, 0}, {1.53, 0, 0}, true);
    EXPECT_NEAR(snapped.change.move.x, 1.3, 1e-9);
    const Drag in_plane(Tool::move, Part::xy, {0, 0, 0}, {0.4, -0.3, 0});
    EXPECT_LT(glm::length(in_plane.change.move - dvec3(0.4, -0.3, 0)), 1e-3);
    const Drag typed(Tool::move, Part::y, {0, 0.2, 0}, {0, 3, 0}, false, -2.5);
    EXPECT_EQ(typed.change.move, dvec3(0, -2.5, 0));
}

TEST(Handles, TurnAndScale) {
    const Drag turn(Tool::rotate, Part::z, {1, 0, 0}, {0, 1, 0});
    EXPECT_NEAR(glm::degrees(glm::angle(turn.change.turn)), 90, 0.1);
    const dvec3 x = turn.change.turn * dvec3(1, 0, 0);
    EXPECT_LT(glm::length(x - dvec3(0, 1, 0)), 1e-3);
    const Drag snapped(Tool::rotate, Part::z, {1, 0, 0}, {1, 0.3, 0}, true);
    EXPECT_NEAR(glm::degrees(glm::angle(snapped.change.turn)), 15, 1e-6);
    const Drag wider(Tool::scale, Part::x, {0.5, 0, 0}, {1, 0, 0});
    EXPECT_NEAR(wider.change.stretch.x, 2, 1e-2);
    EXPECT_EQ(wider.change.stretch.y, 1);
    EXPECT_EQ(Drag(Tool::scale, Part::view, {0, 0, 0}, {1, 0, 0}, false, 3.0).change.stretch, dvec3(3));
}

TEST(Handles, ALightsRangeAndCone) {
    HandlePlace lamp;
    lamp.range = 2;
    EXPECT_NEAR(Drag(Tool::move, Part::range, {2, 0, 0}, {0, 1.5, 0}, false, {}, lamp).change.range, 1.5,
                1e-2);
    lamp.cone = 0.5;
    lamp.light_axes = glm::dmat3(dvec3(0, 0, 1), dvec3(1, 0, 0), dvec3(0, 1, 0));  // shines down
    const HandleChange change =
        Drag(Tool::move, Part::cone, {0.5, -1, 0}, {1, -1, 0}, false, {}, lamp).change;
    EXPECT_NEAR(glm::degrees(change.cone), 45, 0.5);
}

}  // namespace
}  // namespace lanthorn::edit_window
