#include "rig/sweep/folder_result.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "rig/failure.h"
#include "rig/output/run_folder.h"
#include "rig/sweep/page.h"
#include "rig/sweep/result.h"

namespace foverig::sweep {

std::filesystem::path write_result(const std::filesystem::path& folder) {
    constexpr std::size_t kMostNamed = 10;
    const Measured measured = read_measured(folder);
    std::vector<std::size_t> missing = measured.missing();
    if (!missing.empty()) {
        const std::size_t count = missing.size();
        missing.resize(std::min(count, kMostNamed));
        throw InputError(fmt::format(
            "{}: {} of {} points are not measured yet ({}{}); run the sweep again with the same "
            "--shard to go on",
            folder.string(), count, measured.points(), fmt::join(missing, ", "),
            count > kMostNamed ? ", ..." : ""));
    }
    const auto pareto = pareto_json(measured);
    replace_text(folder / "pareto.json", pareto.dump(2) + "\n");
    replace_text(folder / "pareto.html", page(pareto));
    return folder / "pareto.html";
}

}  // namespace foverig::sweep
