#pragma once
#include <string>
#include <utility>

#include "devices/result.h"
#include "rig/failure.h"

namespace foverig {

/// The source, or DeviceError with the device's name and its own sentence.
template <class Source>
Source opened(const std::string& device, Result<Source> result) {
    if (!result) throw DeviceError(device + ": " + result.error().text);
    return std::move(result).value();
}

}  // namespace foverig
