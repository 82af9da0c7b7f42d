#pragma once
#include <map>
#include <optional>
#include <string>

#include "metrics/change.h"
#include "metrics/flicker.h"
#include "metrics/fovvideovdp.h"
#include "renderer/camera.h"
#include "renderer/image.h"

namespace foverig::sweep {

inline constexpr double kFoveaDeg = 10.0;  ///< as `foverig diff` has it

/// Errors of one eye's images against their references, frame by frame, given where the eye looks.
/// NaN and infinities count as metrics/finite.h has them.
class FrameErrors {
  public:
    /// `fvvdp`: that too, which takes longer than all others together.
    FrameErrors(double frames_per_s, bool fvvdp);

    /// Each of error_names() (but for `fvvdp`) of the next frame; what is of a sequence is seen
    /// through the frames before. `fovea` and `periphery` are 0 of no pixel.
    std::map<std::string, double> add(const Image& reference, const Image& test,
                                      const EyeInput& eye);
    /// The next frame is not judged, but later ones are seen through it.
    void see(const Image& reference, const Image& test);

  private:
    metrics::ChangeOverTime change_;
    metrics::Flicker flicker_;
    std::optional<metrics::FovVideoVdp> vdp_;
};

}  // namespace foverig::sweep
