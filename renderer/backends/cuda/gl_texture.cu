#include "renderer/backends/cuda/gl_texture.h"

#include "renderer/backends/cuda/check.cuh"

#if __has_include(<GL/gl.h>)
#include <cuda_gl_interop.h>

namespace foverig::cuda {

struct GlTexture::Registered {
    Registered(unsigned int texture, int width, int height)
        : name(texture), width_px(width), height_px(height) {
        if (cudaGraphicsGLRegisterImage(&resource, texture, GL_TEXTURE_2D,
                                        cudaGraphicsRegisterFlagsWriteDiscard) != cudaSuccess) {
            resource = nullptr;
            cudaGetLastError();  // GL on another device is no failure
        }
    }
    Registered(const Registered&) = delete;
    Registered& operator=(const Registered&) = delete;
    ~Registered() {
        if (resource != nullptr) cudaGraphicsUnregisterResource(resource);
    }

    bool is(unsigned int texture, int width, int height) const {
        return name == texture && width_px == width && height_px == height;
    }

    unsigned int name;
    int width_px;
    int height_px;
    cudaGraphicsResource_t resource = nullptr;
};

bool GlTexture::copy(View<const Half4> image, int width_px, int height_px, unsigned int texture,
                     CUstream_st* stream) {
    if (registered_ == nullptr || !registered_->is(texture, width_px, height_px)) {
        registered_.reset();
        registered_ = std::make_unique<Registered>(texture, width_px, height_px);
    }
    cudaGraphicsResource_t resource = registered_->resource;
    if (resource == nullptr) return false;
    check(cudaGraphicsMapResources(1, &resource, stream), "cudaGraphicsMapResources");
    cudaArray_t array = nullptr;
    check(cudaGraphicsSubResourceGetMappedArray(&array, resource, 0, 0),
          "cudaGraphicsSubResourceGetMappedArray");
    const std::size_t row = static_cast<std::size_t>(width_px) * sizeof(Half4);
    check(cudaMemcpy2DToArrayAsync(array, 0, 0, image.data, row, row,
                                   static_cast<std::size_t>(height_px), cudaMemcpyDeviceToDevice,
                                   stream),
          "cudaMemcpy2DToArrayAsync to a GL texture");
    check(cudaGraphicsUnmapResources(1, &resource, stream), "cudaGraphicsUnmapResources");
    return true;
}

#else

namespace foverig::cuda {

struct GlTexture::Registered {};

bool GlTexture::copy(View<const Half4> /*image*/, int /*width_px*/, int /*height_px*/,
                     unsigned int /*texture*/, CUstream_st* /*stream*/) {
    return false;
}

#endif

GlTexture::GlTexture() = default;
GlTexture::~GlTexture() = default;

}  // namespace foverig::cuda
