// What drawings of measurements share: axes.
#pragma once

#include <string>
#include <vector>

namespace lanthorn::tools {

// A logarithmic axis over a range of values, in pixels.
class LogAxis {
  public:
    // `low` and `high` are more than 0, and lie at `from` and `to`.
    LogAxis(double low, double high, double from, double to);

    double operator()(double value) const;
    // 1, 2 and 5 times the powers of ten within the range.
    std::vector<double> ticks() const;

  private:
    double low_, high_, from_, to_;
};

// The least and the largest of the values that were added, which are more than 0.
struct LogRange {
    double low = 1e300, high = 0;
    void add(double value);
    // Over a little more than these.
    LogAxis axis(double from, double to) const { return {low / 1.15, high * 1.15, from, to}; }
};

}  // namespace lanthorn::tools
