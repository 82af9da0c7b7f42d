#pragma once
// The seam between what renders an eye and what draws it.
#include "devices/display/display.h"
#include "devices/window/gl_objects.h"

namespace foverig::window {

/// RGBA16F, linear light; row 0 is the picture's top. Filtered bilinearly, edges held.
class EyeTexture {
  public:
    EyeTexture();

    /// Takes the picture over, on the graphics card where that can be done, else through the host;
    /// allocates only where the size changes.
    void fill(const EyePicture& picture);

    GLuint name() const { return texture_.name(); }

  private:
    void set_up();

    GlTexture texture_;
    int width_px_ = 0, height_px_ = 0;
};

}  // namespace foverig::window
