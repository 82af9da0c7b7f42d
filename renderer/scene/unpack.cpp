#include "renderer/scene/unpack.h"

#if !defined(FOVERIG_STB_ALONE)
#include <zstd.h>
#endif

#include <memory>

#include "renderer/scene/import_error.h"

namespace foverig::scene_import {

bool is_zstd(std::string_view bytes) {
    return bytes.starts_with("\x28\xB5\x2F\xFD");
}

#if defined(FOVERIG_STB_ALONE)

std::string unpack_zstd(std::string_view /*packed*/, const std::filesystem::path& file,
                        std::uint64_t /*max_bytes*/) {
    fail(file, "is packed with zstd, which this build does without; unpack it first: zstd -d");
}

#else

std::string unpack_zstd(std::string_view packed, const std::filesystem::path& file,
                        std::uint64_t max_bytes) {
    const std::size_t most_bytes = kMostTimesLarger * packed.size();
    const std::unique_ptr<ZSTD_DCtx, std::size_t (*)(ZSTD_DCtx*)> context(ZSTD_createDCtx(),
                                                                          ZSTD_freeDCtx);
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    std::string bytes;
    std::size_t expected = 1;  // of the frame under way; 0 at its end
    while (in.pos < in.size || expected > 0) {
        const std::size_t begun = bytes.size();
        bytes.resize(begun + ZSTD_DStreamOutSize());
        ZSTD_outBuffer out{bytes.data() + begun, bytes.size() - begun, 0};
        const std::size_t read = in.pos;
        expected = ZSTD_decompressStream(context.get(), &out, &in);
        bytes.resize(begun + out.pos);
        if (ZSTD_isError(expected) != 0)
            fail(file, "holds damaged zstd data ({}); pack it again", ZSTD_getErrorName(expected));
        if (in.pos == read && out.pos == 0)
            fail(file, "ends within its zstd data, after {} bytes of its content; copy it again",
                 bytes.size());
        if (bytes.size() > max_bytes)
            fail(file, "unpacks to more than the {} bytes that this format can have here",
                 max_bytes);
        if (bytes.size() > most_bytes)
            fail(file,
                 "unpacks to more than {} times its {} bytes; unpack it by hand if it is meant",
                 kMostTimesLarger, packed.size());
    }
    return bytes;
}

#endif

}  // namespace foverig::scene_import
