#pragma once
// Both eyes in one launch: a foveated eye alone does not fill a large GPU.
#include "renderer/kernels/pixel.h"

namespace foverig {

inline constexpr int kMostEyes = 2;

/// One kernel an eye. Element i is element i % each of eye i / each. A branch and not an index, so
/// that no launch parameter is copied to memory.
template <class Kernel>
struct EachEye {
    Kernel eye[kMostEyes];
    int each;

    template <class... Args>
    RIG_HD auto operator()(int i, const Args&... args) const {
        return i < each ? eye[0](i, args...) : eye[1](i - each, args...);
    }
};

/// One kernel an eye. Element i belongs to the eye of the i-th queued pixel.
template <class Kernel>
struct EyeOfPixel {
    Kernel eye[kMostEyes];
    const PackedPixel* pixels;

    template <class... Args>
    RIG_HD auto operator()(int i, const Args&... args) const {
        return pixel_eye(pixels[i]) == 0 ? eye[0](i, args...) : eye[1](i, args...);
    }
};

}  // namespace foverig
