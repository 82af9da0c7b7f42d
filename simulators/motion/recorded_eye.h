#pragma once
// A recorded gaze, played as a function of time.
#include <filesystem>
#include <vector>

#include "devices/result.h"
#include "simulators/motion/eye_motion.h"

namespace foverig::motion {

/// Straight lines between rows; before the first and after the last the gaze rests.
class RecordedEye final : public EyeMotion {
  public:
    struct Row {
        double t_s;
        dvec2 gaze_deg;  ///< x to the right, y upwards, in the head
        double openness = 1.0;
    };

    /// Columns t_s,gaze_x_deg,gaze_y_deg and perhaps openness.
    static Result<RecordedEye> load(const std::filesystem::path& file);
    /// At least 2 rows with rising times.
    explicit RecordedEye(std::vector<Row> rows) : rows_(std::move(rows)) {}

    EyeState at(double t_s) const override;

  private:
    std::vector<Row> rows_;
};

}  // namespace foverig::motion
