#pragma once
#include <string>
#include <string_view>

namespace foverig {

/// Tells contents apart: 32 hexadecimal digits (FNV-1a, 128 bits; Fowler, Noll and Vo). Nobody is
/// kept from making two texts of one digest on purpose.
class Digest {
  public:
    Digest& add(std::string_view bytes);
    std::string hex() const;

  private:
    unsigned __int128 hash_ =
        (static_cast<unsigned __int128>(0x6c62272e07bb0142u) << 64) | 0x62b821756295c58du;
};

}  // namespace foverig
