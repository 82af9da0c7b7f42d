#pragma once
// Images of chosen frames: copied while the run goes on, judged and written once it is over, so
// that neither is on any frame's time.
#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "renderer/renderer.h"
#include "rig/scenario/scenario.h"
#include "rig/session/lens_pass.h"

namespace foverig {

class KeptImages {
  public:
    explicit KeptImages(const Scenario& scenario);

    /// Copies the renderer's last frame if it is one to keep. `share` of the run is done by now.
    bool frame_done(const FrameInput& input, const Renderer& renderer, double share);

    /// Keeps the last frame after all, where a run ended before any was kept.
    void run_done(const FrameInput& last, const Renderer& renderer);

    /// Compares kept frames with `full` rendered from the same input, until asked to stop.
    void compare_with(Renderer& full, const std::function<bool()>& stop_requested);

    /// Writes images/*.png below `folder`, the panel's picture too where there is a lens pass;
    /// returns the summary's list [{frame, eye, kind, file, gaze_px, mean_absolute_error}].
    nlohmann::json write(const std::filesystem::path& folder, const LensPass* lens) const;

    /// Frames that the scenario asks for and the run never came to.
    std::vector<std::int64_t> missed() const;
    bool empty() const { return frames_.empty(); }

  private:
    struct EyeImages {
        Image final;
        Mask sampling;
        Mask resampling;
        Image full;                         ///< the same, by the full pipeline; or empty
        Image error;                        ///< difference to full, kErrorGain times; or empty
        double mean_absolute_error = -1.0;  ///< < 0: not compared
    };
    struct Frame {
        FrameInput input;
        std::vector<EyeImages> eyes;
    };
    bool wanted(const FrameInput& input, double share) const;
    void keep(const FrameInput& input, const Renderer& renderer);

    ImageSettings settings_;
    bool on_wall_clock_;
    std::vector<Frame> frames_;
};

/// |a - b| of each pixel as seen (sRGB), `gain` times, for looking at.
Image difference(const Image& a, const Image& b, float gain);

}  // namespace foverig
