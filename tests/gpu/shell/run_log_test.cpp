// The log of a run: whole lines of JSON, also where names are no text and where the disk is full.
#include "lanthorn/shell/run_log.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "lanthorn/gpu/context.h"
#include "tests/support/file_size_limit.h"

namespace lanthorn::shell {
namespace {

namespace fs = std::filesystem;

class RunLogFile : public testing::Test {
  protected:
    ~RunLogFile() override { fs::remove(file_); }
    std::vector<std::string> lines() const {
        std::vector<std::string> result;
        std::ifstream in(file_);
        for (std::string line; std::getline(in, line);) {
            result.push_back(line);
        }
        return result;
    }
    const std::unique_ptr<gpu::Context> context_ = gpu::create_headless_context();
    const fs::path file_ =
        fs::temp_directory_path() / ("lanthorn-run-log-" + std::to_string(::getpid()) + ".jsonl");
};

RunLog::Drawn drawn(const char* level) {
    return {{{"level", level}, {"preset", "low"}}, {64, 36}};
}

TEST_F(RunLogFile, NamesThatAreNoTextAreWrittenOut) {
    RunLog log("program", file_.string());
    log.frame(600, drawn("l\xff"));
    log.frame(600, drawn("l\xff"));
    log.frame(16, drawn("l\xff"));
    const std::vector<std::string> written = lines();
    ASSERT_EQ(written.size(), 1u);
    const nlohmann::json line = nlohmann::json::parse(written[0]);
    EXPECT_EQ(line["level"], "l\\xff");
    EXPECT_EQ(line["frame_ms"], (nlohmann::json{600.0, 600.0}));
}

TEST_F(RunLogFile, AFullDiskIsSaidOnceAndLeavesWholeLines) {
    RunLog log("program", file_.string());
    const auto second = [&] { log.frame(1001, drawn("level")); };
    second();
    second();
    const std::uintmax_t line = fs::file_size(file_);
    testing::internal::CaptureStderr();
    {
        const support::FileSizeLimit full(line + line / 2);
        for (int i = 0; i < 4; ++i) {
            second();
        }
    }
    second();
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(said, "program: warning: " + file_.string() +
                        ": cannot be written: File too large; the log ends here\n");
    EXPECT_EQ(fs::file_size(file_), line);
    EXPECT_NO_THROW(nlohmann::json::parse(lines().at(0)));
}

}  // namespace
}  // namespace lanthorn::shell
