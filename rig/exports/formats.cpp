#include "rig/exports/formats.h"

#include <algorithm>
#include <stdexcept>

#include "rig/exports/benchmark_json.h"
#include "rig/exports/markdown.h"
#include "rig/exports/perfetto.h"
#include "rig/exports/presentmon.h"

namespace foverig::exports {

const std::vector<Format>& formats() {
    static const std::vector<Format> all{
        {"perfetto", "trace.pftrace", perfetto_trace},
        {"markdown", "summary.md", markdown},
        {"benchmark", "benchmark.json",
         [](const report::RunData& run) { return benchmark_json({run}).dump(2) + "\n"; }},
        {"presentmon", "presentmon.csv", presentmon_csv}};
    return all;
}

const Format& format_of(const std::string& name) {
    const auto found = std::find_if(formats().begin(), formats().end(),
                                    [&](const Format& format) { return format.name == name; });
    if (found == formats().end()) throw std::invalid_argument("no export is called " + name);
    return *found;
}

}  // namespace foverig::exports
