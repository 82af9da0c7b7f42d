// foverig_gpu: what a machine with a GPU runs first. Proves that CUDA gives host-bvh's answers,
// then measures; one JSON file a scene, written before the next scene begins.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>

#include "bench/gpu/exit_code.h"
#include "bench/gpu/moving_mesh.h"
#include "bench/gpu/suites.h"
#include "renderer/backends/cuda/cuda_error.h"
#include "renderer/backends/cuda/device_info.h"
#include "renderer/scene/error.h"
#include "renderer/scene/library.h"
#include "rig/identity/build_info.h"
#include "rig/identity/host_info.h"

namespace foverig::gpu {
namespace {

struct Options {
    std::filesystem::path out = "gpu-results";
    std::vector<std::string> builtin;  ///< which of the built-in scenes; empty: all
    std::vector<std::string> scenes;
    bool parity_only = false;
    GpuSettings settings;
};

Json identity(const cuda::DeviceInfo& device) {
    const BuildInfo build = build_info();
    const HostInfo host = host_info();
    return {
        {"build",
         {{"version", build.version},
          {"git", build.git.value_or("")},
          {"compiler", build.compiler},
          {"flags", build.flags},
          {"cuda_flags", FOVERIG_CUDA_FLAGS},
          {"type", build.build_type},
          {"fp_mode", build.fp_mode},
          {"backend", "cuda"},
          {"builder", "binned SAH"}}},
        {"device",
         {{"name", device.name},
          {"architecture", fmt::format("sm_{}{}", device.major, device.minor)},
          {"multiprocessors", device.multiprocessors},
          {"memory_bytes", device.memory_bytes},
          {"l2_bytes", device.l2_bytes},
          {"clock_khz", device.clock_khz},
          {"driver_cuda", device.driver},
          {"runtime_cuda", device.runtime}}},
        {"host",
         {{"cpu", host.cpu.value_or("")}, {"cores", host.cores}, {"os", host.os.value_or("")}}}};
}

void write(const std::filesystem::path& file, const Json& document) {
    std::filesystem::create_directories(file.parent_path());
    const std::filesystem::path part = file.string() + ".part";
    std::ofstream stream(part);
    stream << document.dump(2) << '\n';
    stream.close();
    if (!stream) throw std::runtime_error(fmt::format("{}: cannot write it", part.string()));
    std::filesystem::rename(part, file);
}

/// A scene's results: written anew after each suite, so that what came out stays.
class Row {
  public:
    Row(const Options& options, const std::string& scene, const Json& identity)
        : file_(options.out / (std::filesystem::path(scene).filename().string() + ".json")),
          document_({{"schema", "foverig.gpu/1"}, {"scene", scene}}) {
        document_.update(identity);
        fmt::print("{}:", scene);
    }
    const Json& add(const char* suite, Json result) {
        document_[suite] = std::move(result);
        write(file_, document_);
        return document_[suite];
    }
    template <class... Args>
    void tell(fmt::format_string<Args...> text, Args&&... args) const {
        fmt::print(text, std::forward<Args>(args)...);
        std::fflush(stdout);
    }

  private:
    std::filesystem::path file_;
    Json document_;
};

/// Whether CUDA agrees with the host on it. What answers rays wrongly, or loses a number, is not
/// timed; what is only further from the twin's image than allowed is, and says so.
bool run_scene(Row& row, const GpuScene& scene, const Options& options, int paced_frames) {
    row.add("size", {{"triangles", scene.scene().triangles.size()},
                     {"references", scene.host().bvh().view().triangles.size},
                     {"nodes", scene.host().bvh().view().nodes.size}});
    const Json agreement = row.add("parity", parity(scene, options.settings));
    bool pass = agreement["pass"];
    row.tell(" parity {}", pass ? "good" : "FAILED");
    if (scene.host().bvh().plan().moves()) {
        const bool refitted = row.add("refit", refit(scene.scene(), options.settings))["pass"];
        row.tell(", refit {}", refitted ? "good" : "FAILED");
        pass = pass && refitted;
    }
    if (options.parity_only || !agreement["may_be_timed"].get<bool>()) return pass;
    const Json& rates = row.add("rates", ray_rates(scene, options.settings));
    for (const char* kind : {"primary", "shadow", "ao16", "diffuse"})
        if (rates.contains(kind))
            row.tell(", {} {:.0f} Mrays/s", kind, rates[kind]["mrays_s"].get<double>());
    const Json& table = row.add("frames", frames(scene, options.settings));
    row.tell(", both eyes with AO 16 in {:.2f} ms",
             table["ao16"]["reprojected"]["both_eyes"]["passes_sum_ms"].get<double>());
    if (paced_frames > 0) {
        const Json& paced = row.add("pacing", pacing(scene, paced_frames));
        row.tell(", {} of {} paced frames late", paced["missed_vsyncs"].get<int>(), paced_frames);
    }
    return pass;
}

/// The refit of a mesh of a known size, in a file of its own.
bool run_refit(Row& row, const Options& options) {
    const Json& result = row.add("refit", refit(moving_mesh(), options.settings));
    const bool pass = result["pass"];
    row.tell(" refit {}", pass ? "good" : "FAILED");
    if (pass) row.tell(", {:.3f} ms", result["refit"]["median_ms"].get<double>());
    return pass;
}

/// One scene after the other: one that fails says why, in its file too, and the next begins.
class Runs {
  public:
    explicit Runs(const Options& options)
        : options_(options), identity_(identity(cuda::device_info())) {}

