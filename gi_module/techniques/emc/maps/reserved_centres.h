// Centres of environment maps that are reserved for what the picture needs and the others do not show: where
// to try them, and which to take. No GL.
#pragma once

#include <vector>

#include "gi_module/techniques/emc/maps/unseen_survey.h"

namespace lanthorn::gi {

// Whether so many rays lack a map that one is worth a look: one in two thousand.
bool lacks_maps(const UnseenSurvey& survey);

// At most `count` centres to try, on rays that met unseen places and therefore in free air: in the middle,
// and near the place where that is far from it. Of those rays around whose places most others lie, not near
// each other. `diagonal` of the scene, m. O(count * places^2).
std::vector<vec3> trial_centres(const UnseenSurvey& survey, float diagonal, int count);

struct Reservation {
    int trial = -1;     // that is taken; -1: none
    int replaced = -1;  // the reserved centre that it takes the place of; -1: none, it is one more
};

// What to do so that the reserved centres show most of the places. `seen[c]`, by centre, those in use first
// and then the trials: which places it sees. A centre more must show places of one ray in two thousand; one
// that takes another's place, half as much again as all before, so that none hops to and fro.
Reservation reservation(const UnseenSurvey& survey, const std::vector<std::vector<bool>>& seen, int in_use,
                        int most);

}  // namespace lanthorn::gi
