#include "devices/hardware/keep_alive_pace.h"

namespace foverig::hardware {

bool KeepAlivePace::due(HostTime now) const {
    return now - last_taken_ >= period_ && now - last_refused_ >= period_ && !patience_.spent(now);
}

void KeepAlivePace::keep_alive_taken(HostTime now) {
    taken(now);
    lost_before_ = false;
    patience_.answered();
}

void KeepAlivePace::keep_alive_failed(HostTime asked, HostTime now) {
    if (now - asked <= Patience::kLong) {
        last_refused_ = now;
        return;
    }
    if (lost_before_) patience_.failed(asked, now);
    lost_before_ = true;
}

}  // namespace foverig::hardware
