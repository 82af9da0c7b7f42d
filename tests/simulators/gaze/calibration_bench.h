#pragma once
// A simulated tracker before eyes that are exactly where they are told to be, and the host's part
// of a calibration, by hand.
#include <algorithm>
#include <functional>
#include <vector>

#include "devices/gaze/calibration_targets.h"
#include "devices/gaze_angles.h"
#include "simulators/gaze/simulated_gaze.h"
#include "simulators/motion/pointed_eye.h"

namespace foverig::test {

class CalibrationBench {
  public:
    explicit CalibrationBench(const SimulatedGaze::Settings& settings = {})
        : device(clock, eyes, settings) {}

    Status order(std::uint8_t id, std::uint16_t value = 0, Bytes data = {}) {
        return device.control_set(id, value, data);
    }
    gaze::DeviceStatus status() {
        const auto bytes =
            device.control_get(gaze::request::get_status, 0, gaze::DeviceStatus::kSize);
        return gaze::DeviceStatus::decode(*bytes).value();
    }

    /// Looks there from now on.
    void look(const dvec2& at_deg) {
        eyes.look(to_seconds(clock.now().time_since_epoch()),
                  {.direction = gaze_direction(at_deg)});
    }
    void pass(double seconds) {
        const HostTime until = clock.now() + from_seconds(seconds);
        while (true) {
            const auto next = device.next(until);
            const auto* packet = std::get_if<Packet>(&next);
            if (packet == nullptr) break;
            const auto frame = gaze::decode_frame(packet->bytes);
            if (!frame) continue;
            if (const auto* c = std::get_if<gaze::CalibrationFrame>(&*frame)) told.push_back(*c);
            if (const auto* s = std::get_if<gaze::SampleFrame>(&*frame)) samples.push_back(*s);
        }
        clock.sleep_until(until);
    }
    /// The tracker's states since the last call.
    std::vector<gaze::CalibrationState> states() {
        std::vector<gaze::CalibrationState> all;
        for (const auto& frame : told) all.push_back(frame.state);
        told.clear();
        return all;
    }

    static std::vector<std::byte> pairs(const std::vector<dvec2>& targets_deg) {
        std::vector<gaze::Vec2f> px;
        for (const dvec2& target : targets_deg) px.push_back(gaze::por_of(target));
        return gaze::encode_targets(px);
    }
    /// The eyes go to each target and it is accepted; false where the tracker refuses anything.
    bool do_points(std::uint8_t request, const std::vector<dvec2>& targets_deg) {
        const auto count = static_cast<std::uint16_t>(targets_deg.size());
        if (!order(request, count, pairs(targets_deg))) return false;
        for (const dvec2& target : targets_deg) {
            look(target);
            pass(0.1);
            if (!order(gaze::request::cal_accept)) return false;
            pass(0.6);
        }
        return !told.empty() && told.back().state == gaze::CalibrationState::done;
    }
    bool calibrate(int points, double reach_deg = 16.0) {
        return do_points(gaze::request::cal_start, gaze::targets_deg(points, reach_deg));
    }
    /// Angle between an eye's gaze as sent and as it is, looking at a target 1.5 m away.
    double error_deg(Side side, const dvec2& target_deg) {
        look(target_deg);
        pass(0.1);
        const auto& block = side == Side::left ? samples.back().left : samples.back().right;
        const auto& d = block.direction;
        return angle_between_deg(dvec3(-d[0], d[1], -d[2]),
                                 eye_direction(side, {.direction = gaze_direction(target_deg)}));
    }
    /// Mean over both eyes and a grid within the points' reach, which no calibration has as points.
    double mean_error_deg(double reach_deg = 16.0) {
        double sum = 0.0;
        int count = 0;
        for (const double x : {-0.9, -0.3, 0.3, 0.9})
            for (const double y : {-0.9, -0.3, 0.3, 0.9})
                for (const Side side : {Side::left, Side::right}) {
                    sum += error_deg(side, reach_deg * dvec2(x, y));
                    ++count;
                }
        return sum / count;
    }

    ManualClock clock;
    motion::PointedEye eyes;
    SimulatedGaze device;
    std::vector<gaze::CalibrationFrame> told;
    std::vector<gaze::SampleFrame> samples;
};

}  // namespace foverig::test
