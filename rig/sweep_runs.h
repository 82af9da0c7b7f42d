#pragma once
// The runs of a sweep, one at a time, each with a renderer of its own.
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "renderer/renderer.h"
#include "rig/sweep/definition.h"
#include "rig/sweep/records.h"
#include "rig/sweep/reference_images.h"

namespace foverig {

class SweepRuns {
  public:
    /// What ends a run before its time.
    struct Stopped {};

    struct Hooks {
        std::function<bool()> stop_requested;
        std::function<void(const std::string&)> note;  ///< of what takes long
    };

    /// `program` is a digest of the program. References are kept in a folder of `folder`. `sweep`
    /// outlives this.
    SweepRuns(const sweep::Sweep& sweep, const std::filesystem::path& folder, std::string program,
              Hooks hooks);

    /// Throw Stopped.
    sweep::Accuracy accuracy(std::size_t point);
    sweep::Times times(std::size_t point, int repetition);

  private:
    /// What points have in common that differ in the renderer's settings alone.
    struct Stage {
        std::string key;
        std::shared_ptr<const Scene> scene;
        std::vector<sweep::FlownFrame> flight;
    };
    const Stage& stage_of(const Scenario& scenario);
    sweep::ReferenceImages references_of(const Stage& stage, const RenderSettings& reference);
    /// What went before is another place of the flight.
    bool begins_stretch(std::size_t frame) const;
    bool is_warm(std::size_t frame) const;
    /// Of the warm-ups the first alone is kept in the records.
    bool is_kept(std::size_t frame) const;
    double warm_frames(const Stage& stage) const;
    void check_stop() const;

    const sweep::Sweep& sweep_;
    std::filesystem::path folder_;
    std::string program_;
    Hooks hooks_;
    Stage stage_;  ///< the last one
};

}  // namespace foverig
