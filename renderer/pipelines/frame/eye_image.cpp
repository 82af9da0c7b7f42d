#include "renderer/pipelines/frame/eye_image.h"

namespace foverig {

Image image_of(View<const Half4> halves, const TileGrid& grid) {
    Image image;
    image.width_px = grid.width_px;
    image.height_px = grid.height_px;
    image.pixels.resize(static_cast<std::size_t>(grid.width_px) *
                        static_cast<std::size_t>(grid.height_px));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = vec3(unpack_half4(halves[i]));
    return image;
}

}  // namespace foverig
