// A level in play that a build with other components has kept: its state goes by names.
#include <gtest/gtest.h>

#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/ecs/world_hash.h"
#include "tests/unit/game/test_level.h"

namespace lanthorn::game {
namespace saved_level_test {

struct Medal {
    int worth = 3;
};

void declare_medal(Played& game) {
    game.session.app().registry().component<Medal>("medal", "of another build",
                                                   ecs::field("worth", &Medal::worth));
}
ecs::Snapshot kept(Played& game) {
    return ecs::Snapshot::save(game.world(), game.session.app().registry());
}
std::vector<std::uint64_t> hashes(Played& game) {
    return ecs::state_hashes(game.session.app().registry(), game.world());
}
void play(Played& game) {
    game.press(kUse);
    game.walk(0.5, 60);
}

TEST(SavedLevel, OfABuildWithMoreGoesOnWithoutIt) {
    Played newer(test_level().scene), older(test_level().scene);
    declare_medal(newer);
    play(newer);
    newer.world().add(newer.named("player"), Medal{7});
    const ecs::Snapshot read =
        ecs::Snapshot::from_bytes(kept(newer).to_bytes(), older.session.app().registry(), "progress");
    EXPECT_EQ(read.left_out(), std::vector<std::string>{"medal"});
    read.restore(older.world());
    EXPECT_GT(older.of<Door>("door").angle, 0.1);
    EXPECT_EQ(older.of<Door>("door"), newer.of<Door>("door"));
    EXPECT_EQ(older.place("player"), newer.place("player"));
    older.steps(30);  // it goes on
    EXPECT_GT(older.of<Door>("door").angle, newer.of<Door>("door").angle);
}

TEST(SavedLevel, OfABuildWithLessLeavesWhatIsNewAsTheLevelHasIt) {
    Played older(test_level().scene), newer(test_level().scene);
    declare_medal(newer);
    newer.world().add(newer.named("player"), Medal{7});
    play(older);
    const ecs::Snapshot read =
        ecs::Snapshot::from_bytes(kept(older).to_bytes(), newer.session.app().registry(), "progress");
    EXPECT_TRUE(read.left_out().empty());
    read.restore(newer.world());
    EXPECT_EQ(newer.of<Medal>("player").worth, 7);
    EXPECT_EQ(newer.of<Door>("door"), older.of<Door>("door"));
    EXPECT_EQ(newer.place("player"), older.place("player"));
}

// Another schema alone makes no value another: every part of the state is the same.
TEST(SavedLevel, IsBitForBitWhatItWas) {
    Played game(test_level().scene), other(test_level().scene);
    play(game);
    declare_medal(other);
    ecs::Snapshot::from_bytes(kept(game).to_bytes(), other.session.app().registry(), "progress")
        .restore(other.world());
    const std::vector<std::string> parts = ecs::state_parts(game.session.app().registry());
    const std::vector<std::string> others = ecs::state_parts(other.session.app().registry());
    const std::vector<std::uint64_t> expected = hashes(game), found = hashes(other);
    for (std::size_t i = 0, k = 0; i < others.size(); ++i) {
        if (others[i] != "medal") {
            EXPECT_EQ(others[i], parts[k]);
            EXPECT_EQ(found[i], expected[k++]) << others[i];
        }
    }
}

}  // namespace saved_level_test
}  // namespace lanthorn::game
