#include "metrics/heatmap.h"

#include <algorithm>
#include <array>

#include "metrics/rows.h"

namespace foverig::metrics {
namespace {

/// Every 15th of the 256 codes of magma (van der Walt and Smith 2015); between them a line.
constexpr std::array<std::array<int, 3>, 18> kMagma{{
    {0, 0, 4},
    {9, 7, 32},
    {26, 16, 66},
    {49, 17, 101},
    {74, 16, 121},
    {98, 25, 128},
    {121, 34, 130},
    {145, 43, 129},
    {170, 51, 125},
    {194, 59, 117},
    {217, 70, 107},
    {236, 88, 96},
    {247, 114, 92},
    {252, 142, 100},
    {254, 170, 116},
    {254, 198, 138},
    {253, 226, 163},
    {252, 253, 191},
}};

}  // namespace

Image heatmap(const Plane& errors) {
    Image image{errors.width_px, errors.height_px, std::vector<vec3>(errors.values.size())};
    for_rows(errors.height_px, [&](int y) {
        for (int x = 0; x < errors.width_px; ++x) {
            const float at = 17.0F * std::clamp(errors.row(y)[x], 0.0F, 1.0F);
            const auto below = std::min<std::size_t>(static_cast<std::size_t>(at), 16);
            const float share = at - static_cast<float>(below);
            for (std::size_t c = 0; c < 3; ++c) {
                const auto from = static_cast<float>(kMagma[below][c]);
                const auto to = static_cast<float>(kMagma[below + 1][c]);
                image.at(x, y)[static_cast<int>(c)] =
                    linear_from_srgb((from + share * (to - from)) * (1.0F / 255.0F));
            }
        }
    });
    return image;
}

}  // namespace foverig::metrics
