#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace foverig::sweep {

/// Speed-up and ray cut of every case and variant but the baseline: the paper's beside ours, static
/// SVG. Of paper_result.h's JSON.
std::string paper_chart(const nlohmann::json& paper);

/// Style of its marks, and their legend.
extern const char* const kPaperStyle;
std::string paper_legend();

}  // namespace foverig::sweep
