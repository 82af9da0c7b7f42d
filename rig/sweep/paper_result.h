#pragma once
#include <nlohmann/json.hpp>

namespace foverig::sweep {

/// A paper's numbers beside ours: {source, conditions, baseline, stages[], rows[{case, variant,
/// point, theirs, ours, speed_up, ray_cut}]}. `theirs` and `ours` are {ms, mrays, stages_ms[]}, and
/// `read`, `ms_error` of theirs, `ci95` of ours; theirs is null where the paper says nothing.
/// speed_up and ray_cut are {theirs, ours} against the baseline variant of the same case; ours with
/// ci95: Student's t of the ratios of runs of one repetition. `definition` is header.h's, `points`
/// are pareto.json's.
nlohmann::ordered_json paper_json(const nlohmann::json& definition,
                                  const nlohmann::ordered_json& points);

}  // namespace foverig::sweep
