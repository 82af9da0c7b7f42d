#pragma once
// Embree asked for one ray at a time: the peer of a tracer that takes one ray at a time.
#include "renderer/backends/embree/embree_scene.h"
#include "renderer/trace/ray.h"

namespace foverig::bench {

class SingleRays {
  public:
    /// Borrows the scene.
    explicit SingleRays(const embree::EmbreeScene& scene) : scene_(scene) {}

    Hit closest(const Ray& ray) {
        RTCRayHit rayhit;
        set(rayhit.ray, ray);
        rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rayhit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        query_.closest1(scene_.handle(), rayhit);
        if (rayhit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        return {rayhit.ray.tfar, rayhit.hit.u, rayhit.hit.v,
                scene_.first_triangles()[rayhit.hit.geomID] + rayhit.hit.primID};
    }

    bool occluded(const Ray& ray) {
        RTCRay r;
        set(r, ray);
        query_.occluded1(scene_.handle(), r);
        return r.tfar < 0.0F;
    }

  private:
    static void set(RTCRay& r, const Ray& ray) {
        r = {ray.origin_m.x,
             ray.origin_m.y,
             ray.origin_m.z,
             ray.t_min,
             ray.direction.x,
             ray.direction.y,
             ray.direction.z,
             0.0F,
             ray.t_max,
             ~0U,
             0U,
             0U};
    }

    const embree::EmbreeScene& scene_;
    embree::Query query_{embree::Coherence::incoherent};
};

}  // namespace foverig::bench
