#include <cstring>

#include "bench/gpu/device_refit.h"
#include "bench/gpu/suites.h"
#include "bench/statistics.h"
#include "renderer/trace/build/moved_parts.h"

namespace foverig::gpu {
namespace {

template <class T>
std::size_t count_apart(const std::vector<T>& device, View<const T> host) {
    if (device.size() != host.size) return host.size;
    std::size_t apart = 0;
    for (std::size_t i = 0; i < host.size; ++i)
        apart += std::memcmp(&device[i], &host[i], sizeof(T)) == 0 ? 0U : 1U;
    return apart;
}

Json times_of(const std::vector<double>& ms) {
    return {{"ms", ms}, {"median_ms", bench::median(ms)}};
}

}  // namespace

Json refit(const Scene& scene, const GpuSettings& settings) {
    host_bvh::HostBvhScene host(scene, {});
    const RefitPlan& plan = host.bvh().plan();
    DeviceRefit device(host.view(), host.bvh().view(), plan);
    std::size_t nodes_apart = 0;
    std::size_t triangles_apart = 0;
    for (const double time_s : {0.37, 1.9, 0.6, 4.3}) {
        host.set_time(time_s);
        if (time_s < 1.0)
            device.move(host.view());
        else
            device.move_by_graph(host.view());
        nodes_apart += count_apart(device.nodes(), host.bvh().view().nodes);
        triangles_apart += count_apart(device.packed_triangles(), host.bvh().view().triangles);
    }
    Json row = {{"pass", nodes_apart + triangles_apart == 0},
                {"moving_triangles", plan.triangle_count},
                {"moving_nodes", plan.node_count()},
                {"levels", plan.level_ends.size()},
                {"nodes_apart", nodes_apart},
                {"triangles_apart", triangles_apart}};
    if (!row["pass"].get<bool>()) return row;  // what ends otherwise is not timed
    const DeviceRefit::Times times = device.times(settings.repetitions);
    row["upload_bytes"] = moving_vertices(plan) * 2 * sizeof(vec3) +
                          plan.upper.capacity() * (sizeof(WideNode) + sizeof(std::uint32_t));
    row["upload"] = times_of(times.upload_ms);
    row["refit"] = times_of(times.refit_ms);
    row["graph"] = times_of(times.graph_ms);
    return row;
}

}  // namespace foverig::gpu
