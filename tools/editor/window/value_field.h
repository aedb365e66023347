// A row with a name and a value: the name is dragged, the value is clicked on and typed.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"

namespace lanthorn::edit_window {

// What the hand does to a row's value in this frame.
enum class Doing { nothing, dragging, done, dropped };

struct NumberRow {
    std::string label;
    double value = 0;
    std::string unit = {};
    bool mixed = false;  // several things are chosen that differ in it
    double lower = std::numeric_limits<double>::lowest(), upper = std::numeric_limits<double>::max();
    double step = 0.01;                  // of the value, a pixel; of a logarithmic one its share
    bool logarithmic = false;            // drags by ratios: lamps, ranges
    std::optional<double> initial = {};  // the default: a double click on the name; a dot where it differs
    std::string words = {};              // what it is, shown by hovering
    int digits = 5;
};

struct NumberChange {
    Doing doing = Doing::nothing;
    double value = 0;
    std::string unit;  // that was typed behind it where that is another than the row's
};

// Draws rows, and remembers what is being dragged and typed in them.
class ValueFields {
  public:
    // `names`: width of their column, pixels.
    void begin(float names, float unit) {
        names_ = names;
        unit_ = unit;
    }
    NumberChange number(const NumberRow& row);
    // Three numbers in a row, as x, y and z. `which` of them changed.
    NumberChange vector(const std::string& label, const dvec3& value, const std::string& unit, double step,
                        bool mixed, const std::string& words, int& which);
    // Returns whether another was chosen.
    bool choice(const std::string& label, const std::vector<std::string>& names, int& value,
                const std::string& words);
    bool flag(const std::string& label, bool& value, const std::string& words);
    // Linear RGB whose largest part is 1 at most, edited as sRGB.
    Doing colour(const std::string& label, vec3& value, const std::string& words);
    // Whether Enter was pressed on other text.
    bool text(const std::string& label, std::string& value, const std::string& words);
    bool dragging() const { return dragged_ != 0; }
    void let_go() { dropped_ = dragged_ != 0; }  // Esc: the drag ends as it began

  private:
    void name(const std::string& label, const std::string& words, bool differs);
    NumberChange field(const char* id, const NumberRow& row, float width);
    // The id's own drag by the item that was just added.
    NumberChange drag(unsigned id, const NumberRow& row);

    float names_ = 100, unit_ = 1;
    unsigned dragged_ = 0;
    double from_ = 0, at_ = 0;
    bool dropped_ = false, moved_ = false;
    unsigned typed_in_ = 0;
    std::string typed_;
    vec3 colour_{0};
};

}  // namespace lanthorn::edit_window
