#include "devices/display/lens_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace foverig {
namespace {

dvec2 place_of(const LensVertex& v) {
    return {v.x, v.y};
}

std::array<dvec2, 3> tangents_of(const LensVertex& v) {
    return {dvec2(v.red_x, v.red_y), dvec2(v.green_x, v.green_y), dvec2(v.blue_x, v.blue_y)};
}

/// The worst of the middles of all triangles, px of an eye's image at density 1, where that image
/// is.
double worst_px(Eye eye, const LensMesh& mesh, const Dk2Optics& optics) {
    const TangentFrustum f = optics.frustum(eye);
    double worst = 0.0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const LensVertex& a = mesh.vertices[mesh.indices[i]];
        const LensVertex& b = mesh.vertices[mesh.indices[i + 1]];
        const LensVertex& c = mesh.vertices[mesh.indices[i + 2]];
        const dvec2 middle = (place_of(a) + place_of(b) + place_of(c)) / 3.0;
        const dvec2 ndc(2.0 * middle.x + (eye == Eye::left ? 1.0 : -1.0), middle.y);
        for (std::size_t colour = 0; colour < 3; ++colour) {
            const dvec2 straight =
                (tangents_of(a)[colour] + tangents_of(b)[colour] + tangents_of(c)[colour]) / 3.0;
            const dvec2 bent = optics.tangent(eye, ndc, static_cast<Channel>(colour));
            const bool seen =
                bent.x > -f.left && bent.x < f.right && bent.y > -f.down && bent.y < f.up;
            if (!seen) continue;
            worst =
                std::max(worst, optics.pixels_per_tan_at_center() * glm::distance(straight, bent));
        }
    }
    return worst;
}

TEST(LensMesh, IsNowhereOffByMoreThanItSays) {
    const Dk2Optics optics;
    for (const Eye eye : {Eye::left, Eye::right}) {
        const double worst = worst_px(eye, lens_mesh(eye, EyeMap(true)), optics);
        EXPECT_LT(worst, 0.06);
        EXPECT_GT(worst, 1e-4) << "a lens bends";
    }
}

TEST(LensMesh, CoversItsHalfOnce) {
    for (const Eye eye : {Eye::left, Eye::right}) {
        const LensMesh mesh = lens_mesh(eye, EyeMap(true));
        double area = 0.0;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const dvec2 a = place_of(mesh.vertices[mesh.indices[i]]);
            const dvec2 ab = place_of(mesh.vertices[mesh.indices[i + 1]]) - a;
            const dvec2 ac = place_of(mesh.vertices[mesh.indices[i + 2]]) - a;
            const double twice = ab.x * ac.y - ab.y * ac.x;
            EXPECT_GT(twice, 0.0) << "each triangle the same way round";
            area += 0.5 * twice;
        }
        EXPECT_NEAR(area, 2.0, 1e-5);  // half of the panel's 2x2
        for (const LensVertex& v : mesh.vertices) EXPECT_LE(eye == Eye::left ? v.x : -v.x, 0.0F);
    }
}

TEST(EyeMap, WithoutALensTheFrustumFillsTheHalf) {
    const EyeMap flat(false);
    const TangentFrustum f = flat.frustum(Eye::left);
    constexpr double kRounding = 1e-15;
    const auto apart = [&](const dvec2& ndc, const dvec2& tangent) {
        return glm::distance(flat.tangent(Eye::left, ndc), tangent);
    };
    EXPECT_NEAR(apart({-1.0, 1.0}, {-f.left, f.up}), 0.0, kRounding);
    EXPECT_NEAR(apart({1.0, -1.0}, {f.right, -f.down}), 0.0, kRounding);
    const dvec2 tangent(0.3, -0.4);
    EXPECT_NEAR(glm::distance(flat.tangent(Eye::right, flat.ndc(Eye::right, tangent)), tangent),
                0.0, 1e-12);
}

}  // namespace
}  // namespace foverig
