#include "rig/governor/governed_renderer.h"

#include <algorithm>

namespace foverig::governor {
namespace {

std::vector<double> costs_of(const Ladder& ladder) {
    std::vector<double> ms;
    for (const Rung& rung : ladder.rungs) ms.push_back(rung.ms);
    return ms;
}

}  // namespace

Limits limits_of(const Scenario& scenario) {
    return {.limit_ms = (1.0 - scenario.governor.headroom) * 1000.0 / scenario.display.rate_hz,
            .patience_frames = scenario.governor.patience_frames};
}

GovernedRenderer::GovernedRenderer(Ladder ladder, const Limits& limits, const Open& open)
    : ladder_(std::move(ladder)), limits_(limits), governor_(costs_of(ladder_), limits) {
    for (std::size_t i = 0; i < ladder_.rungs.size(); ++i) hold(i, open);
    shown_ = governor_.setting();
}

void GovernedRenderer::hold(std::size_t setting, const Open& open) {
    const RenderSettings& wanted = ladder_.rungs[setting].render;
    const auto able = std::find_if(held_.begin(), held_.end(),
                                   [&](Held& held) { return held.renderer->tune(wanted); });
    held_by_.push_back(static_cast<std::size_t>(able - held_.begin()));
    if (able == held_.end())
        held_.push_back({open(wanted), setting});
    else
        able->setting = setting;
}

FrameStats GovernedRenderer::render(const FrameInput& input) {
    shown_ = governor_.setting();
    chosen_.push_back(static_cast<std::uint32_t>(shown_));
    Held& held = held_[held_by_[shown_]];
    if (held.setting != shown_) held.renderer->tune(ladder_.rungs[shown_].render);
    held.setting = shown_;
    return held.renderer->render(input);
}

double GovernedRenderer::fixed_ms(double dearest_ms) const {
    return dearest_ms * ladder_.rungs[governor_.setting()].ms / ladder_.rungs.back().ms;
}

std::uint64_t GovernedRenderer::backend_bytes() const {
    std::uint64_t bytes = 0;
    for (const Held& held : held_) bytes += held.renderer->backend_bytes();
    return bytes;
}

GovernorRecord GovernedRenderer::record() const {
    GovernorRecord record;
    record.error_name = ladder_.error_name;
    record.limit_ms = limits_.limit_ms;
    for (const Rung& rung : ladder_.rungs)
        record.settings.push_back({rung.text, rung.ms, rung.error});
    return record;
}

}  // namespace foverig::governor
