#pragma once
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "bench/report_json.h"
#include "bench/statistics.h"
#include "renderer/renderer.h"

namespace foverig::bench {

/// Renders with one renderer and keeps medians of its frame and pass times.
class PassMedians {
  public:
    FrameStats render(Renderer& renderer, const FrameInput& input) {
        const double before_ms = process_cpu_ms();
        FrameStats stats = renderer.render(input);
        cpu_ms_.push_back(process_cpu_ms() - before_ms);
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
    static double process_cpu_ms() {
        timespec t{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
    }

    std::vector<double> frame_ms_;
    std::vector<double> cpu_ms_;
    std::vector<double> outside_ms_;
    std::map<std::string, std::vector<double>> passes_ms_;
};

}  // namespace foverig::bench
