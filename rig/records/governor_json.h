#pragma once
#include <nlohmann/json.hpp>

#include "rig/records/run_record.h"

namespace foverig {

/// What a run's governor did: {error_name, limit_ms, changes, error_paid, error_dearest, settings
/// [{settings, ms, error, frames}]}. error_paid is the mean over the frames of what their setting
/// was measured to be off the reference, error_dearest that of the dearest setting; null where no
/// sweep has measured them. Null without a governor.
nlohmann::json governor_json(const RunRecord& run);

}  // namespace foverig
