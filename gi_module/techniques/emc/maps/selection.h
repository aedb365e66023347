// Choosing environment map centres by new coverage area (Yao et al. 2010, sec. 4.1). No GL: areas come
// through a function.
#pragma once

#include <functional>
#include <vector>

namespace lanthorn::gi {

// A(v | C \ {v}) for each v of `viewers`, in square metres; C = `selected`. All indices are into the
// candidates U.
using MeasureCoverage =
    std::function<std::vector<double>(const std::vector<int>& viewers, const std::vector<int>& selected)>;

// Greedy choice of at most `k` of `candidates`: each time the one with the largest new coverage area. Ends
// early when the best one's area is not above `negligible` times the area of the first: a map that adds
// nothing is not drawn. Ties go to the smaller index. k passes of `measure`.
std::vector<int> greedy_selection(int candidates, int k, double negligible, const MeasureCoverage& measure);

struct Exchange {
    int added = -1;
    int removed = -1;
    bool none() const { return added == removed; }
};

// Puts `added` into C, then takes out the member with the smallest A(v | C \ {v}): which may be `added`.
// Members from `candidates` on are reserved for what no candidate sees, and stay. One pass of `measure`.
Exchange exchange_for(std::vector<int>& selected, int added, int candidates, const MeasureCoverage& measure);

// Whether C, which has room for another member, is to have `larger.back()` as one more rather than in
// another's place: it and every member sees an area above `negligible` that the others do not. `own`: A(v |
// larger \ {v}) by place in `larger`.
bool is_to_grow(const std::vector<int>& larger, const std::vector<double>& own, int candidates,
                double negligible);

// One update step: adds the unselected candidate with the largest new coverage area, then removes the member
// with the smallest A(v | C \ {v}). The size of `selected` stays; the new member takes the place of the
// removed one.
Exchange update_step(std::vector<int>& selected, int candidates, const MeasureCoverage& measure);

// Repeats update_step until what is added is what is removed. Returns the number of steps (at most `limit`).
int refine_until_stable(std::vector<int>& selected, int candidates, int limit,
                        const MeasureCoverage& measure);

}  // namespace lanthorn::gi
