#pragma once
// The only file that knows which Embree this is: 3.13 (Debian 12) passes a context, 4 passes
// arguments.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace foverig::embree {

inline constexpr int kPacket = 16;

/// Whether neighbouring lanes are expected to take the same path (PERFORMANCE: worth 4x for
/// primaries).
enum class Coherence { coherent, incoherent };

class Query {
  public:
    explicit Query(Coherence coherence) {
#if RTC_VERSION_MAJOR >= 4
        rtcInitIntersectArguments(&intersect_);
        rtcInitOccludedArguments(&occluded_);
        intersect_.flags = occluded_.flags = flags(coherence);
#else
        rtcInitIntersectContext(&context_);
        context_.flags = flags(coherence);
#endif
    }

    void closest16(const int* valid, RTCScene scene, RTCRayHit16& rays) {
#if RTC_VERSION_MAJOR >= 4
        rtcIntersect16(valid, scene, &rays, &intersect_);
#else
        rtcIntersect16(valid, scene, &context_, &rays);
#endif
    }

    void closest1(RTCScene scene, RTCRayHit& ray) {
#if RTC_VERSION_MAJOR >= 4
        rtcIntersect1(scene, &ray, &intersect_);
#else
        rtcIntersect1(scene, &context_, &ray);
#endif
    }

    /// Sets tfar of an occluded ray to -infinity.
    void occluded1(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR >= 4
        rtcOccluded1(scene, &ray, &occluded_);
#else
        rtcOccluded1(scene, &context_, &ray);
#endif
    }

    /// Sets tfar of occluded lanes to -infinity.
    void occluded16(const int* valid, RTCScene scene, RTCRay16& rays) {
#if RTC_VERSION_MAJOR >= 4
        rtcOccluded16(valid, scene, &rays, &occluded_);
#else
        rtcOccluded16(valid, scene, &context_, &rays);
#endif
    }

  private:
#if RTC_VERSION_MAJOR >= 4
    static RTCRayQueryFlags flags(Coherence c) {
        return c == Coherence::coherent ? RTC_RAY_QUERY_FLAG_COHERENT
                                        : RTC_RAY_QUERY_FLAG_INCOHERENT;
    }
    RTCIntersectArguments intersect_;
    RTCOccludedArguments occluded_;
#else
    static RTCIntersectContextFlags flags(Coherence c) {
        return c == Coherence::coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT
                                        : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    }
    RTCIntersectContext context_;
#endif
};

}  // namespace foverig::embree
