// What is done with values through their descriptions: comparing, hashing, bytes, renumbering of references.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "lanthorn/ecs/value_type.h"

namespace lanthorn::ecs {

enum class Fields {
    all,
    state,   // without transient ones
    author,  // nor runtime ones
};

bool is_among(const Field& field, Fields fields);

// Bit for bit: -0 is not +0, and NaN is itself. Padding does not count; opaque values without == differ.
bool equal(const ValueType& type, const void* a, const void* b, Fields fields = Fields::all);

// Appends the value's bytes without padding, lists with their length: of all fields or of the state. What is
// opaque is left out.
void append_bytes(const ValueType& type, const void* value, Fields fields, std::string& bytes);

// Reads what append_bytes(Fields::all) wrote into a living value. Returns false if `bytes` ends too early or
// cannot be such a value; takes what was read off its front.
bool read_bytes(const ValueType& type, void* value, std::span<const std::byte>& bytes);

// Every reference to an entity within becomes what `renumber` gives for it.
void renumber_entities(const ValueType& type, void* value, const std::function<Entity(Entity)>& renumber);

}  // namespace lanthorn::ecs
