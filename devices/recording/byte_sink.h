#pragma once
#include "devices/bytes.h"
#include "devices/result.h"

namespace foverig {

/// Where a recording's bytes go. After an error nothing more is written.
class ByteSink {
  public:
    virtual ~ByteSink() = default;
    virtual Status write(Bytes bytes) = 0;
    /// What was written is where it should be, or not.
    virtual Status close() = 0;
};

}  // namespace foverig
