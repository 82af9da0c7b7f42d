// libFuzzer target: any bytes as a recording, through the indexed reader, recovery and replay.
// What comes out must be an error or a file that reads back. scripts/fuzz runs it.
#include <cstdlib>

#include "devices/recording/recover.h"
#include "simulators/replay/replayed_device.h"
#include "tests/devices/recording/memory_sink.h"

namespace foverig {
namespace {

void replay(Bytes bytes) {
    const auto recording = Recording::open(std::make_unique<MemorySource>(bytes), "fuzz");
    if (!recording) return;
    for (const char* name : {"dk2", "gaze"}) {
        if (!recording->has(name)) continue;
        ManualClock clock;
        ReplayedDevice device(*recording, name, clock, {});
        for (int i = 0; i < 10'000 && !device.at_end(); ++i) {
            (void)device.next(HostTime(Nanoseconds(std::int64_t{1} << 61)));
            (void)device.control_get(3, 0, 69);
        }
    }
    (void)recording->attachment("scenario.toml");
    (void)recording->metadata("foverig.session");
}

void recover(Bytes bytes) {
    const auto file = mcap::RecordFile::open(std::make_unique<MemorySource>(bytes), "fuzz");
    if (!file) return;
    test::Disk disk;
    const auto recovery = mcap::recover(*file, std::make_unique<test::MemorySink>(disk));
    if (!recovery) return;
    const auto mended = disk.bytes();
    const auto again = mcap::RecordFile::open(std::make_unique<MemorySource>(mended), "mended");
    if (!again || !mcap::check_recovered(*again, *recovery)) std::abort();
}

}  // namespace
}  // namespace foverig

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const foverig::Bytes bytes(reinterpret_cast<const std::byte*>(data), size);
    foverig::replay(bytes);
    foverig::recover(bytes);
    return 0;
}
