#pragma once
// GLFW's life: one object at a time, on the thread that runs the program.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <span>
#include <utility>

#include "devices/window/monitors.h"

namespace foverig::window {

class Glfw {
  public:
    /// The error is one sentence with what GLFW says.
    static Result<Glfw> open();
    Glfw(Glfw&& other) noexcept : open_(std::exchange(other.open_, false)) {}
    Glfw& operator=(Glfw&&) = delete;
    ~Glfw();

    std::span<GLFWmonitor* const> monitors() const;

  private:
    Glfw() = default;
    bool open_ = true;
};

Monitor facts_of(GLFWmonitor* monitor);
/// What GLFW said last.
std::string glfw_complaint();

}  // namespace foverig::window
