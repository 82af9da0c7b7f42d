#pragma once
#include "devices/transport.h"

namespace foverig::dk2::detail {

/// One feature report, asked for and decoded.
template <class Report>
Result<Report> get_report(Transport& transport) {
    const auto bytes = transport.control_get(Report::kId, 0, Report::kSize);
    if (!bytes) return bytes.error();
    return Report::decode(*bytes);
}

}  // namespace foverig::dk2::detail
