#pragma once
#include <memory>
#include <string>

#include "devices/window/window.h"
#include "rig/failure.h"
#include "rig/scenario/scenario.h"

namespace foverig {

/// DeviceError with what to do where a window, or what is drawn in it, cannot be had.
DeviceError window_failure(const Scenario& scenario, const Error& error);

template <class T>
T window_or_throw(const Scenario& scenario, Result<T> result) {
    if (!result) throw window_failure(scenario, result.error());
    return std::move(result).value();
}

/// The window that the scenario's display asks for. Throws DeviceError where there is none to be
/// had, UsageError where the clock is not the wall's.
std::unique_ptr<window::Window> open_window(const Scenario& scenario, const std::string& title);

}  // namespace foverig
