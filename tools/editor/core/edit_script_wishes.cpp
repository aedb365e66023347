// Light wishes in scripts.
#include <fmt/format.h>

#include <algorithm>

#include "tools/editor/core/edit_script.h"
#include "tools/editor/core/light_wishes.h"

namespace lanthorn::editor {

bool EditScript::run_wishes(const std::vector<std::string>& words) {
    const std::string& verb = words[0];
    if (verb == "wish") {
        expect_words(words, 3, 4, "wish WHERE LUX [RADIUS]");
        wishes_.push_back(wish_of(words[1], words[2], words.size() > 3 ? words[3] : std::string()));
    } else if (verb == "keep") {
        expect_words(words, 2, 1000, "keep PATH...");
        for (std::size_t i = 1; i < words.size(); ++i) {
            const std::uint32_t node = session_.node_at(words[i]);
            if (light_of(session_.model(), node) == nullptr) {
                throw InputError(fmt::format("keep: '{}' has no light, expected a node with one", words[i]));
            }
            kept_.push_back(words[i]);
        }
    } else if (verb == "solve") {
        expect_words(words, 1, 1, "solve alone");
        const WishSolution found = solution();
        const std::vector<std::string> lines = found.commands();
        if (!lines.empty()) {
            session_.run(kSolveTitle, lines);
        }
        for (const WishOutcome& outcome : found.outcomes) {
            print_(outcome_words(outcome));
        }
        print_(solution_words(found));
    } else if (verb == "forget-wishes") {
        expect_words(words, 1, 1, "forget-wishes alone");
        wishes_.clear();
        kept_.clear();
    } else {
        return false;
    }
    return true;
}

WishSolution EditScript::solution() {
    if (!session_.is_open()) {
        throw InputError("found no scene, expected open FILE or new-room before it");
    }
    if (wishes_.empty()) {
        throw InputError("found no wish, expected wish WHERE LUX before it");
    }
    session_.refresh_guests();
    session_.app().show();
    return solve_wishes(wish_task(session_, settings_, wishes_, kept_));
}

// As the lamps are now, traced once more.
void EditScript::expect_wishes(const std::string& wanted) {
    if (wanted != "met" && wanted != "missed") {
        throw InputError(fmt::format("expect wishes: found '{}', expected met or missed", wanted));
    }
    bool met = true;
    std::string lines;
    for (const WishOutcome& outcome : solution().outcomes) {
        met = met && outcome.met_with(outcome.before);
        lines += (lines.empty() ? "" : "; ") + outcome_words(outcome);
    }
    if (met != (wanted == "met")) {
        throw Error(ExitCode::check_failed, fmt::format("the wishes are {}, expected them {}: {}",
                                                        met ? "met" : "missed", wanted, lines));
    }
}

}  // namespace lanthorn::editor
