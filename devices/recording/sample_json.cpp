#include "devices/recording/sample_json.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace foverig {
namespace {

constexpr const char* kImuSchema = R"({"type": "object", "title": "foverig.ImuSample",
"description": "x right, y up, z back; accelerometer reads +9.8 in y upright at rest",
"properties": {
"host_ns": {"type": "integer", "description": "device time on the host's clock"},
"arrival_ns": {"type": "integer"}, "device_ns": {"type": "integer"},
"sequence": {"type": "integer"}, "gap": {"type": "boolean"},
"accel_m_s2": {"type": "object", "properties":
{"x": {"type": "number"}, "y": {"type": "number"}, "z": {"type": "number"}}},
"gyro_rad_s": {"type": "object", "properties":
{"x": {"type": "number"}, "y": {"type": "number"}, "z": {"type": "number"}}},
"temperature_c": {"type": "number"}}})";

constexpr const char* kGazeSchema = R"({"type": "object", "title": "foverig.GazeSample",
"description": "angles from straight ahead, right and up; null where an eye was not seen",
"properties": {
"host_ns": {"type": "integer", "description": "mid-exposure on the host's clock"},
"arrival_ns": {"type": "integer"}, "device_ns": {"type": "integer"},
"sequence": {"type": "integer"}, "valid": {"type": "boolean"}, "saccade": {"type": "boolean"},
"gap": {"type": "boolean"},
"left": {"type": "object", "properties": {"right_deg": {"type": "number"},
"up_deg": {"type": "number"}, "blink": {"type": "boolean"}, "openness": {"type": "number"},
"confidence": {"type": "number"}, "pupil_radius_mm": {"type": "number"}}},
"right": {"type": "object", "properties": {"right_deg": {"type": "number"},
"up_deg": {"type": "number"}, "blink": {"type": "boolean"}, "openness": {"type": "number"},
"confidence": {"type": "number"}, "pupil_radius_mm": {"type": "number"}}},
"combined": {"type": "object", "properties": {"right_deg": {"type": "number"},
"up_deg": {"type": "number"}}},
"vergence_distance_m": {"type": "number"}}})";

void put_number(std::string& out, double v) {
    if (std::isfinite(v)) {
        fmt::format_to(std::back_inserter(out), "{}", v);
    } else {
        out += "null";
    }
}

void put(std::string& out, const char* key, double v) {
    out += key;
    put_number(out, v);
}

void put(std::string& out, const char* key, const dvec3& v) {
    out += key;
    put(out, "{\"x\":", v.x);
    put(out, ",\"y\":", v.y);
    put(out, ",\"z\":", v.z);
    out += '}';
}

void put(std::string& out, const char* key, bool v) {
    out += key;
    out += v ? "true" : "false";
}

void put_angles(std::string& out, const GazeRay& ray) {
    const double nan = std::nan("");
    const dvec3& d = ray.direction;
    put(out, "{\"right_deg\":", ray.valid ? glm::degrees(std::atan2(d.x, -d.z)) : nan);
    put(out, ",\"up_deg\":", ray.valid ? glm::degrees(std::atan2(d.y, std::hypot(d.x, d.z))) : nan);
}

void put(std::string& out, const char* key, const GazeEye& eye) {
    out += key;
    put_angles(out, eye.ray);
    put(out, ",\"blink\":", eye.blink);
    put(out, ",\"openness\":", eye.openness);
    put(out, ",\"confidence\":", eye.confidence);
    put(out, ",\"pupil_radius_mm\":", eye.pupil_radius_m * 1e3);
    out += '}';
}

template <class Sample>
void put_times(std::string& out, const Sample& sample) {
    fmt::format_to(std::back_inserter(out),
                   "{{\"host_ns\":{},\"arrival_ns\":{},\"device_ns\":{},\"sequence\":{}",
                   sample.host_time.time_since_epoch().count(),
                   sample.arrival.time_since_epoch().count(),
                   sample.device_time.time_since_epoch().count(), sample.sequence);
}

}  // namespace

RecordedTopic imu_topic() {
    return {.topic = "/dk2/imu",
            .message_encoding = "json",
            .schema_name = "foverig.ImuSample",
            .json_schema = kImuSchema};
}

RecordedTopic gaze_topic() {
    return {.topic = "/gaze/samples",
            .message_encoding = "json",
            .schema_name = "foverig.GazeSample",
            .json_schema = kGazeSchema};
}

void write_json(std::string& out, const ImuSample& sample) {
    out.clear();
    put_times(out, sample);
    put(out, ",\"accel_m_s2\":", sample.accel_m_s2);
    put(out, ",\"gyro_rad_s\":", sample.gyro_rad_s);
    put(out, ",\"temperature_c\":", sample.temperature_c);
    put(out, ",\"gap\":", sample.gap);
    out += '}';
}

void write_json(std::string& out, const GazeSample& sample) {
    out.clear();
    put_times(out, sample);
    put(out, ",\"valid\":", sample.valid);
    put(out, ",\"saccade\":", sample.saccade);
    put(out, ",\"gap\":", sample.gap);
    put(out, ",\"left\":", sample.left);
    put(out, ",\"right\":", sample.right);
    out += ",\"combined\":";
    put_angles(out, sample.combined);
    put(out, "},\"vergence_distance_m\":", sample.vergence_distance_m);
    out += '}';
}

}  // namespace foverig
