#pragma once
// Motions by name, as scenarios ask for them.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "devices/result.h"
#include "simulators/motion/eye_motion.h"
#include "simulators/motion/head_motion.h"

namespace foverig::motion {

struct MotionInfo {
    std::string_view name;
    std::string_view meaning;
};

std::span<const MotionInfo> head_motions();
std::span<const MotionInfo> eye_motions();

/// A model's name, or the path of a trajectory, which ends in .csv.
Result<std::unique_ptr<HeadMotion>> make_head(const std::string& name, std::uint64_t seed);
Result<std::unique_ptr<EyeMotion>> make_eye(const std::string& name, std::uint64_t seed);

}  // namespace foverig::motion
