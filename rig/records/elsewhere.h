#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace foverig {

/// Less of a machine's processor time elsewhere moves no time by more than `compare` calls a
/// difference (3 %, its default threshold).
inline constexpr double kElsewhereMatters_ratio = 0.03;

/// Share of the machine's processor time that other programs and other guests of its host had while
/// a run went on; no value where its summary does not tell.
std::optional<double> elsewhere_ratio(const nlohmann::json& summary);

/// "31 % to other guests of its host, 5 % to other programs"; empty where it is too little to
/// matter, or not known.
std::string elsewhere_text(const nlohmann::json& summary);

}  // namespace foverig
