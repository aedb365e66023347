#include "tools/lanthorn/common/svg.h"

#include <algorithm>
#include <cmath>

namespace lanthorn::tools {

LogAxis::LogAxis(double low, double high, double from, double to)
    : low_(std::log10(low)), high_(std::log10(high)), from_(from), to_(to) {}

double LogAxis::operator()(double value) const {
    return from_ + (to_ - from_) * (std::log10(value) - low_) / (high_ - low_);
}

std::vector<double> LogAxis::ticks() const {
    std::vector<double> list;
    for (int e = static_cast<int>(std::floor(low_)); e <= static_cast<int>(std::ceil(high_)); ++e) {
        for (const double m : {1.0, 2.0, 5.0}) {
            const double value = m * std::pow(10.0, e);
            if (std::log10(value) >= low_ && std::log10(value) <= high_) {
                list.push_back(value);
            }
        }
    }
    return list;
}

void LogRange::add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
}

}  // namespace lanthorn::tools
