#include "devices/hardware/patience.h"

#include <fmt/format.h>

#include <algorithm>

namespace foverig::hardware {

std::optional<Error> Patience::spent(HostTime now) const {
    if (now >= rests_until_) return std::nullopt;
    return Error{ErrorCode::not_asked,
                 fmt::format("the device let a request run out of time and is asked nothing for "
                             "another {:.1f} s; plug it in again",
                             to_seconds(rests_until_ - now))};
}

void Patience::failed(HostTime asked, HostTime now) {
    if (now - asked <= kLong) return;
    rests_until_ = now + kRests[std::min(in_vain_, kRests.size() - 1)] * (now - asked);
    ++in_vain_;
}

}  // namespace foverig::hardware
