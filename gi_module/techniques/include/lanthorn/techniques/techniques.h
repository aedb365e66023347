// The one list of techniques that have folders and libraries of their own.
#pragma once

namespace lanthorn::gi {

// Makes all of them known (technique.h), and Embree's rays to `emc`. Once, before settings are declared.
void add_techniques();

}  // namespace lanthorn::gi
