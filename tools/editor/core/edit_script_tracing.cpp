// Which technique draws a script's pictures, and pictures whose samples grow line by line.
#include <fmt/format.h>

#include <charconv>

#include "lanthorn/core/error.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/runtime/app.h"
#include "tools/editor/core/edit_script.h"
#include "tools/editor/core/two_sides.h"

namespace lanthorn::editor {

namespace {

constexpr double kMostMs = 1e9;

double number(const std::string& text, double low, double high, const char* what) {
    double value = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (problem != std::errc() || end != text.data() + text.size() || !(value >= low && value <= high)) {
        throw InputError(fmt::format("found '{}', expected {}", text, what));
    }
    return value;
}

}  // namespace

void EditScript::choose_technique(const std::vector<std::string>& words) {
    expect_words(words, 2, 2, "technique TECHNIQUE, TECHNIQUE/PRESET, /PRESET or back");
    if (words[1] == "back") {
        if (!settings_before_) {
            throw InputError("technique back: found no technique before this one");
        }
        settings_ = *settings_before_;
        settings_before_.reset();
    } else {
        Settings chosen = drawn_as(words[1], {settings_, ""}).settings;
        settings_before_ = settings_;
        settings_ = std::move(chosen);
    }
    traced_size_ = ivec2(0);
    traced_.forget();
}

// The frames that follow those before, while nothing else has been drawn.
void EditScript::trace(const std::vector<std::string>& words) {
    expect_words(words, 1, 3, "trace [WIDTHxHEIGHT [FRAMES]]");
    CheckedFrames what = frames_in(words, 1);
    what.frames = words.size() > 2 ? what.frames : 1;
    const ivec2 size_before = traced_size_;
    need_context();
    if (!gi::technique_entry(gi::gi_settings(settings_).technique).is_reference) {
        throw InputError(fmt::format("trace: found technique {}, expected one whose samples grow (path)",
                                     settings_.text("gi.technique")));
    }
    if (what.size != size_before || session_.version() != traced_version_) {
        session_.refresh_guests();
        begin_cold(session_, settings_, what.size);
        traced_version_ = session_.version();
        traced_.forget();
    }
    for (int i = 0; i < what.frames; ++i) {
        session_.app().view().camera = session_.eye();
        session_.app().show();
        traced_.drew(gi::technique_of(session_.app(), ViewId::first).progress(), 0);
    }
    traced_size_ = what.size;
    print_(progress_words());
}

std::string EditScript::progress_words() const {
    return traced_.grows() ? traced_.words() : "nothing is traced";
}

// MS: what a sample of every pixel is said to take. What passes take here would differ from run to run.
void EditScript::print_progress(const std::vector<std::string>& words) {
    expect_words(words, 2, 3, "progress [MS]");
    std::string line = progress_words();
    if (words.size() > 2 && traced_.due()) {
        const double ms = number(words[2], 0, kMostMs, "milliseconds from 0 to 1e9");
        line += ", " + duration_words(traced_.seconds_left(ms)) + " left";
    }
    print_(line);
}

void EditScript::expect_progress(const std::vector<std::string>& words) {
    if (words[1] == "technique") {
        expect_words(words, 3, 3, "technique TECHNIQUE");
        expect_value("the technique", '"' + settings_.text("gi.technique") + '"', words[2]);
        return;
    }
    expect_words(words, 4, 4, "progress DONE WANTED");
    expect_value("what is traced", '"' + progress_words() + '"',
                 fmt::format("{} of {} samples", words[2], words[3]));
}

}  // namespace lanthorn::editor
