#include "engine/assets/gltf_accessor.h"

#include <algorithm>
#include <cstring>
#include <span>

#include "engine/assets/gltf_format.h"

namespace lanthorn {

namespace {

// Elements in a buffer view: element i starts at data[i * stride].
struct Elements {
    const std::uint8_t* data = nullptr;
    std::size_t stride = 0;

    const std::uint8_t* at(std::size_t i) const { return data + i * stride; }
};

// check_gltf() and build_model() have made sure that views lie in buffers and accessors in views.
Elements elements_of(const tinygltf::Model& model, int view_index, std::size_t offset, std::size_t size) {
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
    const auto& bytes = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    return {bytes.data() + view.byteOffset + offset, view.byteStride != 0 ? view.byteStride : size};
}

template <typename T>
T load(const std::uint8_t* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

// glTF 2.0, 3.6.2.2 and KHR_mesh_quantization.
float component(const std::uint8_t* bytes, std::uint64_t type, bool normalised) {
    switch (type) {
        case kByte: {
            const float value = load<std::int8_t>(bytes);
            return normalised ? std::max(value / 127.0f, -1.0f) : value;
        }
        case kUnsignedByte: {
            const float value = load<std::uint8_t>(bytes);
            return normalised ? value / 255.0f : value;
        }
        case kShort: {
            const float value = load<std::int16_t>(bytes);
            return normalised ? std::max(value / 32767.0f, -1.0f) : value;
        }
        case kUnsignedShort: {
            const float value = load<std::uint16_t>(bytes);
            return normalised ? value / 65535.0f : value;
        }
        case kUnsignedInt:
            return static_cast<float>(load<std::uint32_t>(bytes));
        default:
            return load<float>(bytes);
    }
}

std::uint32_t unsigned_component(const std::uint8_t* bytes, std::uint64_t type) {
    switch (type) {
        case kUnsignedByte:
            return load<std::uint8_t>(bytes);
        case kUnsignedShort:
            return load<std::uint16_t>(bytes);
        default:
            return load<std::uint32_t>(bytes);
    }
}

// Calls use(i, bytes of element i) for the accessor's elements, then for the sparse substitutes. Elements
// without a buffer view are skipped: they are zero.
template <typename Use>
void for_each_element(const GltfContext& context, std::size_t index, Use&& use) {
    const tinygltf::Model& model = context.model;
    const tinygltf::Accessor& accessor = model.accessors[index];
    const auto type = static_cast<std::uint64_t>(accessor.componentType);
    const std::size_t size =
        component_size(type) *
        static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
    if (accessor.bufferView >= 0) {
        const Elements elements = elements_of(model, accessor.bufferView, accessor.byteOffset, size);
        for (std::size_t i = 0; i < accessor.count; ++i) {
            use(i, elements.at(i));
        }
    }
    if (accessor.sparse.isSparse) {
        const auto& sparse = accessor.sparse;
        const auto index_type = static_cast<std::uint64_t>(sparse.indices.componentType);
        const Elements where =
            elements_of(model, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                        component_size(index_type));
        const Elements values = elements_of(model, sparse.values.bufferView,
                                            static_cast<std::size_t>(sparse.values.byteOffset), size);
        for (std::size_t i = 0; i < static_cast<std::size_t>(sparse.count); ++i) {
            const std::uint32_t target = unsigned_component(where.at(i), index_type);
            if (target >= accessor.count) {
                context.refuse(
                    accessor_place(index) + "/sparse/indices",
                    fmt::format("element {} is {}, expected an index below {}", i, target, accessor.count));
            }
            use(target, values.at(i));
        }
    }
}

}  // namespace

bool has_data(const GltfContext& context, std::size_t index) {
    const tinygltf::Model& model = context.model;
    const tinygltf::Accessor& accessor = model.accessors[index];
    const auto present = [&](int view) {
        return view < 0 || !model
                                .buffers[static_cast<std::size_t>(
                                    model.bufferViews[static_cast<std::size_t>(view)].buffer)]
                                .data.empty();
    };
    return accessor.count > 0 && present(accessor.bufferView) &&
           (!accessor.sparse.isSparse ||
            (present(accessor.sparse.indices.bufferView) && present(accessor.sparse.values.bufferView)));
}

std::string accessor_place(std::size_t index) {
    return fmt::format("/accessors/{}", index);
}

std::vector<float> read_floats(const GltfContext& context, std::size_t index, std::size_t components,
                               float fill, Integers integers) {
    const tinygltf::Accessor& accessor = context.model.accessors[index];
    const auto type = static_cast<std::uint64_t>(accessor.componentType);
    const std::size_t available = std::min<std::size_t>(
        components, static_cast<std::size_t>(
                        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type))));
    const bool normalised =
        integers == Integers::fractions || (integers == Integers::as_stated && accessor.normalized);
    std::vector<float> values(accessor.count * components, 0.0f);
    for (std::size_t i = 0; i < accessor.count && available < components; ++i) {
        std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(i * components + available),
                    components - available, fill);
    }
    for_each_element(context, index, [&](std::size_t i, const std::uint8_t* bytes) {
        for (std::size_t c = 0; c < available; ++c) {
            values[i * components + c] = component(bytes + c * component_size(type), type, normalised);
        }
    });
    return values;
}

std::vector<float> read_attribute(const GltfContext& context, std::size_t index, const std::string& place,
                                  const AttributeShape& shape, float fill, Integers integers) {
    const tinygltf::Accessor& source = context.model.accessors[index];
    const bool vector = source.type == TINYGLTF_TYPE_VEC2 || source.type == TINYGLTF_TYPE_VEC3 ||
                        source.type == TINYGLTF_TYPE_VEC4;
    const auto found = static_cast<std::size_t>(source.type);  // tinygltf numbers VEC2..VEC4 2..4
    if (!vector || found < shape.min_components || found > shape.components) {
        context.refuse(place, fmt::format("accessor {} is no VEC{}{}", index, shape.min_components,
                                          shape.min_components == shape.components
                                              ? ""
                                              : fmt::format(" or VEC{}", shape.components)));
    }
    if (source.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT) {
        context.refuse(
            place,
            fmt::format("accessor {} has 32-bit integers, expected floats or smaller integers", index));
    }
    if (source.count != shape.vertices) {
        context.refuse(place, fmt::format("accessor {} has {} elements, expected {} as POSITION has", index,
                                          source.count, shape.vertices));
    }
    return read_floats(context, index, shape.components, fill, integers);
}

std::vector<std::uint32_t> read_indices(const GltfContext& context, std::size_t index,
                                        std::size_t components) {
    const tinygltf::Accessor& accessor = context.model.accessors[index];
    const auto type = static_cast<std::uint64_t>(accessor.componentType);
    std::vector<std::uint32_t> values(accessor.count * components, 0);
    for_each_element(context, index, [&](std::size_t i, const std::uint8_t* bytes) {
        for (std::size_t c = 0; c < components; ++c) {
            values[i * components + c] = unsigned_component(bytes + c * component_size(type), type);
        }
    });
    return values;
}

}  // namespace lanthorn
