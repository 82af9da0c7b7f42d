// The passes of `reprojected` that trace nothing: mesh, coarse view, combination, post-process.
#include <algorithm>
#include <cmath>

#include "renderer/kernels/cache_update.h"
#include "renderer/kernels/frame_raster.h"
#include "renderer/kernels/post_process.h"
#include "renderer/pipelines/reprojected.h"

namespace foverig {

void ReprojectedRenderer::reproject_mesh(ReprojectedEye& eye) {
    core_.backend().launch("reproject_vertices", eye.coarse_grid.height_px,
                           eye.reproject_vertices(), 32);
    const BoundBlocks bounds{eye.mesh(),
                             eye.blocks(),
                             eye.grid.columns(),
                             eye.grid.rows(),
                             1.0F / kTile,
                             static_cast<float>(eye.grid.width_px),
                             static_cast<float>(eye.grid.height_px)};
    core_.backend().launch("reproject_vertices", eye.coarse_grid.height_px - 1, bounds, 32);
    core_.backend().launch("measure_facing", eye.coarse_grid.height_px - 1, eye.measure_facing(),
                           32);
}

void ReprojectedRenderer::raster_tile(ReprojectedEye& eye, Scratch& scratch,
                                      const RasterFrame& frame, const TileRange& range) {
    const RasterTile tile = scratch.raster();
    std::fill_n(tile.inverse_depth, static_cast<std::size_t>(frame.height) * kRasterStride, 0.0F);
    const CellBlocks blocks = eye.blocks();
    visit_blocks(blocks, range, scratch.block_flags.data(), [&](int block) {
        raster_block(frame, tile, block / blocks.per_row, block % blocks.per_row * kBlockCells);
    });
}

void ReprojectedRenderer::find_resampling(ReprojectedEye& eye) {
    const RasterFrame whole = eye.coarse_raster();
    const ResolveCoarse resolve = eye.resolve_coarse({});
    const auto full_tile = [](float coarse_px, float scale, int tiles) {
        return tile_index(coarse_px / scale, 1.0F / kTile, tiles);
    };
    core_.backend().for_tiles(eye.coarse_grid.count(), [&](Lane& lane, int thread, int index) {
        const TileRect rect = eye.coarse_grid.rect(index);
        Scratch& scratch = scratches_[static_cast<std::size_t>(thread)];
        const RasterFrame frame = frame_of_tile(whole, rect);
        const TileRange range{
            full_tile(static_cast<float>(rect.x0), frame.scale_x, eye.grid.columns()),
            full_tile(static_cast<float>(rect.x0 + rect.width), frame.scale_x, eye.grid.columns()),
            full_tile(static_cast<float>(rect.y0), frame.scale_y, eye.grid.rows()),
            full_tile(static_cast<float>(rect.y0 + rect.height), frame.scale_y, eye.grid.rows())};
        lane.launch("reproject_coarse", 1, [&](int) { raster_tile(eye, scratch, frame, range); });
        ResolveCoarse in_rect = in_tile(resolve, 0, rect);
        in_rect.tile = scratch.raster();
        lane.launch("reproject_coarse", rect.height, in_rect);
    });
    core_.backend().launch("mark_resampling", eye.coarse_grid.height_px,
                           eye.mark_resampling(core_.settings().reprojection), 32);
}

template <bool kOcclusion, bool kLightBuffer>
void ReprojectedRenderer::combine_tile(Lane& lane, ReprojectedEye& eye, Scratch& scratch, int tile,
                                       std::uint32_t frame) {
    const TileRect rect = eye.grid.rect(tile);
    const RasterTile raster = scratch.raster();
    const HistoryImages to = eye.current();
    const ReprojectionSettings& s = core_.settings().reprojection;
    const int width_px = eye.grid.width_px;
    if (eye.has_history) {
        const auto column = static_cast<std::uint8_t>(tile % eye.grid.columns());
        const auto row = static_cast<std::uint8_t>(tile / eye.grid.columns());
        const RasterFrame raster_frame = frame_of_tile(eye.image_raster(), rect);
        lane.launch("reproject_raster", 1, [&](int) {
            raster_tile(eye, scratch, raster_frame, {column, column, row, row});
        });
        const auto reproject = [&]<int kTaps>() {
            lane.launch("reproject", rect.height,
                        ReprojectPixels<kTaps, kLightBuffer>{raster,
                                                             {taps_.data()},
                                                             eye.last(),
                                                             to,
                                                             rect.x0,
                                                             rect.y0,
                                                             rect.width,
                                                             width_px,
                                                             eye.grid.height_px});
        };
        switch (tap_count()) {
            case 1:
                reproject.template operator()<1>();
                break;
            case 2:
                reproject.template operator()<2>();
                break;
            case 8:
                reproject.template operator()<8>();
                break;
            default:
                reproject.template operator()<4>();
                break;
        }
    } else {
        std::fill_n(raster.inverse_depth, static_cast<std::size_t>(rect.height) * kRasterStride,
                    0.0F);
    }
    lane.launch("merge", rect.height,
                MergeSupport<kLightBuffer>{raster, eye.support_lookup(), to, rect.x0, rect.y0,
                                           rect.width, width_px, frame});
    const int n = eye.sample_counts[static_cast<std::size_t>(tile)];
    const SmallestWeight colour_weight(s.k_min, s.k_max, s.t_max);
    const SmallestWeight light_weight(s.k_min_light, s.k_max, s.t_max);
    const auto update = [&]<bool kOversampling>() {
        lane.launch(
            "cache_update", n,
            CacheUpdate<kOcclusion, kLightBuffer, kOversampling>{
                raster, eye.samples(tile), to, colour_weight, light_weight, core_.scene().ambient,
                static_cast<float>(s.epsilon_cache), frame, rect.x0, rect.y0, width_px});
    };
    if (core_.plan().on(Effect::oversampling))
        update.template operator()<true>();
    else
        update.template operator()<false>();
}

void ReprojectedRenderer::combine_tiles(ReprojectedEye& eye, std::uint32_t frame) {
    core_.backend().for_tiles(eye.grid.count(), [&](Lane& lane, int thread, int tile) {
        Scratch& scratch = scratches_[static_cast<std::size_t>(thread)];
        if (core_.plan().on(Effect::ambient_occlusion))
            combine_tile<true, true>(lane, eye, scratch, tile, frame);
        else if (core_.plan().on(Effect::light_buffer))
            combine_tile<false, true>(lane, eye, scratch, tile, frame);
        else
            combine_tile<false, false>(lane, eye, scratch, tile, frame);
    });
}

void ReprojectedRenderer::post_process(ReprojectedEye& eye, std::uint32_t frame_seed) {
    const ReprojectionSettings& s = core_.settings().reprojection;
    const LightingSettings& lighting = core_.settings().lighting;
    core_.backend().for_tiles(eye.grid.count(), [&](Lane& lane, int, int tile) {
        const auto run = [&]<bool kOcclusion>() {
            lane.launch(
                "post_process", eye.sample_counts[static_cast<std::size_t>(tile)],
                PostProcess<kOcclusion>{
                    eye.samples(tile), eye.current(), eye.resampled(), eye.coarse().inverse_depth,
                    static_cast<float>(s.epsilon_cache), light_noise(lighting.area_samples),
                    light_noise(lighting.ao_samples), core_.scene().ambient, s.post_samples,
                    s.post_search_px, frame_seed, eye.grid.width_px, eye.grid.height_px});
        };
        if (core_.plan().on(Effect::ambient_occlusion))
            run.operator()<true>();
        else
            run.operator()<false>();
    });
}

}  // namespace foverig
