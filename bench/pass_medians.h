#pragma once
#include <map>
#include <string>
#include <vector>

#include "bench/report_json.h"
#include "bench/statistics.h"
#include "devices/time.h"
#include "renderer/renderer.h"
#include "rig/identity/processor_use.h"

namespace foverig::bench {

/// Renders with one renderer and keeps medians of its frame and pass times.
class PassMedians {
  public:
    FrameStats render(Renderer& renderer, const FrameInput& input) {
        const auto before = process_time();
        FrameStats stats = renderer.render(input);
        cpu_ms_.push_back(to_ms(process_time() - before));
        frame_ms_.push_back(stats.render_ms);
        double sum = 0.0;
        for (const PassTime& pass : stats.passes) {
            passes_ms_[pass.name].push_back(pass.ms);
            sum += pass.ms;
        }
        outside_ms_.push_back(stats.render_ms - sum);
        return stats;
    }

    double frame_ms() const { return median(frame_ms_); }
    /// Processor time of all threads: what a frame costs whoever else is using the machine.
    double cpu_ms() const { return median(cpu_ms_); }
    /// 0 for a pass that never ran.
    double pass_ms(const std::string& name) const {
        const auto found = passes_ms_.find(name);
        return found == passes_ms_.end() ? 0.0 : median(found->second);
    }

    /// Every pass, and "outside_passes": queueing, scheduling, waiting for the last tile.
    Json passes() const {
        Json all = Json::object();
        for (const auto& [name, ms] : passes_ms_) all[name] = median(ms);
        all["outside_passes"] = median(outside_ms_);
        return all;
    }

  private:
    std::vector<double> frame_ms_;
    std::vector<double> cpu_ms_;
    std::vector<double> outside_ms_;
    std::map<std::string, std::vector<double>> passes_ms_;
};

}  // namespace foverig::bench
