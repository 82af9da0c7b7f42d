#pragma once
#include <map>
#include <string>
#include <vector>

#include "bench/report_json.h"
#include "bench/statistics.h"
#include "renderer/renderer.h"

namespace foverig::bench {

/// Collects the frames of one renderer and gives medians of frame and pass times.
class PassMedians {
  public:
    void add(const FrameStats& stats) {
        frame_ms_.push_back(stats.render_ms);
        double sum = 0.0;
        for (const PassTime& pass : stats.passes) {
            passes_ms_[pass.name].push_back(pass.ms);
            sum += pass.ms;
        }
        outside_ms_.push_back(stats.render_ms - sum);
    }

    double frame_ms() const { return median(frame_ms_); }
    /// 0 for a pass that never ran.
    double pass_ms(const std::string& name) const {
        const auto found = passes_ms_.find(name);
        return found == passes_ms_.end() ? 0.0 : median(found->second);
    }
    const std::vector<double>& frames_ms() const { return frame_ms_; }

    /// Every pass, and "outside_passes": queueing, scheduling, waiting for the last tile.
    Json passes() const {
        Json all = Json::object();
        for (const auto& [name, ms] : passes_ms_) all[name] = median(ms);
        all["outside_passes"] = median(outside_ms_);
        return all;
    }

  private:
    std::vector<double> frame_ms_;
    std::vector<double> outside_ms_;
    std::map<std::string, std::vector<double>> passes_ms_;
};

}  // namespace foverig::bench
