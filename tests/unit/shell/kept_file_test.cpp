// Files that a program keeps: whole or not at all, and never in its way.
#include "lanthorn/shell/kept_file.h"

#include <sys/stat.h>

#include <cstdlib>

#include "tests/support/file_size_limit.h"
#include "tests/support/kept_folder.h"

namespace lanthorn::shell {
namespace {

using support::KeptFolder;

namespace fs = std::filesystem;

TEST_F(KeptFolder, WhatIsWrittenIsRead) {
    EXPECT_FALSE(file().read());
    EXPECT_TRUE(file().write("some bytes"));
    EXPECT_EQ(file().read(), "some bytes");
    EXPECT_TRUE(said.empty());
}

TEST_F(KeptFolder, MakesItsFolder) {
    EXPECT_TRUE(file("new/newer/kept").write("x"));
    EXPECT_EQ(get("new/newer/kept"), "x");
}

TEST_F(KeptFolder, WhatOthersHaveWrittenMeanwhileIsToldBeforeItIsPutAside) {
    put("mine");
    KeptFile kept = file();
    EXPECT_FALSE(kept.written_by_others());
    ASSERT_EQ(kept.read(), "mine");
    EXPECT_FALSE(kept.written_by_others());
    put("theirs");
    EXPECT_EQ(kept.written_by_others(), "theirs");
    EXPECT_TRUE(kept.write("both"));
    EXPECT_FALSE(kept.written_by_others());
}

TEST_F(KeptFolder, ADamagedFileIsPutAside) {
    put("older", "kept.damaged");
    put("nonsense");
    KeptFile kept = file();
    kept.put_aside("kept: found nonsense");
    EXPECT_EQ(get("kept.damaged"), "nonsense");
    EXPECT_FALSE(has("kept"));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_EQ(said[0], "kept: found nonsense; kept as kept.damaged");
    EXPECT_TRUE(kept.write("new"));
}

TEST_F(KeptFolder, WhatCannotBePutAsideIsNotWrittenOver) {
    put("nonsense");
    fs::create_directories(folder / "kept.damaged" / "in the way");
    KeptFile kept = file();
    kept.put_aside("kept: found nonsense");
    EXPECT_FALSE(kept.write("new"));
    EXPECT_EQ(get(), "nonsense");
    EXPECT_EQ(said.size(), 2u);
}

TEST_F(KeptFolder, AFailureIsSaidOnceAndLeavesTheOldFile) {
    put("old");
    KeptFile kept = file();
    {
        const support::FileSizeLimit full(10);
        EXPECT_FALSE(kept.write(std::string(100, 'x')));
        EXPECT_FALSE(kept.write(std::string(100, 'x')));
    }
    EXPECT_EQ(said.size(), 1u);
    EXPECT_EQ(get(), "old");
    EXPECT_TRUE(kept.write("new"));  // the disk has room again
}

TEST_F(KeptFolder, TwoProgramsWithOneFileLoseNothing) {
    put("both");
    KeptFile one = file(), two = file();
    one.read();
    two.read();
    EXPECT_TRUE(one.write("one's"));
    EXPECT_TRUE(said.empty());
    EXPECT_TRUE(two.write("two's"));
    EXPECT_EQ(get(), "two's");
    EXPECT_EQ(get("kept.other"), "one's");
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NE(said[0].find("was written by another program meanwhile; that is kept as kept.other"),
              std::string::npos)
        << said[0];
    EXPECT_TRUE(two.write("two's again"));
    EXPECT_EQ(said.size(), 1u);
    EXPECT_EQ(get("kept.other"), "one's");
}

TEST_F(KeptFolder, AFileThatAnotherProgramMakesIsKept) {
    KeptFile kept = file();
    EXPECT_FALSE(kept.read());
    put("another's");
    EXPECT_TRUE(kept.write("ours"));
    EXPECT_EQ(get("kept.other"), "another's");
    EXPECT_EQ(get(), "ours");
}

TEST_F(KeptFolder, AFolderInItsPlaceIsSaidAndLeft) {
    fs::create_directories(folder / "kept");
    KeptFile kept = file();
    EXPECT_FALSE(kept.read());
    EXPECT_EQ(said.size(), 1u);
    EXPECT_FALSE(kept.write("x"));
}

TEST_F(KeptFolder, APipeInItsPlaceIsSaidAndKeepsNobodyWaiting) {
    ASSERT_EQ(::mkfifo((folder / "kept").c_str(), 0600), 0);
    KeptFile kept = file();
    EXPECT_FALSE(kept.read());
    EXPECT_EQ(said.size(), 1u);
    EXPECT_FALSE(kept.write("x"));
    EXPECT_TRUE(fs::is_fifo(folder / "kept"));
}

TEST_F(KeptFolder, AnUnwritableFolderIsSaidOnce) {
    put("a file", "file");
    KeptFile kept = file("file/below/kept");
    EXPECT_FALSE(kept.write("x"));
    EXPECT_FALSE(kept.write("x"));
    EXPECT_EQ(said.size(), 1u);
}

TEST_F(KeptFolder, WithoutAPathNothingIsKept) {
    KeptFile kept({}, "the file", [this](const std::string& line) { said.push_back(line); });
    EXPECT_FALSE(kept.read());
    EXPECT_FALSE(kept.write("x"));
    EXPECT_EQ(said, std::vector<std::string>{"the file will not be kept"});
}

class Environment {
  public:
    Environment(const char* name, const char* value) : name_(name) {
        const char* before = std::getenv(name);
        had_ = before != nullptr;
        before_ = had_ ? before : "";
        value != nullptr ? ::setenv(name, value, 1) : ::unsetenv(name);
    }
    ~Environment() { had_ ? ::setenv(name_, before_.c_str(), 1) : ::unsetenv(name_); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    const char* name_;
    bool had_ = false;
    std::string before_;
};

TEST(UserFiles, FollowTheEnvironment) {
    const Environment home("HOME", "/home/ada");
    {
        const Environment config("XDG_CONFIG_HOME", "/elsewhere/config");
        const Environment data("XDG_DATA_HOME", "/elsewhere/data");
        const Environment cache("XDG_CACHE_HOME", "/elsewhere/cache");
        EXPECT_EQ(config_file("lamp", "kept"), "/elsewhere/config/lamp/kept");
        EXPECT_EQ(data_file("lamp", "kept"), "/elsewhere/data/lamp/kept");
        EXPECT_EQ(cache_file("lamp", "kept"), "/elsewhere/cache/lamp/kept");
    }
    const Environment config("XDG_CONFIG_HOME", "relative");
    const Environment data("XDG_DATA_HOME", nullptr);
    const Environment cache("XDG_CACHE_HOME", nullptr);
    EXPECT_EQ(config_file("lamp", "kept"), "/home/ada/.config/lamp/kept");
    EXPECT_EQ(data_file("lamp", "kept"), "/home/ada/.local/share/lamp/kept");
    EXPECT_EQ(cache_file("lamp", "kept"), "/home/ada/.cache/lamp/kept");
    const Environment nowhere("HOME", nullptr);
    EXPECT_TRUE(config_file("lamp", "kept").empty());
    EXPECT_TRUE(data_file("lamp", "kept").empty());
    EXPECT_TRUE(cache_file("lamp", "kept").empty());
}

}  // namespace
}  // namespace lanthorn::shell
