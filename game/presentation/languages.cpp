#include "game/presentation/languages.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include "lanthorn/core/error.h"

namespace lanthorn::game {

namespace {

namespace fs = std::filesystem;

constexpr const char* kEnglish = "en";

}  // namespace

std::string language_of_system() {
    for (const char* variable : {"LC_ALL", "LC_MESSAGES", "LANG"}) {
        const char* value = std::getenv(variable);
        if (value != nullptr && *value != '\0') {
            const std::string name = value;
            return name.substr(0, name.find_first_of("_.@"));
        }
    }
    return "";
}

Languages::Languages(const fs::path& folder, shell::Say say) : folder_(folder), say_(std::move(say)) {
    codes_.emplace_back(kEnglish);
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
        const fs::path& file = entry.path();
        if (file.extension() == ".json" && file.stem() != kEnglish) {
            codes_.push_back(file.stem().string());
        }
    }
    std::ranges::sort(codes_);
    english_ = read(kEnglish);
}

Words Languages::read(const std::string& code) const {
    const fs::path file = folder_ / (code + ".json");
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    if (!stream) {
        if (code != kEnglish) {
            say_(file.string() + ": cannot be read; the game speaks English");
        }
        return {};
    }
    try {
        return Words::from_json(text.str(), file.string());
    } catch (const InputError& e) {
        say_(std::string(e.what()) + "; the game speaks English");
        return {};
    }
}

const Words& Languages::words(const std::string& code) {
    const auto known = [&](const std::string& one) { return std::ranges::count(codes_, one) > 0; };
    const std::string system = language_of_system();
    const std::string wanted = known(code) ? code : known(system) ? system : kEnglish;
    if (wanted == code_) {
        return words_;
    }
    code_ = wanted;
    words_ = wanted == kEnglish ? english_ : read(wanted);
    if (words_.language().empty()) {
        words_ = english_;
        return words_;
    }
    if (const std::vector<std::string> holes = words_.holes(english_); !holes.empty()) {
        say_((folder_ / (wanted + ".json")).string() + ": has no words for " + std::to_string(holes.size()) +
             " of the English ones, the first '" + holes.front() + "'; those stay English");
    }
    return words_;
}

}  // namespace lanthorn::game
