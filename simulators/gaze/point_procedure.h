#pragma once
// Calibration and validation inside the tracker (DEVICES.md 4.5.5, 4.5.6): points one after
// another, each waiting for CAL_ACCEPT, then watched for half a second. What the tables leave open
// is our choice: a point that is refused waits again, a validation says "done" of each target.
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "devices/gaze/data_quality.h"
#include "devices/gaze/frames.h"
#include "devices/time.h"
#include "simulators/gaze/calibration_map.h"

namespace foverig {

class PointProcedure {
  public:
    static constexpr Nanoseconds kCollect{500'000'000};
    static constexpr Nanoseconds kPatience{30'000'000'000};  ///< for CAL_ACCEPT
    static constexpr double kLeastSeen = 0.75;               ///< of a point's exposures
    static constexpr int kLeastSights = 10;                  ///< and no fewer than these
    static constexpr double kUnstable_deg = 1.0;             ///< standard deviation of an eye

    enum class Kind { calibrate, validate };
    struct Settings {
        Kind kind = Kind::calibrate;
        std::uint16_t id = 0;  ///< of the calibration in the making, or that is judged
        std::vector<gaze::Vec2f> targets_px{};
        double mapping_m = 1.5;  ///< how far away the targets are
    };
    /// One exposure: gaze angles of both eyes, as measured (to calibrate) or as sent (to validate).
    struct Sight {
        HostTime exposed{};
        std::optional<std::array<dvec2, 2>> gaze_deg{};  ///< absent: not both eyes were seen well
    };

    /// Shows the first target at `now`.
    PointProcedure(const Settings& settings, HostTime now);

    /// False where no point waits.
    bool accept(HostTime now, const std::optional<gaze::Vec2f>& instead);
    void abort();
    /// In order of time.
    void take(const Sight& sight);

    Kind kind() const { return settings_.kind; }
    bool over() const { return over_; }
    /// Of a calibration that succeeded: left, right.
    const std::optional<std::array<CalibrationMap, 2>>& maps() const { return maps_; }
    std::uint8_t quality() const { return quality_; }  ///< 0..100, 255 unknown
    /// Why the last point was refused.
    gaze::CalibrationReason last_reason() const { return last_reason_; }
    /// What there is to tell the host since the last call; without headers.
    std::vector<gaze::CalibrationFrame> take_frames();

  private:
    using EyeDegrees = std::array<dvec2, 2>;

    void tell(gaze::CalibrationState state,
              gaze::CalibrationReason reason = gaze::CalibrationReason::none);
    void show(HostTime now);
    void judge(HostTime now);
    std::optional<gaze::CalibrationReason> fault_of_point() const;
    void next_point(HostTime now);
    void finish_calibration();
    EyeDegrees wanted_deg() const;
    gaze::DataQuality quality_of(std::size_t eye, const dvec2& wanted_deg) const;

    Settings settings_;
    std::size_t point_ = 0;
    HostTime shown_{};
    std::optional<HostTime> accepted_;
    std::vector<Sight> sights_;  // since accepted
    std::array<std::vector<dvec2>, 2> measured_deg_, wanted_deg_;
    std::array<double, 2> squared_s2s_deg2_{};
    std::optional<std::array<CalibrationMap, 2>> maps_;
    std::uint8_t quality_ = 255;
    gaze::Vec2f accuracy_deg_{gaze::kNotMeasured, gaze::kNotMeasured};
    gaze::Vec2f precision_deg_{gaze::kNotMeasured, gaze::kNotMeasured};
    gaze::CalibrationReason last_reason_ = gaze::CalibrationReason::none;
    bool over_ = false;
    std::vector<gaze::CalibrationFrame> frames_;
};

}  // namespace foverig
