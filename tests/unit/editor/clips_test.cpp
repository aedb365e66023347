// Which clip is shown, and which one a file begins with: the first is how one looks, the second an edit.
#include <gtest/gtest.h>

#include <algorithm>

#include "lanthorn/core/error.h"
#include "lanthorn/scene/components.h"
#include "tests/support/repository.h"
#include "tools/editor/core/edit_warnings.h"
#include "tools/editor/core/scene_clips.h"

namespace lanthorn::editor {
namespace {

class Clips : public testing::Test {
  protected:
    Clips() { session.open(support::repository_file("assets/levels/pool.glb")); }
    std::vector<Transform> poses() {
        session.app().show();
        std::vector<Transform> all;
        for (const ecs::Entity e : session.entities()) {
            all.push_back(e ? session.world().get<LocalTransform>(e).value : Transform{});
        }
        return all;
    }
    EditSession session;
};

TEST_F(Clips, AreListedWithWhatTheyMove) {
    const std::vector<ClipRow> rows = clip_rows(session);
    ASSERT_GE(rows.size(), 6u);
    EXPECT_EQ(start_clip(session, rows), rows.front().key);
    const auto walk = std::ranges::find(rows, "hero.walk", &ClipRow::key);
    ASSERT_NE(walk, rows.end());
    EXPECT_GT(walk->seconds, 0.1);
    EXPECT_GE(walk->nodes.size(), 10u);
    EXPECT_TRUE(std::ranges::is_sorted(walk->keys));
    EXPECT_TRUE(moves(*walk, session.model(), walk->nodes.back()));
    EXPECT_TRUE(moves(*walk, session.model(), session.model().node(walk->nodes.front()).parent));
    EXPECT_FALSE(moves(rows.front(), session.model(), walk->nodes.back()));
}

TEST_F(Clips, AMomentIsHowOneLooksAndNoEdit) {
    const std::vector<Transform> before = poses();
    session.show_moment("hero.walk", 0.4);
    EXPECT_EQ(session.moment(), 0.4);
    const std::vector<Transform> walking = poses();
    EXPECT_NE(walking, before);
    EXPECT_EQ(poses(), walking);
    session.show_moment("hero.walk", 0.1);
    EXPECT_NE(poses(), walking);
    session.show_moment("hero.walk", 0.4);
    EXPECT_EQ(poses(), walking);
    EXPECT_THROW(session.show_moment("hero.flies", 0), InputError);
    EXPECT_EQ(session.shown_clip(), "hero.walk");
    session.show_moment(std::nullopt, 0);
    EXPECT_EQ(poses(), before);
    EXPECT_FALSE(session.is_dirty());
    EXPECT_EQ(session.steps().position(), 0u);
}

TEST_F(Clips, TheOneThatTheFileBeginsWithIsAStep) {
    session.run(start_clip_line(session, "hero.walk"));
    const std::vector<Transform> walking = poses();
    EXPECT_EQ(start_clip(session, clip_rows(session)), "hero.walk");
    EXPECT_TRUE(session.is_dirty());
    session.show_moment("hero.walk", 0);
    EXPECT_EQ(poses(), walking);
    session.show_moment(std::nullopt, 0);
    const auto warns = [&] {
        return std::ranges::any_of(edit_warnings(session),
                                   [](const EditWarning& w) { return w.kind == "clip"; });
    };
    EXPECT_FALSE(warns());
    session.run(start_clip_line(session, "hero.flies"));
    EXPECT_EQ(session.steps().position(), 2u);
    EXPECT_TRUE(warns());
    EXPECT_EQ(start_clip(session, clip_rows(session)), "none");
    session.undo();
    EXPECT_EQ(poses(), walking);
    session.undo();
    EXPECT_FALSE(session.is_dirty());
    EXPECT_EQ(start_clip(session, clip_rows(session)), clip_rows(session).front().key);
}

TEST_F(Clips, ARoomHasNone) {
    session.new_room();
    EXPECT_TRUE(clip_rows(session).empty());
    EXPECT_EQ(start_clip(session, {}), "");
    EXPECT_THROW(session.show_moment("walk", 0), InputError);
}

}  // namespace
}  // namespace lanthorn::editor
