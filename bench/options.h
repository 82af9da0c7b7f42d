#pragma once
#include <filesystem>
#include <string>

namespace foverig::bench {

/// What the command line may change; defaults give the whole suite in less than eight minutes on
/// two quiet cores.
struct Options {
    std::filesystem::path results;                      ///< folder for JSON; empty: none is written
    std::filesystem::path scenes = "../shared/scenes";  ///< where sponza/, sibenik/, kitchen/ are
    int frames = 12;              ///< measured frames of each flight whose speed is compared
    int repetitions = 7;          ///< of each side of a comparison with bare Embree
    int error_frames = 300;       ///< consecutive frames of a flight whose error is measured
    int error_stride = 10;        ///< of those, compare every n-th where light is sampled at random
    int compared_mrays = 10;      ///< millions of rays a scene that two tracers must agree on
    bool robust = true;           ///< watertight tracing, on both sides of every comparison
    std::string devices = "sim";  ///< or "hardware": of the suites latency and vsync
};

}  // namespace foverig::bench
