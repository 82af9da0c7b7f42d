#pragma once
// Which other programs have a device's node open: two that use one headset set it up against each
// other, and the kernel does not say who has what.
#include <string>
#include <vector>

#include "devices/result.h"

namespace foverig::hardware {

struct Holder {
    int pid = 0;
    std::string name;
};

/// Other processes that have `path` open, as far as this user may see: those of other users only
/// root sees.
std::vector<Holder> holders_of(const std::string& path, const std::string& proc = "/proc");

/// ErrorCode::busy: who has it where that is seen, and what to do.
Error busy(const std::string& path, const std::vector<Holder>& holders);
inline Error busy(const std::string& path) {
    return busy(path, holders_of(path));
}

}  // namespace foverig::hardware
