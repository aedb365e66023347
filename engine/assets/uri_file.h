// The files that a glTF's URIs name, and those that it may not name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lanthorn {

struct UriFile {
    std::filesystem::path path;  // empty if there is a problem
    std::string note;            // how the URI was understood, if not as the format has it; usually empty
    std::string problem;         // why no file may be read, one line; empty: `path` may, if it is there
};

// The file in `folder` that a relative URI names. Where there is none of that name, the URI is tried as it
// stands ("a%20b.png" may be a file's name) and with backslashes for slashes, as programs on Windows write
// them. A file that stands, links followed, outside of `folder` is a problem unless `allow_outside`: whoever
// opens a stranger's file does not ask for his own to be read.
UriFile find_uri_file(const std::filesystem::path& folder, std::string_view uri, bool allow_outside);

}  // namespace lanthorn
