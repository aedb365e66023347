// Table 1 of Jozwowski 2002 as a rule: shooting takes as long as balancing.
#include "tools/lanthorn/measure/photon_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "lanthorn/core/error.h"

namespace lanthorn::tools {
namespace {

// A machine whose costs are known: ms.
PhotonFrame known(int total, int per_frame) {
    const double n = total;
    return {total, per_frame, 0.02 + 6e-4 * per_frame, 2e-5 * n * std::log2(n), 1 + 0.1 * std::log2(n)};
}

PhotonCosts costs() {
    return PhotonCosts(std::vector<PhotonFrame>{known(1000, 100), known(4000, 800), known(32000, 100)});
}

TEST(PhotonChoice, CostsAreThoseMeasured) {
    for (const auto& [total, per_frame] : {std::pair(2000, 50), std::pair(100'000, 4000)}) {
        const PhotonFrame is = costs().at(total, per_frame), should = known(total, per_frame);
        EXPECT_NEAR(is.shoot, should.shoot, 1e-9);
        EXPECT_NEAR(is.balance, should.balance, 1e-9);
        EXPECT_NEAR(is.estimate, should.estimate, 1e-9);
    }
}

TEST(PhotonChoice, ShootsAsLongAsItBalances) {
    int before = 0;
    for (const double frame_ms : {3.0, 5.0, 10.0, 20.0, 50.0}) {
        const PhotonFrame chosen = choose_photons(costs(), frame_ms);
        const PhotonFrame is = known(chosen.total, chosen.per_frame);
        EXPECT_NEAR(is.shoot, is.balance, 6e-4) << "to a photon, " << frame_ms;
        EXPECT_LE(is.shoot, is.balance + 1e-9);
        EXPECT_LE(is.whole(), frame_ms + 1e-9);
        EXPECT_GT(known(chosen.total + 1, chosen.per_frame + 1).whole(), frame_ms)
            << "no frame's time is left over";
        EXPECT_GT(chosen.total, before);
        before = chosen.total;
    }
}

// Dear shooting: still one photon; cheap shooting: all of them in every frame.
TEST(PhotonChoice, EndsAtOnePhotonAndAtAll) {
    const auto with = [](double shoot, double each) {
        std::vector<PhotonFrame> frames{known(1000, 100), known(32000, 800)};
        for (PhotonFrame& f : frames) {
            f.shoot = shoot + each * f.per_frame;
        }
        return PhotonCosts(frames);
    };
    const PhotonFrame dear = choose_photons(with(0, 5), 8);
    EXPECT_EQ(dear.per_frame, 1);
    EXPECT_LE(dear.whole(), 8);
    const PhotonFrame cheap = choose_photons(with(0, 1e-9), 8);
    EXPECT_EQ(cheap.per_frame, cheap.total);
    EXPECT_EQ(choose_photons(costs(), 1e9).total, kMostPhotons);
    EXPECT_THROW(choose_photons(costs(), 1), InputError);
    EXPECT_THROW(choose_photons(costs(), std::nan("")), InputError);
}

TEST(PhotonChoice, CostsAreNeverBelow0) {
    // Noise: more photons, less time.
    const PhotonCosts odd(std::vector<PhotonFrame>{{1000, 100, 2, 1, 2}, {8000, 800, 1, 1, 1}});
    const PhotonFrame none = odd.at(1, 1), many = odd.at(1'000'000, 1'000'000);
    for (const double ms :
         {none.shoot, none.balance, none.estimate, many.shoot, many.balance, many.estimate}) {
        EXPECT_GE(ms, 0);
        EXPECT_TRUE(std::isfinite(ms));
    }
}

}  // namespace
}  // namespace lanthorn::tools
