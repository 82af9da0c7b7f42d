#pragma once
// Packed chunks. MCAP knows none, lz4 and zstd by name (mcap.dev/spec); here are none and zstd.
#include <memory>

#include "devices/recording/mcap.h"
#include "devices/result.h"

struct ZSTD_CCtx_s;

namespace foverig::mcap {

enum class Compression { none, zstd };

inline constexpr const char* kZstd = "zstd";

/// Packs one chunk after the other with zstd's fastest ordinary level.
class ChunkPacker {
  public:
    explicit ChunkPacker(Compression compression);

    /// `chunk` packed, its records in this packer until the next call; as it was where packing is
    /// off or gains nothing.
    Chunk packed(const Chunk& chunk);

  private:
    struct Free {
        void operator()(ZSTD_CCtx_s* context) const;
    };
    std::unique_ptr<ZSTD_CCtx_s, Free> context_;  // null: none
    std::vector<std::byte> buffer_;
};

/// The records of zstd's `packed`, in `buffer`: as many as can be told of what may be cut or
/// damaged, and no more than `most` bytes. Memory grows with what comes out, not with what a file
/// claims.
Bytes unpacked_zstd(Bytes packed, std::uint64_t most, std::vector<std::byte>& buffer);

}  // namespace foverig::mcap
