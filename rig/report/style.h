#pragma once

namespace foverig::report {

/// The page's style sheet: colours as variables, once for light and once for dark.
extern const char* const kStyle;

}  // namespace foverig::report
