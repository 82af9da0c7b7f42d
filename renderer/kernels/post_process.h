#pragma once
#include "renderer/kernels/cache_update.h"
#include "renderer/kernels/resampling.h"
#include "renderer/kernels/sampling.h"

namespace foverig {

/// Light-buffer post-process (Weier 2016 3.5) for the i-th sample of a tile, if it was resampled
/// outside the fovea: finds the nearest reconstructed neighbour on the axes, samples the window of
/// that size n times, and lights the pixel with the light of the closest reconstructed pixel found.
/// The fovea keeps its own light: there the image is promised to equal the full renderer's.
template <bool kOcclusion>
struct PostProcess {
    Samples samples;
    HistoryImages images;
    CoarseLookup resampled;
    vec3 ambient;
    int window_samples;
    int search_px;
    std::uint32_t frame_seed;
    int width_px;
    int height_px;

    RIG_HD bool reconstructed(int x, int y) const {
        return x >= 0 && y >= 0 && x < width_px && y < height_px && !resampled(x, y);
    }

    RIG_HD int axis_distance(int x, int y) const {
        for (int d = 1; d <= search_px; ++d)
            if (reconstructed(x - d, y) || reconstructed(x + d, y) || reconstructed(x, y - d) ||
                reconstructed(x, y + d))
                return d;
        return 0;
    }

    RIG_HD void operator()(int i) const {
        if ((samples.flags[i] & (kResampled | kFovealSample)) != kResampled) return;
        const int x = static_cast<int>(pixel_x(samples.pixels[i]));
        const int y = static_cast<int>(pixel_y(samples.pixels[i]));
        const int window = axis_distance(x, y);
        if (window == 0) return;
        int best = window * window + 1;
        int from = -1;
        const auto consider = [&](int px, int py) {
            const int distance2 = (px - x) * (px - x) + (py - y) * (py - y);
            if (distance2 >= best || !reconstructed(px, py)) return;
            best = distance2;
            from = py * width_px + px;
        };
        consider(x - window, y);
        consider(x + window, y);
        consider(x, y - window);
        consider(x, y + window);
        std::uint32_t h = hash32(frame_seed ^ samples.pixels[i]);
        for (int k = 0; k < window_samples; ++k) {
            h = hash32(h + 0x9E3779B9U);
            const int span = 2 * window + 1;
            consider(x - window +
                         static_cast<int>((h & 0xFFFFU) * static_cast<std::uint32_t>(span) >> 16U),
                     y - window +
                         static_cast<int>((h >> 16U) * static_cast<std::uint32_t>(span) >> 16U));
        }
        if (from < 0) return;
        const vec4 light = unpack_half4(images.light[from]);
        const vec3 colour =
            vec3(unpack_half4(samples.base[i])) +
            lit(vec3(unpack_half4(samples.diffuse[i])), vec3(light), light.w, ambient, kOcclusion);
        const int target = y * width_px + x;
        const float rho = unpack_half4(images.colour[target]).w;
        images.colour[target] = pack_half4(vec4(colour, rho));
    }
};

}  // namespace foverig
