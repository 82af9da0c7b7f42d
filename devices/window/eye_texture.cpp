#include "devices/window/eye_texture.h"

namespace foverig::window {

EyeTexture::EyeTexture() {
    set_up();
}

void EyeTexture::set_up() {
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D, axis, GL_CLAMP_TO_EDGE);
}

void EyeTexture::fill(const EyePicture& picture) {
    glBindTexture(GL_TEXTURE_2D, texture_.name());
    if (picture.width_px != width_px_ || picture.height_px != height_px_) {
        width_px_ = picture.width_px;
        height_px_ = picture.height_px;
        texture_ =
            GlTexture();  // whoever registered the old one must not meet its name at another size
        set_up();
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, width_px_, height_px_, 0, GL_RGBA, GL_HALF_FLOAT,
                     nullptr);
    }
    if (picture.copy_to_texture && picture.copy_to_texture(texture_.name())) return;
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_px_, height_px_, GL_RGBA, GL_HALF_FLOAT,
                    picture.half_rgba().data());
}

}  // namespace foverig::window
