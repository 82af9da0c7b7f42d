#pragma once
#include <memory>

#include "renderer/half.h"
#include "renderer/view.h"

struct CUstream_st;

namespace foverig::cuda {

/// A texture of OpenGL's as the device writes it, so that an image on the device reaches a window
/// without the host.
class GlTexture {
  public:
    GlTexture();
    GlTexture(const GlTexture&) = delete;
    GlTexture& operator=(const GlTexture&) = delete;
    ~GlTexture();

    /// Into a 2D texture of RGBA16F of that size, of the context that is current; in order with the
    /// stream, and GL's next use of it waits. Returns false where the two do not share a device, or
    /// this build knows no OpenGL: take the host's way then. Throws CudaError.
    bool copy(View<const Half4> image, int width_px, int height_px, unsigned int texture,
              CUstream_st* stream);

  private:
    struct Registered;
    std::unique_ptr<Registered> registered_;
};

}  // namespace foverig::cuda
