#include "gi_module/techniques/emc/maps/candidate_look.h"

#include <gtest/gtest.h>

namespace lanthorn::gi {
namespace {

// Three candidates, of which 1 is in C and 2 in a solid.
CandidateLook look() {
    CandidateLook look;
    look.begin(3);
    look.found(0, 4, 2, false);
    look.found(1, 10, 10, false);
    look.found(2, 6, 6e-6, true);
    look.found_new(0, 3, 1.5);
    look.found_new(2, 2, 2e-6);
    return look;
}

TEST(CandidateLook, KnowsWhatEachWouldAdd) {
    const CandidateLook l = look();
    EXPECT_EQ(l.gain(0), 1.5);
    EXPECT_LT(l.gain(1), 0) << "nobody asked";
    EXPECT_EQ(l.best(), 0);
    EXPECT_EQ(l.largest(), 10);
    EXPECT_DOUBLE_EQ(l.coverage(), 1 - 5.0 / 20);
    EXPECT_EQ(l.closed(), std::vector<std::size_t>{2});
}

TEST(CandidateLook, AMemberOfCAddsNothingMore) {
    CandidateLook l = look();
    l.joined(0);
    l.joined(7);  // a reserved centre is none of the candidates
    EXPECT_LT(l.gain(0), 0);
    EXPECT_EQ(l.best(), 2);
    EXPECT_DOUBLE_EQ(l.coverage(), 1 - 2.0 / 20);
}

TEST(CandidateLook, OfNothingKnowsNothing) {
    CandidateLook l = look();
    l.forget();
    EXPECT_EQ(l.best(), -1);
    EXPECT_TRUE(l.closed().empty());
    l.begin(2);
    EXPECT_EQ(l.coverage(), 0);
    EXPECT_EQ(l.largest(), 0);
    EXPECT_EQ(CandidateLook().largest(), 0);
}

}  // namespace
}  // namespace lanthorn::gi
