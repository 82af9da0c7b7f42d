#include "renderer/pipelines/frame/eyes_apart.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <stdexcept>

namespace foverig {
namespace {

void add(FrameStats& sum, const FrameStats& eye) {
    sum.rays.primary += eye.rays.primary;
    sum.rays.shadow += eye.rays.shadow;
    sum.rays.ao += eye.rays.ao;
    sum.rays.reflection += eye.rays.reflection;
    sum.rays.probe += eye.rays.probe;
    sum.rays.vpl += eye.rays.vpl;
    sum.sampled_pixels += eye.sampled_pixels;
    sum.all_pixels += eye.all_pixels;
    sum.numerics.nan += eye.numerics.nan;
    sum.numerics.inf += eye.numerics.inf;
    sum.numerics.clamped += eye.numerics.clamped;
    for (const PassTime& pass : eye.passes) {
        const auto known = std::find_if(sum.passes.begin(), sum.passes.end(),
                                        [&](const PassTime& p) { return p.name == pass.name; });
        if (known == sum.passes.end())
            sum.passes.push_back(pass);
        else
            known->ms = std::max(known->ms, pass.ms);
    }
}

}  // namespace

FrameStats EyesApart::render(const FrameInput& input) {
    if (input.eyes.size() > eyes_.size())
        throw std::invalid_argument("a frame has more eyes than there are renderers for them");
    const auto start = std::chrono::steady_clock::now();
    std::vector<std::future<FrameStats>> running;
    for (std::size_t i = 0; i < input.eyes.size(); ++i)
        running.push_back(std::async(std::launch::async, [this, &input, i] {
            return eyes_[i]->render({input.frame, input.time_s, {input.eyes[i]}});
        }));
    for (const auto& eye : running) eye.wait();
    FrameStats sum;
    for (auto& eye : running) add(sum, eye.get());
    sum.render_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return sum;
}

std::string EyesApart::backend_name() const {
    return eyes_.front()->backend_name() + " x " + std::to_string(eyes_.size());
}

std::uint64_t EyesApart::backend_bytes() const {
    std::uint64_t sum = 0;
    for (const auto& eye : eyes_) sum += eye->backend_bytes();
    return sum;
}

}  // namespace foverig
