#include "lanthorn/replay/content_hash.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "lanthorn/core/error.h"

namespace lanthorn::replay {
namespace {

namespace fs = std::filesystem;

TEST(ContentHash, IsXxh3OfTheBytes) {
    // XXH3_64bits of no bytes with seed 0, from xxHash's own test vectors.
    EXPECT_EQ(hash_bytes({}), 0x2d06800538d394c2ull);
}

TEST(ContentHash, OfAFileIsThatOfItsBytes) {
    const fs::path file = fs::temp_directory_path() / ("lanthorn-content-hash-" + std::to_string(::getpid()));
    const std::string text("a\r\n\0b", 5);
    std::ofstream(file, std::ios::binary) << text;
    EXPECT_EQ(hash_file(file.string()), hash_bytes(std::as_bytes(std::span(text))));
    fs::remove(file);
    EXPECT_THROW(hash_file(file.string()), InputError);
}

}  // namespace
}  // namespace lanthorn::replay
