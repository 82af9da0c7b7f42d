#include "rig/exports/presentmon.h"

#include <fmt/format.h>

namespace foverig::exports {
namespace {

using Time = std::optional<double>;

constexpr const char* kHeader =
    "Application,ProcessID,SwapChainAddress,Runtime,SyncInterval,PresentFlags,Dropped,"
    "TimeInSeconds,msInPresentAPI,msBetweenPresents,AllowsTearing,PresentMode,"
    "msUntilRenderComplete,msUntilDisplayed,msBetweenDisplayChange\n";

/// 0 where an end is absent, as PresentMon 1.x has it: its viewers read numbers.
std::string ms_between(const Time& from_ns, const Time& to_ns) {
    return fmt::format("{:.6f}", from_ns && to_ns ? (*to_ns - *from_ns) * 1e-6 : 0.0);
}

}  // namespace

std::string presentmon_csv(const report::RunData& run) {
    const FrameTable& frames = run.frames;
    const auto present_ns = frames.column("present_ns");
    const auto submit_ns = frames.column("submit_ns");
    const auto vsync_ns = frames.column("vsync_ns");
    std::string csv = kHeader;
    Time present_before, shown_before;
    for (std::size_t i = 0; i < frames.frames; ++i) {
        const Time& present = present_ns[i];
        const Time& vsync = vsync_ns[i];
        if (present_before)  // a present that has none before it is left out there too
            csv += fmt::format(
                "foverig,0,0x0,Other,1,0,{},{:.9f},0.000000,{},0,Hardware: Legacy Flip,{},{},{}\n",
                vsync ? 0 : 1, (present.value_or(0.0) - present_ns[0].value_or(0.0)) * 1e-9,
                ms_between(present_before, present), ms_between(present, submit_ns[i]),
                ms_between(present, vsync), ms_between(shown_before, vsync));
        present_before = present;
        if (vsync) shown_before = vsync;
    }
    return csv;
}

}  // namespace foverig::exports
