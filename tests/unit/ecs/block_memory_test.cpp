#include "lanthorn/ecs/block_memory.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <set>

namespace lanthorn::ecs {
namespace {

constexpr std::size_t kBytes = 64 * 1024;
constexpr std::size_t kBlocks = 100;  // 16 by themselves, the rest in three slabs

std::vector<std::byte*> filled(BlockMemory& memory) {
    std::vector<std::byte*> blocks;
    for (std::size_t i = 0; i < kBlocks; ++i) {
        blocks.push_back(memory.take());
        std::memset(blocks.back(), static_cast<int>(i), kBytes);
    }
    return blocks;
}

bool holds(const std::byte* block, std::size_t value) {
    return std::all_of(block, block + kBytes,
                       [&](std::byte b) { return b == static_cast<std::byte>(value); });
}

TEST(BlockMemory, GivesAlignedBlocksThatDoNotOverlap) {
    BlockMemory memory(kBytes);
    const std::vector<std::byte*> blocks = filled(memory);
    EXPECT_EQ(std::set<std::byte*>(blocks.begin(), blocks.end()).size(), kBlocks);
    for (std::size_t i = 0; i < kBlocks; ++i) {
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(blocks[i]) % BlockMemory::kAlign, 0u) << i;
        EXPECT_TRUE(holds(blocks[i], i)) << i;
    }
}

// Pages alone are lost: what lies beside a block, in its own page or another, stays.
TEST(BlockMemory, DiscardsABlockAndNothingBesideIt) {
    BlockMemory memory(kBytes);
    const std::vector<std::byte*> blocks = filled(memory);
    for (std::size_t i = 1; i < kBlocks; i += 2) {
        memory.discard(blocks[i]);
    }
    for (std::size_t i = 0; i < kBlocks; i += 2) {
        EXPECT_TRUE(holds(blocks[i], i)) << i;
    }
    for (std::size_t i = 1; i < kBlocks; i += 2) {
        std::memset(blocks[i], 255, kBytes);
        EXPECT_TRUE(holds(blocks[i], 255)) << i;
    }
    EXPECT_TRUE(holds(blocks[2], 2));
}

TEST(BlockMemory, DiscardsBlocksSmallerThanAPage) {
    BlockMemory memory(256);
    std::byte* block = memory.take();
    std::memset(block, 7, 256);
    memory.discard(block);
    EXPECT_EQ(block[255], std::byte{7});
}

TEST(BlockMemory, BlocksStayWhereTheyAreWhenItMoves) {
    BlockMemory memory(kBytes);
    const std::vector<std::byte*> blocks = filled(memory);
    BlockMemory moved(std::move(memory));
    BlockMemory assigned(kBytes);
    assigned.take();
    assigned = std::move(moved);
    for (std::size_t i = 0; i < kBlocks; ++i) {
        EXPECT_TRUE(holds(blocks[i], i)) << i;
    }
    EXPECT_TRUE(std::ranges::find(blocks, assigned.take()) == blocks.end());
    assigned.clear();
    EXPECT_NE(assigned.take(), nullptr);
}

}  // namespace
}  // namespace lanthorn::ecs
