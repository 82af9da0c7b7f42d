#pragma once
#include "devices/display/display.h"
#include "devices/window/gl_objects.h"

namespace foverig::window {

/// A camera's picture: sRGB8, so that fetches are linear light; black beyond its edges.
class BehindTexture {
  public:
    BehindTexture();

    /// Allocates only where the size changes.
    void fill(const BehindPicture& picture);

    GLuint name() const { return texture_.name(); }
    /// Tangents of half the picture's width and height.
    const dvec2& half_tangents() const { return half_tangents_; }

  private:
    GlTexture texture_;
    int width_px_ = 0, height_px_ = 0;
    dvec2 half_tangents_{1.0};
};

}  // namespace foverig::window