    template <class Body>
    void run(const std::string& scene, const Body& body) {
        Row row(options_, scene, identity_);
        try {
            if (!body(row)) worsen(GpuExit::parity_failed);
        } catch (const cuda::CudaError& error) {
            failed(row, error, GpuExit::device);
        } catch (const SceneError& error) {
            failed(row, error, GpuExit::input);
        } catch (const std::exception& error) {
            failed(row, error, GpuExit::internal);
        }
        row.tell("\n");
    }
    GpuExit worst() const { return worst_; }

  private:
    void failed(Row& row, const std::exception& error, GpuExit code) {
        row.add("error", error.what());
        row.tell(" {}", error.what());
        worsen(code);
    }
    void worsen(GpuExit code) {
        if (worst_ == GpuExit::good || worst_ == GpuExit::parity_failed) worst_ = code;
    }

    const Options& options_;
    Json identity_;
    GpuExit worst_ = GpuExit::good;
};

GpuExit run(const Options& options) {
    const cuda::DeviceInfo device = cuda::device_info();
    fmt::print("{}, sm_{}{}, {} multiprocessors, driver for CUDA {}\n", device.name, device.major,
               device.minor, device.multiprocessors, device.driver);
    std::vector<std::string> names = options.builtin;
    if (names.empty())
        for (const BuiltinInfo& info : builtin_scenes()) names.push_back(info.name);
    names.insert(names.end(), options.scenes.begin(), options.scenes.end());
    Runs runs(options);
    runs.run("moving-mesh", [&](Row& row) { return run_refit(row, options); });
    int paced_frames = options.settings.paced_frames;
    for (const std::string& name : names)
        runs.run(name, [&](Row& row) {
            return run_scene(row, GpuScene(load_scene(name)), options,
                             std::exchange(paced_frames, 0));
        });
    fmt::print("results in {}\n", options.out.string());
    return runs.worst();
}

GpuExit fail(const std::exception& error, GpuExit code) {
    fmt::print(stderr, "foverig_gpu: {}\n", error.what());
    return code;
}

GpuExit guarded(const Options& options) {
    try {
        return run(options);
    } catch (const cuda::NoGpuError& error) {
        return fail(error, GpuExit::no_gpu);
    } catch (const cuda::CudaError& error) {
        return fail(error, GpuExit::device);
    } catch (const SceneError& error) {
        return fail(error, GpuExit::input);
    } catch (const std::exception& error) {
        return fail(error, GpuExit::internal);
    }
}

}  // namespace
}  // namespace foverig::gpu

int main(int argc, char** argv) {
    using namespace foverig::gpu;
    Options options;
    CLI::App app(
        "Parity of CUDA with host-bvh and GPU benchmarks, on the built-in scenes and on any scene "
        "file given. Exit codes: 0 good; 1 parity failed; 2 usage; 3 a scene file; 4 CUDA; 5 "
        "internal; 6 no GPU that it can use");
    app.add_option("--out", options.out, "folder for the results")->capture_default_str();
    app.add_option("scenes", options.scenes, "scene files: OBJ, glTF, GLB or PLY");
    app.add_option("--builtin", options.builtin, "only these of the built-in scenes");
    app.add_flag("--parity-only", options.parity_only, "time nothing");
    app.add_option("--rays", options.settings.rays, "rays of a timed batch")
        ->check(CLI::Range(1024, 100'000'000))
        ->capture_default_str();
    app.add_option("--parity-rays", options.settings.parity_rays, "rays compared, of each kind")
        ->check(CLI::Range(1024, 100'000'000))
        ->capture_default_str();
    app.add_option("--repetitions", options.settings.repetitions,
                   "of each measurement; odd is best")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    app.add_option("--paced-frames", options.settings.paced_frames,
                   "frames of the first scene at 75 Hz of the wall clock; 0: none")
        ->check(CLI::Range(0, 1'000'000))
        ->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : static_cast<int>(GpuExit::usage);
    }
    return static_cast<int>(guarded(options));
}
