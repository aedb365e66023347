#include "tools/lanthorn/measure/photon_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/core/error.h"

namespace lanthorn::tools {

namespace {

struct Line {
    double at_0 = 0, slope = 0;
};

// By least squares, neither part below 0.
template <class X, class Y>
Line fit(std::span<const PhotonFrame> frames, const X& x, const Y& y) {
    const auto n = static_cast<double>(frames.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const PhotonFrame& f : frames) {
        sx += x(f);
        sy += y(f);
        sxx += x(f) * x(f);
        sxy += x(f) * y(f);
    }
    const double spread = n * sxx - sx * sx;
    Line line;
    line.slope = spread > 0 ? std::max((n * sxy - sx * sy) / spread, 0.0) : 0;
    line.at_0 = (sy - line.slope * sx) / n;
    if (line.at_0 < 0) {  // through 0
        line = {0, sxx > 0 ? sxy / sxx : 0};
    }
    return line;
}

double n_log_n(int total) {
    return total * std::log2(std::max(total, 2));
}

}  // namespace

PhotonCosts::PhotonCosts(std::span<const PhotonFrame> measured) {
    const Line shoot = fit(
        measured, [](const PhotonFrame& f) { return static_cast<double>(f.per_frame); },
        [](const PhotonFrame& f) { return f.shoot; });
    shoot_ = shoot.at_0;
    per_photon_ = shoot.slope;
    double squares = 0, products = 0;
    for (const PhotonFrame& f : measured) {
        squares += n_log_n(f.total) * n_log_n(f.total);
        products += n_log_n(f.total) * f.balance;
    }
    balance_ = squares > 0 ? products / squares : 0;
    const Line estimate = fit(
        measured, [](const PhotonFrame& f) { return std::log2(std::max(f.total, 2)); },
        [](const PhotonFrame& f) { return f.estimate; });
    estimate_ = estimate.at_0;
    by_doubling_ = estimate.slope;
}

PhotonFrame PhotonCosts::at(int total, int per_frame) const {
    return {total, per_frame, shoot_ + per_photon_ * per_frame, balance_ * n_log_n(total),
            estimate_ + by_doubling_ * std::log2(std::max(total, 2))};
}

PhotonFrame choose_photons(const PhotonCosts& costs, double frame_ms) {
    const auto frame_of = [&](int total) {
        int least = 1, most = total;  // the most photons that take no longer than balancing
        const double balance = costs.at(total, 1).balance;
        while (least < most) {
            const int middle = least + (most - least + 1) / 2;
            (costs.at(total, middle).shoot <= balance ? least : most) =
                costs.at(total, middle).shoot <= balance ? middle : middle - 1;
        }
        return costs.at(total, least);
    };
    if (!(frame_of(1).whole() <= frame_ms)) {
        throw InputError(fmt::format(
            "--frame-ms: found {:g}, expected at least the {:.3g} ms that a frame of one photon takes",
            frame_ms, frame_of(1).whole()));
    }
    int least = 1, most = kMostPhotons;
    while (least < most) {
        const int middle = least + (most - least + 1) / 2;
        if (frame_of(middle).whole() <= frame_ms) {
            least = middle;
        } else {
            most = middle - 1;
        }
    }
    return frame_of(least);
}

}  // namespace lanthorn::tools
