#include <fmt/format.h>

#include "rig/commands.h"
#include "rig/output/run_folder.h"
#include "rig/report/page.h"

namespace foverig {

ExitCode report_command(const std::vector<std::filesystem::path>& runs) {
    for (const auto& run : runs) {
        const auto file = run / "report.html";
        replace_text(file, report::page(report::read_run(run)));
        fmt::print("report: {}\n", std::filesystem::absolute(file).lexically_normal().string());
    }
    return ExitCode::good;
}

}  // namespace foverig
