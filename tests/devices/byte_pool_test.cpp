#include "devices/byte_pool.h"

#include <gtest/gtest.h>

#include <optional>

namespace foverig {
namespace {

const std::vector<std::byte> kHead{std::byte{1}, std::byte{2}};
const std::vector<std::byte> kRest{std::byte{3}};
const std::vector<std::byte> kWhole{std::byte{1}, std::byte{2}, std::byte{3}};

TEST(BytePool, GivesTheSameMemoryAgain) {
    BytePool pool;
    const std::byte* first = nullptr;
    {
        const BytePool::Held held = pool.copy_of(kHead, kRest);
        EXPECT_EQ(held, kWhole);
        first = Bytes(held).data();
    }
    const BytePool::Held again = pool.copy_of(kRest);
    EXPECT_EQ(again, kRest);
    EXPECT_EQ(Bytes(again).data(), first);
    EXPECT_NE(Bytes(pool.copy_of(kRest)).data(), first);
}

TEST(BytePool, WhatIsMovedOnComesBackOnce) {
    BytePool pool;
    BytePool::Held held = pool.copy_of(kHead);
    const std::byte* first = Bytes(held).data();
    BytePool::Held moved = std::move(held);
    held = BytePool::Held();
    const BytePool::Held other = pool.copy_of(kHead);
    EXPECT_NE(Bytes(other).data(), first);
    moved = BytePool::Held();
    EXPECT_EQ(Bytes(pool.copy_of(kHead)).data(), first);
}

TEST(BytePool, ACopyAndWhatIsReleasedAreTheirOwn) {
    BytePool pool;
    BytePool::Held held = pool.copy_of(kHead);
    const BytePool::Held copy = held;
    EXPECT_EQ(copy, held);
    EXPECT_NE(Bytes(copy).data(), Bytes(held).data());
    EXPECT_EQ(std::move(held).release(), kHead);
}

TEST(BytePool, MayEndBeforeWhatItGave) {
    std::optional<BytePool> pool(std::in_place);
    const BytePool::Held held = pool->copy_of(kHead);
    pool.reset();
    EXPECT_EQ(held, kHead);
}

}  // namespace
}  // namespace foverig
