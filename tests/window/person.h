#pragma once
// A hand on keyboard and mouse, and an eye on the screen, through a connection of its own to the X
// server.
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

#include <array>
#include <optional>
#include <string>

// Xlib's macros that other headers use as names.
#undef None
#undef Status
#undef Success

namespace foverig::test {

class Person {
  public:
    Person() : server_(XOpenDisplay(nullptr)) {}
    ~Person() {
        if (server_ != nullptr) XCloseDisplay(server_);
    }
    Person(const Person&) = delete;
    Person& operator=(const Person&) = delete;

    /// Without a window manager a window is a child of the root.
    std::optional<Window> window_titled(const std::string& title) const {
        Window root = 0, parent = 0, *children = nullptr;
        unsigned count = 0;
        XQueryTree(server_, DefaultRootWindow(server_), &root, &parent, &children, &count);
        std::optional<Window> found;
        for (unsigned i = 0; i < count; ++i) {
            char* name = nullptr;
            if (XFetchName(server_, children[i], &name) != 0 && name != nullptr) {
                if (title == name) found = children[i];
                XFree(name);
            }
        }
        if (children != nullptr) XFree(children);
        return found;
    }

    void press(Window window, KeySym key) {
        XEvent event{};
        event.xkey.type = KeyPress;
        event.xkey.display = server_;
        event.xkey.window = window;
        event.xkey.root = DefaultRootWindow(server_);
        event.xkey.same_screen = True;
        event.xkey.keycode = XKeysymToKeycode(server_, key);
        event.xkey.time = ++time_;  // GLFW takes a key of the same time for an echo
        XSendEvent(server_, window, True, KeyPressMask, &event);
        event.xkey.type = KeyRelease;
        event.xkey.time = ++time_;
        XSendEvent(server_, window, True, KeyReleaseMask, &event);
        XSync(server_, False);
    }

    void move_to(int x_px, int y_px) {
        XWarpPointer(server_, 0, DefaultRootWindow(server_), 0, 0, 0, 0, x_px, y_px);
        XSync(server_, False);
    }

    /// Red, green, blue of a place on the screen.
    std::array<int, 3> colour_at(int x_px, int y_px) const {
        XImage* image =
            XGetImage(server_, DefaultRootWindow(server_), x_px, y_px, 1, 1, AllPlanes, ZPixmap);
        const unsigned long pixel = XGetPixel(image, 0, 0);
        XDestroyImage(image);
        return {static_cast<int>(pixel >> 16U & 255U), static_cast<int>(pixel >> 8U & 255U),
                static_cast<int>(pixel & 255U)};
    }

  private:
    ::Display* server_;
    Time time_ = 0;
};

}  // namespace foverig::test
