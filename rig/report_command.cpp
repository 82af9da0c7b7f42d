#include <fmt/format.h>

#include "rig/commands.h"
#include "rig/output/run_folder.h"
#include "rig/report/page.h"
#include "rig/sweep/folder_result.h"
#include "rig/sweep/merged.h"

namespace foverig {

ExitCode report_command(const std::vector<std::filesystem::path>& runs) {
    for (const auto& run : runs) {
        auto file = run / "report.html";
        if (sweep::is_sweep(run))
            file = sweep::write_result(run);
        else
            replace_text(file, report::page(report::read_run(run)));
        fmt::print("report: {}\n", std::filesystem::absolute(file).lexically_normal().string());
    }
    return ExitCode::good;
}

}  // namespace foverig
