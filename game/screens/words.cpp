#include "game/screens/words.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"

namespace lanthorn::game {

Words Words::from_json(std::string_view text, std::string_view source) {
    const nlohmann::json all = parse_json_object(text, source, "a language, as JSON");
    const auto expect = [&](bool holds, const std::string& member, const char* what) {
        if (!holds) {
            throw InputError(source, member, std::string("expected ") + what);
        }
    };
    Words words;
    const auto language = all.find("language");
    expect(language != all.end() && language->is_string() && !language->get<std::string>().empty(),
           "language", "the language's name for itself");
    words.language_ = language->get<std::string>();
    const auto table = all.find("words");
    expect(table != all.end() && table->is_object(), "words", "an object of English words and their own");
    for (const auto& [english, own] : table->items()) {
        expect(own.is_string(), "words/" + english, "a text");
        if (!own.get<std::string>().empty()) {
            words.words_.emplace(english, own.get<std::string>());
        }
    }
    return words;
}

std::string Words::say(std::string_view english) const {
    const auto found = words_.find(english);
    if (found == words_.end()) {
        unknown_.emplace(english);
        return std::string(english);
    }
    return found->second;
}

std::vector<std::string> Words::holes(const Words& all) const {
    std::vector<std::string> missing;
    for (const auto& [english, own] : all.words_) {
        if (!words_.contains(english)) {
            missing.push_back(english);
        }
    }
    return missing;
}

}  // namespace lanthorn::game
