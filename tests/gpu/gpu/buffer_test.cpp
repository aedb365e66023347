// Buffers keep to the order of what is written, filled and copied: a driver of a real GPU lost the first
// small write behind a clear.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <vector>

#include "lanthorn/gpu/buffer.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn {
namespace buffer_test {

class Buffers : public ::testing::Test {
  protected:
    void SetUp() override {
        static const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
        context->make_current();
    }
};

constexpr std::size_t kSizes[] = {4, 24, 160, 4096, 65536, 1 << 20, (1 << 20) + 4, 5 << 20};  // bytes

TEST_F(Buffers, KeepWhatIsWrittenFirst) {
    for (const std::size_t bytes : kSizes) {
        for (int round = 0; round < 4; ++round) {
            gpu::Buffer buffer(bytes);
            const std::vector<std::uint32_t> word = {0xa0b1c2d3u};
            buffer.write(0, std::span<const std::uint32_t>(word));
            EXPECT_EQ(buffer.read<std::uint32_t>(1), word) << bytes;
        }
    }
}

TEST_F(Buffers, BeginWithZeroes) {
    for (const std::size_t bytes : kSizes) {
        const gpu::Buffer buffer(bytes);
        const std::vector<std::uint32_t> zeroes(bytes / 4);
        EXPECT_EQ(buffer.read<std::uint32_t>(bytes / 4), zeroes) << bytes;
    }
}

TEST_F(Buffers, KeepWhatIsWrittenBehindAFill) {
    for (const std::size_t bytes : kSizes) {
        gpu::Buffer buffer(bytes);
        for (std::uint32_t round = 1; round < 5; ++round) {
            std::vector<std::uint32_t> wanted(bytes / 4, 0xffffffffu);
            wanted.back() = round;
            buffer.fill(0xffffffffu);
            buffer.write(bytes - 4, std::span<const std::uint32_t>(&wanted.back(), 1));
            EXPECT_EQ(buffer.read<std::uint32_t>(bytes / 4), wanted) << bytes;
        }
    }
}

TEST_F(Buffers, AreWhatTheyAreMadeFrom) {
    std::vector<std::uint32_t> numbers(3000);
    std::iota(numbers.begin(), numbers.end(), 7u);
    EXPECT_EQ(gpu::Buffer::from(numbers).read<std::uint32_t>(numbers.size()), numbers);
    gpu::Buffer copy(numbers.size() * 4);
    const gpu::Buffer source = gpu::Buffer::from(numbers);
    glCopyNamedBufferSubData(source.id(), copy.id(), 0, 0, static_cast<GLsizeiptr>(copy.bytes()));
    EXPECT_EQ(copy.read<std::uint32_t>(numbers.size()), numbers);
}

}  // namespace buffer_test
}  // namespace lanthorn
