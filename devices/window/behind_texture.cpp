#include "devices/window/behind_texture.h"

namespace foverig::window {

BehindTexture::BehindTexture() {
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, axis, GL_CLAMP_TO_BORDER);
}

void BehindTexture::fill(const BehindPicture& picture) {
    half_tangents_ = {picture.tan_half_width,
                      picture.tan_half_width * picture.height_px / picture.width_px};
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
