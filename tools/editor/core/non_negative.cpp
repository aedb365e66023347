#include "tools/editor/core/non_negative.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lanthorn::editor {

namespace {

constexpr double kNothing = 1e-12;  // of the largest diagonal, or gradient

// The normal equations: of pairs of unknowns, and of each with the sums.
struct Normal {
    std::size_t size = 0;
    std::vector<double> pairs, sums;

    double pair(std::size_t i, std::size_t k) const { return pairs[i * size + k]; }
};

Normal normal_of(std::span<const Equation> equations) {
    Normal n;
    n.size = equations.empty() ? 0 : equations.front().factors.size();
    n.pairs.resize(n.size * n.size);
    n.sums.resize(n.size);
    for (const Equation& e : equations) {
        for (std::size_t i = 0; i < n.size; ++i) {
            n.sums[i] += e.factors[i] * e.sum;
            for (std::size_t k = 0; k < n.size; ++k) {
                n.pairs[i * n.size + k] += e.factors[i] * e.factors[k];
            }
        }
    }
    return n;
}

// Of the unknowns in `free` alone, the others 0, by Cholesky's factors; one that the equations do not tell
// from those before it stays 0.
std::vector<double> least_squares(const Normal& n, const std::vector<std::size_t>& free) {
    const std::size_t count = free.size();
    std::vector<double> factor(count * count), y(count);
    const auto at = [&](std::size_t i, std::size_t k) -> double& { return factor[i * count + k]; };
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
            double sum = n.pair(free[i], free[k]);
            for (std::size_t m = 0; m < k; ++m) {
                sum -= at(i, m) * at(k, m);
            }
            if (i == k) {
                at(i, i) = sum > kNothing * n.pair(free[i], free[i]) ? std::sqrt(sum) : 0;
            } else {
                at(i, k) = at(k, k) > 0 ? sum / at(k, k) : 0;
            }
        }
        double sum = n.sums[free[i]];
        for (std::size_t m = 0; m < i; ++m) {
            sum -= at(i, m) * y[m];
        }
        y[i] = at(i, i) > 0 ? sum / at(i, i) : 0;
    }
    std::vector<double> result(n.size, 0);
    for (std::size_t i = count; i-- > 0;) {
        double sum = y[i];
        for (std::size_t m = i + 1; m < count; ++m) {
            sum -= at(m, i) * result[free[m]];
        }
        result[free[i]] = at(i, i) > 0 ? sum / at(i, i) : 0;
    }
    return result;
}

}  // namespace

std::vector<double> non_negative_solution(std::span<const Equation> equations) {
    const Normal n = normal_of(equations);
    std::vector<double> x(n.size, 0);
    std::vector<std::size_t> free;
    double most = 0;
    for (const double sum : n.sums) {
        most = std::max(most, std::abs(sum));
    }
    // Each step takes the unknown in that promises most; it ends after as many as can be of use.
    for (std::size_t step = 0; step < 3 * n.size; ++step) {
        std::size_t best = n.size;
        double promise = kNothing * most;
        for (std::size_t i = 0; i < n.size; ++i) {
            if (std::ranges::find(free, i) != free.end()) {
                continue;
            }
            double gradient = n.sums[i];
            for (std::size_t k = 0; k < n.size; ++k) {
                gradient -= n.pair(i, k) * x[k];
            }
            if (gradient > promise) {
                promise = gradient;
                best = i;
            }
        }
        if (best == n.size) {
            break;
        }
        free.push_back(best);
        for (std::vector<double> wanted = least_squares(n, free); !free.empty();
             wanted = least_squares(n, free)) {
            // As far as all of them stay above 0; who comes to 0 stays there.
            double share = 1;
            for (const std::size_t i : free) {
                if (wanted[i] < 0 && x[i] - wanted[i] > 0) {
                    share = std::min(share, x[i] / (x[i] - wanted[i]));
                }
            }
            for (std::size_t i = 0; i < n.size; ++i) {
                x[i] += share * (wanted[i] - x[i]);
            }
            const auto out = [&](std::size_t i) {
                return wanted[i] < 0 && x[i] <= kNothing * std::abs(wanted[i]);
            };
            if (std::erase_if(free, out) == 0) {
                break;
            }
            for (std::size_t i = 0; i < n.size; ++i) {
                x[i] = std::ranges::find(free, i) == free.end() ? 0 : x[i];
            }
        }
    }
    for (double& each : x) {
        each = std::max(each, 0.0);
    }
    return x;
}

}  // namespace lanthorn::editor
