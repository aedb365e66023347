// A file that a program keeps for its user from one run to the next: options, progress. It is written whole
// or not at all; a damaged one is kept aside; where nothing can be written the program goes on without.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "lanthorn/core/error.h"

namespace lanthorn::shell {

// Takes one line for the user to read.
using Say = std::function<void(const std::string&)>;

class KeptFile {
  public:
    // `what`: the file in a word or two, for the lines that are said. An empty `path` keeps nothing.
    KeptFile(std::filesystem::path path, std::string what, Say say);

    const std::filesystem::path& path() const { return path_; }  // empty: nothing is kept

    // All bytes; nothing if there is no such file, or, which is said, if it cannot be read or is larger than
    // kMostBytes.
    std::optional<std::string> read();

    // For what read() gave and is of no use: renames it to NAME.damaged, in the place of an older one, and
    // says so with the `problem`. If that fails the file stays, and write() does nothing any more.
    void put_aside(std::string_view problem);

    // What `parse(bytes, source)` makes of the file. Where there is none, and where that throws InputError,
    // for which the file is put aside: what a file that says nothing would give.
    template <class Parse>
    auto read_as(Parse parse) -> decltype(parse(std::string_view(), std::string_view())) {
        try {
            if (const std::optional<std::string> bytes = read()) {
                return parse(*bytes, path_.string());
            }
        } catch (const InputError& e) {
            put_aside(e.what());
        }
        return {};
    }

    // What another program has put there since read(); nothing where none has.
    std::optional<std::string> written_by_others() const;

    // Makes the folder if need be. Returns whether the file is written; says the first time why it is not.
    // What another program has put there since read() is renamed to NAME.other, in the place of an older one,
    // and that is said.
    bool write(std::string_view bytes);

    static constexpr std::uintmax_t kMostBytes = 256u << 20u;

  private:
    void fail(const std::string& line);
    std::optional<std::string> bytes() const;
    void keep_others();

    std::filesystem::path path_;
    std::string what_;
    Say say_;
    // Hash of what lies there as far as this knows, 0 for no file; nothing before read().
    std::optional<std::size_t> known_;
    bool locked_ = false;  // what lies there must not be written over
    bool said_failure_ = false;
};

// Where the file `name` of a user of `program` belongs (XDG Base Directory Specification 0.8): in the folder
// `program` below $XDG_CONFIG_HOME or ~/.config, and below $XDG_DATA_HOME or ~/.local/share. Empty if the
// environment names neither; relative paths in it count for nothing.
std::filesystem::path config_file(std::string_view program, std::string_view name);
// Likewise for what the program makes rather than what its user chose.
std::filesystem::path data_file(std::string_view program, std::string_view name);
// Likewise, below $XDG_CACHE_HOME or ~/.cache, for what costs nothing but time to make once more.
std::filesystem::path cache_file(std::string_view program, std::string_view name);

}  // namespace lanthorn::shell
