// How a program runs, for tools that look at it from outside: one line of JSON a second.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::shell {

class RunLog {
  public:
    // Appends to `file`; an empty name: nothing is written. Throws InputError if it cannot be opened. A line
    // that cannot be written (a full disk) is said once on standard error, after the name of the `program`,
    // and ends the log; the file keeps whole lines.
    RunLog(std::string program, const std::string& file);
    ~RunLog();
    RunLog(const RunLog&) = delete;
    RunLog& operator=(const RunLog&) = delete;

    // What a frame was drawn as.
    struct Drawn {
        // The program's own words and their names, in the order in which they are written. The other names of
        // a line (seconds, picture, frame_ms and those of Holdings) are taken.
        std::vector<std::pair<std::string, std::string>> words;
        ivec2 picture{0};  // pixels

        bool operator==(const Drawn&) const = default;
    };
    // Call after every frame. A line is written, whole, when a second has passed, and when `drawn` is
    // another. Names that are no UTF-8 are written with their bytes as \x text.
    void frame(double ms, const Drawn& drawn);

  private:
    void write();
    void append(const std::string& line);

    std::string program_, file_;
    int out_ = -1;  // descriptor
    Drawn drawn_;
    std::vector<double> frames_;  // milliseconds
    double passed_ = 0, total_ = 0;
};

}  // namespace lanthorn::shell
