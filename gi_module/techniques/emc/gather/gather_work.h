// What a frame does for the points of the picture that the gather shoots rays from, by its plan.
#pragma once

namespace lanthorn::gi {

struct GatherWork {
    bool forget = false;      // nothing that is remembered holds
    bool points = false;      // camera or surfaces have changed: points are found again
    bool other_view = false;  // the camera or the picture's size has changed
    bool verify = false;      // things have moved, or a map was exchanged
    bool shoot = false;       // a frame more of rays
    bool survey = false;      // what the rays have met that no map shows is found: Gather::unseen()
};

}  // namespace lanthorn::gi
