#include "telar/zeroed_bytes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "telar/reused_memory.h"

namespace telar::zeroed_bytes_test {
namespace {

constexpr std::size_t MIB = std::size_t{1} << 20;

bool isZero(const ZeroedBytes& bytes) {
  return std::ranges::all_of(bytes, [](std::uint8_t byte) { return byte == 0; });
}

TEST(ZeroedBytes, AreZeroAlsoWhereOthersLayBefore) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{5}, MIB, 2 * MIB, 2 * MIB + 1, 7 * MIB - 1}) {
    for (int time = 0; time < 3; ++time) {
      ZeroedBytes bytes(size);
      ASSERT_EQ(bytes.size(), size);
      EXPECT_TRUE(isZero(bytes)) << size;
      std::ranges::fill(bytes, 0xa5);
      EXPECT_EQ(isZero(bytes), size == 0) << "planted fault: bytes of before";
    }
  }
}

TEST(ReusesMemory, AFreedBlockIsTheNextOneOfItsSize) {
  giveFreedBack();
  const void* before = nullptr;
  {
    const ZeroedBytes bytes(7 * MIB, 0xa5);
    before = bytes.data();
  }
  const ZeroedBytes cleared(7 * MIB);
  EXPECT_TRUE(isZero(cleared)) << "nobody said that every byte will be written";
  const ReusesMemory yes;
  const ZeroedBytes smaller(5 * MIB), again(7 * MIB), other(7 * MIB);
  EXPECT_EQ(again.data(), before);
  EXPECT_NE(other.data(), before);
  EXPECT_FALSE(isZero(again)) << "planted fault: a block that is zero was cleared";
  EXPECT_TRUE(isZero(smaller));
  EXPECT_TRUE(isZero(ZeroedBytes(MIB)));
}

TEST(ReusesMemory, FreedBlocksAreGivenBackOnce) {
  giveFreedBack();
  { const ZeroedBytes bytes(7 * MIB); }
  EXPECT_EQ(giveFreedBack(), 8 * MIB);
  EXPECT_EQ(giveFreedBack(), 0u);
}

TEST(ReusesMemory, NoMoreIsKeptThanTheBound) {
  for (const bool isLargerFreed : {false, true}) {
    giveFreedBack();
    {
      std::vector<ZeroedBytes> all;
      for (int i = 0; i < 12; ++i) all.emplace_back((6 + i % 4) * MIB);
    }
    if (isLargerFreed) freeZeroed(allocateZeroed(MOST_FREED_BYTES + 1), MOST_FREED_BYTES + 1);
    const std::size_t kept = giveFreedBack();
    EXPECT_LE(kept, MOST_FREED_BYTES);
    EXPECT_GT(kept, MOST_FREED_BYTES - 10 * MIB) << "one that is larger drops none";
  }
}

TEST(ZeroedBytes, LargeOnesBeginAtAHugePage) {
  const ZeroedBytes bytes(3 * MIB);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(bytes.data()) % (2 * MIB), 0u);
}

TEST(ZeroedBytes, CopiesMovesAndGrowthKeepTheBytes) {
  ZeroedBytes bytes(2 * MIB, 7);
  bytes.resize(5 * MIB);
  const ZeroedBytes copy = bytes;
  const ZeroedBytes moved = std::move(bytes);
  EXPECT_EQ(copy, moved);
  EXPECT_EQ(copy[2 * MIB - 1], 7);
  EXPECT_EQ(copy[2 * MIB], 0);
  EXPECT_EQ(copy.back(), 0);
}

TEST(ZeroedBytes, WhatNoMemoryHoldsIsRefused) {
  for (const std::size_t size : {~std::size_t{0}, ~std::size_t{0} - 3 * MIB, std::size_t{1} << 62}) {
    EXPECT_THROW(allocateZeroed(size), std::bad_alloc);
  }
}

}  // namespace
}  // namespace telar::zeroed_bytes_test
