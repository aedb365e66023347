// Words for reasons that the plans of techniques share.
#pragma once

#include <string_view>

#include "lanthorn/gi/plan.h"

namespace lanthorn::gi {

// Of reasons by these names; empty for others.
template <class Reason>
std::string_view plan_words(Reason reason, Unlit unlit) {
    switch (reason) {
        case Reason::no_frame_yet:
            return "no frame yet";
        case Reason::no_indirect_light:
            return words(unlit);
        case Reason::first_frame:
            return "there is none yet";
        case Reason::other_view:
            return "the picture shows something else";
        case Reason::picture_holds:
            return "the picture holds";
        default:
            return {};
    }
}

}  // namespace lanthorn::gi
