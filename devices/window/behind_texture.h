#pragma once
#include <optional>

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
    /// The lens, with lengths as shares of the picture's width and height.
    struct Lens {
        glm::vec2 focal{1.0F}, centre{0.5F};
        glm::vec4 bend{0.0F};        ///< k1, k2, k3, and a fisheye's k4
        glm::vec2 tangential{0.0F};  ///< p1, p2; a fisheye has none
        float farthest = 0.0F;  ///< tangent, or a fisheye's angle, beyond which nothing is seen
        bool fisheye = false;
    };
    const Lens& lens() const { return lens_; }

  private:
    GlTexture texture_;
    int width_px_ = 0, height_px_ = 0;
    Lens lens_;
    std::optional<camera::AnyLens> told_;  // what lens_ is of
};

}  // namespace foverig::window
