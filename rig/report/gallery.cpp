#include "rig/report/gallery.h"

#include <fmt/format.h>

#include <algorithm>
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
    std::optional<std::array<double, 2>> gaze_px;
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
        const auto gaze = image.find("gaze_px");
        kept.push_back({image.value("frame", std::int64_t{0}), image.value("kind", ""),
                        image.value("eye", ""), image.value("file", ""),
                        error != image.end() && error->is_number()
                            ? std::optional(error->get<double>())
                            : std::nullopt,
                        gaze != image.end() ? std::optional(gaze->get<std::array<double, 2>>())
                                            : std::nullopt});
    }
    return kept;
}

/// Shown over another in turns, where the page's switch is on; empty: nothing to compare with.
std::string over(const Picture& picture) {
    if (picture.rgb.empty()) return "";
    return fmt::format("<img class=\"over\" src=\"{}\" alt=\"the same in full\">",
                       jpeg_uri(picture, 88));
}

std::string figure(const char* css_class, const Picture& picture, const Picture& full,
                   const std::string& words, const std::string& file) {
    return fmt::format(
        "<figure class=\"{}\"><div class=\"stack\"><img src=\"{}\" width=\"{}\" height=\"{}\" "
        "alt=\"{}\">{}</div><figcaption>{} <code>{}</code></figcaption></figure>",
        css_class, jpeg_uri(picture, 88), picture.width_px, picture.height_px, escaped(words),
        over(full), escaped(words), escaped(file));
}

Picture read(const RunData& run, const Kept* kept) {
    return kept == nullptr ? Picture{} : read_png(run.folder / kept->file);
}

/// An image as a whole, and of a final one a fifth of its width around the gaze.
std::string figures(const RunData& run, const Kept& kept, const Kept* full, const char* caption,
                    int width_px) {
    const Picture picture = read_png(run.folder / kept.file);
    const Picture truth = read(run, full);
    std::string words = kept.eye.empty() ? caption : fmt::format("{} eye, {}", kept.eye, caption);
    if (kept.error) words += fmt::format("; mean {} of full scale", percent(kept.error));
    const bool wide = picture.width_px > picture.height_px;
    std::string html = figure(wide ? "wide" : "eye", shrunk(picture, width_px),
                              shrunk(truth, width_px), words, kept.file);
    if (!kept.gaze_px) return html;
    const auto [x_px, y_px] = *kept.gaze_px;
    const auto around = [&, x = x_px, y = y_px](const Picture& whole) {
        return whole.rgb.empty() ? whole : cropped(whole, x, y, whole.width_px / 5);
    };
    return html + figure("eye magnified", around(picture), around(truth),
                         kept.eye + " eye, around the gaze, magnified", kept.file);
}

std::string drawn(const RunData& run, const std::vector<Kept>& images, int width_px) {
    std::map<std::int64_t, std::vector<const Kept*>> by_frame;
    for (const Kept& image : images) by_frame[image.frame].push_back(&image);
    std::string html;
    for (const auto& [frame, of_frame] : by_frame) {
        const auto find = [&, &of = of_frame](const std::string& eye, const std::string& kind) {
            const auto found = std::find_if(of.begin(), of.end(), [&](const Kept* image) {
                return image->eye == eye && image->kind == kind;
            });
            return found == of.end() ? nullptr : *found;
        };
        html += fmt::format("<div><h3>Frame {}</h3>", frame);
        if (find("left", "full") != nullptr)
            html += fmt::format(
                "<input type=\"checkbox\" class=\"flicker\" id=\"flicker-{0}\"><label "
                "for=\"flicker-{0}\"> show the rendered and the full image in turns</label>",
                frame);
        // A row for each eye, so that its pictures lie side by side; the panel shows both.
        for (const char* eye : {"left", "right", ""}) {
            html += "<div class=\"gallery\">";
            for (const Kind& kind : kKinds) {
                const Kept* image = find(eye, kind.name);
                if (image == nullptr) continue;
                const Kept* full = kind.name == kKinds[0].name ? find(eye, "full") : nullptr;
                html += figures(run, *image, full, kind.caption,
                                image->eye.empty() ? 2 * width_px : width_px);
            }
            html += "</div>";
        }
        html += "</div>";
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
