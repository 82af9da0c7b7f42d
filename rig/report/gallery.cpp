#include "rig/report/gallery.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <vector>

#include "rig/report/markup.h"
#include "rig/report/picture.h"

namespace foverig::report {
namespace {

struct Kept {
    std::int64_t frame = 0;
    std::string kind;
    std::string eye;
    std::string file;
    std::optional<double> error;  ///< mean absolute, against full
};

struct Kind {
    const char* name;
    const char* caption;
};

constexpr std::array<Kind, 5> kKinds{{
    {"final", "as rendered"},
    {"sampling", "traced pixels"},
    {"resampling", "reprojection found wanting"},
    {"error", "difference to full, 8 times"},
    {"panel", "on the panel, distorted"},
}};

std::vector<Kept> kept_images(const RunData& run) {
    std::vector<Kept> kept;
    if (!run.summary.contains("images")) return kept;
    for (const auto& image : run.summary["images"]) {
        const auto error = image.find("mean_absolute_error");
        kept.push_back({image.value("frame", std::int64_t{0}), image.value("kind", ""),
                        image.value("eye", ""), image.value("file", ""),
                        error != image.end() && error->is_number()
                            ? std::optional(error->get<double>())
                            : std::nullopt});
    }
    return kept;
}

std::string figure(const RunData& run, const Kept& kept, const char* caption, int width_px) {
    const Picture picture = shrunk(read_png(run.folder / kept.file), width_px);
    std::string words = kept.eye.empty() ? caption : fmt::format("{} eye, {}", kept.eye, caption);
    if (kept.error) words += fmt::format("; mean {} of full scale", percent(kept.error));
    return fmt::format(
        "<figure class=\"{}\"><img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\"><figcaption>{} "
        "<code>{}</code></figcaption></figure>",
        picture.width_px > picture.height_px ? "wide" : "eye", jpeg_uri(picture, 88),
        picture.width_px, picture.height_px, escaped(words), escaped(words), escaped(kept.file));
}

std::string drawn(const RunData& run, const std::vector<Kept>& images, int width_px) {
    std::map<std::int64_t, std::vector<const Kept*>> by_frame;
    for (const Kept& image : images) by_frame[image.frame].push_back(&image);
    std::string html;
    for (const auto& [frame, of_frame] : by_frame) {
        html += fmt::format("<h3>Frame {}</h3>", frame);
        // A row for each eye, so that its pictures lie side by side; the panel shows both.
        for (const char* eye : {"left", "right", ""}) {
            html += "<div class=\"gallery\">";
            for (const Kind& kind : kKinds) {
                for (const Kept* image : of_frame) {
                    if (image->eye != eye || image->kind != kind.name) continue;
                    const int width = image->eye.empty() ? 2 * width_px : width_px;
                    html += figure(run, *image, kind.caption, width);
                }
            }
            html += "</div>";
        }
    }
    return html;
}

}  // namespace

std::string gallery(const RunData& run, std::size_t most_bytes) {
    const auto images = kept_images(run);
    if (images.empty()) return "<p>No image was kept (images.count is 0).</p>";
    std::string html;
    for (const int width_px : {600, 480, 360, 270, 200, 140, 100, 70}) {
        html = drawn(run, images, width_px);
        if (html.size() <= most_bytes) return html;
    }
    return html;
}

}  // namespace foverig::report
