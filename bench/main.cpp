// foverig_bench: Google Benchmark's program with our flags, suites and results files.
#include <benchmark/benchmark.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "bench/large_scene_child.h"
#include "bench/on_devices.h"
#include "bench/suites.h"
#include "rig/failure.h"
#include "rig/require_devices.h"

namespace foverig::bench {
namespace {

void add_context(const Options& options) {
    const Json about = identity(options);
    for (const char* part : {"build", "host", "embree"})
        for (const auto& [key, value] : about[part].items())
            benchmark::AddCustomContext(
                std::string(part) + "." + key,
                value.is_string() ? value.get<std::string>() : value.dump());
    benchmark::AddCustomContext("robust_tracing", options.robust ? "true" : "false");
    benchmark::AddCustomContext("devices", options.devices);
}

int run(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    Bench bench;
    Options& o = bench.options;
    std::string child;
    CLI::App app(
        "foverig_bench: proves results right, then times them (--benchmark_* flags as ever)");
    app.add_option("--results", o.results, "folder for one JSON file a suite");
    app.add_option("--scenes", o.scenes, "folder of the shared scenes")->capture_default_str();
    app.add_option("--frames", o.frames, "measured frames of each speed comparison")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--repetitions", o.repetitions, "of each comparison with bare Embree")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--error-frames", o.error_frames, "frames of a flight whose error is measured")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--error-stride", o.error_stride, "compare every n-th, where light is sampled")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--compared-mrays", o.compared_mrays,
                   "millions of rays a scene that two tracers must agree on")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_flag("--robust,!--no-robust", o.robust, "watertight tracing")->capture_default_str();
    app.add_option("--devices", o.devices,
                   "whose latency and VSyncs are measured: simulated ones, or those on the desk")
        ->check(CLI::IsMember({"sim", "hardware"}))
        ->capture_default_str();
    app.add_option("--child", child, "internal: one large scene, measured in its own process");
    CLI11_PARSE(app, argc, argv);
    if (!child.empty()) return run_large_scene(child);

    register_full_against_embree(bench);
    register_foveation_speedup(bench);
    register_fixed_work(bench);
    register_frame_times(bench);
    register_reprojection_error(bench);
    register_large_scenes(bench);
    register_tracer(bench);
    register_recorder(bench);
    register_metrics(bench);
    register_kernels();
    register_devices();
    register_camera();
    register_hour(bench);
    register_transport(bench);
    register_vsync(bench);
    register_rig_latency(bench);
    add_context(o);
    if (o.devices == "hardware") require_devices(on_devices({}, o));
    try {
        if (benchmark::RunSpecifiedBenchmarks() == 0) return 2;
    } catch (const DeviceError&) {  // unplugged: what was measured before stands
        bench.results.write();
        throw;
    }
    bench.results.write();
    return 0;
}

}  // namespace
}  // namespace foverig::bench

int main(int argc, char** argv) {
    try {
        return foverig::bench::run(argc, argv);
    } catch (const foverig::DeviceError& e) {
        std::cerr << "foverig_bench: " << e.what() << '\n';
        return 4;
    } catch (const std::exception& e) {
        std::cerr << "foverig_bench: " << e.what() << '\n';
        return 5;
    }
}
