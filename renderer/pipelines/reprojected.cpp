#include "renderer/pipelines/reprojected.h"

#include <algorithm>
#include <cmath>

#include "renderer/kernels/select_pixels.h"
#include "renderer/pipelines/frame/eye_image.h"
#include "renderer/pipelines/frame/footprint_taps.h"

namespace foverig {
namespace {

constexpr std::size_t kRasterFloats = static_cast<std::size_t>(kRasterTile) * kRasterStride;

FovealFunction foveal_of(const FoveationSettings& s) {
    return {s.r0_deg, s.r1_deg, s.p_min};
}

TileZone zone_of(const TileRect& tile, const EyeRays& eye, const vec3& gaze,
                 const FovealFunction& foveal) {
    const auto direction = [&](int x, int y) {
        return dvec3(eye.direction(static_cast<float>(x), static_cast<float>(y)));
    };
    const int x1 = tile.x0 + tile.width;
    const int y1 = tile.y0 + tile.height;
    const dvec3 centre = direction(tile.x0 + tile.width / 2, tile.y0 + tile.height / 2);
    double radius = 0.0;
    for (const auto& corner : {direction(tile.x0, tile.y0), direction(x1, tile.y0),
                               direction(tile.x0, y1), direction(x1, y1)})
        radius = std::max(radius, angle_between_rad(centre, corner));
    const double eccentricity = angle_between_rad(centre, dvec3(gaze));
    if (eccentricity + radius <= static_cast<double>(foveal.r0_rad)) return TileZone::foveal;
    if (eccentricity - radius >= static_cast<double>(foveal.r1_rad)) return TileZone::peripheral;
    return TileZone::falloff;
}

}  // namespace

ReprojectedRenderer::Scratch::Scratch(MemoryCount& memory, std::size_t blocks)
    : raster_rows(memory, 4 * kRasterFloats),
      block_flags(memory, blocks),
      pixel_flags(memory, kTilePixels),
      sparse(memory, kTilePixels) {}

RasterTile ReprojectedRenderer::Scratch::raster() {
    float* const p = raster_rows.data();
    return {p, p + kRasterFloats, p + 2 * kRasterFloats, p + 3 * kRasterFloats};
}

ReprojectedRenderer::ReprojectedRenderer(std::shared_ptr<const Scene> scene,
                                         const RenderSettings& settings)
    : core_(std::move(scene), settings), foveal_(foveal_of(settings.foveation)) {
    require_known_taps(settings.reprojection.footprint_samples);
    taps_ = Buffer<float>(core_.memory().of(Effect::reprojection),
                          tap_floats(settings.reprojection.footprint_samples));
}

bool ReprojectedRenderer::tune(const RenderSettings& settings) {
    if (!core_.tune(settings)) return false;
    foveal_ = foveal_of(settings.foveation);
    return true;
}

void ReprojectedRenderer::prepare_eyes(const FrameInput& input) {
    eyes_.resize(input.eyes.size());
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        const EyeView& view = input.eyes[i].view;
        if (eyes_[i] == nullptr || !eyes_[i]->fits(view)) {
            eyes_[i] = std::make_unique<ReprojectedEye>(core_.memory(), core_.plan(),
                                                        core_.settings().reprojection, view);
            scratches_.clear();
        }
        eyes_[i]->turn(view);
    }
    if (!scratches_.empty()) return;
    std::size_t blocks = 0;
    for (const auto& eye : eyes_)
        blocks = std::max(blocks, static_cast<std::size_t>(eye->blocks().count));
    for (int i = 0; i < core_.backend().threads(); ++i)
        scratches_.emplace_back(core_.memory().of(Effect::reprojection), blocks);
}

int ReprojectedRenderer::queue_pixels(Lane& lane, int thread, ReprojectedEye& eye,
                                      const EyeInput& input, int tile, std::uint32_t frame_seed) {
    const TileRect rect = eye.grid.rect(tile);
    std::uint8_t* const flags = scratches_[static_cast<std::size_t>(thread)].pixel_flags.data();
    if (rect.width < kTile || rect.height < kTile) std::fill_n(flags, kTilePixels, std::uint8_t{0});
    const EyeRays rays(input.view);
    const vec3 gaze = glm::normalize(input.view.world_from_eye * input.gaze);
    lane.launch(
        "select_pixels", rect.height,
        SelectPixels{foveal_, rays, gaze, frame_seed, eye.resampled(), eye.support_column.data(),
                     eye.support_row.data(), zone_of(rect, rays, gaze, foveal_), rect.x0, rect.y0,
                     rect.width, flags});
    const Samples samples = eye.samples(tile);
    TileScratch& scratch = core_.scratch(thread);
    std::uint8_t* const sparse = scratches_[static_cast<std::size_t>(thread)].sparse.data();
    scratch.sparse = sparse;
    int n = 0;
    lane.launch("queue_pixels", 1, [&](int) {
        const PackedPixel corner =
            pack_pixel(static_cast<std::uint32_t>(rect.x0), static_cast<std::uint32_t>(rect.y0));
        for (const std::uint32_t at : kCoherentOrder) {
            const std::uint8_t why = flags[at];
            if (why == 0) continue;
            samples.pixels[n] = corner + pack_pixel(at % kTile, at / kTile);
            samples.flags[n] = why;
            ++n;
        }
        for (int i = 0; i < n; ++i) {
            scratch.pixels[static_cast<std::size_t>(i)] = samples.pixels[i];
            sparse[i] = (samples.flags[i] & kFovealSample) == 0 ? 1 : 0;
        }
    });
    return n;
}

