#pragma once
#include <cstdint>

#include "renderer/scene/posed_scene.h"
#include "renderer/trace/build/scene_bvh.h"
#include "renderer/trace/ray.h"

namespace foverig::host_bvh {

struct HostBvhSettings {
    bool alpha_test = true;  ///< effect alpha_mask; without it masked parts trace as opaque
    PoseSettings pose;
    BuildBinary build_still;  ///< of what never moves; empty: the plain builder
};

/// A Scene in the compressed wide BVH that the device traces, traced on the host by the same code.
/// Borrows `scene`, which must outlive it and stay unchanged.
class HostBvhScene {
  public:
    HostBvhScene(const Scene& scene, const HostBvhSettings& settings);

    /// As traverse.h: t in [t_min, t_max], the lowest triangle number of several at one t.
    Hit closest(const Ray& ray) const;
    bool occluded(const Ray& ray) const;

    const SceneView& view() const { return posed_.view(); }
    const SceneBvh& bvh() const { return bvh_; }
    bool holes() const { return holes_; }  ///< some triangle is alpha tested

    /// Moves the parts that have a motion and refits; nothing to do in a static scene.
    void set_time(double time_s);
    /// Only the vertices: for whoever refits a copy of the tree. Rays see the scene as it was.
    void move_vertices(double time_s) { posed_.set_time(time_s); }

    SceneBytes bytes() const;

  private:
    PosedScene posed_;
    SceneBvh bvh_;
    BvhView traced_;
    bool holes_ = false;  ///< some triangle is alpha tested
};

}  // namespace foverig::host_bvh
