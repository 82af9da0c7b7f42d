#include "simulators/motion/catalog.h"

#include <fmt/format.h>

#include <array>

#include "simulators/motion/look_head.h"
#include "simulators/motion/recorded_eye.h"
#include "simulators/motion/recorded_head.h"
#include "simulators/motion/scan_eye.h"
#include "simulators/motion/simple_heads.h"
#include "simulators/motion/target_eye.h"

namespace foverig::motion {
namespace {

constexpr std::array<MotionInfo, 5> kHeads{{
    {"still", "the head rests, looking straight ahead"},
    {"look", "head shifts of 25 degrees (median) between pauses, and a little noise"},
    {"stress", "yaw swings by 5.5 degrees five times a second (173 deg/s)"},
    {"extreme", "yaw swings by 11 degrees five times a second (346 deg/s); one knock of 6 g"},
    {"step", "one turn of 10 degrees in 0.1 s, one second from the start"},
}};

constexpr std::array<MotionInfo, 4> kEyes{{
    {"still", "the eyes rest, looking straight ahead"},
    {"scan", "fixations, saccades, micro-saccades and drift within 20 degrees"},
    {"pursuit", "the eyes follow a moving target, late and with catch-up saccades"},
    {"target", "the eyes are always on a moving target"},
}};

bool is_file(std::string_view name) {
    return name.ends_with(".csv");
}

Error unknown(const std::string& name, std::span<const MotionInfo> known) {
    std::string names;
    for (const MotionInfo& info : known) names += fmt::format("{}, ", info.name);
    return {ErrorCode::not_found,
            fmt::format("there is no motion '{}'; expected {}or the path of a .csv trajectory",
                        name, names)};
}

template <class Base, class T>
Result<std::unique_ptr<Base>> boxed(Result<T> loaded) {
    if (!loaded) return loaded.error();
    return std::unique_ptr<Base>(std::make_unique<T>(std::move(loaded).value()));
}

}  // namespace

std::span<const MotionInfo> head_motions() {
    return kHeads;
}
std::span<const MotionInfo> eye_motions() {
    return kEyes;
}

Result<std::unique_ptr<HeadMotion>> make_head(const std::string& name, std::uint64_t seed) {
    using Head = std::unique_ptr<HeadMotion>;
    if (name == "still") return Head(std::make_unique<StillHead>());
    if (name == "look") return Head(std::make_unique<LookHead>(seed));
    if (name == "stress") return Head(std::make_unique<ShakeHead>(ShakeHead::stress()));
    if (name == "extreme") return Head(std::make_unique<ShakeHead>(ShakeHead::extreme()));
    if (name == "step") return Head(std::make_unique<StepHead>());
    if (is_file(name)) return boxed<HeadMotion>(RecordedHead::load(name));
    return unknown(name, kHeads);
}

Result<std::unique_ptr<EyeMotion>> make_eye(const std::string& name, std::uint64_t seed) {
    using Eye = std::unique_ptr<EyeMotion>;
    if (name == "still") return Eye(std::make_unique<StillEye>());
    if (name == "scan") return Eye(std::make_unique<ScanEye>(seed));
    if (name == "pursuit") return Eye(std::make_unique<PursuitEye>(seed));
    if (name == "target") return Eye(std::make_unique<TargetEye>(seed));
    if (is_file(name)) return boxed<EyeMotion>(RecordedEye::load(name));
    return unknown(name, kEyes);
}

}  // namespace foverig::motion
