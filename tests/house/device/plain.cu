// The headers that kernels stand on and that no kernel of their name uses up.
#include "renderer/camera.h"
#include "renderer/counts.h"
#include "renderer/foveation/foveal_function.h"
#include "renderer/half.h"
#include "renderer/hd.h"
#include "renderer/kernels/pixel.h"
#include "renderer/kernels/support.h"
#include "renderer/kernels/surface.h"
#include "renderer/lanes.h"
#include "renderer/math.h"
#include "renderer/scene/scene_view.h"
#include "renderer/trace/ray.h"
#include "renderer/vec.h"
#include "renderer/view.h"
#include "tests/house/device/launch.h"

namespace foverig::device {

__global__ void halves(View<Half4> packed, const int* indices) {
    packed[0] = pack_half4(unpack_half4(packed[1]));
    packed[2] = mean_half4<4>(packed.data, indices, 1);
}

__global__ void numbers(FovealFunction foveal, EyeView view, float* out) {
    const float angle = fast_angle_rad(out[0], out[1]);
    store_lanes(
        out, max_lanes(min_lanes(load_lanes(out), lane_indices() + foveal(angle)), lane_indices()));
    out[2] = clamp_to(view.tan_left, 0.0F, 1.0F);
}

__global__ void records(Surfaces surfaces, SupportLookup lookup, PackedPixel pixel) {
    const int slot = static_cast<int>(pixel_x(pixel));
    surfaces.set3(Row::normal_x, slot, surfaces.get3(Row::view_x, slot));
    surfaces.at(Row::depth, slot) =
        lookup(lookup.support.colour, slot, static_cast<int>(pixel_y(pixel))).x;
}

}  // namespace foverig::device
