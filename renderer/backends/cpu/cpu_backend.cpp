#include "renderer/backends/cpu/cpu_backend.h"

#include <tbb/info.h>

#include "renderer/backends/embree/split_build.h"
#include "renderer/check.h"

namespace foverig {
namespace {

TracedScene traced(const Scene& scene, const embree::EmbreeSettings& settings, Tracer tracer) {
    if (tracer == Tracer::embree)
        return TracedScene(std::in_place_type<embree::EmbreeScene>, scene, settings);
    const auto build = [threads = settings.threads](std::span<const Corners> triangles) {
        return embree::build_with_splits(triangles, threads);
    };
    return TracedScene(std::in_place_type<host_bvh::HostBvhScene>, scene,
                       host_bvh::HostBvhSettings{
                           settings.alpha_test, {settings.textures, settings.motion}, build});
}

}  // namespace

CpuBackend::CpuBackend(const Scene& scene, const embree::EmbreeSettings& settings, Tracer tracer)
    : threads_(settings.threads > 0 ? settings.threads : tbb::info::default_concurrency()),
      arena_(std::make_unique<tbb::task_arena>(threads_)),
      scene_(traced(scene, settings, tracer)) {
    for (int i = 0; i < threads_; ++i) lanes_.emplace_back(scene_);
}

const embree::EmbreeScene& CpuBackend::embree_scene() const {
    const auto* scene = std::get_if<embree::EmbreeScene>(&scene_);
    RIG_CHECK(scene != nullptr, "the scene is asked for where Embree holds it");
    return *scene;
}

const SceneView& CpuBackend::view() const {
    return std::visit([](const auto& scene) -> const SceneView& { return scene.view(); }, scene_);
}

void CpuBackend::set_time(double time_s) {
    std::visit([time_s](auto& scene) { scene.set_time(time_s); }, scene_);
}

SceneBytes CpuBackend::bytes() const {
    return std::visit([](const auto& scene) { return scene.bytes(); }, scene_);
}

PassTable CpuBackend::take_passes() {
    PassTable sum;
    for (Lane& lane : lanes_) {
        sum.merge(lane.passes());
        lane.passes().clear();
    }
    return sum;
}

}  // namespace foverig
