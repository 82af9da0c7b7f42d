#pragma once
#include <cstdint>

#include "renderer/image.h"

namespace foverig::metrics {

/// Channels that are NaN or infinite: no metric here may meet one.
std::uint64_t count_not_finite(const Image& image);

/// The image with NaN and -infinity as 0 and +infinity as 65504, the largest half float. Whoever
/// does this should say what `count_not_finite` said.
Image with_finite_values(Image image);

}  // namespace foverig::metrics
