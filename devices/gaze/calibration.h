#pragma once
// The host's part of a calibration or validation (DEVICES.md 4.5.5, 4.5.6) without any I/O: it is
// told samples, frames and the time, and says what to ask of the tracker and what to show.
#include <optional>
#include <string>
#include <vector>

#include "devices/gaze/data_quality.h"
#include "devices/gaze/fixation_watch.h"
#include "devices/gaze/gaze_sample.h"

namespace foverig::gaze {

struct CalibrationConfig {
    FixationWatch::Config fixation{};
    /// From a target's appearance: up to 300 ms of latency, a saccade, and a corrective one 100 to
    /// 200 ms later (5.1).
    Nanoseconds shortest_look{700'000'000};
    Nanoseconds longest_look{10'000'000'000};    ///< without a fixation: gives up
    Nanoseconds longest_silence{3'000'000'000};  ///< of a tracker that owes an answer: gives up
    int attempts = 5;                            ///< at a target that the tracker refuses
    double mapping_m = 1.5;                      ///< how far away the targets are (SET_MAPPING)
};

class CalibrationProcedure {
  public:
    enum class Task { calibrate, validate };
    enum class State { running, done, failed, aborted };

    /// A vendor request, for Transport::control_set.
    struct Order {
        std::uint8_t request = 0;
        std::uint16_t value = 0;
        std::vector<std::byte> data{};
    };
    struct Target {
        dvec2 at_deg{0.0};  ///< gaze angles from between the eyes
        int attempts = 0;
        DataQuality left{}, right{}, combined{};  ///< of a validation
        /// What the tracker says of it: left, right.
        Vec2f told_accuracy_deg{kNotMeasured, kNotMeasured};
        Vec2f told_rms_s2s_deg{kNotMeasured, kNotMeasured};
    };

    /// The targets in the order in which they are shown. None: to calibrate with 0 points.
    CalibrationProcedure(Task task, const std::vector<dvec2>& targets_deg, HostTime now,
                         const CalibrationConfig& config = {});

    /// What to ask of the tracker now, each once; also after the end, where it must be told of it.
    std::optional<Order> next_order(HostTime now);
    /// The tracker refused the last order.
    void refused(const std::string& why) { fail(why); }

    void take(const CalibrationFrame& frame, HostTime now);
    /// In order with the frames.
    void take(const GazeSample& sample);
    void abort();

    State state() const { return state_; }
    /// One sentence, of a procedure that failed.
    const std::string& failure() const { return failure_; }
    /// The target to show, by number; none: nothing.
    std::optional<std::size_t> shown() const;
    bool collecting() const { return step_ == Step::collecting; }
    const std::vector<Target>& targets() const { return targets_; }
    /// The tracker's last word: id, and mean accuracy and precision at the points of a calibration.
    const CalibrationFrame& outcome() const { return outcome_; }

  private:
    enum class Step { starting, awaiting, settling, accepting, collecting, over };
    struct Meters {
        DataQualityMeter left{}, right{}, combined{};
        dvec3 left_base_m{0.0}, right_base_m{0.0}, combined_base_m{0.0};
    };

    std::optional<Order> order_of_settling(HostTime now);
    void show(std::size_t target, HostTime now);
    void point_refused(CalibrationReason reason, HostTime now);
    void point_done(const CalibrationFrame& frame, HostTime now);
    void measure(const GazeSample& sample);
    void keep_quality(Target& target) const;
    void await(HostTime now);
    void fail(const std::string& why);
    void give_up(const std::string& why);

    Task task_;
    CalibrationConfig config_;
    std::vector<Target> targets_;
    Step step_ = Step::starting;
    State state_ = State::running;
    std::size_t at_ = 0;
    HostTime since_{};  // of the step
    FixationWatch watch_;
    GazeTime collected_from_{};
    Meters meters_;
    bool owes_abort_ = false;
    CalibrationFrame outcome_;
    std::string failure_;
};

/// "no eyes", "unstable", ...
const char* text_of(CalibrationReason reason);

}  // namespace foverig::gaze
