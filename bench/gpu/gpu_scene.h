#pragma once
#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "renderer/backends/host_bvh/host_bvh_scene.h"
#include "renderer/camera.h"
#include "renderer/trace/build/binned_sah.h"

namespace foverig::gpu {

/// The plain binned builder, which builds no tree twice: a scene's is known by its size.
inline BuildBinary built_once() {
    auto kept = std::make_shared<std::map<std::size_t, BinaryBvh>>();
    return [kept](std::span<const Corners> triangles) {
        const auto [at, added] = kept->try_emplace(triangles.size());
        if (added) at->second = build_binned_triangles(triangles);
        return at->second;
    };
}

/// A scene as both sides trace it: one tree, built by the plain binned builder.
class GpuScene {
  public:
    explicit GpuScene(Scene scene)
        : scene_(std::move(scene)),
          build_(built_once()),
          host_(scene_, {.alpha_test = true, .pose = {}, .build_still = build_}) {}
    GpuScene(const GpuScene&) = delete;
    GpuScene& operator=(const GpuScene&) = delete;
    ~GpuScene() = default;

    const Scene& scene() const { return scene_; }
    const host_bvh::HostBvhScene& host() const { return host_; }
    /// For renderers of this very scene.
    const BuildBinary& build() const { return build_; }
    bool holes() const {
        return std::any_of(scene_.parts.begin(), scene_.parts.end(),
                           [](const Part& p) { return p.alpha_masked; });
    }

    /// From the first key of the camera path, 90 degrees wide.
    EyeView view(int width_px, int height_px) const {
        const CameraKey& key = scene_.camera_path.front();
        EyeView v;
        v.width_px = width_px;
        v.height_px = height_px;
        v.tan_down = v.tan_up = static_cast<float>(height_px) / static_cast<float>(width_px);
        v.position_m = key.position_m;
        const vec3 back = glm::normalize(key.position_m - key.target_m);
        const vec3 helper = back.y * back.y > 0.98F ? vec3(1, 0, 0) : vec3(0, 1, 0);
        const vec3 right = glm::normalize(glm::cross(helper, back));
        v.world_from_eye = mat3(right, glm::cross(back, right), back);
        return v;
    }

  private:
    Scene scene_;
    BuildBinary build_;
    host_bvh::HostBvhScene host_;
};

}  // namespace foverig::gpu
