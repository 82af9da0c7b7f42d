#include "rig/records/vsync_count.h"

namespace foverig {

VsyncCount count_vsyncs(const std::vector<FrameRecord>& frames) {
    VsyncCount count;
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    for (const FrameRecord& frame : frames) {
        ++count.rendered;
        if (frame.late()) ++count.late;
        if (frame.dropped()) {
            ++count.dropped;
            continue;
        }
        if (frame.mis_presented) ++count.mis_presented;
        if (count.presented++ == 0) first = *frame.shown_vsync;
        last = *frame.shown_vsync;
    }
    if (count.presented > 0) count.total = last - first + 1;
    count.missed = count.total - count.presented;
    return count;
}

}  // namespace foverig
