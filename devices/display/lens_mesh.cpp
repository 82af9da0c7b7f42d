#include "devices/display/lens_mesh.h"

namespace foverig {
namespace {

constexpr int kColumns = Dk2Optics::kEyePanel.width / kLensCell_px;
constexpr int kRows = Dk2Optics::kEyePanel.height / kLensCell_px;

LensVertex vertex_at(Eye eye, const dvec2& ndc, const EyeMap& map) {
    const auto f = [](double v) { return static_cast<float>(v); };
    const dvec2 red = map.tangent(eye, ndc, Channel::red);
    const dvec2 green = map.tangent(eye, ndc, Channel::green);
    const dvec2 blue = map.tangent(eye, ndc, Channel::blue);
    const double panel_x = 0.5 * (ndc.x + (eye == Eye::left ? -1.0 : 1.0));
    return {f(panel_x), f(ndc.y), f(red.x), f(red.y), f(green.x), f(green.y), f(blue.x), f(blue.y)};
}

}  // namespace

LensMesh lens_mesh(Eye eye, const EyeMap& map) {
    LensMesh mesh;
    for (int row = 0; row <= kRows; ++row)
        for (int column = 0; column <= kColumns; ++column)
            mesh.vertices.push_back(
                vertex_at(eye, {2.0 * column / kColumns - 1.0, 2.0 * row / kRows - 1.0}, map));
    for (int row = 0; row < kRows; ++row) {
        for (int column = 0; column < kColumns; ++column) {
            const auto a = static_cast<std::uint32_t>(row * (kColumns + 1) + column);
            const std::uint32_t b = a + 1, c = a + kColumns + 1, d = c + 1;
            for (const std::uint32_t i : {a, b, c, c, b, d}) mesh.indices.push_back(i);
        }
    }
    return mesh;
}

}  // namespace foverig
