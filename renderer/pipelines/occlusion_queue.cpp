#include "renderer/pipelines/occlusion_queue.h"

#include <algorithm>
#include <bit>

#include "renderer/kernels/sampling.h"
#include "renderer/trace/ray.h"

namespace foverig {
namespace {

constexpr int kDepths = 32;                         ///< half octaves from 2^-8 m on
constexpr int kKeys = kPatterns + 6 * kDepths + 1;  ///< patterns, six normals x depths, none
constexpr std::uint16_t kNoKey = kKeys - 1;
constexpr int kGroup = 16;  ///< sparse surfaces of one pattern: a packet
constexpr int kGroups = 2;  ///< more would hide the sharing better: four cost 10 % of the rate
constexpr int kRun = kGroup * kGroups;

/// Half octave of a positive depth: exponent and first bit of the mantissa.
int depth_bucket(float depth_m) {
    constexpr int kFirst = (127 - 8) * 2;
    return std::clamp(static_cast<int>(std::bit_cast<std::uint32_t>(depth_m) >> 22U) - kFirst, 0,
                      kDepths - 1);
}

/// Which of the six axes a normal is nearest to.
int nearest_axis(const vec3& n) {
    const vec3 size = glm::abs(n);
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    return 2 * axis + (n[axis] < 0.0F ? 1 : 0);
}

}  // namespace

OcclusionQueue::OcclusionQueue(EffectMemory& memory, const EffectPlan& plan) {
    if (!plan.on(Effect::ambient_occlusion)) return;
    MemoryCount& count = memory.of(Effect::ambient_occlusion);
    slots_ = {count, kTilePixels + kGroup};
    patterns_ = {count, kTilePixels + kGroup};
    keys_ = {count, kTilePixels};
}

OcclusionQueue::Part OcclusionQueue::part(int first, int n) const {
    const auto size = static_cast<std::size_t>(n);
    return {{slots_.data() + first, size}, {patterns_.data() + first, size}};
}

void OcclusionQueue::order(const Surfaces& surfaces, View<const PackedPixel> pixels,
                           View<const std::uint32_t> slots, const std::uint8_t* sparse, int n,
                           std::uint32_t seed) {
    std::array<int, kKeys + 1> starts{};
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        const auto slot = static_cast<int>(slots[i]);
        int key = kNoKey;
        if (slots[i] != kMiss && (sparse == nullptr || sparse[i] == 0))
            key = pattern_of(pixel_x(pixels[i]), pixel_y(pixels[i]));
        else if (slots[i] != kMiss)
            key = kPatterns + nearest_axis(surfaces.get3(Row::normal_x, slot)) * kDepths +
                  depth_bucket(surfaces.at(Row::depth, slot));
        keys_[i] = static_cast<std::uint16_t>(key);
        ++starts[static_cast<std::size_t>(key) + 1];
    }
    for (std::size_t k = 0; k < kKeys; ++k) starts[k + 1] += starts[k];
    dense_ = starts[kPatterns];
    count_ = starts[kNoKey];
    for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        if (keys_[i] == kNoKey) continue;
        const auto place = static_cast<std::size_t>(starts[keys_[i]]++);
        slots_[place] = static_cast<int>(slots[i]);
        patterns_[place] = keys_[i];
    }
    if (count_ > dense_) interleave_sparse(hash32(seed, pixels[0]));
}

/// Deals each run out to its groups in turn, so that neighbours use different patterns.
void OcclusionQueue::interleave_sparse(std::uint32_t seed) {
    for (int first = dense_; first + kRun <= count_; first += kRun) {
        int* const run = slots_.data() + first;
        std::array<int, kRun> dealt{};
        for (int k = 0; k < kRun; ++k) dealt[k % kGroups * kGroup + k / kGroups] = run[k];
        std::copy_n(dealt.begin(), kRun, run);
    }
    // An odd step visits all patterns in turn, so that groups next to each other never agree.
    for (int place = dense_; place < count_; ++place) {
        const auto group = static_cast<std::uint32_t>((place - dense_) / kGroup);
        patterns_[static_cast<std::size_t>(place)] =
            static_cast<int>((seed + 5U * group) % kPatterns);
    }
}

}  // namespace foverig
