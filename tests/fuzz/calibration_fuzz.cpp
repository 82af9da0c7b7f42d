// libFuzzer target: any bytes as the file of a gaze calibration. What comes out must be a refusal
// that names the file, or a calibration that a tracker takes and that reads back. scripts/fuzz runs
// it.
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>

#include "rig/failure.h"
#include "rig/session/calibration_file.h"

namespace foverig {

int fuzz_calibration(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    gaze::StoredCalibration stored;
    try {
        stored = calibration_of(text, "fuzz.json");
    } catch (const InputError& error) {
        if (!std::string(error.what()).starts_with("fuzz.json: ")) std::abort();
        return 0;
    }
    const auto blob = gaze::CalibrationBlob::decode(stored.blob);
    if (!blob) std::abort();
    CalibrationRecord record;
    record.tracker.serial = stored.serial;
    record.blob = stored.blob;
    const auto again = calibration_of(calibration_json(record).dump(), "again.json");
    if (again.serial != stored.serial || again.blob != stored.blob) std::abort();
    return 0;
}

}  // namespace foverig

#if defined(FOVERIG_FUZZER)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return foverig::fuzz_calibration(data, size);
}
#endif
