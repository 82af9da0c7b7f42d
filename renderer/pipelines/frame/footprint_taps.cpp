#include "renderer/pipelines/frame/footprint_taps.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "renderer/kernels/reproject_pixels.h"
#include "renderer/kernels/sampling.h"

namespace foverig {
namespace {

constexpr std::size_t kPlane = kTapPeriod * kTapPeriod;

}  // namespace

std::size_t tap_floats(int taps) {
    return static_cast<std::size_t>(taps) * 2 * kPlane;
}

void draw_taps(View<float> table, double sigma, std::uint32_t frame_seed) {
    for (std::size_t tap = 0; tap * 2 * kPlane < table.size; ++tap) {
        for (std::size_t i = 0; i < kPlane; ++i) {
            const auto key = static_cast<std::uint32_t>(tap * kPlane + i);
            const float u = unit_float(hash32(frame_seed ^ 0xA511E9B3U, 2 * key));
            const float v = unit_float(hash32(frame_seed ^ 0xA511E9B3U, 2 * key + 1));
            const float radius = static_cast<float>(sigma) * std::sqrt(-2.0F * std::log1p(-u));
            const float angle = 2.0F * std::numbers::pi_v<float> * v;
            table[(2 * tap) * kPlane + i] = radius * std::cos(angle);
            table[(2 * tap + 1) * kPlane + i] = radius * std::sin(angle);
        }
    }
}

void require_known_taps(int taps) {
    if (taps != 1 && taps != 2 && taps != 4 && taps != 8)
        throw std::invalid_argument(
            fmt::format("reprojection.footprint_samples is {}; choose 1, 2, 4 or 8", taps));
}

}  // namespace foverig
