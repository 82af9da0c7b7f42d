#include "devices/recording/fix_json.h"

#include <fmt/format.h>

#include <cmath>

namespace foverig {
namespace {

constexpr const char* kSchema = R"({"type": "object", "title": "foverig.PoseFix",
"description": "the headset's inertial sensor before the camera: x right, y down, z ahead",
"properties": {
"host_ns": {"type": "integer", "description": "middle of the exposure on the host's clock"},
"arrival_ns": {"type": "integer"}, "device_ns": {"type": "integer"},
"position_m": {"type": "object", "properties":
{"x": {"type": "number"}, "y": {"type": "number"}, "z": {"type": "number"}}},
"rotation": {"type": "object", "properties": {"x": {"type": "number"},
"y": {"type": "number"}, "z": {"type": "number"}, "w": {"type": "number"}}},
"sigma_mm": {"type": "number"}, "sigma_deg": {"type": "number"},
"rms_px": {"type": "number"}, "leds": {"type": "integer"}}})";

/// Root of the three variances' sum, from row `at` of the covariance.
double sigma(const PoseFix& fix, std::size_t at) {
    const auto& c = fix.covariance;
    return std::sqrt(c(at, at) + c(at + 1, at + 1) + c(at + 2, at + 2));
}

}  // namespace

RecordedTopic fix_topic() {
    return {.topic = "/camera/fixes",
            .message_encoding = "json",
            .schema_name = "foverig.PoseFix",
            .json_schema = kSchema};
}

void write_json(std::string& out, const PoseFix& fix) {
    const dvec3& p = fix.camera_from_imu.translation_m;
    const dquat& q = fix.camera_from_imu.rotation;
    out.clear();
    fmt::format_to(std::back_inserter(out),
                   "{{\"host_ns\":{},\"arrival_ns\":{},\"device_ns\":{},"
                   "\"position_m\":{{\"x\":{},\"y\":{},\"z\":{}}},"
                   "\"rotation\":{{\"x\":{},\"y\":{},\"z\":{},\"w\":{}}},"
                   "\"sigma_mm\":{:.4},\"sigma_deg\":{:.4},\"rms_px\":{:.4},\"leds\":{}}}",
                   fix.taken.time_since_epoch().count(), fix.arrival.time_since_epoch().count(),
                   fix.taken_device.time_since_epoch().count(), p.x, p.y, p.z, q.x, q.y, q.z, q.w,
                   1e3 * sigma(fix, 3), glm::degrees(sigma(fix, 0)), fix.rms_px, fix.points);
}

}  // namespace foverig
