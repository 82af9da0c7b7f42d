#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "rig/commands.h"

namespace foverig {

/// The options of `foverig compare`.
class CompareOptions {
  public:
    void add_to(CLI::App& app);
    /// Throws UsageError where it is not said which runs are the base and which are new.
    CompareRequest request() const;

  private:
    std::vector<std::string> runs_, against_, allowed_;
    std::string of_ = "frame_time_ms";
    double threshold_percent_ = 3.0;
    bool paired_ = false, json_ = false;
};

}  // namespace foverig
