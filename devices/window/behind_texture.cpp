#include "devices/window/behind_texture.h"

#include <algorithm>

namespace foverig::window {
namespace {

constexpr double kFarthest = 1e6;  // nothing is hidden but what lies behind the camera

BehindTexture::Lens in_shares(const camera::Lens& lens, const dvec2& size_px) {
    return {.focal = glm::vec2(dvec2(lens.fx_px, lens.fy_px) / size_px),
            .centre = glm::vec2((dvec2(lens.cx_px, lens.cy_px) + 0.5) / size_px),
            .bend = {lens.k1, lens.k2, lens.k3, 0.0},
            .tangential = {lens.p1, lens.p2},
            .farthest = static_cast<float>(std::min(lens.fold_tangent(), kFarthest))};
}

BehindTexture::Lens in_shares(const camera::FisheyeLens& lens, const dvec2& size_px) {
    const auto& [fx_px, fy_px, cx_px, cy_px, k] = lens.numbers();
    return {.focal = glm::vec2(dvec2(fx_px, fy_px) / size_px),
            .centre = glm::vec2((dvec2(cx_px, cy_px) + 0.5) / size_px),
            .bend = {k[0], k[1], k[2], k[3]},
            .farthest = static_cast<float>(lens.fold_rad()),
            .fisheye = true};
}

}  // namespace

BehindTexture::BehindTexture() {
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, axis, GL_CLAMP_TO_BORDER);
}

void BehindTexture::fill(const BehindPicture& picture) {
    if (told_ != picture.lens || picture.width_px != width_px_ || picture.height_px != height_px_) {
        const dvec2 size_px(picture.width_px, picture.height_px);
        lens_ =
            std::visit([&](const auto& lens) { return in_shares(lens, size_px); }, picture.lens);
        told_ = picture.lens;
    }
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    if (picture.width_px != width_px_ || picture.height_px != height_px_) {
        width_px_ = picture.width_px;
        height_px_ = picture.height_px;
        glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8, width_px_, height_px_, 0, GL_RGB, GL_UNSIGNED_BYTE,
                     picture.srgb.data());
    } else if (picture.changed) {
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_px_, height_px_, GL_RGB, GL_UNSIGNED_BYTE,
                        picture.srgb.data());
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

}  // namespace foverig::window
