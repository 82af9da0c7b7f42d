#pragma once
#include "devices/display/dk2_optics.h"

namespace foverig {

/// From a place on an eye's half of the panel to where it is seen: through the DK2's lens, or
/// without one, where the eye's frustum fills its half.
class EyeMap {
  public:
    explicit EyeMap(bool lens) : lens_(lens) {}

    bool lens() const { return lens_; }
    TangentFrustum frustum(Eye eye) const { return optics_.frustum(eye); }

    dvec2 tangent(Eye eye, const dvec2& ndc, Channel channel = Channel::green) const {
        if (lens_) return optics_.tangent(eye, ndc, channel);
        const TangentFrustum f = frustum(eye);
        return {-f.left + 0.5 * (ndc.x + 1.0) * (f.left + f.right),
                -f.down + 0.5 * (ndc.y + 1.0) * (f.up + f.down)};
    }
    dvec2 ndc(Eye eye, const dvec2& tangent) const {
        if (lens_) return optics_.ndc(eye, tangent);
        const TangentFrustum f = frustum(eye);
        return {2.0 * (tangent.x + f.left) / (f.left + f.right) - 1.0,
                2.0 * (tangent.y + f.down) / (f.up + f.down) - 1.0};
    }

  private:
    bool lens_;
    Dk2Optics optics_;
};

}  // namespace foverig
