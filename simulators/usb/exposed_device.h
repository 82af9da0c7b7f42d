#pragma once
// From a model's bytes to a kernel's device: one thread gives each packet to the kernel when its
// time has come, and unplugs and plugs in as the model is.
#include <mutex>
#include <optional>
#include <thread>

#include "simulators/usb/face.h"
#include "simulators/usb/locked_transport.h"

namespace foverig::usb {

class ExposedDevice {
  public:
    struct Counts {
        std::uint64_t packets = 0;
        std::uint64_t plugged_in = 0;
        std::uint64_t unheard = 0;  ///< as Face's, over all that were plugged in
    };

    /// Plugged in now; the error is why it cannot be. `model` and `clock` outlive the device; the
    /// clock runs in real time and any thread may read it.
    static Result<std::unique_ptr<ExposedDevice>> begin(LockedTransport& model, Clock& clock,
                                                        PlugIn plug_in);

    Counts counts() const;
    /// It goes on no longer: the model has come to its end, the kernel let go, or an error.
    bool ended() const;
    /// Why, where that was an error.
    std::optional<Error> error() const;

  private:
    ExposedDevice(LockedTransport& model, Clock& clock, PlugIn plug_in, std::unique_ptr<Face> face);

    void run(const std::stop_token& stop);
    /// All that is due; false: it is over.
    bool pass_on(const std::stop_token& stop);
    bool plug_in_again();
    void unplug();
    void note_unheard();
    bool end(std::optional<Error> error = {});

    LockedTransport& model_;
    Clock& clock_;
    PlugIn plug_in_;
    std::unique_ptr<Face> face_;        // null while the model is unplugged
    std::uint64_t unheard_before_ = 0;  // by the faces before this one
    mutable std::mutex mutex_;          // of what follows
    Counts counts_{.packets = 0, .plugged_in = 1, .unheard = 0};
    bool ended_ = false;
    std::optional<Error> error_;
    std::jthread thread_;  // last: stops first
};

}  // namespace foverig::usb
