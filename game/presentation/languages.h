// The languages that there are: one file each in assets/languages, named after the language's code. Where the
// player has chosen none it is the system's (LC_ALL, LC_MESSAGES, LANG), else English.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "game/screens/words.h"
#include "lanthorn/shell/kept_file.h"

namespace lanthorn::game {

class Languages {
  public:
    // Of that folder's files. `say` is told of files that cannot be read and of languages with holes, whose
    // words stay English: a line each, when they are asked for.
    Languages(const std::filesystem::path& folder, shell::Say say);

    // Codes, in order; "en" is among them whether there is a file or not.
    const std::vector<std::string>& codes() const { return codes_; }
    // The words of `code`; of a code that is not there or empty: the system's language, else English. Reads
    // the file when another is asked for than before.
    const Words& words(const std::string& code);
    // The code that words() has been given for last.
    const std::string& code() const { return code_; }

  private:
    Words read(const std::string& code) const;

    std::filesystem::path folder_;
    shell::Say say_;
    std::vector<std::string> codes_;
    std::string code_;
    Words english_, words_;
};

// "de" of "de_DE.UTF-8"; empty where the environment names none.
std::string language_of_system();

}  // namespace lanthorn::game
