// Single kernels of `reprojected`, a tile or a row of 64 at a time; each is proved right before it
// is timed.
#include <benchmark/benchmark.h>

#include <cmath>

#include "bench/mesh_fixture.h"
#include "bench/suites.h"
#include "renderer/backends/embree/embree_scene.h"
#include "renderer/kernels/cache_update.h"
#include "renderer/kernels/select_pixels.h"
#include "renderer/kernels/texture.h"

namespace foverig::bench {
namespace {

constexpr int kTilePx = kRasterTile * kRasterTile;

void count_pixels(benchmark::State& state, double pixels_an_iteration) {
    state.counters["time_per_px"] =
        benchmark::Counter(pixels_an_iteration, benchmark::Counter::kIsIterationInvariantRate |
                                                    benchmark::Counter::kInvert);
}

void BM_RasterTile(benchmark::State& state) {
    MeshFixture fixture(0.01F);
    fixture.raster();
    const RasterTile tile = fixture.tile();
    for (int y = 0; y < kRasterTile; ++y)
        for (int x = 0; x < kRasterTile; ++x)
            if (std::abs(tile.inverse_depth[y * kRasterStride + x] * kWallDepth_m - 1.0F) > 1e-4F)
                return state.SkipWithError("a pixel's depth is not the wall's");
    for (auto unused : state) {
        fixture.raster();
        benchmark::ClobberMemory();
    }
    count_pixels(state, kTilePx);
}

template <int kTaps>
ReprojectPixels<kTaps, false> reprojecting(MeshFixture& fixture, const std::vector<float>& taps) {
    return {fixture.tile(), {taps.data()}, fixture.from(), fixture.to(), kTileX_px,
            kTileY_px,      kRasterTile,   kEyeWidth_px,   kEyeHeight_px};
}

void BM_ReprojectPixels(benchmark::State& state) {
    MeshFixture fixture(0.0F);
    fixture.raster();
    std::vector<float> taps(4 * 2 * kTapPeriod * kTapPeriod, 0.0F);
    for (int y = 0; y < kRasterTile; ++y) reprojecting<1>(fixture, taps)(y);
    for (int y = kTileY_px; y < kTileY_px + kRasterTile; ++y)
        for (int x = kTileX_px; x < kTileX_px + kRasterTile; ++x)
            if (fixture.to().colour[MeshFixture::pixel(x, y)].bits !=
                fixture.from().colour[MeshFixture::pixel(x, y)].bits)
                return state.SkipWithError("a still eye with one tap does not copy");
    for (std::size_t i = 0; i < taps.size(); ++i)
        taps[i] = unit_float(hash32(static_cast<std::uint32_t>(i))) - 0.5F;
    const auto kernel = reprojecting<4>(fixture, taps);
    for (auto unused : state) {
        for (int y = 0; y < kRasterTile; ++y) kernel(y);
        benchmark::ClobberMemory();
    }
    count_pixels(state, kTilePx);
}

void BM_SelectPixels(benchmark::State& state) {
    EyeView view;
    view.width_px = view.height_px = 1200;
    std::vector<std::uint8_t> flags(kTilePx);
    const std::vector<std::int16_t> no_support(1200, -1);
    const FovealFunction foveal(10.0, 20.0, 0.05);
    const EyeRays eye(view);
    const vec3 gaze(0.0F, 0.0F, -1.0F);
    constexpr int kX0 = 740;
    constexpr int kY0 = 568;
    const SelectPixels kernel{foveal,
                              eye,
                              gaze,
                              7U,
                              {},
                              no_support.data(),
                              no_support.data(),
                              TileZone::falloff,
                              kX0,
                              kY0,
                              kRasterTile,
                              flags.data()};
    double expected = 0.0;
    int chosen = 0;
    for (int y = 0; y < kRasterTile; ++y) {
        kernel(y);
        for (int x = 0; x < kRasterTile; ++x) {
            const vec3 d = eye.direction(static_cast<float>(kX0 + x) + 0.5F,
                                         static_cast<float>(kY0 + y) + 0.5F);
            expected += static_cast<double>(
                foveal(static_cast<float>(angle_between_rad(dvec3(gaze), dvec3(d)))));
            chosen += flags[static_cast<std::size_t>(y * kRasterTile + x)] != 0 ? 1 : 0;
        }
    }
    // A sum of 4096 draws of variance <= 1/4: four standard deviations are 128.
    if (std::abs(chosen - expected) > 128.0)
        return state.SkipWithError("not as many pixels chosen as the foveal function says");
    for (auto unused : state) {
        for (int y = 0; y < kRasterTile; ++y) kernel(y);
        benchmark::ClobberMemory();
    }
    count_pixels(state, kTilePx);
}

void BM_CacheUpdate(benchmark::State& state) {
    MeshFixture fixture(0.0F);
    fixture.raster();
    constexpr int kSamples = kTilePx / 5;
    std::vector<PackedPixel> pixels(kSamples);
    std::vector<std::uint8_t> flags(kSamples, kChosenSample);
    std::vector<Half4> colours(kSamples, pack_half4({0.25F, 0.5F, 0.75F, kWallDepth_m}));
    for (int i = 0; i < kSamples; ++i)
        pixels[static_cast<std::size_t>(i)] =
            pack_pixel(static_cast<std::uint32_t>(kTileX_px + i * 5 % kRasterTile),
                       static_cast<std::uint32_t>(kTileY_px + i * 5 / kRasterTile));
    const CacheUpdate<false, false, false> kernel{fixture.tile(),
                                                  {pixels.data(), flags.data(), colours.data()},
                                                  fixture.to(),
                                                  SmallestWeight(0.1, 1.0, 30),
                                                  {},
                                                  vec3(0.0F),
                                                  0.05F,
                                                  2U,
                                                  kTileX_px,
                                                  kTileY_px,
                                                  kEyeWidth_px};
    const auto first = MeshFixture::pixel(kTileX_px, kTileY_px);
    fixture.to().colour[first] = pack_half4({0.75F, 0.5F, 0.25F, 1.0F});
    fixture.to().info[first] = touched_in(1U);
    kernel(0);
    // One old sample and one new one: their mean, worth two.
    const vec4 blended = unpack_half4(fixture.to().colour[first]);
    if (blended != vec4(0.5F, 0.5F, 0.5F, 2.0F))
        return state.SkipWithError("two samples do not give their mean");
    for (auto unused : state) {
        for (int i = 0; i < kSamples; ++i) kernel(i);
        benchmark::ClobberMemory();
    }
    count_pixels(state, kSamples);
}

/// One triangle with a white texture of 256x256 texels and all its levels.
Scene textured_triangle() {
    Scene scene;
    scene.name = "textured triangle";
    scene.positions_m = {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    scene.normals.assign(3, {0.0F, 0.0F, 1.0F});
    scene.texcoords = {{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}};
    scene.triangles = {{0, 1, 2}};
    scene.triangle_materials = {0};
    scene.materials.resize(1);
    scene.materials[0].diffuse_texture = 0;
    scene.textures = {{.width = 256, .height = 256, .level_count = 9}};
    for (std::size_t side = 256; side > 0; side /= 2)
        scene.texels.insert(scene.texels.end(), side * side, 0xFFFFFFFFU);
    scene.parts = {
        {.first_triangle = 0, .triangle_count = 1, .first_vertex = 0, .vertex_count = 3}};
    scene.camera_path.resize(1);
    update_bounds(scene);
    check_scene(scene);
    return scene;
}

void BM_TextureLookup(benchmark::State& state) {
    const Scene scene = textured_triangle();
    const embree::EmbreeScene tables(scene, {});
    const SceneView view = tables.view();
    constexpr int kLookups = 1024;
    std::vector<vec2> at(kLookups);
    for (std::size_t i = 0; i < kLookups; ++i)
        at[i] = {unit_float(hash32(static_cast<std::uint32_t>(i), 1U)),
                 unit_float(hash32(static_cast<std::uint32_t>(i), 2U))};
    for (const vec2& uv : at)
        if (glm::distance(sample_texture(view, 0, uv, 0.5F), vec4(1.0F)) > 1e-6F)
            return state.SkipWithError("a white texture is not white");
    for (auto unused : state)
        for (const vec2& uv : at) benchmark::DoNotOptimize(sample_texture(view, 0, uv, 0.5F));
    count_pixels(state, kLookups);
}

}  // namespace

void register_kernels() {
    benchmark::RegisterBenchmark("BM_RasterTile", BM_RasterTile);
    benchmark::RegisterBenchmark("BM_ReprojectPixels/taps:4", BM_ReprojectPixels);
    benchmark::RegisterBenchmark("BM_SelectPixels/falloff", BM_SelectPixels);
    benchmark::RegisterBenchmark("BM_CacheUpdate", BM_CacheUpdate);
    benchmark::RegisterBenchmark("BM_TextureLookup/trilinear", BM_TextureLookup);
}

}  // namespace foverig::bench
