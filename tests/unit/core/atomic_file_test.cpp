// Files that appear whole or not at all.
#include "lanthorn/core/atomic_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "lanthorn/core/error.h"
#include "tests/support/file_size_limit.h"

namespace lanthorn {
namespace {

namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
  protected:
    AtomicFileTest() { fs::create_directories(folder); }
    ~AtomicFileTest() override { fs::remove_all(folder); }

    static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
    static std::string read(const fs::path& path) {
        std::ifstream stream(path);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    std::ptrdiff_t files() const {
        return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    }

    const fs::path folder = fs::temp_directory_path() / ("lanthorn-atomic-" + std::to_string(::getpid()));
    const fs::path target = folder / "report.json";
};

TEST_F(AtomicFileTest, AppearsOnCommitOnly) {
    AtomicFile file(target);
    file.write("ne");
    file.write("w");
    EXPECT_FALSE(fs::exists(target));
    file.commit();
    EXPECT_EQ(read(target), "new");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, WithoutCommitTheOldFileStays) {
    write(target, "old");
    {
        AtomicFile file(target);
        file.write("half");
    }
    EXPECT_EQ(read(target), "old");
    EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, TwoWritersDoNotMeet) {
    AtomicFile first(target);
    AtomicFile second(target);
    first.write("first");
    second.write("second");
    first.commit();
    second.commit();
    EXPECT_EQ(read(target), "second");
}

TEST_F(AtomicFileTest, AFailedWriteSaysWhyAndLeavesTheOldFile) {
    write(target, "old");
    {
        const support::FileSizeLimit limit(1000);
        EXPECT_NO_THROW(write_file(folder / "small", std::string(1000, 's')));
        try {
            write_file(target, std::string(5000, 'n'));
            FAIL() << "expected an InputError";
        } catch (const InputError& error) {
            EXPECT_EQ(std::string(error.what()), target.string() + ": cannot be written: File too large");
        }
    }
    EXPECT_EQ(read(target), "old");
    EXPECT_EQ(files(), 2);
}

TEST_F(AtomicFileTest, ImpossibleTargets) {
    EXPECT_THROW(AtomicFile(folder / "none" / "a.json"), InputError);
    EXPECT_THROW(AtomicFile{folder}, InputError);
    EXPECT_THROW(AtomicFile{fs::path("/dev/null")}, InputError);
    EXPECT_THROW(AtomicFile{fs::path()}, InputError);
    EXPECT_THROW(AtomicFile{target / ""}, InputError);
    EXPECT_EQ(files(), 0);
}

TEST_F(AtomicFileTest, CheckingLeavesNothing) {
    EXPECT_NO_THROW(check_writable(target));
    write(target, "old");
    EXPECT_NO_THROW(check_writable(target));
    EXPECT_EQ(read(target), "old");
    EXPECT_EQ(files(), 1);
    EXPECT_THROW(check_writable(folder / "none" / "a.json"), InputError);
}

}  // namespace
}  // namespace lanthorn
