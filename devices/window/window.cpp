#include "devices/window/window.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "devices/window/glfw.h"

namespace foverig::window {

struct Window::Parts {
    Glfw glfw;
    GLFWwindow* handle = nullptr;
    std::string letters{};
    std::string shown_on{};
    bool full_screen = false;
    int refresh_hz = 0;

    explicit Parts(Glfw opened) : glfw(std::move(opened)) {}
    ~Parts() {
        if (handle != nullptr) glfwDestroyWindow(handle);
    }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
};

namespace {

void on_key(GLFWwindow* window, int key, int, int action, int) {
    if (action != GLFW_PRESS) return;
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(window, GLFW_TRUE);
    if (key < GLFW_KEY_A || key > GLFW_KEY_Z) return;
    auto& letters = *static_cast<std::string*>(glfwGetWindowUserPointer(window));
    letters += static_cast<char>(key);
}

void hint_context() {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SAMPLES, 0);
    // A headset goes on showing while the desktop's focus is elsewhere.
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
}

/// The size that the monitor shows now, at the wanted rate where it has a mode of that.
GLFWvidmode mode_of(GLFWmonitor* monitor, double rate_hz) {
    GLFWvidmode chosen = *glfwGetVideoMode(monitor);
    int count = 0;
    const GLFWvidmode* modes = glfwGetVideoModes(monitor, &count);
    for (const GLFWvidmode& mode : std::span(modes, static_cast<std::size_t>(count))) {
        const bool same_size = mode.width == chosen.width && mode.height == chosen.height;
        if (same_size && mode.refreshRate == std::lround(rate_hz)) chosen = mode;
    }
    return chosen;
}

}  // namespace

Result<std::unique_ptr<Window>> Window::open(const Settings& settings) {
    Result<Glfw> glfw = Glfw::open();
    if (!glfw) return glfw.error();
    auto parts = std::make_unique<Parts>(std::move(glfw).value());
    hint_context();
    SizePx size = settings.size;
    GLFWmonitor* monitor = nullptr;
    if (settings.full_screen) {
        const auto all = parts->glfw.monitors();
        std::vector<Monitor> facts;
        for (GLFWmonitor* each : all) facts.push_back(facts_of(each));
        const Result<std::size_t> chosen = choose_monitor(facts, settings.monitor);
        if (!chosen) return chosen.error();
        monitor = all[*chosen];
        parts->full_screen = true;
        const GLFWvidmode mode = mode_of(monitor, settings.rate_hz);
        glfwWindowHint(GLFW_REFRESH_RATE, mode.refreshRate);
        size = {mode.width, mode.height};
        parts->refresh_hz = mode.refreshRate;
        parts->shown_on = text_of(facts[*chosen]);
    } else if (GLFWmonitor* primary = glfwGetPrimaryMonitor()) {
        parts->refresh_hz = facts_of(primary).refresh_hz;
        parts->shown_on = fmt::format("a window of {}x{}", size.width, size.height);
    }
    parts->handle =
        glfwCreateWindow(size.width, size.height, settings.title.c_str(), monitor, nullptr);
    if (parts->handle == nullptr)
        return Error{ErrorCode::unsupported,
                     fmt::format("no window with OpenGL 3.3 can be had ({})", glfw_complaint())};
    glfwMakeContextCurrent(parts->handle);
    glfwSwapInterval(settings.wait_vsync ? 1 : 0);
    return std::unique_ptr<Window>(new Window(std::move(parts)));
}

Window::Window(std::unique_ptr<Parts> parts)
    : parts_(std::move(parts)),
      shown_on_(parts_->shown_on),
      full_screen_(parts_->full_screen),
      refresh_hz_(parts_->refresh_hz) {
    glfwSetWindowUserPointer(parts_->handle, &parts_->letters);
    glfwSetKeyCallback(parts_->handle, on_key);
}

Window::~Window() = default;

void Window::poll() {
    glfwPollEvents();
}

bool Window::closed() const {
    return glfwWindowShouldClose(parts_->handle) == GLFW_TRUE;
}

std::string Window::take_letters() {
    return std::exchange(parts_->letters, {});
}

std::optional<dvec2> Window::cursor_px() const {
    if (glfwGetWindowAttrib(parts_->handle, GLFW_HOVERED) == GLFW_FALSE) return std::nullopt;
    dvec2 at;
    glfwGetCursorPos(parts_->handle, &at.x, &at.y);
    int width = 0, height = 0;
    glfwGetWindowSize(parts_->handle, &width, &height);
    if (width <= 0 || height <= 0) return std::nullopt;
    // Screen coordinates are not pixels on every desktop.
    const SizePx pixels = view().framebuffer();
    return dvec2(at.x * pixels.width / width, at.y * pixels.height / height);
}

PanelView Window::view() const {
    SizePx size;
    glfwGetFramebufferSize(parts_->handle, &size.width, &size.height);
    return {size, full_screen_ && size.height > size.width};
}

void Window::swap() {
    glfwSwapBuffers(parts_->handle);
    glFinish();
}

}  // namespace foverig::window
