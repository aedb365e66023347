// Clips in scripts.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "lanthorn/core/error.h"
#include "tools/editor/core/edit_script.h"
#include "tools/editor/core/scene_clips.h"

namespace lanthorn::editor {

namespace {

double seconds_in(const std::string& text) {
    double seconds = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), seconds);
    if (problem != std::errc() || end != text.data() + text.size() || !(seconds >= 0) ||
        !std::isfinite(seconds)) {
        throw InputError(fmt::format("found '{}', expected seconds of 0 or more", text));
    }
    return seconds;
}

}  // namespace

void EditScript::show_clip(const std::vector<std::string>& words) {
    expect_words(words, 1, 3, "clip [NAME|none [SECONDS]]");
    if (!session_.is_open()) {
        throw InputError("found no scene, expected open FILE or new-room before it");
    }
    session_.show_moment(words.size() > 1 ? std::optional(words[1]) : std::nullopt,
                         words.size() > 2 ? seconds_in(words[2]) : 0);
}

void EditScript::expect_clip(const std::vector<std::string>& words) {
    const std::string starts = start_clip(session_, clip_rows(session_));
    if (words[1] == "starts-with") {
        expect_words(words, 3, 3, "expect starts-with NAME");
        expect_value("the clip that the file begins with", '"' + starts + '"', words[2]);
        return;
    }
    expect_words(words, 3, 4, "expect clip NAME [SECONDS]");
    expect_value("the clip that is shown", '"' + session_.shown_clip().value_or(starts) + '"', words[2]);
    if (words.size() > 3) {
        expect_value("the moment that is shown", fmt::format("{}", session_.moment()), words[3]);
    }
}

void EditScript::print_clips() {
    const std::vector<ClipRow> clips = clip_rows(session_);
    if (clips.empty()) {
        print_("no clips");
    }
    const std::string starts = start_clip(session_, clips);
    for (const ClipRow& clip : clips) {
        print_(fmt::format("{} {:<24} {:.3f} s, {} frames at {} a second, moves {} node{}",
                           clip.key == starts ? '>' : ' ', clip.name.empty() ? '#' + clip.key : clip.name,
                           clip.seconds, std::lround(clip.seconds * clip.rate), clip.rate, clip.nodes.size(),
                           clip.nodes.size() == 1 ? "" : "s"));
    }
}

}  // namespace lanthorn::editor
