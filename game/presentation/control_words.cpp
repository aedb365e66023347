#include "game/presentation/control_words.h"

#include <algorithm>

#include "game/rules/actions.h"
#include "lanthorn/input/bindings.h"

namespace lanthorn::game {

namespace {

std::string both(const ControlWords& words) {
    return words.pad.empty() ? words.keys : words.keys + " or " + words.pad;
}

}  // namespace

std::vector<ControlWords> control_words() {
    const input::Bindings bindings = usual_bindings();
    std::vector<ControlWords> all = {{"look about", "mouse", "right stick"}};
    for (std::size_t row = 0; row < actions().size(); ++row) {
        const input::Action& action = actions()[row];
        const bool walks = action.kind == input::Kind::held;
        all.push_back({action.words, input::key_list(bindings, row, false),
                       walks ? "left stick" : input::key_list(bindings, row, true)});
    }
    return all;
}

std::string control_lines() {
    const std::vector<ControlWords> all = control_words();
    std::size_t width = 0;
    for (const ControlWords& words : all) {
        width = std::max(width, both(words).size());
    }
    std::string lines;
    for (const ControlWords& words : all) {
        std::string keys = both(words);
        keys.resize(width, ' ');
        lines += "  " + keys + "  " + words.what + '\n';
    }
    return lines;
}

std::string control_sentence() {
    std::string sentence;
    for (const ControlWords& words : control_words()) {
        sentence += (sentence.empty() ? "" : "; ") + words.what + ": " + both(words);
    }
    return sentence;
}

}  // namespace lanthorn::game
