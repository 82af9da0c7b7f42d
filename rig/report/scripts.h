#pragma once
#include <string_view>

namespace foverig::report {

/// Scripts of the page (rig/report/web), put into the program when it was built. A build that could
/// not fetch uPlot from npm has neither it nor the strip: those strings are empty.
extern const std::string_view kMagnifierScript;
extern const std::string_view kStripScript;
extern const std::string_view kUplotScript;
extern const std::string_view kUplotStyle;
extern const std::string_view kUplotLicence;

}  // namespace foverig::report
