#pragma once
#include <optional>
#include <string>

namespace foverig {

/// What this program was built from; every report carries it.
struct BuildInfo {
    std::string version;
    std::optional<std::string> git;  ///< commit, with -dirty; absent outside a checkout
    std::string compiler;
    std::string flags;
    std::string build_type;  ///< Release, Debug, ...
    std::string fp_mode;     ///< fast: contraction allowed (DESIGN, floating-point modes)
};

BuildInfo build_info();

}  // namespace foverig
