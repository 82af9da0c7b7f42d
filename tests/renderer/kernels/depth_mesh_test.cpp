#include "renderer/kernels/depth_mesh.h"

#include <gtest/gtest.h>

#include <cmath>

#include "renderer/kernels/raster.h"
#include "tests/renderer/kernels/mesh_arrays.h"

namespace foverig {
namespace {

/// The DK2's eye, off axis.
EyeView eye() {
    EyeView v;
    v.width_px = 1182;
    v.height_px = 1464;
    v.tan_left = 1.0586F;
    v.tan_right = 1.0924F;
    v.tan_down = 1.3292F;
    v.tan_up = 1.3292F;
    return v;
}

mat3 turned(double yaw_rad, double pitch_rad, double roll_rad) {
    const dquat q = glm::angleAxis(yaw_rad, dvec3(0, 1, 0)) *
                    glm::angleAxis(pitch_rad, dvec3(1, 0, 0)) *
                    glm::angleAxis(roll_rad, dvec3(0, 0, 1));
    return mat3(glm::mat3_cast(q));
}

/// Image position in double precision of a world point; the independent path.
dvec2 project(const EyeView& v, const dvec3& world_m) {
    const dvec3 p = glm::transpose(dmat3(v.world_from_eye)) * (world_m - dvec3(v.position_m));
    const double left = v.tan_left;
    const double up = v.tan_up;
    return {(p.x / -p.z + left) / (left + static_cast<double>(v.tan_right)) * v.width_px,
            (up - p.y / -p.z) / (up + static_cast<double>(v.tan_down)) * v.height_px};
}

dvec3 unproject(const EyeView& v, double x_px, double y_px, double depth_m) {
    const double tx =
        -static_cast<double>(v.tan_left) +
        x_px / v.width_px * (static_cast<double>(v.tan_left) + static_cast<double>(v.tan_right));
    const double ty =
        static_cast<double>(v.tan_up) -
        y_px / v.height_px * (static_cast<double>(v.tan_up) + static_cast<double>(v.tan_down));
    return dvec3(v.position_m) + dmat3(v.world_from_eye) * (depth_m * dvec3(tx, ty, -1.0));
}

/// Vertices on a regular grid of the old image at depths depth(x, y), moved as the kernel moves
/// them.
template <class Depth>
MeshArrays reprojected(const EyeView& from, const EyeView& to, const Depth& depth_m,
                       int columns = 33, int rows = 41) {
    MeshArrays m(columns, rows);
    for (int c = 0; c < columns; ++c)
        m.source_x_px[static_cast<std::size_t>(c)] = static_cast<float>(c) *
                                                     static_cast<float>(from.width_px) /
                                                     static_cast<float>(columns - 1);
    for (int r = 0; r < rows; ++r)
        m.source_y_px[static_cast<std::size_t>(r)] = static_cast<float>(r) *
                                                     static_cast<float>(from.height_px) /
                                                     static_cast<float>(rows - 1);
    std::vector<float> depths(m.cells());
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            depths[m.at(c, r)] =
                static_cast<float>(depth_m(m.source_x_px[static_cast<std::size_t>(c)],
                                           m.source_y_px[static_cast<std::size_t>(r)]));
    const ReprojectVertices kernel{
        Reprojection(from, to), depths.data(), m.source_x_px.data(),  m.source_y_px.data(), columns,
        m.x_px.data(),          m.y_px.data(), m.inverse_depth.data()};
    for (int r = 0; r < rows; ++r) kernel(r);
    return m;
}

TEST(Reprojection, AStillEyeMapsPixelsToThemselves) {
    EyeView v = eye();
    v.position_m = {12.0F, 1.7F, -30.0F};
    v.world_from_eye = turned(2.1, -0.4, 0.2);
    for (const double depth : {0.05, 1.0, 30.0, 1.0e6}) {
        const MeshArrays m = reprojected(v, v, [&](double, double) { return depth; });
        for (int r = 0; r < m.rows; ++r) {
            for (int c = 0; c < m.columns; ++c) {
                ASSERT_NEAR(m.x_px[m.at(c, r)], m.source_x_px[static_cast<std::size_t>(c)], 1.0e-3);
                ASSERT_NEAR(m.y_px[m.at(c, r)], m.source_y_px[static_cast<std::size_t>(r)], 1.0e-3);
                ASSERT_NEAR(m.inverse_depth[m.at(c, r)] * depth, 1.0, 1.0e-5);
            }
        }
    }
}

TEST(Reprojection, APureTurnIsTheHomographyAtEveryDepth) {
    const EyeView from = eye();
    EyeView to = eye();
    to.world_from_eye = turned(0.12, 0.07, -0.05);
    for (const double depth : {0.3, 4.0, 1.0e6}) {
        const MeshArrays m = reprojected(from, to, [&](double, double) { return depth; });
        for (int r = 0; r < m.rows; ++r) {
            for (int c = 0; c < m.columns; ++c) {
                const dvec2 expected =
                    project(to, unproject(from, m.source_x_px[static_cast<std::size_t>(c)],
                                          m.source_y_px[static_cast<std::size_t>(r)], 1.0));
                ASSERT_NEAR(m.x_px[m.at(c, r)], expected.x, 2.0e-3);
                ASSERT_NEAR(m.y_px[m.at(c, r)], expected.y, 2.0e-3);
            }
        }
    }
}

TEST(Reprojection, ASlantedPlaneMovesAsItsPointsDo) {
    EyeView from = eye();
    from.position_m = {3.0F, 1.5F, 2.0F};
    EyeView to = from;
    to.position_m += vec3(0.08F, -0.03F, 0.15F);
    to.world_from_eye = turned(0.02, -0.01, 0.01);
    // Depth along the view axis of the plane through (0, 0, -4) with normal (0.3, 0, 1), from the
    // first eye.
    const auto depth = [&](double x_px, double y_px) {
        const dvec3 d = unproject(from, x_px, y_px, 1.0) - dvec3(from.position_m);
        const dvec3 n(0.3, 0.0, 1.0);
        return glm::dot(dvec3(0.0, 0.0, -4.0), n) / glm::dot(d, n);
    };
    const MeshArrays m = reprojected(from, to, depth);
    for (int r = 0; r < m.rows; ++r) {
        for (int c = 0; c < m.columns; ++c) {
            const float sx = m.source_x_px[static_cast<std::size_t>(c)];
            const float sy = m.source_y_px[static_cast<std::size_t>(r)];
            const dvec3 world = unproject(from, sx, sy, depth(sx, sy));
            const dvec2 expected = project(to, world);
            const double depth_m =
                -(glm::transpose(dmat3(to.world_from_eye)) * (world - dvec3(to.position_m))).z;
            ASSERT_NEAR(m.x_px[m.at(c, r)], expected.x, 3.0e-3);
            ASSERT_NEAR(m.y_px[m.at(c, r)], expected.y, 3.0e-3);
            ASSERT_NEAR(m.inverse_depth[m.at(c, r)] * depth_m, 1.0, 1.0e-5);
        }
    }
}

TEST(Reprojection, WhatFallsBehindTheEyeIsUnseenAndFinite) {
    const EyeView from = eye();
    EyeView to = from;
    to.position_m.z = -2.0F;
    const MeshArrays m = reprojected(from, to, [](double, double) { return 2.0; });
    for (std::size_t i = 0; i < m.cells(); ++i) {
        ASSERT_EQ(m.inverse_depth[i], 0.0F);
        ASSERT_TRUE(std::isfinite(m.x_px[i]) && std::isfinite(m.y_px[i]));
    }
}

TEST(Reprojection, TheRasterisedMeshOfAPlaneShowsWhereEachPixelWas) {
    // Vertices and raster together: a pixel's source is the old position of the plane point it
    // shows.
    const EyeView from = eye();
    EyeView to = from;
    to.position_m = {0.05F, 0.02F, -0.1F};
    to.world_from_eye = turned(-0.03, 0.02, 0.0);
    const double plane_z = -3.0;
    const MeshArrays m = reprojected(
        from, to, [&](double, double) { return -plane_z; }, 257, 319);
    for (const auto& [x0, y0] : {std::pair{0, 0}, std::pair{512, 704}, std::pair{1088, 1344}}) {
        RasterArrays target;
        RasterFrame frame{m.mesh()};
        frame.x0 = x0;
        frame.y0 = y0;
        raster_all(frame, target.tile());
        int covered = 0;
        for (int y = 0; y < kRasterTile; ++y) {
            for (int x = 0; x < kRasterTile; ++x) {
                const std::size_t at = RasterArrays::index(x, y);
                if (target.inverse_depth[at] <= 0.0F) continue;
                ++covered;
                const dvec3 d =
                    unproject(to, x0 + x + 0.5, y0 + y + 0.5, 1.0) - dvec3(to.position_m);
                const dvec3 world = dvec3(to.position_m) +
                                    d * ((plane_z - static_cast<double>(to.position_m.z)) / d.z);
                const dvec2 expected = project(from, world);
                ASSERT_NEAR(target.source_x_w[at] / target.inverse_depth[at], expected.x, 0.02);
                ASSERT_NEAR(target.source_y_w[at] / target.inverse_depth[at], expected.y, 0.02);
            }
        }
        EXPECT_GT(covered, kRasterTile * kRasterTile / 4);
    }
}

}  // namespace
}  // namespace foverig
