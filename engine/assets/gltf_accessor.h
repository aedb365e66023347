// Reading the elements of an accessor, whatever their layout and type.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/assets/gltf_context.h"

namespace lanthorn {

// The accessors read must have their data (see has_data()).

// Whether integers are fractions of the largest of their type: as the accessor states it, none, or all.
enum class Integers { as_stated, numbers, fractions };

// The elements of accessor `index` as floats, `components` each, tightly packed: strides, sparse substitution
// and normalised integers resolved (glTF 2.0, 3.6.2); integers that are not normalised are converted as
// numbers, unless `integers` says otherwise. Values may be NaN or infinite if the file's floats are.
// `components` may be larger than the accessor's, the rest is then `fill`. O(count).
std::vector<float> read_floats(const GltfContext& context, std::size_t index, std::size_t components,
                               float fill = 0, Integers integers = Integers::as_stated);

// What a vertex attribute's accessor must be: a VEC of so many components, with one element a vertex.
struct AttributeShape {
    std::size_t min_components = 3;
    std::size_t components = 3;
    std::size_t vertices = 0;
};

// read_floats() of a vertex attribute. Refuses at `place` an accessor of another shape or of 32-bit integers.
std::vector<float> read_attribute(const GltfContext& context, std::size_t index, const std::string& place,
                                  const AttributeShape& shape, float fill = 0,
                                  Integers integers = Integers::as_stated);

// The elements of an accessor of unsigned integers, `components` each (no more than the accessor's), tightly
// packed.
std::vector<std::uint32_t> read_indices(const GltfContext& context, std::size_t index,
                                        std::size_t components = 1);

// False if the accessor has no elements, or some of its data is in a buffer that has none (an extension's
// business, glTF 2.0, 3.6.1.1).
bool has_data(const GltfContext& context, std::size_t index);

// "/accessors/7"
std::string accessor_place(std::size_t index);

}  // namespace lanthorn
