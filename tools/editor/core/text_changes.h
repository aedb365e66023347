// What saving would change in a file: the lines, and how many bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace lanthorn::editor {

struct TextChanges {
    struct Line {
        bool added = false;    // else taken away
        std::size_t line = 0;  // from 1, of the text that it stands in
        std::string text;
    };
    std::vector<Line> lines;        // in the order of the file, what goes before what comes
    std::size_t changed_lines = 0;  // a line that is replaced counts once
    std::size_t changed_bytes = 0;  // the larger of what goes and what comes, of each stretch
    bool empty() const { return lines.empty(); }
};

// Lines are compared; a line longer than 200 bytes is taken apart behind commas and brackets, so that files
// of one line say something, too. O(bytes + differences^2), differences bounded.
TextChanges text_changes(std::string_view before, std::string_view after);

// "3 lines, 61 bytes of 4.1 MB"; "nothing" for none.
std::string summary(const TextChanges& changes, std::size_t file_bytes);

}  // namespace lanthorn::editor
