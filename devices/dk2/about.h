#pragma once
// What a headset says of itself, for a person: who it is, how it was made, what it has stored, and
// what another program left in it.
#include <string>
#include <vector>

#include "devices/dk2/feature_reports.h"
#include "devices/dk2/identity_reports.h"
#include "devices/transport.h"

namespace foverig::dk2 {

struct About {
    std::string serial, uuid;
    std::vector<ManufacturingReport> stages;  ///< that were recorded, in their order
    int mag_calibration = 0;                  ///< version; 0: none
    RangeReport range;                        ///< as it is now
    RegisterReport written;                   ///< the last register that a program wrote, if any
};

/// By GETs alone: nothing is set. Errors: what the transport says of the first report that fails.
Result<About> read_about(Transport& transport);

/// One line. What differs from the firmware's own settings is told with what undoes it.
std::string text_of(const About& about);

}  // namespace foverig::dk2
