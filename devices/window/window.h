#pragma once
// A window on the desktop, or a monitor filled with one, with an OpenGL 3.3 core context that is
// current on the thread that opened it. One at a time.
#include <memory>
#include <optional>
#include <string>

#include "devices/display/panel_view.h"
#include "devices/window/monitors.h"

namespace foverig::window {

class Window {
  public:
    struct Settings {
        std::string title = "foverig";
        SizePx size{1280, 720};  ///< on the desktop
        bool full_screen = false;
        std::string monitor{};   ///< of full screen; empty: the one that looks like a DK2's panel
        double rate_hz = 75;     ///< of full screen, where the monitor has a mode of it
        bool wait_vsync = true;  ///< swap interval 1; many drivers may ignore it
    };

    /// not_found: no desktop, or not that monitor; unsupported: no such OpenGL.
    static Result<std::unique_ptr<Window>> open(const Settings& settings);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Takes what the desktop has to say: keys, cursor, close.
    void poll();
    /// Escape, or the window's close button.
    bool closed() const;
    /// Letters whose keys were pressed since the last call: 'H'.
    std::string take_letters();
    /// From the framebuffer's upper left corner; nothing while it is elsewhere.
    std::optional<dvec2> cursor_px() const;

    /// Where the panel's picture lies in it; turned on a full screen that is upright.
    PanelView view() const;
    /// "a window of 1280x720", or the monitor.
    const std::string& shown_on() const { return shown_on_; }
    /// Of the monitor under it; 0: not told.
    int refresh_hz() const { return refresh_hz_; }
    /// Returns once the graphics card is done with it, which is after a VSync where the driver
    /// waits for one.
    void swap();

  private:
    struct Parts;
    explicit Window(std::unique_ptr<Parts> parts);

    std::unique_ptr<Parts> parts_;
    std::string shown_on_;
    bool full_screen_ = false;
    int refresh_hz_ = 0;
};

}  // namespace foverig::window
