// What is kept of photons carries their power in the mean.
#include "gi_module/techniques/splat/photon_record.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "gi_module/reference/random.h"

namespace lanthorn::gi::test {
namespace {

TEST(PhotonRecord, CopiesCarryTheFluxInTheMean) {
    const vec3 power(2, 4, 0.5f), flux(1.3f, 4, 2.6f);
    dvec3 sum(0);
    constexpr int kSamples = 10'000;
    for (int i = 0; i < kSamples; ++i) {
        sum += dvec3(copies_of(flux, power, (static_cast<float>(i) + 0.5f) / kSamples)) * dvec3(power);
    }
    for (glm::length_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(sum[c] / kSamples, static_cast<double>(flux[c]), 1e-3) << c;
    }
}

TEST(PhotonRecord, AWholePowerIsOneCopyAlways) {
    for (const float u : {0.0f, 0.3f, 0.9999f}) {
        EXPECT_EQ(copies_of(vec3(3), vec3(3), u), glm::uvec3(1));
        EXPECT_EQ(copies_of(vec3(0), vec3(3), u), glm::uvec3(0));
        EXPECT_EQ(copies_of(vec3(1), vec3(0), u), glm::uvec3(0));  // the group has none of that
    }
}

TEST(PhotonRecord, MoreThanFitIsMoreRecords) {
    Photon photon;
    photon.flux = vec3(16, 3, 0);
    std::vector<PhotonRecord> records;
    add_records(photon, vec3(1), 12345, 0, records);
    ASSERT_EQ(records.size(), 3u);
    std::uint32_t red = 0, green = 0, blue = 0;
    for (const PhotonRecord& r : records) {
        red += r.copies(0);
        green += r.copies(1);
        blue += r.copies(2);
        EXPECT_EQ(r.side(), 12345u);
        EXPECT_EQ(r.more(), &r != records.data());  // of one photon
    }
    EXPECT_EQ(red, 16u);
    EXPECT_EQ(green, 3u);
    EXPECT_EQ(blue, 0u);
    add_records(Photon(), vec3(1), 1, 0.5f, records);
    EXPECT_EQ(records.size(), 3u);  // no flux, no record
}

TEST(PhotonRecord, BlocksHoldEveryRecordOnceOnOneSideOfOneGroupAndInTheirBox) {
    RecordRun run;
    std::vector<std::uint16_t> groups;
    std::map<float, std::uint16_t> group_at;
    std::multiset<float> before, after;
    for (std::uint32_t i = 0; i < 5000; ++i) {
        const reference::RandomNumbers random(1, 0, i);
        const vec2 u = random.pair(0);
        run.records.push_back({vec3(u.x, u.y, random.pair(1).x), PhotonRecord::pack({1, 1, 1}, i % 7)});
        before.insert(u.x);
        groups.push_back(static_cast<std::uint16_t>(i % 3));
        group_at[u.x] = groups.back();
    }
    arrange(run, groups);
    std::uint32_t next = 0;
    for (const PhotonBlock& block : run.blocks) {
        EXPECT_EQ(block.first, next);
        EXPECT_GE(block.count, 1u);
        EXPECT_LE(block.count, PhotonBlock::kMost);
        next += block.count;
        for (std::uint32_t i = block.first; i < next; ++i) {
            const PhotonRecord& r = run.records[i];
            EXPECT_EQ(r.side(), block.side);
            EXPECT_EQ(group_at[r.position.x], block.group);
            EXPECT_TRUE(glm::all(glm::lessThanEqual(block.lower, r.position)) &&
                        glm::all(glm::lessThanEqual(r.position, block.upper)));
            after.insert(r.position.x);
        }
    }
    EXPECT_EQ(next, run.records.size());
    EXPECT_EQ(before, after);
    EXPECT_EQ(group_at.size(), 5000u);  // no two in one place
    EXPECT_LE(run.blocks.size(), 5000u / PhotonBlock::kMost + 2 * 7 * 3);
}

TEST(PhotonRecord, AllOnOnePointIsNoTrouble) {
    RecordRun run;
    run.records.assign(1000, {vec3(3), 1});
    arrange(run);
    EXPECT_EQ(run.blocks.size(), 16u);
    RecordRun none;
    arrange(none);
    EXPECT_TRUE(none.blocks.empty());
}

}  // namespace
}  // namespace lanthorn::gi::test
