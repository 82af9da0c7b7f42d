#pragma once
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "devices/camera/rgb_image.h"

#include <jpeglib.h>

namespace foverig::test {

/// As a camera's: 4:2:2, quality 95.
inline std::vector<std::byte> jpeg_of(const camera::RgbImage& image) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &memory, &size);
    jpeg.image_width = static_cast<JDIMENSION>(image.width_px);
    jpeg.image_height = static_cast<JDIMENSION>(image.height_px);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 95, TRUE);
    jpeg.comp_info[0].v_samp_factor = 1;
    jpeg_start_compress(&jpeg, TRUE);
    std::vector<JSAMPLE> row(static_cast<std::size_t>(3 * image.width_px));
    for (int y = 0; y < image.height_px; ++y) {
        std::copy_n(image.bytes.data() + static_cast<std::size_t>(y) * row.size(), row.size(),
                    row.begin());
        JSAMPROW rows = row.data();
        jpeg_write_scanlines(&jpeg, &rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    const auto* bytes = reinterpret_cast<const std::byte*>(memory);
    std::vector<std::byte> all(bytes, bytes + size);
    std::free(memory);
    return all;
}

}  // namespace foverig::test
