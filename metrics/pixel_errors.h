#pragma once
#include "renderer/image.h"

namespace foverig::metrics {

/// Means over pixels and channels of what each differs by. `largest` is a maximum.
struct Differences {
    double mse = 0.0;
    double mae = 0.0;
    double largest = 0.0;
};

/// Of display codes, 0 to 255.
Differences code_differences(const Image& a, const Image& b);

/// Of linear values as they are.
Differences linear_differences(const Image& a, const Image& b);

/// 10 log10(255^2 / mse) in dB, of an mse of display codes; infinite for equal images.
double psnr_db(double mse);

inline constexpr double kRelativeFloor = 1.0e-2;  ///< keeps dark pixels from ruling

/// Errors of linear values relative to the reference R, means over pixels and channels.
struct RelativeDifferences {
    double relmse = 0.0;  ///< (T - R)^2 / (R^2 + kRelativeFloor)
    double mape = 0.0;    ///< |T - R| / (|R| + kRelativeFloor)
    double smape = 0.0;   ///< 2 |T - R| / (|R| + |T| + kRelativeFloor): the symmetric one
};

RelativeDifferences relative_differences(const Image& reference, const Image& test);

}  // namespace foverig::metrics