void ReprojectedRenderer::store_samples(Lane& lane, TileScratch& scratch, ReprojectedEye& eye,
                                        int tile, int n, const ShadingFrame& frame) {
    const auto store = [&]<bool kOcclusion, bool kLightBuffer>() {
        lane.launch("store_samples", n,
                    StoreSamples<kOcclusion, kLightBuffer>{
                        scratch.surfaces(), scratch.slots.view(), eye.samples(tile), eye.support(),
                        eye.support_column.data(), eye.support_row.data(), frame.scene.ambient,
                        frame.scene.background, &scratch.numerics});
    };
    if (core_.plan().on(Effect::ambient_occlusion))
        store.operator()<true, true>();
    else if (core_.plan().on(Effect::light_buffer))
        store.operator()<false, true>();
    else
        store.operator()<false, false>();
}

void ReprojectedRenderer::trace_tiles(ReprojectedEye& eye, const EyeInput& input,
                                      std::uint32_t frame) {
    ShadingFrame shading = core_.shading_frame(input.view);
    shading.pattern_seed = hash32(core_.settings().seed ^ 0x3C6EF372U, frame);
    if (core_.plan().on(Effect::oversampling)) shading.jitter_px = pixel_jitter_px(frame);
    const std::uint32_t frame_seed = hash32(core_.settings().seed, frame);
    core_.backend().for_tiles(eye.grid.count(), [&](Lane& lane, int thread, int tile) {
        TileScratch& scratch = core_.scratch(thread);
        const int n = queue_pixels(lane, thread, eye, input, tile, frame_seed);
        shade_tile(lane, scratch, shading, n);
        store_samples(lane, scratch, eye, tile, n, shading);
        eye.sample_counts[static_cast<std::size_t>(tile)] = n;
    });
}

FrameStats ReprojectedRenderer::render(const FrameInput& input) {
    core_.begin_frame(input);
    prepare_eyes(input);
    const std::uint32_t frame_seed = hash32(core_.settings().seed, input.frame);
    draw_taps(taps_.view(), core_.settings().reprojection.footprint_sigma, frame_seed);
    std::uint64_t all_pixels = 0;
    for (std::size_t i = 0; i < eyes_.size(); ++i) {
        ReprojectedEye& eye = *eyes_[i];
        all_pixels += pixel_count(eye.view);
        if (eye.has_history) {
            reproject_mesh(eye);
            find_resampling(eye);
        }
        trace_tiles(eye, input.eyes[i], input.frame);
        combine_tiles(eye, input.frame);
        if (core_.plan().on(Effect::post_process) && eye.has_history) post_process(eye, frame_seed);
        eye.has_history = true;
    }
    return core_.end_frame(all_pixels);
}

Image ReprojectedRenderer::image(int eye) const {
    const ReprojectedEye& e = *eyes_.at(static_cast<std::size_t>(eye));
    return image_of(e.image(), e.grid);
}

View<const Half4> ReprojectedRenderer::pixels(int eye) const {
    return eyes_.at(static_cast<std::size_t>(eye))->image();
}

Mask ReprojectedRenderer::sampling_mask(int eye) const {
    ReprojectedEye& e = *eyes_.at(static_cast<std::size_t>(eye));
    Mask mask{e.grid.width_px, e.grid.height_px, std::vector<std::uint8_t>(e.image().size)};
    for (int tile = 0; tile < e.grid.count(); ++tile) {
        const Samples samples = e.samples(tile);
        for (int i = 0; i < e.sample_counts[static_cast<std::size_t>(tile)]; ++i)
            mask.pixels[pixel_y(samples.pixels[i]) * static_cast<std::size_t>(mask.width_px) +
                        pixel_x(samples.pixels[i])] = 1;
    }
    return mask;
}

Mask ReprojectedRenderer::resampling_mask(int eye) const {
    const ReprojectedEye& e = *eyes_.at(static_cast<std::size_t>(eye));
    Mask mask{e.grid.width_px, e.grid.height_px, std::vector<std::uint8_t>(e.image().size)};
    const CoarseLookup resampled = e.resampled();
    for (int y = 0; y < mask.height_px; ++y)
        for (int x = 0; x < mask.width_px; ++x)
            mask.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width_px) +
                        static_cast<std::size_t>(x)] = resampled(x, y) ? 1 : 0;
    return mask;
}

}  // namespace foverig
