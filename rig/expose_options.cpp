#include "rig/expose_options.h"

namespace foverig {

void ExposeOptions::add_to(CLI::App& app) {
    CLI::App& expose = *app.add_subcommand(
        "expose", "a simulated or recorded device as a real one of the kernel, for any program");
    expose.add_option("device", device_, "dk2, camera or gaze")
        ->check(CLI::IsMember({"dk2", "camera", "gaze"}))
        ->required();
    scenario_.add_to(expose);
    expose.add_option("--via", via_, "usbip: USB, through vhci-hcd; uhid: HID alone, dk2 only")
        ->type_name("usbip|uhid")
        ->check(CLI::IsMember({"usbip", "uhid"}))
        ->capture_default_str();
    expose.add_option("--record", record_, "keep what went over, both ways (MCAP)")
        ->type_name("FILE");
    expose.footer(
        "Examples (as root, after modprobe vhci-hcd):\n"
        "  foverig expose dk2\n"
        "  foverig expose gaze my.toml --set faults.gaze.dropout=0.01\n"
        "  foverig expose dk2 --set motion.head=look --set faults.dk2.unplug_at=5 \\\n"
        "                     --set faults.dk2.unplug_for=1\n"
        "  foverig expose dk2 --devices replay:desk.mcap      a recording's headset\n"
        "docs/kernel.md explains it.");
}

ExposeRequest ExposeOptions::request() const {
    ExposeRequest request{
        .device = device_, .via = via_, .scenario = scenario_.scenario(), .record = {}};
    if (!record_.empty()) request.record = record_;
    return request;
}

}  // namespace foverig
