#include "devices/camera/jpeg.h"

#include <csetjmp>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>
#include <jpeglib.h>

namespace foverig::camera {
namespace {

/// libjpeg reports errors by a call that must not return.
struct Errors {
    jpeg_error_mgr manager{};
    std::jmp_buf back{};
    char text[JMSG_LENGTH_MAX] = {};
};

void on_error(j_common_ptr info) {
    auto* errors = reinterpret_cast<Errors*>(info->err);
    info->err->format_message(info, errors->text);
    std::longjmp(errors->back, 1);
}

void on_message(j_common_ptr /*info*/) {}

/// A progressive image may hold thousands of scans, each of which costs a pass; a camera's has one.
void on_progress(j_common_ptr info) {
    if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= 10) return;
    auto* errors = reinterpret_cast<Errors*>(info->err);
    std::strcpy(errors->text, "more than 10 scans");
    std::longjmp(errors->back, 1);
}

struct Guard {
    jpeg_decompress_struct& jpeg;
    ~Guard() { jpeg_destroy_decompress(&jpeg); }
};

/// No object with a destructor may live in these two: longjmp passes over them.
bool read_header(jpeg_decompress_struct& jpeg, Errors& errors, Bytes bytes) {
    if (setjmp(errors.back) != 0) return false;
    jpeg_create_decompress(&jpeg);
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(bytes.data()),
                 static_cast<unsigned long>(bytes.size()));
    return jpeg_read_header(&jpeg, TRUE) == JPEG_HEADER_OK;
}

bool read_rows(jpeg_decompress_struct& jpeg, Errors& errors, std::uint8_t* rgb) {
    if (setjmp(errors.back) != 0) return false;
    jpeg.out_color_space = JCS_RGB;
    jpeg.dct_method = JDCT_IFAST;  // a frame is seen for a few milliseconds
    jpeg_start_decompress(&jpeg);
    while (jpeg.output_scanline < jpeg.output_height) {
        JSAMPROW row = rgb + std::size_t{3} * jpeg.output_scanline * jpeg.output_width;
        jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
    return true;
}

Error refused(const std::string& why) {
    return {ErrorCode::invalid_data, "camera frame refused: its JPEG " + why};
}

}  // namespace

Status decode_jpeg(Bytes bytes, RgbImage& image) {
    Errors errors;
    jpeg_decompress_struct jpeg{};
    jpeg.err = jpeg_std_error(&errors.manager);
    errors.manager.error_exit = on_error;
    errors.manager.output_message = on_message;
    jpeg_progress_mgr progress{};
    progress.progress_monitor = on_progress;

    const Guard guard{jpeg};
    if (!read_header(jpeg, errors, bytes)) {
        return refused(fmt::format("is broken ({})", errors.text));
    }
    jpeg.progress = &progress;
    if (static_cast<int>(jpeg.image_width) != image.width_px ||
        static_cast<int>(jpeg.image_height) != image.height_px) {
        return refused(fmt::format("is {} x {}, the camera streams {} x {}", jpeg.image_width,
                                   jpeg.image_height, image.width_px, image.height_px));
    }
    if (jpeg.jpeg_color_space != JCS_YCbCr && jpeg.jpeg_color_space != JCS_GRAYSCALE) {
        return refused("is of a colour space that no camera sends");
    }
    image.bytes.resize(std::size_t{3} * jpeg.image_width * jpeg.image_height);
    if (!read_rows(jpeg, errors, image.bytes.data())) {
        return refused(fmt::format("is broken ({})", errors.text));
    }
    return Done{};
}

}  // namespace foverig::camera
