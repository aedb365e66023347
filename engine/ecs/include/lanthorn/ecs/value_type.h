// What a field's value is made of, as data: everything that is done with declared components (JSON, hashes,
// snapshots, clones, inspectors) walks these descriptions instead of knowing C++ types.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/core/value_info.h"
#include "lanthorn/ecs/entity.h"

namespace lanthorn::ecs {

// What a value is made of, which decides how it is copied, compared, hashed and written as JSON.
enum class ValueKind {
    boolean,
    integer,      // ValueType::size and is_signed say which
    real,         // float or double
    enumeration,  // Field::choices are the names of 0, 1, 2, ...
    text,         // std::string
    numbers,      // vectors, quaternions (x, y, z, w) and matrices (by columns): `numbers` scalars in a row
    entity,       // a reference, renumbered when entities are cloned
    list,         // std::optional (at most one), std::array, std::vector
    structure,    // `fields`
    opaque,       // copied, and nothing else is known of it
};

struct ValueType;

// One declared member of a component, resource or structure.
struct Field : ValueInfo {
    bool runtime = false;    // the simulation writes it; else an author's, saved in levels
    bool transient = false;  // no state: not hashed
    bool flat = false;       // a structure whose fields stand in JSON beside its neighbours
    std::size_t offset = 0;  // bytes
    const ValueType* type = nullptr;

    // "a number from 0 to 3.1 rad": for messages and tables.
    std::string expectation() const;
};

struct ValueType {
    ValueKind kind = ValueKind::opaque;
    std::string name;  // "float", "vec3", "list of float"
    std::size_t size = 0;
    bool plain = false;  // bytes without padding are the value
    bool is_signed = false;
    bool refers = false;                 // to entities, somewhere within
    bool opaque_within = false;          // something within is ValueKind::opaque
    const ValueType* element = nullptr;  // of numbers and lists
    std::size_t numbers = 0;
    bool optional = false;      // of lists: std::optional
    bool fixed = false;         // of lists: std::array
    std::vector<Field> fields;  // of structures, in the order of their declaration

    // Of lists.
    std::size_t (*count)(const void* list) = nullptr;
    void* (*data)(void* list) = nullptr;
    void (*resize)(void* list, std::size_t count) = nullptr;
    // Null if the type has no ==. Of opaque values alone.
    bool (*opaque_equal)(const void* a, const void* b) = nullptr;

    // What to do with a structure's bytes, neighbours joined: plain runs (type null) and what is not plain.
    struct Step {
        std::size_t offset;
        std::size_t size;
        const ValueType* type;
    };
    std::vector<Step> all_steps, state_steps;
};

// The address `offset` bytes into a value: of a field, by Field::offset.
inline const void* at(const void* value, std::size_t offset) {
    return static_cast<const std::byte*>(value) + offset;
}
// The same to write.
inline void* at(void* value, std::size_t offset) {
    return static_cast<std::byte*>(value) + offset;
}

// A number of kind boolean, integer, real or enumeration, and back (integers beyond 2^53 are rounded).
double number_of(const ValueType& type, const void* value);
// Writes `number` in the type's size; it must lie in the type's range, and fractions are cut off for
// integers.
void set_number(const ValueType& type, void* value, double number);

namespace detail {

template <class T>
inline char type_tag = 0;  // its address stands for the type

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};
template <class T>
struct IsVector : std::false_type {};
template <class T>
struct IsVector<std::vector<T>> : std::true_type {};
template <class T>
struct IsArray : std::false_type {};
template <class T, std::size_t N>
struct IsArray<std::array<T, N>> : std::true_type {};

// Vectors claim an == even where their elements have none.
template <class T>
inline constexpr bool kComparable = std::equality_comparable<T>;
template <class T>
inline constexpr bool kComparable<std::vector<T>> = kComparable<T>;

// GLM's shapes: the scalar and how many.
template <class T>
struct Numbers : std::false_type {};
template <int N, class S>
struct Numbers<glm::vec<N, S, glm::defaultp>> : std::true_type {
    using Scalar = S;
    static constexpr std::size_t count = N;
};
template <int C, int R, class S>
struct Numbers<glm::mat<C, R, S, glm::defaultp>> : std::true_type {
    using Scalar = S;
    static constexpr std::size_t count = C * R;
};
template <class S>
struct Numbers<glm::qua<S, glm::defaultp>> : std::true_type {
    using Scalar = S;
    static constexpr std::size_t count = 4;
};

}  // namespace detail

}  // namespace lanthorn::ecs
