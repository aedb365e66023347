// Running a program as a user does, with its output caught in files (so that it is no terminal).
#pragma once

#include <string>
#include <vector>

namespace lanthorn::testing_tools {

struct Outcome {
    int code = -1;  // exit code; minus the signal's number if one ended it
    std::string out, err;
    long error_lines() const;
};

// `environment`: "NAME=VALUE" on top of this process's.
Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::vector<std::string>& environment = {});

std::string file_bytes(const std::string& path);
std::vector<std::string> files_in(const std::string& folder);  // names, sorted

// A new folder that is removed with everything in it.
class TemporaryFolder {
  public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    std::string path(const std::string& name = {}) const { return name.empty() ? path_ : path_ + "/" + name; }
    std::vector<std::string> files() const { return files_in(path_); }

  private:
    std::string path_;
};

}  // namespace lanthorn::testing_tools
