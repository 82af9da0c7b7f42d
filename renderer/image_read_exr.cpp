#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <fmt/format.h>

#include <cstring>

#include "renderer/image_formats.h"

namespace foverig::image_formats {
namespace {

class MemoryStream final : public Imf::IStream {
  public:
    explicit MemoryStream(std::string_view bytes) : Imf::IStream("image"), bytes_(bytes) {}

    bool read(char* to, int n) override {
        const auto count = static_cast<std::size_t>(n);
        if (count > bytes_.size() - at_) throw FormatError("is an EXR that is cut off");
        std::memcpy(to, bytes_.data() + at_, count);
        at_ += count;
        return at_ < bytes_.size();
    }
    std::uint64_t tellg() override { return at_; }
    void seekg(std::uint64_t position) override {
        if (position > bytes_.size()) throw FormatError("is an EXR that is cut off");
        at_ = static_cast<std::size_t>(position);
    }

  private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

Image decode(std::string_view bytes) {
    MemoryStream stream(bytes);
    Imf::InputFile file(stream, 1);
    const auto window = file.header().dataWindow();
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    Image image = blank_image(width, height, bytes.size(), 4096);
    const auto& channels = file.header().channels();
    const bool colour = channels.findChannel("R") != nullptr &&
                        channels.findChannel("G") != nullptr &&
                        channels.findChannel("B") != nullptr;
    if (!colour && channels.findChannel("Y") == nullptr)
        throw FormatError("is an EXR without channels R, G, B or Y");
    Imf::FrameBuffer buffer;
    const auto add = [&](const char* name, int component) {
        buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][component], window,
                                             sizeof(vec3), sizeof(vec3) * image.width_px));
    };
    if (colour) {
        add("R", 0);
        add("G", 1);
        add("B", 2);
    } else {
        add("Y", 0);
    }
    file.setFrameBuffer(buffer);
    file.readPixels(window.min.y, window.max.y);
    if (!colour)
        for (vec3& p : image.pixels) p = vec3(p.x);
    return image;
}

}  // namespace

Image decode_exr(std::string_view bytes) {
    try {
        return decode(bytes);
    } catch (const FormatError&) {
        throw;
    } catch (const std::exception& error) {
        throw FormatError(fmt::format("is an EXR that OpenEXR rejects ({})", error.what()));
    }
}

}  // namespace foverig::image_formats
