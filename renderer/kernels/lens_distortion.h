#pragma once
#include "renderer/half.h"
#include "renderer/math.h"

namespace foverig {

/// Where one colour of a panel pixel lies between four texels of an eye's image.
struct LensSource {
    std::int32_t texel = -1;  ///< the upper left one; < 0: outside, black
    std::uint16_t right = 0;  ///< share of the right two, of kLensShare
    std::uint16_t lower = 0;
};
inline constexpr int kLensShare = 1 << 15;  // finer than halves can tell, and 1 is among the shares

/// One row of an eye's half of the panel: each colour of a pixel is fetched bilinearly from its own
/// place in the eye's image (DEVICES.md 2.1: three tangents a pixel).
struct DistortRow {
    const LensSource* sources;  ///< red, green, blue of each pixel of the half
    int width_px;               ///< of the half
    const Half4* eye;
    int eye_width_px;
    vec3* panel;  ///< the half's top left pixel
    int panel_stride_px;

    template <int kChannel>
    RIG_HD float fetch(const LensSource& source) const {
        if (source.texel < 0) return 0.0F;
        const Half4* const upper = eye + source.texel;
        const Half4* const lower = upper + eye_width_px;
        const Quad a = unpack_quad(upper[0]);
        const Quad b = unpack_quad(lower[0]);
        const Quad left = a + (b - a) * (static_cast<float>(source.lower) / kLensShare);
        const Quad c = unpack_quad(upper[1]);
        const Quad d = unpack_quad(lower[1]);
        const Quad right = c + (d - c) * (static_cast<float>(source.lower) / kLensShare);
        const Quad mixed = left + (right - left) * (static_cast<float>(source.right) / kLensShare);
        return mixed[kChannel];
    }

    RIG_HD void operator()(int y) const {
        const auto row = static_cast<std::size_t>(y);
        const LensSource* source = sources + 3 * row * static_cast<std::size_t>(width_px);
        vec3* const out = panel + row * static_cast<std::size_t>(panel_stride_px);
        for (int x = 0; x < width_px; ++x, source += 3)
            out[x] = {fetch<0>(source[0]), fetch<1>(source[1]), fetch<2>(source[2])};
    }
};

}  // namespace foverig
