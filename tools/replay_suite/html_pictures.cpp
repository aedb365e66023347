#include "tools/replay_suite/html_pictures.h"

#include <fmt/format.h>

#include <cstdint>

#include "engine/core/base64.h"
#include "lanthorn/core/printable.h"
#include "tools/replay_suite/files.h"
#include "tools/replay_suite/summary.h"

namespace lanthorn::suite {

namespace {

using nlohmann::json;

std::string image(const std::string& file, const char* name, const char* style) {
    const std::string bytes = file.empty() ? "" : read_if_there(file);
    if (bytes.empty()) {
        return file.empty() ? "" : fmt::format("<p class=\"small\">{}: gone</p>", markup_text(file));
    }
    return fmt::format("<img class=\"{}\" alt=\"{}\" src=\"data:image/png;base64,{}\">", style, name,
                       base64(bytes));
}

std::string figure(const std::string& inside, const char* caption) {
    return inside.empty() ? ""
                          : fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", inside, caption);
}

std::string sign(bool failed) {
    return fmt::format("<span class=\"sign {}\">{}</span>", failed ? "failed" : "ok", failed ? "✗" : "✓");
}

std::string one(const json& picture) {
    const bool failed = picture.value("failed", false), light_failed = picture.value("light_failed", false);
    std::string html = fmt::format(
        "<p>{} <b>{}</b>, step {}: {}", sign(failed || light_failed), markup_text(picture.value("mark", "")),
        picture.value("step", std::uint64_t{0}), markup_text(picture.value("text", "")));
    if (const std::string light = picture.value("light", ""); !light.empty()) {
        html += "<br>light " + markup_text(light);
    }
    html += "</p>\n";
    const std::string actual = picture.value("actual", ""), expected = picture.value("expected", "");
    if (!failed || actual.empty()) {
        return html;
    }
    html += "<div class=\"figures\">";
    if (expected.empty()) {
        html += figure(image(actual, "actual", "picture"), "actual");
    } else {
        html += figure(image(expected, "expected", "picture"), "expected");
        html += figure(image(actual, "actual", "picture"), "actual");
        html += figure(image(picture.value("difference", ""), "difference", "picture"),
                       "FLIP: black is equal, white is as different as can be");
        html +=
            figure(fmt::format("<div class=\"wipe\">{}{}<input type=\"range\" min=\"0\" max=\"100\" "
                               "value=\"50\" aria-label=\"expected to the left, actual to the right\"></div>",
                               image(expected, "expected", "picture"), image(actual, "actual", "over")),
                   "expected | actual");
    }
    return html + "</div>\n";
}

}  // namespace

std::string pictures_html(const Result& result) {
    std::string html;
    if (result.verify.is_object()) {
        for (const json& picture : result.verify.value("pictures", json::array())) {
            if (picture.is_object()) {
                html += one(picture);
            }
        }
    }
    return html;
}

}  // namespace lanthorn::suite
