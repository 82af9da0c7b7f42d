// Bar 7: voxel-town at 6.7 M triangles made, built and rendered, and the kitchen loaded, each in a
// process of its own, so that its peak memory is its own.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <memory>

#include "bench/suites.h"

namespace foverig::bench {
namespace {

struct ClosePipe {
    void operator()(std::FILE* pipe) const { pclose(pipe); }
};

/// The last line that this program prints as a child for that scene; empty where it fails.
std::string measure_in_child(const std::string& name_or_file) {
    const std::string program = std::filesystem::read_symlink("/proc/self/exe").string();
    const std::string command = fmt::format("'{}' --child='{}'", program, name_or_file);
    const std::unique_ptr<std::FILE, ClosePipe> pipe(popen(command.c_str(), "r"));
    std::string all;
    std::array<char, 4096> chunk{};
    while (pipe != nullptr && std::fgets(chunk.data(), chunk.size(), pipe.get()) != nullptr)
        all = chunk.data();
    return all;
}

void run(benchmark::State& state, Bench& bench, const std::string& name,
         const std::string& name_or_file) {
    Json row;
    for (auto unused : state) {
        const std::string line = measure_in_child(name_or_file);
        row = Json::parse(line, nullptr, false);
        if (row.is_discarded()) return state.SkipWithError("the child process failed");
        state.SetIterationTime(row["total_s"].get<double>());
    }
    for (const char* key : {"triangles", "make_s", "build_s", "render_s", "peak_rss_gib"})
        state.counters[key] = row[key].get<double>();
    bench.results.add("large_scenes", name, row);
}

void add(Bench& bench, const std::string& name, const std::string& name_or_file) {
    benchmark::RegisterBenchmark(fmt::format("BM_LargeScene/{}", name).c_str(),
                                 [&bench, name, name_or_file](benchmark::State& state) {
                                     run(state, bench, name, name_or_file);
                                 })
        ->Iterations(1)
        ->UseManualTime()
        ->Unit(benchmark::kSecond);
}

}  // namespace

void register_large_scenes(Bench& bench) {
    add(bench, "voxel-town", "voxel-town");
    const std::filesystem::path kitchen = bench.options.scenes / "kitchen" / "kitchen.glb";
    if (std::filesystem::exists(kitchen)) add(bench, "kitchen", kitchen.string());
}

}  // namespace foverig::bench
