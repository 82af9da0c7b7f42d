// libFuzzer target: any bytes as a camera's frame, Motion JPEG above all, to the picture that a
// window shows. What comes out must be an error or a picture of the header's size of which the
// frame said every byte. scripts/fuzz runs it.
#include <algorithm>
#include <cstdlib>

#include "devices/camera/rgb_image.h"

namespace foverig {
namespace {

/// The picture on memory that held `before`, as that of an older frame; none where it is refused.
std::vector<std::uint8_t> picture(const camera::FrameHeader& header, Bytes packet,
                                  std::uint8_t before) {
    camera::RgbImage image;
    image.bytes.assign(std::size_t{3} * header.width_px * header.height_px, before);
    if (!camera::to_rgb(header, packet, image)) return {};
    if (image.width_px != header.width_px || image.height_px != header.height_px ||
        image.bytes.size() != std::size_t{3} * header.width_px * header.height_px)
        std::abort();
    return std::move(image.bytes);
}

}  // namespace

int fuzz_jpeg(const std::uint8_t* data, std::size_t size) {
    const Bytes packet(reinterpret_cast<const std::byte*>(data), size);
    const auto header = camera::decode_any_header(packet);
    if (!header) return 0;
    camera::RgbImage fresh;
    const bool good = static_cast<bool>(camera::to_rgb(*header, packet, fresh));
    // More than that takes a second each and shows nothing new.
    if (!good || fresh.bytes.size() > std::size_t{1} << 20) return 0;
    if (picture(*header, packet, 0) != picture(*header, packet, 255)) std::abort();
    return 0;
}

}  // namespace foverig

#if defined(FOVERIG_FUZZER)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return foverig::fuzz_jpeg(data, size);
}
#endif
