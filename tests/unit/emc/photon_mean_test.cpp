#include "gi_module/techniques/emc/lit_maps/photon_mean.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

namespace lanthorn::gi {
namespace {

constexpr PhotonMean::Change kStill;
constexpr PhotonMean::Change kLight{.any = true};
constexpr PhotonMean::Change kSurfaces{.any = true, .surfaces = true};

// "HELD+TIMES " a frame, "- " where nothing is traced.
std::string frames(PhotonMean& mean, const PhotonMean::Change& change, int count) {
    std::string done;
    for (int i = 0; i < count; ++i) {
        const auto frame = mean.next(change);
        done += frame ? std::to_string(frame->held) + '+' + std::to_string(frame->times) + ' ' : "- ";
    }
    return done;
}

TEST(PhotonMean, OfAStillSceneFillsAndEnds) {
    PhotonMean mean;
    EXPECT_EQ(frames(mean, kStill, 15), "0+4 4+1 5+1 6+1 7+1 8+1 9+1 10+1 11+1 12+1 13+1 14+1 15+1 - - ");
    EXPECT_EQ(mean.units(), PhotonMean::kFrames);
}

TEST(PhotonMean, HasFewFramesWhileThingsChange) {
    PhotonMean light;
    EXPECT_EQ(frames(light, kLight, 9), "0+4 4+1 5+1 6+1 7+1 7+1 7+1 7+1 7+1 ");
    PhotonMean surfaces;  // twice as many photons, in one frame
    EXPECT_EQ(frames(surfaces, kSurfaces, 5), "0+4 0+2 0+2 0+2 0+2 ");
}

TEST(PhotonMean, IsTheShorterTheFasterLampsMove) {
    const std::pair<float, int> expected[] = {{0, 7}, {0.001f, 7}, {0.0049f, 3}, {0.0099f, 1}, {10, 0}};
    for (const auto& [drift, held] : expected) {
        PhotonMean mean;
        const PhotonMean::Change moves{.any = true, .drift = drift};
        frames(mean, moves, 20);
        EXPECT_EQ(mean.next(moves)->held, held) << drift;
    }
}

TEST(PhotonMean, BeginsAgainOnceAllHasComeToRest) {
    PhotonMean mean;
    frames(mean, kStill, 20);
    EXPECT_EQ(frames(mean, kLight, 2), "7+1 7+1 ");
    // The third frame begins the mean of a still scene, which none of before is part of.
    EXPECT_EQ(frames(mean, kStill, 3), "8+1 9+1 0+4 ");
    EXPECT_EQ(frames(mean, kStill, 13), "4+1 5+1 6+1 7+1 8+1 9+1 10+1 11+1 12+1 13+1 14+1 15+1 - ");
}

TEST(PhotonMean, OfOtherLampsBeginsAtOnceAndOnceWithMorePhotons) {
    PhotonMean mean;
    frames(mean, kStill, 20);
    std::string done;
    for (int i = 0; i < 3; ++i) {  // lamps that blink
        mean.begin();
        done += frames(mean, kLight, 1);
    }
    EXPECT_EQ(done, "0+4 0+1 0+1 ");
    mean.forget();
    EXPECT_EQ(frames(mean, kLight, 1), "0+4 ") << "as the first of all";
}

TEST(PhotonMean, MakesRoomForWhatOtherMapsShow) {
    PhotonMean mean;
    frames(mean, kStill, 20);
    mean.make_room();
    EXPECT_EQ(mean.units(), PhotonMean::kFrames / 2);
    EXPECT_EQ(frames(mean, kStill, 9), "8+1 9+1 10+1 11+1 12+1 13+1 14+1 15+1 - ");
    PhotonMean begun;
    frames(begun, kStill, 1);
    begun.make_room();
    EXPECT_EQ(begun.units(), PhotonMean::kFirst) << "it has room";
}

// Photons of one mean are all different ones: no part of the sequences of random numbers is in it twice.
TEST(PhotonMean, HoldsNoPhotonTwice) {
    PhotonMean mean;
    std::set<int> traced;
    const auto add = [&](const PhotonMean::Frame& frame) {
        if (frame.held == 0) {
            traced.clear();  // another mean
        }
        for (int unit = frame.pass * frame.times; unit < (frame.pass + 1) * frame.times; ++unit) {
            EXPECT_TRUE(traced.insert(unit).second) << unit;
        }
    };
    while (const auto frame = mean.next(kStill)) {
        add(*frame);
    }
    EXPECT_EQ(traced.size(), std::size_t{PhotonMean::kFrames});
    // Those after a change, of other counts a frame, do not come among the last ones either.
    PhotonMean moving;
    add(*moving.next(kSurfaces));
    for (int i = 0; i < 4; ++i) {
        add(*moving.next(i % 2 == 0 ? kSurfaces : kLight));
    }
}

}  // namespace
}  // namespace lanthorn::gi
