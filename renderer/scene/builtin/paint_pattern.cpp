#include "renderer/scene/builtin/noise.h"
#include "renderer/scene/builtin/painters.h"

namespace foverig::builtin {

Canvas paint_checker(std::uint32_t size_px, int squares, const vec3& light, const vec3& dark) {
    const auto count = static_cast<float>(squares);
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        const int parity = static_cast<int>(uv.x * count) + static_cast<int>(uv.y * count);
        return vec4{parity % 2 == 0 ? light : dark, 1.0F};
    });
}

Canvas paint_noise(std::uint32_t size_px, int cells, float contrast, std::uint32_t seed) {
    return paint_canvas(size_px, size_px, [&](vec2 uv) {
        return vec4{vec3{0.5F + contrast * fractal_noise(uv, cells, 6, seed)}, 1.0F};
    });
}

}  // namespace foverig::builtin
