#pragma once
#include <map>
#include <string>

#include "renderer/camera.h"
#include "renderer/image.h"

namespace foverig::sweep {

inline constexpr double kFoveaDeg = 10.0;  ///< as `foverig diff` has it

/// Each of error_names() of an eye's image against its reference, given where it looks. NaN and
/// infinities count as metrics/finite.h has them; `fovea` and `periphery` are 0 of no pixel.
std::map<std::string, double> errors_of(const Image& reference, const Image& test,
                                        const EyeInput& eye);

}  // namespace foverig::sweep
