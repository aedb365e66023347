#pragma once

#include <string>
#include <vector>

namespace lanthorn::tools {

// Rows of text in columns that line up; the first row is the heading.
class TextTable {
  public:
    explicit TextTable(std::vector<std::string> heading) { rows_.push_back(std::move(heading)); }
    // What a terminal would obey is written out (lanthorn/core/printable.h).
    void add(std::vector<std::string> row);
    bool empty() const { return rows_.size() == 1; }
    // Two spaces before and between the columns, a newline after each row; nothing for an empty table.
    std::string text() const;

  private:
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace lanthorn::tools
