#pragma once
// The DK2's lenses after LibOVR 0.5 (DEVICES.md 2.1, 2.2): panel to tangent-angle space per colour.
// Tangents: x right, y up, at the eye, forward is -z. Eye NDC: x right, y up, each -1..1 over the
// eye's half of the panel (960x1080 px).
#include <array>

#include "devices/display/panel_timing.h"
#include "devices/math.h"

namespace foverig {

/// Half angles' tangents, all positive.
struct TangentFrustum {
    double up = 0, down = 0, left = 0, right = 0;
};

struct SizePx {
    int width = 0, height = 0;
    bool operator==(const SizePx&) const = default;
};

enum class Channel { red = 0, green = 1, blue = 2 };

class Dk2Optics {
  public:
    static constexpr double kEyeRelief_m = 0.011;  ///< dial step 3; matters for colour fringes only

    explicit Dk2Optics(double eye_relief_m = kEyeRelief_m);

    /// Tangent radius over panel radius, of a channel at squared panel radius r2 >= 0.
    double scale(double r2, Channel channel = Channel::green) const;
    /// Panel radius whose tangent is `tan_radius` >= 0; saturates at 4, far outside the panel.
    double inverse(double tan_radius, Channel channel = Channel::green) const;

    /// Tangent at the eye of a place on its half of the panel.
    dvec2 tangent(Eye eye, const dvec2& ndc, Channel channel = Channel::green) const;
    dvec2 ndc(Eye eye, const dvec2& tangent, Channel channel = Channel::green) const;

    /// Red, green, blue tangents of a pixel's centre; (0, 0) is the top-left pixel of the eye's
    /// half.
    std::array<dvec2, 3> pixel_tangents(Eye eye, int x_px, int y_px) const;

    /// What green can reach along the axes: the exact frustum to render.
    TangentFrustum frustum(Eye eye) const;
    /// 549.618 on both axes.
    double pixels_per_tan_at_center() const;
    /// 1182x1464 at density 1.
    SizePx texture_size(double density = 1) const;

    static constexpr SizePx kEyePanel{960, 1080};

  private:
    std::array<double, 4> chroma_;  // red 0, red r2, blue 0, blue r2
};

}  // namespace foverig
