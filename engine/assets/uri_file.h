// The files that a glTF's URIs name, and those that it may not name.
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>

namespace lanthorn {

struct UriFile {
    std::filesystem::path path;  // empty if there is a problem
    std::string note;            // how the URI was understood, if not as the format has it; usually empty
    std::string problem;         // why no file may be read, one line; empty: `path` may, if it is there
};

// What is in folders, each read once: for all the files that one document names. Any thread may ask.
class FolderNames {
  public:
    // The only entry of `folder` that is `name` but for the case of a-z, by its own name; empty if there is
    // none, or more than one. The same folder must be given by the same path.
    std::string in_any_case(const std::filesystem::path& folder, const std::string& name);

  private:
    using Entries = std::unordered_map<std::string, std::string>;  // by name in lower case; empty: several

    std::mutex mutex_;
    std::map<std::filesystem::path, Entries> folders_;
};

// The file in `folder` that a relative URI names. Where there is none of that name, the URI is tried as it
// stands ("a%20b.png" may be a file's name), with backslashes for slashes, as programs on Windows write
// them, and in any case. A file that stands, links followed, outside of `folder` is a problem unless
// `allow_outside`, nor is a folder there read: whoever opens a stranger's file does not ask for his own to be
// read.
UriFile find_uri_file(const std::filesystem::path& folder, std::string_view uri, bool allow_outside,
                      FolderNames& names);

}  // namespace lanthorn
