// What is compiled in but not called for changes no bit.
#include "renderer/kernels/shade_surface.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "renderer/backends/embree/embree_scene.h"
#include "renderer/kernels/compose.h"
#include "renderer/kernels/sampling.h"
#include "renderer/scene/library.h"

namespace foverig {
namespace {

constexpr int kCount = 2000;
constexpr int kStride = kCount + 16;

struct Shaded {
    Shaded() : rows(static_cast<std::size_t>(kRows) * kStride) {}
    Surfaces surfaces() { return {rows.data(), kStride}; }
    /// Bits of the rows that exist with and without a light buffer.
    std::vector<float> common() const {
        return {rows.begin(), rows.begin() + kRowsWithoutLight * kStride};
    }
    std::vector<float> rows;
};

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

/// Hits strewn over all triangles of the Cornell box, which has no texture.
class ShadeSurfaceBits : public testing::Test {
  protected:
    ShadeSurfaceBits()
        : scene(make_builtin_scene("cornell", 0.1)),
          embree(scene, {}),
          eye(EyeView{64, 64}),
          pixels(kStride),
          hits(kStride),
          slots(kStride) {
        eye.origin_m = {0.1F, 2.0F, 4.0F};
        for (std::uint32_t i = 0; i < kCount; ++i) {
            const float u = unit_float(hash32(i, 1U));
            hits[i] = {1.0F + unit_float(hash32(i, 2U)), u, (1.0F - u) * unit_float(hash32(i, 3U)),
                       hash32(i, 4U) % static_cast<std::uint32_t>(scene.triangles.size())};
            slots[i] = i % 9 == 0 ? kMiss : i;
            pixels[i] = pack_pixel(i % 64, i / 64);
        }
    }

    template <bool kTextures, bool kOcclusion, bool kLightBuffer>
    Shaded shade() {
        Shaded s;
        const ShadeSurface<kTextures, kOcclusion, kLightBuffer> kernel{
            embree.view(), eye,  view_of(pixels), view_of(hits), view_of(slots),
            s.surfaces(),  -5.0F};
        for (int i = 0; i < kCount; ++i) kernel(i);
        return s;
    }

    template <bool kOcclusion, bool kLightBuffer>
    std::vector<std::uint64_t> compose(Shaded& s) {
        std::vector<Half4> image(64 * 64);
        NumericCounts counts;
        const ComposePixels<kOcclusion, kLightBuffer> kernel{s.surfaces(),
                                                             view_of(pixels),
                                                             view_of(slots),
                                                             scene.ambient,
                                                             scene.background,
                                                             view_of(image),
                                                             64,
                                                             &counts};
        for (int i = 0; i < kCount; ++i) kernel(i);
        std::vector<std::uint64_t> bits;
        for (const Half4& h : image) bits.push_back(h.bits);
        EXPECT_EQ(counts.nan + counts.inf, 0U);
        return bits;
    }

    Scene scene;
    embree::EmbreeScene embree;
    EyeRays eye;
    std::vector<PackedPixel> pixels;
    std::vector<Hit> hits;
    std::vector<std::uint32_t> slots;
};

TEST_F(ShadeSurfaceBits, TextureCodeChangesNothingInASceneWithoutTextures) {
    EXPECT_TRUE(same_bits(shade<true, false, false>().rows, shade<false, false, false>().rows));
    EXPECT_TRUE(same_bits(shade<true, true, true>().rows, shade<false, true, true>().rows));
    EXPECT_TRUE(same_bits(shade<true, false, true>().rows, shade<false, false, true>().rows));
}

TEST_F(ShadeSurfaceBits, ALightBufferChangesNoOtherRow) {
    EXPECT_TRUE(
        same_bits(shade<false, false, true>().common(), shade<false, false, false>().common()));
}

TEST_F(ShadeSurfaceBits, ALightBufferWithoutLightShowsTheSameImage) {
    Shaded with = shade<false, false, true>();
    Shaded without = shade<false, false, false>();
    EXPECT_EQ((compose<false, true>(with)), (compose<false, false>(without)));
}

TEST_F(ShadeSurfaceBits, OcclusionOfAnOpenSurfaceIsPlainAmbient) {
    Shaded with = shade<false, true, true>();
    Shaded without = shade<false, false, false>();
    EXPECT_EQ((compose<true, true>(with)), (compose<false, false>(without)));
}

TEST_F(ShadeSurfaceBits, MissesWriteNothing) {
    Shaded s = shade<false, false, true>();
    for (int i = 0; i < kCount; i += 9) ASSERT_EQ(s.surfaces().at(Row::depth, i), 0.0F);
    EXPECT_NE(s.surfaces().at(Row::depth, 1), 0.0F);
}

TEST_F(ShadeSurfaceBits, NormalsFaceTheViewerAndOriginsLieOnTheSurface) {
    Shaded s = shade<false, false, false>();
    for (int i = 0; i < kCount; ++i) {
        if (slots[static_cast<std::size_t>(i)] == kMiss) continue;
        const Hit& hit = hits[static_cast<std::size_t>(i)];
        const uvec3 corner = scene.triangles[hit.triangle];
        const dvec3 a(scene.positions_m[corner.x]);
        const dvec3 b(scene.positions_m[corner.y]);
        const dvec3 c(scene.positions_m[corner.z]);
        const dvec3 n = glm::normalize(glm::cross(b - a, c - a));
        const dvec3 to_eye = dvec3(eye.origin_m) - a;
        const double side = glm::dot(n, to_eye) < 0.0 ? -1.0 : 1.0;
        const double height_m = side * glm::dot(dvec3(s.surfaces().get3(Row::origin_x, i)) - a, n);
        ASSERT_GT(height_m, 0.0);
        ASSERT_LT(height_m, 1.0e-4);
        ASSERT_GE(side * glm::dot(dvec3(s.surfaces().get3(Row::normal_x, i)), n), 0.0);
    }
}

}  // namespace
}  // namespace foverig
