// The words of the game in the player's language: a table from the English ones, which the code says, to
// those that are shown. English has a table too, for what the level files say plainer than a player needs it.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lanthorn::game {

class Words {
  public:
    // Of nothing: every word stays as it is.
    Words() = default;
    // {"language": "Deutsch", "words": {"Play": "Spielen", ...}}. Throws InputError naming `source` and the
    // member for what is no such JSON.
    static Words from_json(std::string_view json, std::string_view source);

    const std::string& language() const { return language_; }  // as it calls itself; empty: of nothing
    // What is shown for it: the table's, else the English itself.
    std::string say(std::string_view english) const;
    // Of `all`, what this table has no word for, in order.
    std::vector<std::string> holes(const Words& all) const;
    // What was asked for and is not there, since this was made: for tests of a table.
    const std::set<std::string>& unknown() const { return unknown_; }

  private:
    std::string language_;
    std::map<std::string, std::string, std::less<>> words_;
    mutable std::set<std::string> unknown_;
};

// `text` with every {name} replaced by what `named` gives for it; what it gives nothing for stays.
template <class Named>
std::string fill_in(std::string_view text, const Named& named) {
    std::string filled;
    while (!text.empty()) {
        const std::size_t open = text.find('{'), close = text.find('}', open);
        if (close == std::string_view::npos) {
            break;
        }
        const std::string with = named(text.substr(open + 1, close - open - 1));
        filled += text.substr(0, open);
        filled += with.empty() ? std::string(text.substr(open, close - open + 1)) : with;
        text.remove_prefix(close + 1);
    }
    return filled += text;
}

}  // namespace lanthorn::game
