#include "renderer/pipelines/occlusion_queue.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <vector>

#include "renderer/effects/plan.h"
#include "renderer/kernels/sampling.h"
#include "renderer/pipelines/tile_scratch.h"
#include "tests/renderer/small_scenes.h"

namespace foverig {
namespace {

/// A tile whose every pixel has a surface but each tenth, which saw the sky.
struct Tile {
    explicit Tile(int n) : count(n) {
        for (int i = 0; i < n; ++i) {
            const std::uint16_t at = kCoherentOrder[static_cast<std::size_t>(i)];
            pixels.push_back(pack_pixel(at % kTile, at / kTile));
            const bool missed = i % 10 == 9;
            slots.push_back(missed ? kMiss : static_cast<std::uint32_t>(surfaces_given));
            if (missed) continue;
            Surfaces s = surfaces();
            // Two walls at right angles, at two depths each.
            s.set3(Row::normal_x, surfaces_given, i % 3 == 0 ? vec3(1, 0, 0) : vec3(0, 0, -1));
            s.at(Row::depth, surfaces_given) = i % 2 == 0 ? 1.5F : 12.0F;
            ++surfaces_given;
        }
    }

    Surfaces surfaces() { return {rows.data(), TileScratch::kStride}; }

    int count;
    int surfaces_given = 0;
    std::vector<PackedPixel> pixels;
    std::vector<std::uint32_t> slots;
    std::vector<float> rows = std::vector<float>(std::size_t{kRows} * TileScratch::kStride);
};

struct Queue {
    explicit Queue(Tile& tile, const std::uint8_t* sparse, std::uint32_t seed = 7)
        : queue(memory, plan()) {
        queue.order(tile.surfaces(), view_of(std::as_const(tile.pixels)),
                    view_of(std::as_const(tile.slots)), sparse, tile.count, seed);
    }

    static EffectPlan plan() {
        SmallScene s;
        s.add_quad(s.add_matte(vec3(0.5F)), {-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
        s.scene().ambient = vec3(0.1F);
        RenderSettings settings = settings_of("full");
        settings.lighting.ao_samples = 4;
        return EffectPlan(*s.finish(), settings);
    }

    EffectMemory memory;
    OcclusionQueue queue;
};

std::multiset<int> slots_in(const OcclusionQueue& queue) {
    std::multiset<int> all;
    for (const auto& part : {queue.dense(), queue.sparse()})
        all.insert(part.slots.begin(), part.slots.end());
    return all;
}

TEST(OcclusionQueue, EverySurfaceIsQueuedOnce) {
    Tile tile(kTilePixels);
    std::vector<std::uint8_t> sparse(kTilePixels);
    for (std::size_t i = 0; i < sparse.size(); ++i) sparse[i] = i % 4 == 0 ? 1 : 0;
    const std::uint8_t* const choices[] = {nullptr, sparse.data()};
    for (const std::uint8_t* const flags : choices) {
        const std::multiset<int> all = slots_in(Queue(tile, flags).queue);
        ASSERT_EQ(all.size(), static_cast<std::size_t>(tile.surfaces_given));
        EXPECT_EQ(std::set<int>(all.begin(), all.end()).size(), all.size());
        EXPECT_EQ(*all.rbegin(), tile.surfaces_given - 1);
    }
}

TEST(OcclusionQueue, ADensePixelUsesThePatternThatBelongsToIt) {
    Tile tile(1000);
    const Queue q(tile, nullptr);
    std::map<int, PackedPixel> pixel_of_slot;
    for (std::size_t i = 0; i < tile.pixels.size(); ++i)
        if (tile.slots[i] != kMiss) pixel_of_slot[static_cast<int>(tile.slots[i])] = tile.pixels[i];
    const OcclusionQueue::Part dense = q.queue.dense();
    EXPECT_EQ(q.queue.sparse().slots.size, 0U);
    for (std::size_t place = 0; place < dense.slots.size; ++place) {
        const PackedPixel p = pixel_of_slot.at(dense.slots[place]);
        ASSERT_EQ(dense.patterns[place], pattern_of(pixel_x(p), pixel_y(p)));
        if (place > 0) {
            ASSERT_GE(dense.patterns[place], dense.patterns[place - 1]);
        }
    }
}

TEST(OcclusionQueue, SparseSurfacesOfAPacketAreAlikeAndTheirNeighboursUseAnotherPattern) {
    Tile tile(kTilePixels);
    const std::vector<std::uint8_t> sparse(kTilePixels, 1);
    const Queue q(tile, sparse.data());
    const OcclusionQueue::Part part = q.queue.sparse();
    const Surfaces s = tile.surfaces();
    int mixed = 0;
    for (std::size_t first = 0; first + 16 <= part.slots.size; first += 16) {
        std::set<int> patterns;
        std::set<std::pair<float, float>> kinds;
        for (std::size_t place = first; place < first + 16; ++place) {
            patterns.insert(part.patterns[place]);
            kinds.insert(
                {s.at(Row::normal_x, part.slots[place]), s.at(Row::depth, part.slots[place])});
        }
        EXPECT_EQ(patterns.size(), 1U);
        mixed += kinds.size() > 1 ? 1 : 0;
    }
    EXPECT_LE(mixed, 2 * 3);  // where one of the four kinds ends and the next begins
    std::map<int, int> pattern_of_slot;
    for (std::size_t place = 0; place < part.slots.size; ++place)
        pattern_of_slot[part.slots[place]] = part.patterns[place];
    int neighbours = 0;
    int shared = 0;
    for (int slot = 6; slot < tile.surfaces_given; ++slot) {
        // Of one wall and depth are those six pixels apart in the queue.
        ++neighbours;
        shared += pattern_of_slot[slot] == pattern_of_slot[slot - 6] ? 1 : 0;
    }
    EXPECT_LT(shared, neighbours / 2);
}

TEST(OcclusionQueue, AnotherFrameDrawsOtherPatterns) {
    Tile tile(320);
    const std::vector<std::uint8_t> sparse(320, 1);
    const Queue a(tile, sparse.data(), 1);
    const Queue b(tile, sparse.data(), 2);
    const auto patterns = [](const Queue& q) {
        const auto part = q.queue.sparse();
        return std::vector<int>(part.patterns.begin(), part.patterns.end());
    };
    EXPECT_NE(patterns(a), patterns(b));
}

}  // namespace
}  // namespace foverig
