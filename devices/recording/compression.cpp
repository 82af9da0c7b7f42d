#include "devices/recording/compression.h"

#include <zstd.h>

#include <algorithm>

namespace foverig::mcap {
namespace {

constexpr int kLevel = 1;
constexpr std::size_t kStep = std::size_t{1} << 18;  // by which an unpacked chunk grows

struct FreeStream {
    void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
};

}  // namespace

void ChunkPacker::Free::operator()(ZSTD_CCtx_s* context) const {
    ZSTD_freeCCtx(context);
}

ChunkPacker::ChunkPacker(Compression compression)
    : context_(compression == Compression::zstd ? ZSTD_createCCtx() : nullptr) {}

Chunk ChunkPacker::packed(const Chunk& chunk) {
    if (!context_) return chunk;
    buffer_.resize(ZSTD_compressBound(chunk.records.size()));
    const std::size_t size = ZSTD_compressCCtx(context_.get(), buffer_.data(), buffer_.size(),
                                               chunk.records.data(), chunk.records.size(), kLevel);
    if (ZSTD_isError(size) != 0 || size >= chunk.records.size()) return chunk;
    Chunk packed = chunk;
    packed.compression = kZstd;
    packed.records = Bytes(buffer_).first(size);
    return packed;
}

Bytes unpacked_zstd(Bytes packed, std::uint64_t most, std::vector<std::byte>& buffer) {
    const std::unique_ptr<ZSTD_DStream, FreeStream> stream(ZSTD_createDStream());
    ZSTD_inBuffer in{packed.data(), packed.size(), 0};
    std::size_t done = 0;
    while (done < most) {
        const auto room = static_cast<std::size_t>(std::min<std::uint64_t>(most, done + kStep));
        if (buffer.size() < room) buffer.resize(room);
        ZSTD_outBuffer out{buffer.data() + done, room - done, 0};
        const std::size_t left = ZSTD_decompressStream(stream.get(), &out, &in);
        if (ZSTD_isError(left) != 0) break;
        done += out.pos;
        const bool all_read = in.pos == in.size && out.pos < out.size;
        if (left == 0 || all_read) break;
    }
    return Bytes(buffer).first(done);
}

}  // namespace foverig::mcap
