#pragma once
// Scenes and loads that the bars of the renderer are measured on.
#include <memory>
#include <string>
#include <vector>

#include "bench/options.h"
#include "renderer/renderer.h"

namespace foverig::bench {

/// One kind of light at a time, as in Weier 2016 Table 1.
enum class Load { point, area8, ao16, ao16_short };

const char* name_of(Load load);

struct Case {
    std::shared_ptr<const Scene> scene;
    RenderSettings settings;  ///< medium configuration; the pipeline is the caller's choice
    std::string note;         ///< what stands in for a scene that is not there, or empty
};

/// Names of scenes: "sponza", "sibenik".
const std::vector<std::string>& scene_names();

/// Loads scenes once and hands them out with the lights of a load. A scene whose file is not there
/// is replaced by the built-in atrium.
class SceneShelf {
  public:
    explicit SceneShelf(const Options& options) : options_(options) {}

    Case take(const std::string& name, Load load);

  private:
    const Options& options_;
    std::string name_;  ///< of the scene that is held: one at a time
    std::string note_;
    Scene scene_;
};

}  // namespace foverig::bench
