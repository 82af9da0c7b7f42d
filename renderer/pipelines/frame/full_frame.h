#pragma once
// The `full` pipeline where a pass takes the whole frame at once: every pixel of both eyes. Its
// image is that of FullRenderer. `Backend`: see frame_shading.h.
#include <vector>

#include "renderer/kernels/compose.h"
#include "renderer/pipelines/frame/frame_shading.h"

namespace foverig {

template <class Backend>
class FullFrame {
    template <class T>
    using Array = typename Backend::template Array<T>;

  public:
    /// Borrows all; `backend` holds `scene` at the time of every frame.
    FullFrame(Backend& backend, const Scene& scene, const RenderSettings& settings,
              const EffectPlan& plan, EffectMemory& memory)
        : backend_(backend),
          plan_(plan),
          memory_(memory),
          shading_(backend, scene, settings, plan, memory) {}

    /// Queues the passes of one frame; image() waits for them. The gaze is of no use here.
    void render(const std::vector<EyeInput>& eyes, std::uint32_t frame) {
        FrameEyes views;
        views.count = static_cast<int>(eyes.size());
        for (std::size_t i = 0; i < kMostEyes; ++i)
            views.view[i] = eyes[i < eyes.size() ? i : 0].view;
        each_ = views.view[0].width_px * views.view[0].height_px;
        const bool as_before = reserve(static_cast<std::size_t>(each_ * views.count));
        shading_.draw_samples(frame);
        backend_.frame(as_before, [&] { passes(views); });
    }

    /// Of one eye, row by row from the top; w is 0.
    View<const Half4> image(int eye) const {
        const auto n = static_cast<std::size_t>(each_);
        return {image_.data() + static_cast<std::size_t>(eye) * n, n};
    }
    FrameShading<Backend>& shading() { return shading_; }
    const FrameShading<Backend>& shading() const { return shading_; }

  private:
    bool reserve(std::size_t pixels) {
        const bool as_before = shading_.reserve(pixels);
        if (!as_before) {
            pixels_ = {};
            image_ = {};
            pixels_ = Array<PackedPixel>(memory_.base(), pixels);
            image_ = Array<Half4>(memory_.base(), pixels);
        }
        return as_before;
    }

    void passes(const FrameEyes& eyes) {
        const auto n = static_cast<std::size_t>(each_);
        const auto queue = [&](std::uint32_t eye) {
            return QueuePixels{
                eyes.view[0].width_px, eyes.view[0].height_px, {pixels_.data() + eye * n, n}, eye};
        };
        const QueueSize all{each_ * eyes.count};
        backend_.launch("queue_pixels", all, EachEye<QueuePixels>{{queue(0), queue(1)}, each_});
        shading_.shade(all, std::as_const(pixels_).view(), eyes, vec2(0.0F));
        const auto run = [&]<bool kOcclusion, bool kLight>() {
            using Kernel = ComposePixels<kOcclusion, kLight>;
            const auto of_eye = [&](std::size_t eye) {
                return Kernel{shading_.surfaces(),
                              std::as_const(pixels_).view(),
                              shading_.slots(),
                              shading_.scene().ambient,
                              shading_.scene().background,
                              {image_.data() + eye * n, n},
                              eyes.view[0].width_px,
                              shading_.numerics()};
            };
            backend_.launch("compose", all,
                            EyeOfPixel<Kernel>{{of_eye(0), of_eye(1)}, pixels_.data()});
        };
        if (plan_.on(Effect::ambient_occlusion)) return run.template operator()<true, true>();
        if (plan_.on(Effect::light_buffer)) return run.template operator()<false, true>();
        run.template operator()<false, false>();
    }

    Backend& backend_;
    const EffectPlan& plan_;
    EffectMemory& memory_;
    FrameShading<Backend> shading_;
    int each_ = 0;  ///< pixels of an eye
    Array<PackedPixel> pixels_;
    Array<Half4> image_;
};

}  // namespace foverig
