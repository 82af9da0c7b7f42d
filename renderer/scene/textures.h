#pragma once
#include "renderer/scene/image_decode.h"
#include "renderer/scene/imported.h"

namespace foverig::scene_import {

struct TextureUse {
    bool repeat_u = true;
    bool repeat_v = true;
    bool alpha = false;  ///< false: the material is opaque, whatever the image's alpha says
};

/// Appends the image and its whole mip chain to the scene's texels and gives the texture's index.
/// Each level is the average of the one above in linear light over the exact footprint; colour is
/// weighted by alpha so that what a hole hides does not bleed into its rim.
std::int32_t append_texture(ImportedScene& imported, const RgbaImage& image, const TextureUse& use,
                            const ImportContext& context);

/// `colour` with the coverage of `mask` as its alpha: the mask's own alpha, else its luminance.
RgbaImage with_alpha_of(RgbaImage colour, const RgbaImage& mask);

}  // namespace foverig::scene_import
