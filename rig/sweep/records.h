#pragma once
// What is measured of a point. Frames are those of the flight, in their order, warm-up included.
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace foverig::sweep {

/// The errors of a frame, means of its eyes (docs/sweeps.md). `fvvdp` is there where a sweep asks
/// for it alone.
const std::vector<std::string>& error_names();

/// One run that nobody timed.
struct Accuracy {
    std::size_t point = 0;
    std::map<std::string, std::vector<double>> errors;  ///< by name, a frame each
    std::map<std::string, double> rays;                 ///< by kind, means beyond the warm-up
    double sampled_pixel_ratio = 0.0;                   ///< traced primary pixels / all, the same
    std::optional<std::uint64_t> backend_bytes;         ///< none at fixed cost: it varies a little
    std::uint64_t nan = 0;
};

/// One run that nothing else was done in.
struct Times {
    std::size_t point = 0;
    int repetition = 0;
    std::vector<double> frame_ms;                  ///< renderer and lens distortion, wall time
    std::map<std::string, double> pass_ms;         ///< by name, means beyond the warm-up
    std::optional<double> elsewhere_processors{};  ///< others had meanwhile; none: not known
};

nlohmann::json to_json(const Accuracy& accuracy);
nlohmann::json to_json(const Times& times);

/// Throw nlohmann::json::exception where it is not one.
Accuracy accuracy_from(const nlohmann::json& json);
Times times_from(const nlohmann::json& json);

}  // namespace foverig::sweep
