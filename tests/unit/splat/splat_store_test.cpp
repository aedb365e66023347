// Photons in memory, on disk, and where the disk ends.
#include "gi_module/techniques/splat/splat_store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/file_size_limit.h"

namespace lanthorn::gi::test {
namespace {

constexpr std::size_t kRecords = 50'000;  // of a run: 800 kB

// A run whose records say which they are.
RecordRun run_of(std::uint32_t number, std::size_t records = kRecords) {
    RecordRun run;
    run.caustic = number % 2 == 1;
    for (std::uint32_t i = 0; i < records; ++i) {
        run.records.push_back({vec3(static_cast<float>(number), static_cast<float>(i), 0),
                               PhotonRecord::pack({1, 0, 0}, i % 5)});
    }
    arrange(run, std::vector<std::uint16_t>(records, static_cast<std::uint16_t>(number % 3)));
    return run;
}

std::vector<RecordRun> read(SplatStore& store) {
    std::vector<RecordRun> all;
    EXPECT_TRUE(store.each([&](const RecordRun& run) { all.push_back(run); })) << store.error();
    return all;
}

void expect_runs(SplatStore& store, std::uint32_t count) {
    for (int again = 0; again < 2; ++again) {  // reading takes nothing away
        const auto all = read(store);
        ASSERT_EQ(all.size(), count);
        for (std::uint32_t r = 0; r < count; ++r) {
            const RecordRun wanted = run_of(r);
            EXPECT_EQ(all[r].caustic, wanted.caustic);
            ASSERT_EQ(all[r].records.size(), wanted.records.size());
            ASSERT_EQ(all[r].blocks.size(), wanted.blocks.size());
            EXPECT_EQ(all[r].blocks.back().group, r % 3);
            for (std::size_t i = 0; i < kRecords; i += 997) {
                EXPECT_EQ(all[r].records[i].position, wanted.records[i].position);
                EXPECT_EQ(all[r].records[i].bits, wanted.records[i].bits);
            }
        }
    }
}

TEST(SplatStore, KeepsWhatFitsInMemory) {
    SplatStore store;
    for (std::uint32_t r = 0; r < 5; ++r) {
        EXPECT_TRUE(store.add({run_of(r)}));
    }
    expect_runs(store, 5);
    EXPECT_EQ(store.on_disk(), 0u);
    EXPECT_EQ(store.records(), 5 * kRecords);
}

TEST(SplatStore, StreamsWhatDoesNotFromDiskWithinItsLimit) {
    SplatStore store;
    constexpr std::size_t kLimit = 12u << 20;
    store.limit(kLimit);
    for (std::uint32_t r = 0; r < 40; ++r) {  // 32 MB
        EXPECT_TRUE(store.add({run_of(r)}));
    }
    EXPECT_GT(store.on_disk(), 20'000'000u);
    expect_runs(store, 40);
    EXPECT_LT(store.most_memory(), kLimit);
}

// Photons that each have a block of their own: the blocks, which stay in memory, are most of it.
TEST(SplatStore, RefusesWhatItCouldNotFindWithinItsMemory) {
    SplatStore store;
    store.limit(8u << 20);
    bool kept = true;
    std::uint64_t records = 0;
    for (int r = 0; r < 20 && kept; ++r) {
        RecordRun run;
        run.records.resize(20'000);
        run.blocks.resize(run.records.size());
        records = store.records();
        kept = store.add({std::move(run)});
    }
    EXPECT_FALSE(kept);
    EXPECT_EQ(store.records(), records);
    EXPECT_LE(store.memory(), 2 * (8u << 20));
    EXPECT_NE(store.error().find("gi.splat.memory"), std::string::npos);
    EXPECT_TRUE(store.each([](const RecordRun&) {}));
}

TEST(SplatStore, ForgetsAllWhenToldTo) {
    SplatStore store;
    store.limit(0);
    EXPECT_TRUE(store.add({run_of(0)}));
    EXPECT_GT(store.on_disk(), 0u);
    store.clear();
    EXPECT_TRUE(read(store).empty());
    EXPECT_EQ(store.on_disk() + store.records() + store.memory(), 0u);
    EXPECT_TRUE(store.add({run_of(0)}));
    expect_runs(store, 1);
}

TEST(SplatStore, AFullDiskLosesNothingThatWasThere) {
    SplatStore store;
    store.limit(0);
    EXPECT_TRUE(store.add({run_of(0)}));
    EXPECT_TRUE(store.add({run_of(1)}));
    {
        const support::FileSizeLimit limit(2'000'000);
        EXPECT_FALSE(store.add({run_of(2)}));
        EXPECT_NE(store.error().find("temporary file"), std::string::npos) << store.error();
        EXPECT_EQ(store.error().find('\n'), std::string::npos);
        expect_runs(store, 2);
        EXPECT_EQ(store.records(), 2 * kRecords);
    }
    EXPECT_TRUE(store.add({run_of(2)}));  // there is room again
    expect_runs(store, 3);
}

// The run that was in memory when the disk filled up stays there, or is whole on disk.
TEST(SplatStore, ADiskThatFillsWhileMemoryIsEmptiedLosesNothing) {
    SplatStore store;
    for (std::uint32_t r = 0; r < 4; ++r) {
        EXPECT_TRUE(store.add({run_of(r)}));
    }
    store.limit(0);
    {
        const support::FileSizeLimit limit(2'000'000);
        EXPECT_FALSE(store.add({run_of(4), run_of(5)}));
        expect_runs(store, 4);
    }
    EXPECT_TRUE(store.add({run_of(4), run_of(5)}));
    expect_runs(store, 6);
}

class StoreFolder : public testing::Test {
  protected:
    StoreFolder() { std::filesystem::create_directories(folder_); }
    ~StoreFolder() override { std::filesystem::remove_all(folder_); }
    const std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("lanthorn-store-test-" + std::to_string(::getpid()));
};

TEST_F(StoreFolder, AFolderThatIsNotThereIsNamed) {
    SplatStore store;
    store.limit(0, folder_ / "gone");
    EXPECT_FALSE(store.add({run_of(0)}));
    EXPECT_NE(store.error().find((folder_ / "gone").string()), std::string::npos) << store.error();
    EXPECT_TRUE(read(store).empty());
}

TEST_F(StoreFolder, AFolderThatVanishesTakesNothingWithIt) {
    SplatStore store;
    store.limit(0, folder_);
    EXPECT_TRUE(store.add({run_of(0)}));
    EXPECT_TRUE(std::filesystem::is_empty(folder_));  // nobody else sees the file
    std::filesystem::remove_all(folder_);
    EXPECT_TRUE(store.add({run_of(1)}));
    expect_runs(store, 2);
}

}  // namespace
}  // namespace lanthorn::gi::test
