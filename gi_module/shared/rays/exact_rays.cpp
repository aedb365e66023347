#include "gi_module/shared/rays/exact_rays.h"

namespace lanthorn::gi {

namespace {

ExactRaysMaker& known_maker() {
    static ExactRaysMaker maker = nullptr;
    return maker;
}

}  // namespace

void add_exact_rays(ExactRaysMaker maker) {
    known_maker() = maker;
}

bool has_exact_rays() {
    return known_maker() != nullptr;
}

std::unique_ptr<ExactRays> make_exact_rays() {
    return has_exact_rays() ? known_maker()() : nullptr;
}

}  // namespace lanthorn::gi
