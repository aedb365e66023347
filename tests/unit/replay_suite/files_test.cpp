// What a suite keeps in files: results, what is accepted, the ratchet, plans.
#include <gtest/gtest.h>

#include <fstream>

#include "lanthorn/core/error.h"
#include "tests/unit/replay_suite/made_results.h"
#include "tests/unit/tools/run_program.h"
#include "tools/replay_suite/accepted.h"
#include "tools/replay_suite/plan.h"
#include "tools/replay_suite/receipt.h"

namespace lanthorn::suite {
namespace {

using testing_tools::file_bytes;
using testing_tools::TemporaryFolder;

void put(const std::string& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
}

TEST(Results, ComeBackAsTheyWere) {
    const TemporaryFolder folder;
    const ResultFiles files(folder.path());
    Result result = diverged("a.rec");
    result.crash = Crash{11, 4, {"f", "in libc.so.6"}};
    files.put(result);
    const auto found = files.find(result.key);
    ASSERT_TRUE(found);
    EXPECT_EQ(to_text(*found), to_text(result));
}

TEST(Results, OfTheSameAreEqualButForTimes) {
    const TemporaryFolder folder;
    const ResultFiles files(folder.path());
    Result result = passed("a.rec");
    files.put(result);
    const std::string bytes = file_bytes(files.file_of(result.key));
    result.times["wall_s"] = 9.0;
    files.put(result);
    EXPECT_EQ(file_bytes(files.file_of(result.key)), bytes);
    EXPECT_EQ(files.find(result.key)->verdict, Verdict::ok);
}

TEST(Results, ThatDifferAreAFinding) {
    const TemporaryFolder folder;
    const ResultFiles files(folder.path());
    files.put(passed("a.rec"));
    Result other = diverged("a.rec");
    files.put(other);
    const auto found = files.find(other.key);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->verdict, Verdict::flaky);
    EXPECT_NE(found->repeats.find("door differs"), std::string::npos);
}

TEST(Results, ThatAreDamagedAreMadeAgain) {
    const TemporaryFolder folder;
    const ResultFiles files(folder.path());
    const Result result = passed("a.rec");
    for (const std::string bytes : {"", "{", "{\"id\": 3}", "[]"}) {
        put(files.file_of(result.key), bytes);
        EXPECT_FALSE(files.find(result.key)) << bytes;
    }
    files.put(result);
    EXPECT_TRUE(files.find(result.key));
}

TEST(Accepted, NeedAReasonAndADayToCome) {
    const TemporaryFolder folder;
    for (const Acceptance& wrong :
         {Acceptance{"a.rec-1", "", "2026-12-31"}, Acceptance{"a.rec-1", " ", "2026-12-31"},
          Acceptance{"a.rec-1", "why", "2026-11-25"}, Acceptance{"a.rec-1", "why", "2026-13-01"},
          Acceptance{"a.rec-1", "why", "2026-02-30"}, Acceptance{"a.rec-1", "why", "soon"}}) {
        EXPECT_THROW(accept(folder.path(), wrong, "2026-11-26"), InputError);
    }
    EXPECT_TRUE(folder.files().empty());
    accept(folder.path(), {"a.rec-1", "why", "2026-11-26"}, "2026-11-26");
    accept(folder.path(), {"a.rec-1", "a better reason", "2026-11-30"}, "2026-11-26");
    const auto list = read_accepted(folder.path());
    ASSERT_EQ(list.size(), 1u);
    EXPECT_EQ(list[0].reason, "a better reason");
    EXPECT_EQ(recording_of("two-glasses.rec-1a2b3c"), "two-glasses.rec");
}

TEST(Accepted, FilesThatAreNoneAreRefusedInALine) {
    const TemporaryFolder folder;
    for (const std::string bytes :
         {"{", "[]", "{}", "{\"accepted\": 3}", "{\"accepted\": [{\"failure\": \"a\"}]}",
          "{\"accepted\": [{\"failure\": \"a\", \"reason\": \"\", \"until\": \"2026-12-31\"}]}"}) {
        put(folder.path(kAcceptedFile), bytes);
        EXPECT_THROW(read_accepted(folder.path()), InputError) << bytes;
    }
}

TEST(Ratchet, GoesUpFreelyAndDownWithAReason) {
    const TemporaryFolder folder;
    Receipt receipt = receipt_of({passed("a.rec")});
    EXPECT_FALSE(read_ratchet(folder.path()).there);
    write_ratchet(folder.path(), receipt, {}, "");
    EXPECT_TRUE(slips(receipt, read_ratchet(folder.path()), {}).empty());
    receipt.steps += 5;
    write_ratchet(folder.path(), receipt, {}, "");
    EXPECT_EQ(read_ratchet(folder.path()).least.steps, 105u);
    receipt.steps -= 6;
    EXPECT_EQ(slips(receipt, read_ratchet(folder.path()), {}),
              std::vector<std::string>{"99 steps, last time 105"});
    EXPECT_THROW(write_ratchet(folder.path(), receipt, {}, " "), InputError);
    write_ratchet(folder.path(), receipt, {}, "the tour is shorter");
    EXPECT_EQ(read_ratchet(folder.path()).reason, "the tour is shorter");
}

TEST(Ratchet, ARunWithoutMutantsKeepsTheirs) {
    const TemporaryFolder folder;
    Receipt receipt = receipt_of({passed("a.rec")});
    receipt.mutants = 40;
    write_ratchet(folder.path(), receipt, {.mutants = true}, "");
    receipt.mutants = 0;
    EXPECT_TRUE(slips(receipt, read_ratchet(folder.path()), {}).empty());
    EXPECT_FALSE(slips(receipt, read_ratchet(folder.path()), {.mutants = true}).empty());
    write_ratchet(folder.path(), receipt, {}, "");
    EXPECT_EQ(read_ratchet(folder.path()).least.mutants, 40u);
}

TEST(Ratchet, FilesThatAreNoneAreRefusedInALine) {
    const TemporaryFolder folder;
    for (const std::string bytes : {"{", "{}", "{\"replays\": -1}"}) {
        put(folder.path(kRatchetFile), bytes);
        EXPECT_THROW(read_ratchet(folder.path()), InputError) << bytes;
    }
}

Plan plan_of(const TemporaryFolder& folder, const std::vector<std::string>& options = {}) {
    return plan_folder(folder.path(), "/bin/true", "a build", options, {},
                       [&](const std::string&) { return folder.path("room.glb"); });
}

TEST(Plans, AKeyChangesWithWhatAVerdictHangsOn) {
    const TemporaryFolder folder;
    put(folder.path("a.rec"), "one");
    put(folder.path("room.glb"), "level");
    const std::string key = plan_of(folder).items[0].key;
    EXPECT_EQ(plan_of(folder).items[0].key, key);
    EXPECT_NE(plan_of(folder, {"--heavy"}).items[0].key, key);
    put(folder.path("room.glb"), "another level");
    EXPECT_NE(plan_of(folder).items[0].key, key);
    put(folder.path("room.glb"), "level");
    put(folder.path("a.rec"), "two");
    EXPECT_NE(plan_of(folder).items[0].key, key);
}

TEST(Plans, AFolderWithoutRecordingsIsRefused) {
    const TemporaryFolder folder;
    EXPECT_THROW(plan_of(folder), InputError);
    EXPECT_THROW(plan_folder(folder.path("absent"), "/bin/true", "", {}, {}, {}), InputError);
}

TEST(Plans, ComeBackFromTheirFileAndAreCutIntoSlices) {
    const TemporaryFolder folder;
    for (int i = 0; i < 10; ++i) {
        put(folder.path("r" + std::to_string(i) + ".rec"), std::to_string(i));
    }
    Plan plan = plan_of(folder, {"--threads", "2"});
    plan.items[3].steps = 5000;
    plan.items[3].expect = {"door"};
    plan.slices = slices(plan, 1.0);
    std::vector<int> times(plan.items.size(), 0);
    for (const auto& slice : plan.slices) {
        EXPECT_FALSE(slice.empty());
        for (const std::size_t i : slice) {
            ++times[i];
        }
    }
    EXPECT_EQ(times, std::vector<int>(plan.items.size(), 1));
    EXPECT_GT(plan.slices.size(), 1u);
    EXPECT_EQ(slices(plan, 1e6).size(), 1u);
    write_plan(folder.path("plan.json"), plan);
    const Plan back = read_plan(folder.path("plan.json"));
    EXPECT_EQ(back.key(), plan.key());
    EXPECT_EQ(back.slices, plan.slices);
    EXPECT_EQ(back.items[3].expect, plan.items[3].expect);
    EXPECT_EQ(back.options, plan.options);
    put(folder.path("plan.json"), "{\"program\": 3}");
    EXPECT_THROW(read_plan(folder.path("plan.json")), InputError);
}

}  // namespace
}  // namespace lanthorn::suite
