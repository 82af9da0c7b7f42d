#pragma once
#include <cstdint>

#include "renderer/view.h"

namespace foverig {

/// Floats of a TapTable of `taps` taps.
std::size_t tap_floats(int taps);

/// Draws a frame's TapTable (kernels/reproject_pixels.h): normal pairs of width `sigma` for every
/// tap and pixel of the 8x8 period, by Box and Muller over hashes.
void draw_taps(View<float> table, double sigma, std::uint32_t frame_seed);

/// Throws std::invalid_argument where no kernel is compiled for so many taps.
void require_known_taps(int taps);

}  // namespace foverig
