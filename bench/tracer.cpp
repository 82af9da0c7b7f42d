// Issue 3, bars 1 and 2: our tracer against Embree's single-ray calls. First 10 M rays a scene are
// compared one by one; only then are the two timed, taking turns in one process on one thread.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <mutex>

#include "bench/agreement.h"
#include "bench/ray_kinds.h"
#include "bench/single_rays.h"
#include "bench/statistics.h"
#include "bench/suites.h"
#include "renderer/backends/embree/split_build.h"
#include "renderer/backends/host_bvh/host_bvh_scene.h"
#include "renderer/scene/library.h"

namespace foverig::bench {
namespace {

constexpr std::uint32_t kTimedRays = 100'000;
constexpr std::array kScales{1.0e-6F, 1.0e6F};

using host_bvh::HostBvhScene;

HostBvhScene our_scene(const Scene& scene) {
    return HostBvhScene(
        scene, {true, {}, [](auto triangles) { return embree::build_with_splits(triangles, 0); }});
}

/// For whoever looks into a disagreement: the ray by its kind and number, and both answers.
std::string sentence(RayKind kind, std::uint32_t i, const Hit& embree, const Hit& ours,
                     bool occluded, const SceneView& scene, const Ray& ray) {
    const auto told = [&](const Hit& hit) {
        if (hit.missed()) return std::string("a miss");
        const ExactHit exact(scene, ray, hit.triangle);
        return fmt::format(
            "triangle {} at {:.9g} (exactly {:.17g}, u {:.3g}, v {:.3g}, {:.3g} m "
            "from an edge, flatness {:.3g}, reach {:.3g} m)",
            hit.triangle, hit.t, exact.t, exact.u, exact.v, exact.edge_distance_m(), exact.flatness,
            exact.reach_m);
    };
    return fmt::format("{} ray {}: Embree says {}, host-bvh {}, occluded {}", name_of(kind), i,
                       told(embree), told(ours), occluded);
}

struct Agreement {
    Verdicts verdicts{};
    std::vector<std::string> wrong;  ///< the first few
};
constexpr std::size_t kMostSentences = 8;

Agreement compare_rays(const embree::EmbreeScene& embree, const HostBvhScene& ours,
                       const Scene& scene, RayKind kind, std::uint32_t rays) {
    Agreement sum;
    std::mutex mutex;
    const RayMaker make_ray(scene);
    tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, rays, 4096), [&](const auto& range) {
        SingleRays peer(embree);
        Verdicts mine{};
        for (std::uint32_t i = range.begin(); i < range.end(); ++i) {
            const Ray ray = make_ray(kind, i);
            const Hit hit = ours.closest(ray);
            const Hit peers = peer.closest(ray);
            const bool occluded = ours.occluded(ray);
            const Verdict verdict = occluded == !hit.missed()
                                        ? compare(embree.view(), ray, peers, hit)
                                        : Verdict::wrong;
            ++mine[static_cast<std::size_t>(verdict)];
            if (verdict != Verdict::wrong) continue;
            const std::lock_guard lock(mutex);
            if (sum.wrong.size() < kMostSentences)
                sum.wrong.push_back(sentence(kind, i, peers, hit, occluded, embree.view(), ray));
        }
        const std::lock_guard lock(mutex);
        for (std::size_t v = 0; v < mine.size(); ++v) sum.verdicts[v] += mine[v];
    });
    return sum;
}

Json json_of(const Agreement& agreement) {
    Json row = Json::object();
    for (std::size_t v = 0; v < kVerdictNames.size(); ++v)
        row[kVerdictNames[v]] = agreement.verdicts[v];
    if (!agreement.wrong.empty()) row["wrong_rays"] = agreement.wrong;
    return row;
}

/// By kind; the scaled copies are compared on `inside` rays. Counts what is wrong.
Json compare_all(const Scene& scene, const embree::EmbreeScene& embree, const HostBvhScene& ours,
                 std::uint32_t rays, std::uint64_t& wrong) {
    Json rows = Json::object();
    const auto add = [&](const std::string& name, const Agreement& agreement) {
        rows[name] = json_of(agreement);
        wrong += agreement.verdicts[static_cast<std::size_t>(Verdict::wrong)];
    };
    const std::uint32_t of_each = rays / (kRayKinds.size() + kScales.size());
    for (const RayKind kind : kRayKinds)
        add(name_of(kind), compare_rays(embree, ours, scene, kind, of_each));
    for (const float scale : kScales) {
        const Scene other = scaled(scene, scale);
        add(fmt::format("inside, scaled by {:g}", scale),
            compare_rays(embree::EmbreeScene(other, {}), our_scene(other), other, RayKind::inside,
                         of_each));
    }
    return rows;
}

/// Processor time of this thread: neighbours on the machine slow it down, but do not stop its
/// clock.
double thread_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

