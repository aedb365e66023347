#include "lanthorn/core/turns.h"

#include <cmath>
#include <numbers>

namespace lanthorn {

using glm::dquat;

namespace {

// The sums of the Taylor series for |x| <= pi / 4, whose next terms are below 1e-17.
double sine_near_0(double x) {
    const double s = x * x;
    return x * (1 + s * (-1.0 / 6 +
                         s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 +
                                                                  s * (-1.0 / 39916800 +
                                                                       s * (1.0 / 6227020800 +
                                                                            s * (-1.0 / 1307674368000))))))));
}
double cosine_near_0(double x) {
    const double s = x * x;
    return 1 + s * (-1.0 / 2 +
                    s * (1.0 / 24 + s * (-1.0 / 720 +
                                         s * (1.0 / 40320 + s * (-1.0 / 3628800 +
                                                                 s * (1.0 / 479001600 +
                                                                      s * (-1.0 / 87178291200 +
                                                                           s * (1.0 / 20922789888000))))))));
}

dquat about(const dvec3& axis, double radians) {
    const SineCosine half = sine_cosine(0.5 * radians);
    return {half.cosine, half.sine * axis};
}

}  // namespace

SineCosine sine_cosine(double radians) {
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    int quarters = 0;  // the last bits of how many were taken off
    const double x = std::remquo(radians, kQuarter, &quarters);
    const double s = sine_near_0(x), c = cosine_near_0(x);
    switch (quarters & 3) {
        case 0:
            return {s, c};
        case 1:
            return {c, -s};
        case 2:
            return {-s, -c};
        default:
            return {-c, s};
    }
}

dquat about_x(double radians) {
    return about({1, 0, 0}, radians);
}
dquat about_y(double radians) {
    return about({0, 1, 0}, radians);
}
dquat about_z(double radians) {
    return about({0, 0, 1}, radians);
}

}  // namespace lanthorn
