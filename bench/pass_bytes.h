#pragma once
// Bytes that the passes of `reprojected` without rays must move, pass by pass, from the types that
// the kernels read and write. What stays in a core's L2 (the raster tile) and what a store reads
// first (write-allocate) is not counted, as STREAM counts neither.
#include <array>
#include <cstddef>

#include "renderer/kernels/reproject_pixels.h"
#include "renderer/kernels/samples.h"

namespace foverig::bench {

/// What a frame's byte count depends on.
struct PassSizes {
    double pixels = 0.0;
    double support_cells = 0.0;
    double samples = 0.0;         ///< traced pixels
    double post_processed = 0.0;  ///< of those, the ones whose light is borrowed
    double taps = 4.0;
    bool light_buffer = false;
};

struct PassBytes {
    const char* pass;
    double moved;     ///< each byte of an image once
    double gathered;  ///< each access on its own: what L1 is asked for
};

inline constexpr double kColour = sizeof(Half4);
inline constexpr double kInfo = sizeof(CacheInfo);
inline constexpr double kDepth = sizeof(float);

/// In the order of the frame. Pixels that the mesh does not cover (merge) are taken as none.
inline std::array<PassBytes, 7> pass_bytes(const PassSizes& s) {
    const double light = s.light_buffer ? sizeof(Half4) : 0.0;
    const double vertex = 3.0 * sizeof(float);
    const double coarse = 3.0 * sizeof(float);
    const double history = kColour + kInfo + light;
    // Reads depth, writes x, y, 1/depth; the block boxes read them again.
    const double vertices = s.support_cells * (kDepth + 2.0 * vertex);
    // Rasters from the vertices, reads one colour and one normal, writes depth, luminance, facing.
    const double coarse_view = s.support_cells * (vertex + 2.0 * kColour + coarse);
    // Reads a cell and (in cache) its neighbours, writes a byte.
    const double marks = s.support_cells * (coarse + 1.0);
    const double raster = s.support_cells * vertex;
    // Colour, info and light of the last frame in, those of this frame out; taps hit L1 and L2.
    const double reproject = s.pixels * 2.0 * history;
    const double reproject_gathered =
        s.pixels * ((s.taps + 1.0) * kColour + 2.0 * kInfo + 2.0 * light);
    // Pixel, flags, colour and (base, diffuse, light) of a sample in, history in and out.
    const double sample = sizeof(PackedPixel) + 1.0 + kColour + 3.0 * light;
    const double update = s.samples * (sample + 2.0 * history);
    // Flags of all samples; base, diffuse, neighbour's light and rho in, colour out where borrowed.
    const double post =
        s.light_buffer ? s.samples * 1.0 + s.post_processed * (sizeof(PackedPixel) + 5.0 * kColour)
                       : 0.0;
    return {{{"reproject_vertices", vertices, vertices},
             {"reproject_coarse", coarse_view, coarse_view},
             {"mark_resampling", marks, s.support_cells * (5.0 * coarse + 1.0)},
             {"reproject_raster", raster, raster},
             {"reproject", reproject, reproject_gathered},
             {"cache_update", update, update},
             {"post_process", post, post}}};
}

}  // namespace foverig::bench
