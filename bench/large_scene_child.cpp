#include "bench/large_scene_child.h"

#include <chrono>
#include <iostream>

#include "bench/flight.h"
#include "bench/report_json.h"
#include "renderer/scene/library.h"
#include "rig/identity/host_info.h"

namespace foverig::bench {
namespace {

constexpr double kTownDetail = 16.0;  ///< 6.7 M triangles (renderer/scene/builtin/builtin.cpp)

class Stopwatch {
  public:
    double lap_s() {
        const auto now = std::chrono::steady_clock::now();
        const double s = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return s;
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

int run_large_scene(const std::string& name_or_file) {
    Stopwatch watch;
    auto scene = std::make_shared<const Scene>(name_or_file == "voxel-town"
                                                   ? make_builtin_scene(name_or_file, kTownDetail)
                                                   : load_scene(name_or_file));
    Json row = {{"triangles", scene->triangles.size()}, {"make_s", watch.lap_s()}};
    RenderSettings settings;
    settings.pipeline = "full";
    const auto renderer = make_renderer(scene, settings);
    row["build_s"] = watch.lap_s();
    const FrameStats stats = renderer->render(Flight(*scene).frame(0));
    row["render_s"] = watch.lap_s();
    row["rays"] = stats.rays.total();
    row["nan_or_inf"] = stats.numerics.nan + stats.numerics.inf;
    row["total_s"] =
        row["make_s"].get<double>() + row["build_s"].get<double>() + row["render_s"].get<double>();
    row["peak_rss_gib"] = static_cast<double>(peak_rss_bytes()) / 1073741824.0;
    std::cout << row.dump() << std::endl;
    return 0;
}

}  // namespace foverig::bench
