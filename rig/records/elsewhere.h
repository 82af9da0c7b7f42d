#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace foverig {

/// Of the processors that others had of the machine while a run went on: from a tenth of one on its
/// times may be theirs, too. Less is what an idle system does beside it. Our own rule.
inline constexpr double kElsewhereMatters_processors = 0.1;

/// How many processors other programs and other guests of the machine's host had while a run went
/// on; no value where its summary does not tell.
std::optional<double> elsewhere_processors(const nlohmann::json& summary);

/// "1.5 of 2 processors: 0.6 to other guests of its host, 0.9 to other programs"; empty where it is
/// too little to matter, or not known.
std::string elsewhere_text(const nlohmann::json& summary);

}  // namespace foverig
