#include "engine/assets/gltf_corners.h"

#include <fmt/format.h>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_format.h"

namespace lanthorn {

namespace {

// The vertices that the primitive strings together, by index or in order.
std::vector<std::uint32_t> corner_list(const GltfCorners& of) {
    if (of.primitive.indices < 0) {
        std::vector<std::uint32_t> list(of.vertex_count);
        for (std::size_t i = 0; i < list.size(); ++i) {
            list[i] = static_cast<std::uint32_t>(i);
        }
        return list;
    }
    const auto index = static_cast<std::size_t>(of.primitive.indices);
    const tinygltf::Accessor& source = of.context.model.accessors[index];
    const auto type = static_cast<std::uint64_t>(source.componentType);
    if (source.type != TINYGLTF_TYPE_SCALAR ||
        (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt)) {
        of.context.refuse(
            of.place + "/indices",
            fmt::format("accessor {} is no SCALAR of unsigned integers (5121, 5123, 5125)", index));
    }
    const std::uint32_t restart =
        static_cast<std::uint32_t>((std::uint64_t{1} << (8 * component_size(type))) - 1);
    std::vector<std::uint32_t> list = read_indices(of.context, index);
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i] >= of.vertex_count || list[i] == restart) {
            of.context.refuse(accessor_place(index),
                              fmt::format("element {} is {}{}, expected a vertex index below {}", i, list[i],
                                          list[i] == restart ? " (primitive restart)" : "", of.vertex_count));
        }
    }
    return list;
}

}  // namespace

std::vector<std::uint32_t> triangles_of(const GltfCorners& of) {
    std::vector<std::uint32_t> list = corner_list(of);
    if (of.primitive.mode == TINYGLTF_MODE_TRIANGLES) {
        if (list.size() % 3 != 0) {
            of.context.warn(
                of.place, fmt::format("{} corners are no multiple of 3; the rest is left out", list.size()));
            list.resize(list.size() / 3 * 3);
        }
        return list;
    }
    std::vector<std::uint32_t> result;
    for (std::size_t i = 2; i < list.size(); ++i) {
        if (of.primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
            result.insert(result.end(), {list[i - 1], list[i], list[0]});
        } else if (i % 2 == 0) {
            result.insert(result.end(), {list[i - 2], list[i - 1], list[i]});
        } else {
            result.insert(result.end(), {list[i - 2], list[i], list[i - 1]});
        }
    }
    return result;
}

std::vector<std::uint32_t> stroke_ends_of(const GltfCorners& of) {
    const std::vector<std::uint32_t> list = corner_list(of);
    std::vector<std::uint32_t> ends;
    const std::size_t step = of.primitive.mode == TINYGLTF_MODE_LINE ? 2 : 1;
    if (of.primitive.mode == TINYGLTF_MODE_POINTS) {
        for (const std::uint32_t point : list) {
            ends.insert(ends.end(), {point, point});
        }
    } else {
        for (std::size_t i = 0; i + 1 < list.size(); i += step) {
            ends.insert(ends.end(), {list[i], list[i + 1]});
        }
        if (of.primitive.mode == TINYGLTF_MODE_LINE_LOOP && list.size() > 2) {
            ends.insert(ends.end(), {list.back(), list.front()});
        }
    }
    return ends;
}

}  // namespace lanthorn
