#include "renderer/pipelines/full.h"

#include "renderer/kernels/compose.h"
#include "renderer/pipelines/frame/eye_image.h"

namespace foverig {
namespace {

/// Queues every pixel of the tile in coherent order.
int queue_all(TileScratch& s, const TileRect& tile) {
    int n = 0;
    for (const std::uint16_t at : kCoherentOrder) {
        const int x = at % kTile;
        const int y = at / kTile;
        if (x < tile.width && y < tile.height)
            s.pixels[static_cast<std::size_t>(n++)] = pack_pixel(
                static_cast<std::uint32_t>(tile.x0 + x), static_cast<std::uint32_t>(tile.y0 + y));
    }
    return n;
}

}  // namespace

void FullRenderer::render_tile(Lane& lane, TileScratch& s, const ShadingFrame& frame,
                               const TileRect& tile, View<Half4> image, int width_px) {
    const int n = queue_all(s, tile);
    shade_tile(lane, s, frame, n);
    const auto compose = [&]<bool kOcclusion, bool kLightBuffer>() {
        lane.launch("compose", n,
                    ComposePixels<kOcclusion, kLightBuffer>{
                        s.surfaces(), s.pixels.view(), s.slots.view(), frame.scene.ambient,
                        frame.scene.background, image, width_px, &s.numerics});
    };
    if (core_.plan().on(Effect::ambient_occlusion))
        compose.operator()<true, true>();
    else if (core_.plan().on(Effect::light_buffer))
        compose.operator()<false, true>();
    else
        compose.operator()<false, false>();
}

FrameStats FullRenderer::render(const FrameInput& input) {
    core_.begin_frame(input);
    eyes_.resize(input.eyes.size());
    std::uint64_t all_pixels = 0;
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        const EyeView& view = input.eyes[i].view;
        Eye& eye = eyes_[i];
        if (eye.grid.width_px != view.width_px || eye.grid.height_px != view.height_px) {
            eye.grid = {view.width_px, view.height_px};
            eye.image = Buffer<Half4>(core_.memory().base(), pixel_count(view));
        }
        all_pixels += pixel_count(view);
        const ShadingFrame frame = core_.shading_frame(view);
        core_.backend().for_tiles(eye.grid.count(), [&](Lane& lane, int thread, int tile) {
            render_tile(lane, core_.scratch(thread), frame, eye.grid.rect(tile), eye.image.view(),
                        view.width_px);
        });
    }
    return core_.end_frame(all_pixels);
}

Image FullRenderer::image(int eye) const {
    const Eye& e = eyes_.at(static_cast<std::size_t>(eye));
    return image_of(e.image.view(), e.grid);
}

View<const Half4> FullRenderer::pixels(int eye) const {
    return eyes_.at(static_cast<std::size_t>(eye)).image.view();
}

}  // namespace foverig
