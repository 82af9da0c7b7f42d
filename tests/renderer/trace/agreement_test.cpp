// Our tracer against Embree's single-ray calls, ray by ray.
#include "bench/agreement.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "bench/ray_kinds.h"
#include "bench/single_rays.h"
#include "renderer/backends/embree/split_build.h"
#include "renderer/backends/host_bvh/host_bvh_scene.h"
#include "renderer/scene/library.h"

namespace foverig {
namespace {

namespace fs = std::filesystem;
using bench::RayKind;
using bench::Verdict;

const fs::path kScenes = fs::path(FOVERIG_SOURCE_DIR).parent_path() / "shared" / "scenes";

constexpr std::uint32_t kRays = 20'000;

BinaryBvh with_splits(std::span<const Corners> triangles) {
    return embree::build_with_splits(triangles, 1);
}

bench::Verdicts compare_all(const Scene& scene, const host_bvh::HostBvhScene& ours, RayKind kind,
                            std::uint32_t rays) {
    const embree::EmbreeScene embree(scene, {true, true, 1});
    bench::SingleRays peer(embree);
    const bench::RayMaker make_ray(scene);
    bench::Verdicts verdicts{};
    for (std::uint32_t i = 0; i < rays; ++i) {
        const Ray ray = make_ray(kind, i);
        const Hit theirs = peer.closest(ray);
        const Hit hit = ours.closest(ray);
        const Verdict verdict = bench::compare(embree.view(), ray, theirs, hit);
        ++verdicts[static_cast<std::size_t>(verdict)];
        EXPECT_NE(verdict, Verdict::wrong)
            << bench::name_of(kind) << " ray " << i << ": triangle " << theirs.triangle << " at "
            << theirs.t << ", ours " << hit.triangle << " at " << hit.t;
        if (hit.missed() == theirs.missed()) {
            EXPECT_EQ(ours.occluded(ray), peer.occluded(ray)) << bench::name_of(kind) << " " << i;
        }
    }
    return verdicts;
}

void expect_agreement(const Scene& scene) {
    const host_bvh::HostBvhScene split(scene, {true, {}, with_splits});
    for (const RayKind kind : bench::kRayKinds) {
        const bench::Verdicts verdicts = compare_all(scene, split, kind, kRays);
        EXPECT_GT(verdicts[static_cast<std::size_t>(Verdict::same)], kRays / 2);
    }
    for (const float factor : {1.0e-6F, 1.0e6F}) {
        const Scene other = bench::scaled(scene, factor);
        const host_bvh::HostBvhScene plain(other, {});
        compare_all(other, plain, RayKind::inside, kRays);
    }
}

class BuiltinAgreement : public testing::TestWithParam<std::string> {};

TEST_P(BuiltinAgreement, SameHitsAsEmbreeOrNamedTies) {
    expect_agreement(make_builtin_scene(GetParam(), 0.02));
}

std::vector<std::string> builtin_names() {
    std::vector<std::string> names;
    for (const BuiltinInfo& info : builtin_scenes()) names.push_back(info.name);
    return names;
}

std::string test_name(std::string text) {
    for (char& c : text)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return text;
}

INSTANTIATE_TEST_SUITE_P(All, BuiltinAgreement, testing::ValuesIn(builtin_names()),
                         [](const auto& test) { return test_name(test.param); });

class SharedAgreement : public testing::TestWithParam<const char*> {};

TEST_P(SharedAgreement, SameHitsAsEmbreeOrNamedTies) {
    const fs::path file = kScenes / GetParam();
    if (!fs::exists(file)) GTEST_SKIP() << GetParam() << " is not beside the checkout";
    expect_agreement(import_scene(file));
}

INSTANTIATE_TEST_SUITE_P(All, SharedAgreement,
                         testing::Values("sponza/sponza.glb", "sibenik/sibenik.obj",
                                         "littlest-tokyo/tokyo.glb", "statues/stanford-bunny.obj",
                                         "statues/teapot.obj", "cornell/CornellBox-Water.obj",
                                         "spot/spot_triangulated.obj"),
                         [](const auto& test) { return test_name(test.param); });

}  // namespace
}  // namespace foverig
