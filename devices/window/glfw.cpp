#include "devices/window/glfw.h"

#include <fmt/format.h>

namespace foverig::window {

Result<Glfw> Glfw::open() {
    if (glfwInit() == GLFW_TRUE) return Glfw();
    return Error{ErrorCode::not_found,
                 fmt::format("there is no desktop to open a window on ({})", glfw_complaint())};
}

Glfw::~Glfw() {
    if (open_) glfwTerminate();
}

std::span<GLFWmonitor* const> Glfw::monitors() const {
    int count = 0;
    GLFWmonitor** const first = glfwGetMonitors(&count);
    return {first, static_cast<std::size_t>(count)};
}

Monitor facts_of(GLFWmonitor* monitor) {
    Monitor facts{.name = glfwGetMonitorName(monitor), .mode = {}};
    glfwGetMonitorPhysicalSize(monitor, &facts.width_mm, &facts.height_mm);
    if (const GLFWvidmode* mode = glfwGetVideoMode(monitor)) {
        facts.mode = {mode->width, mode->height};
        facts.refresh_hz = mode->refreshRate;
    }
    return facts;
}

std::string glfw_complaint() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "GLFW gives no reason" : text;
}

}  // namespace foverig::window
