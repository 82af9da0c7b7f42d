#pragma once
#include <utility>

#include "renderer/backends/embree/embree_api.h"

namespace foverig::embree {

/// Move-only owner of one Embree object. Retain/release counting stays inside Embree.
template <class Handle, void (*Release)(Handle)>
class Owner {
  public:
    Owner() = default;
    explicit Owner(Handle handle) : handle_(handle) {}
    Owner(Owner&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
    Owner& operator=(Owner&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    Owner(const Owner&) = delete;
    Owner& operator=(const Owner&) = delete;
    ~Owner() {
        if (handle_ != nullptr) Release(handle_);
    }
    Handle get() const { return handle_; }

  private:
    Handle handle_ = nullptr;
};

using Device = Owner<RTCDevice, rtcReleaseDevice>;
using SceneHandle = Owner<RTCScene, rtcReleaseScene>;
using Geometry = Owner<RTCGeometry, rtcReleaseGeometry>;

}  // namespace foverig::embree