template <class Trace>
double time_ms(const std::vector<Ray>& rays, const Trace& trace) {
    const double start_ms = thread_ms();
    for (const Ray& ray : rays) benchmark::DoNotOptimize(trace(ray));
    return thread_ms() - start_ms;
}

Json time_kind(const embree::EmbreeScene& embree, const HostBvhScene& ours, const Scene& scene,
               RayKind kind, int repetitions) {
    const RayMaker make_ray(scene);
    std::vector<Ray> rays;
    for (std::uint32_t i = 0; i < kTimedRays; ++i) rays.push_back(make_ray(kind, i));
    SingleRays peer(embree);
    std::vector<double> ms[4];
    for (int i = 0; i < repetitions; ++i) {
        ms[0].push_back(time_ms(rays, [&](const Ray& r) { return ours.closest(r).triangle; }));
        ms[1].push_back(time_ms(rays, [&](const Ray& r) { return peer.closest(r).triangle; }));
        ms[2].push_back(time_ms(rays, [&](const Ray& r) { return ours.occluded(r); }));
        ms[3].push_back(time_ms(rays, [&](const Ray& r) { return peer.occluded(r); }));
    }
    const auto mrays_s = [&](int i) { return kTimedRays / median(ms[i]) * 1e-3; };
    return {{"closest_mrays_s", mrays_s(0)},
            {"embree_closest_mrays_s", mrays_s(1)},
            {"closest_ratio", mrays_s(0) / mrays_s(1)},
            {"any_mrays_s", mrays_s(2)},
            {"embree_any_mrays_s", mrays_s(3)},
            {"any_ratio", mrays_s(2) / mrays_s(3)}};
}

void run(benchmark::State& state, Bench& bench, const std::string& name,
         const std::string& name_or_file) {
    const Scene scene = load_scene(name_or_file);
    const embree::EmbreeScene embree(scene, {});
    const double start_ms = thread_ms();
    const HostBvhScene ours = our_scene(scene);
    const double build_ms = thread_ms() - start_ms;
    std::uint64_t wrong = 0;
    const Json agreement =
        compare_all(scene, embree, ours,
                    1'000'000U * static_cast<std::uint32_t>(bench.options.compared_mrays), wrong);
    Json row = {{"triangles", scene.triangles.size()},
                {"references", ours.bvh().view().triangles.size},
                {"nodes", ours.bvh().view().nodes.size},
                {"levels", ours.bvh().levels()},
                {"bytes_per_triangle", static_cast<double>(ours.bvh().bytes()) /
                                           static_cast<double>(scene.triangles.size())},
                {"build_thread_ms", build_ms},
                {"wrong", wrong},
                {"compared_mrays", bench.options.compared_mrays},
                {"agreement", agreement}};
    if (wrong > 0) {
        bench.results.add("tracer", name, row);
        return state.SkipWithError(fmt::format("{} rays are answered wrong", wrong).c_str());
    }
    Json kinds = Json::object();
    for (auto unused : state)
        for (const RayKind kind : kRayKinds)
            kinds[name_of(kind)] = time_kind(embree, ours, scene, kind, bench.options.repetitions);
    for (const char* ratio : {"closest_ratio", "any_ratio"}) {
        std::vector<double> all;
        for (const auto& [kind, of_kind] : kinds.items()) all.push_back(of_kind[ratio]);
        row[std::string("median_") + ratio] = median(all);
        state.counters[ratio] = median(all);
    }
    row["speed"] = kinds;
    bench.results.add("tracer", name, row);
}

void add(Bench& bench, const std::string& name, const std::string& name_or_file) {
    benchmark::RegisterBenchmark(fmt::format("BM_Tracer/{}", name).c_str(),
                                 [&bench, name, name_or_file](benchmark::State& state) {
                                     run(state, bench, name, name_or_file);
                                 })
        ->Iterations(1)
        ->Unit(benchmark::kSecond);
}

/// Scenes below a folder, relative to it, in order; without the broken ones of hard*, which are the
/// importers' business.
std::vector<std::string> scene_files(const std::filesystem::path& folder) {
    std::vector<std::string> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
        const std::string file = std::filesystem::relative(entry.path(), folder).generic_string();
        const bool scene = file.ends_with(".obj") || file.ends_with(".glb") ||
                           file.ends_with(".glb.zst") || file.ends_with(".gltf") ||
                           file.ends_with(".ply");
        if (scene && !file.starts_with("hard")) files.push_back(file);
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

void register_tracer(Bench& bench) {
    for (const BuiltinInfo& info : builtin_scenes()) add(bench, info.name, info.name);
    for (const std::string& file : scene_files(bench.options.scenes))
        add(bench, file, (bench.options.scenes / file).string());
}

}  // namespace foverig::bench
