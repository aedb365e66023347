// Views that are kept by number, and the ones to go back to.
#include "tools/editor/window/kept_views.h"

#include <gtest/gtest.h>

#include <future>

#include "lanthorn/core/error.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/window/alarm.h"
#include "tools/editor/window/pivot.h"

namespace lanthorn::edit_window {
namespace {

using workbench::CameraPose;

CameraPose from(double x) {
    return {{x, 1.7, -1.0 / 3}, 90, -10, 60};
}

TEST(KeptViews, AreReadAsTheyWereWritten) {
    KeptViews views;
    CameraPose wide = from(2);
    wide.fov = 75;
    views.keep("/a room/b.glb", 1, from(1));
    views.keep("/c.glb", 9, wide);
    views.keep("", 3, from(4));  // of a scene that has no file yet
    views.keep("/a room/b.glb", 1, from(3));
    const KeptViews again = KeptViews::parse(views.text(), "views");
    EXPECT_EQ(again.text(), views.text());
    ASSERT_NE(again.find("/a room/b.glb", 1), nullptr);
    EXPECT_EQ(*again.find("/a room/b.glb", 1), from(3));
    EXPECT_EQ(*again.find("/c.glb", 9), wide);
    EXPECT_EQ(again.find("/c.glb", 1), nullptr);
    EXPECT_EQ(again.find("", 3), nullptr);
    EXPECT_EQ(*views.find("", 3), from(4));
    views.copy("", "/new.glb");
    EXPECT_EQ(*views.find("/new.glb", 3), from(4));
    views.forget("");
    EXPECT_EQ(views.find("", 3), nullptr);
}

TEST(KeptViews, OfTheFilesThatWereUsedLongestAgoAreDropped) {
    KeptViews views;
    for (int i = 0; i < static_cast<int>(KeptViews::kFiles); ++i) {
        views.keep("/" + std::to_string(i), 1, from(i));
    }
    views.keep("/0", 2, from(0));
    views.keep("/one more", 1, from(0));
    EXPECT_NE(views.find("/0", 1), nullptr);
    EXPECT_EQ(views.find("/1", 1), nullptr);
    EXPECT_NE(views.find("/2", 1), nullptr);
}

TEST(KeptViews, RefuseWhatIsNoneWithTheLine) {
    for (const char* bad : {"0 1,2,3,4,5 /a\n", "1 1,2,3,4,5\n", "1 1,2,3 /a\n", "x", "11 1,2,3,4,5 /a"}) {
        try {
            KeptViews::parse("1 1,2,3,4,5 /a\n" + std::string(bad), "views");
            FAIL() << bad;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find("views: line 2"), std::string::npos) << error.what();
        }
    }
}

LookedAt seen(double x) {
    return {from(x)};
}

TEST(ViewHistory, GoesBackToWhereOneStoodAndForthAgain) {
    ViewHistory history;
    EXPECT_FALSE(history.back(seen(0), 1));
    history.leave(seen(0), 10, false);      // a hand begins
    history.leave(seen(0.5), 10.1, false);  // and goes on
    history.leave(seen(1), 10.2, true);     // a jump from 1 to 2
    history.leave(seen(2), 10.3, false);    // a hand again
    EXPECT_EQ(history.back(seen(3), 20), seen(2));
    EXPECT_EQ(history.back(seen(2), 20), seen(1));
    EXPECT_EQ(history.back(seen(1), 20), seen(0));
    EXPECT_FALSE(history.back(seen(0), 20));
    EXPECT_EQ(history.forth(seen(0), 20), seen(1));
    EXPECT_EQ(history.forth(seen(1), 20), seen(2));
    EXPECT_EQ(history.back(seen(2), 20), seen(1));
    history.leave(seen(1), 21, false);  // another way: no way forth any more
    EXPECT_FALSE(history.forth(seen(5), 21));
    EXPECT_EQ(history.back(seen(5), 21), seen(1));
}

TEST(ViewHistory, KnowsWhatStoodBesideAView) {
    const auto side = std::make_shared<const OtherSide>();
    ViewHistory history;
    history.leave(seen(0), 10, true);
    EXPECT_EQ(history.back({from(0), side}, 11), seen(0));
    EXPECT_EQ(history.forth(seen(0), 12), (LookedAt{from(0), side}));
}

TEST(ViewHistory, LookingElsewhereIsNoEdit) {
    editor::EditSession session;
    session.new_room();
    const std::uint64_t version = session.version();
    const bool dirty = session.is_dirty();
    session.set_pose(from(7));
    EXPECT_EQ(session.version(), version);
    EXPECT_EQ(session.is_dirty(), dirty);
    EXPECT_EQ(session.steps().position(), 0u);
}

TEST(Alarm, RingsOnceForTheNewestTimeAndNotForTheOneBefore) {
    std::promise<void> rung;
    int count = 0;
    {
        Alarm alarm([&] {
            if (++count == 1) {
                rung.set_value();
            }
        });
        alarm.set(Alarm::Clock::now() + std::chrono::hours(1));
        alarm.set(Alarm::Clock::now());
        rung.get_future().wait();
    }
    EXPECT_EQ(count, 1);
}

TEST(Pivot, IsTheOriginWhereThatSaysSomethingOfTheThing) {
    Aabb chair;
    chair.add(vec3(-0.3f, 0, -0.3f));
    chair.add(vec3(0.3f, 1, 0.3f));
    EXPECT_TRUE(origin_is_meant(chair, vec3(0)));            // in the middle of its feet
    EXPECT_TRUE(origin_is_meant(chair, vec3(-0.3f, 0, 0)));  // a hinge
    EXPECT_FALSE(origin_is_meant(chair, vec3(5, 0, 0)));     // elsewhere
    Aabb wing;                                               // of a level: modelled where it stands
    wing.add(vec3(-2, -0.2f, -9));
    wing.add(vec3(11, 3, 4));
    EXPECT_FALSE(origin_is_meant(wing, vec3(0)));
    EXPECT_TRUE(origin_is_meant(Aabb(), vec3(0)));
}

}  // namespace
}  // namespace lanthorn::edit_window
