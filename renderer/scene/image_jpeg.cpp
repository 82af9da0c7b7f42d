#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <string>

#include <jpeglib.h>

#include "renderer/scene/image_decode.h"

namespace foverig::scene_import {
namespace {

/// libjpeg reports errors by a call that must not return.
struct JpegErrors {
    jpeg_error_mgr manager{};
    std::jmp_buf back{};
    char text[JMSG_LENGTH_MAX] = {};
};

void on_error(j_common_ptr info) {
    auto* errors = reinterpret_cast<JpegErrors*>(info->err);
    info->err->format_message(info, errors->text);
    std::longjmp(errors->back, 1);
}

void on_message(j_common_ptr /*info*/) {}

/// A progressive file may hold thousands of scans, each of which costs a pass over the image.
void on_progress(j_common_ptr info) {
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= 200) return;
    auto* errors = reinterpret_cast<JpegErrors*>(info->err);
    std::strcpy(errors->text, "more than 200 scans");
    std::longjmp(errors->back, 1);
}

/// No object with a destructor may live here: longjmp passes over them.
bool read_rows(jpeg_decompress_struct& jpeg, JpegErrors& errors, std::uint32_t* pixels) {
    if (setjmp(errors.back) != 0) return false;
    jpeg.out_color_space = JCS_EXT_RGBA;
    jpeg_start_decompress(&jpeg);
    while (jpeg.output_scanline < jpeg.output_height) {
        auto* row = reinterpret_cast<JSAMPROW>(pixels + std::size_t{jpeg.output_scanline} *
                                                            jpeg.output_width);
        jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
    return true;
}

bool read_header(jpeg_decompress_struct& jpeg, JpegErrors& errors, std::string_view bytes) {
    if (setjmp(errors.back) != 0) return false;
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()),
                 static_cast<unsigned long>(bytes.size()));
    return jpeg_read_header(&jpeg, TRUE) == JPEG_HEADER_OK;
}

struct JpegGuard {
    jpeg_decompress_struct& jpeg;
    ~JpegGuard() { jpeg_destroy_decompress(&jpeg); }
};

}  // namespace

RgbaImage decode_jpeg(std::string_view bytes, std::uint64_t max_px) {
    JpegErrors errors;
    jpeg_decompress_struct jpeg{};
    jpeg.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = on_error;
    errors.manager.output_message = on_message;
    jpeg_progress_mgr progress{};
    progress.progress_monitor = on_progress;

    const JpegGuard guard{jpeg};
    if (!read_header(jpeg, errors, bytes))
        throw ImageError(std::string("is a JPEG that libjpeg rejects (") + errors.text + ")");
    jpeg.progress = &progress;
    // Huffman codes spend at least a bit on each of an 8 x 8 block's planes; progressive ones less.
    check_image_size(jpeg.image_width, jpeg.image_height, max_px, bytes.size(), 64 * 64);
    if (jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK)
        throw ImageError("is a CMYK JPEG; convert it to RGB");
    RgbaImage image{jpeg.image_width, jpeg.image_height, false, {}};
    image.pixels.resize(std::size_t{image.width} * image.height);
    if (!read_rows(jpeg, errors, image.pixels.data()))
        throw ImageError(std::string("is a JPEG that libjpeg rejects (") + errors.text + ")");
    return image;
}

}  // namespace foverig::scene_import
