#include "bench/report_json.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <fstream>
#include <stdexcept>

#include "renderer/backends/embree/handles.h"
#include "rig/identity/build_info.h"
#include "rig/identity/host_info.h"

namespace foverig::bench {
namespace {

Json or_null(const std::optional<std::string>& text) {
    return text ? Json(*text) : Json(nullptr);
}

/// Embree does not tell its instruction set; the packets it takes natively do.
Json embree_identity() {
    const embree::Device device(rtcNewDevice(nullptr));
    const auto native = [&](RTCDeviceProperty property) {
        return rtcGetDeviceProperty(device.get(), property) != 0;
    };
    const auto version = rtcGetDeviceProperty(device.get(), RTC_DEVICE_PROPERTY_VERSION);
    const char* isa = "SSE";
    if (native(RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED)) isa = "AVX or AVX2";
    if (native(RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED)) isa = "AVX-512";
    return {
        {"version", fmt::format("{}.{}.{}", version / 10000, version / 100 % 100, version % 100)},
        {"isa", isa}};
}

}  // namespace

Json identity(const Options& options) {
    const BuildInfo build = build_info();
    const HostInfo host = host_info();
    return {{"build",
             {{"version", build.version},
              {"git", or_null(build.git)},
              {"compiler", build.compiler},
              {"flags", build.flags},
              {"type", build.build_type},
              {"fp_mode", build.fp_mode}}},
            {"host", {{"cpu", or_null(host.cpu)}, {"cores", host.cores}, {"os", or_null(host.os)}}},
            {"embree", embree_identity()},
            {"robust_tracing", options.robust},
            {"threads", tbb::info::default_concurrency()}};
}

void Results::add(const std::string& suite, const std::string& name, Json row) {
    Json named = {{"name", name}};
    named.update(row);
    rows_[suite].push_back(std::move(named));
}

void Results::write() const {
    if (options_.results.empty()) return;
    std::filesystem::create_directories(options_.results);
    for (const auto& [suite, rows] : rows_) {
        Json document = {{"schema", "foverig.bench/1"}, {"suite", suite}};
        document.update(identity(options_));
        document["rows"] = rows;
        const std::filesystem::path file = options_.results / (suite + ".json");
        const std::filesystem::path part = file.string() + ".part";
        std::ofstream stream(part);
        stream << document.dump(2) << '\n';
        stream.close();
        if (!stream)
            throw std::runtime_error(fmt::format("{}: cannot write the results", part.string()));
        std::filesystem::rename(part, file);
    }
}

}  // namespace foverig::bench
