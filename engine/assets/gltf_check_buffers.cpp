#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "engine/assets/gltf_check_parts.h"
#include "engine/assets/gltf_format.h"

namespace lanthorn {

using nlohmann::json;

namespace {

constexpr std::uint64_t kMaxBytes = std::uint64_t{1} << 40;  // of one buffer; far above what fits in memory
constexpr std::uint64_t kMaxCount = 0xffffffff;              // elements of an accessor: 32-bit indices

void check_buffer(const JsonPlace& buffer) {
    buffer.integer("byteLength", 1, kMaxBytes, Need::required);
    buffer.string("uri");
}

// EXT_meshopt_compression of a view: what its bytes are decoded from.
void check_meshopt(const JsonPlace& own, const json& view, const json& root) {
    constexpr std::uint64_t kMostPacked = 128;  // times; the codecs reach 64
    own.index("buffer", "buffers", Need::required);
    own.integer("byteOffset", 0, kMaxBytes);
    own.integer("byteLength", 1, kMaxBytes, Need::required);
    own.integer("byteStride", 1, 256, Need::required);
    own.integer("count", 1, kMaxCount, Need::required);
    own.string("mode", Need::required, {"ATTRIBUTES", "TRIANGLES", "INDICES"});
    own.string("filter", Need::optional, {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"});
    const std::uint64_t stride = own.get("byteStride");
    const std::string mode = own.value()["mode"], filter = own.value().value("filter", std::string("NONE"));
    const bool stride_fits = (mode == "ATTRIBUTES" ? stride % 4 == 0 : stride == 2 || stride == 4) &&
                             (filter != "OCTAHEDRAL" || stride == 4 || stride == 8) &&
                             (filter != "QUATERNION" || stride == 8);
    if (!stride_fits) {
        own.refuse("byteStride",
                   fmt::format("found {}, which {} with filter {} does not have", stride, mode, filter));
    }
    if (mode != "ATTRIBUTES" && filter != "NONE") {
        own.refuse("filter", fmt::format("found {} with {}, expected NONE", filter, mode));
    }
    if (mode == "TRIANGLES" && own.get("count") % 3 != 0) {
        own.refuse("count",
                   fmt::format("found {} indices of triangles, expected a multiple of 3", own.get("count")));
    }
    const std::uint64_t length = view["byteLength"], unpacked = own.get("count") * stride;
    if (unpacked != length) {
        own.refuse("count", fmt::format("{} elements of {} bytes are {} bytes, but the view has {}",
                                        own.get("count"), stride, unpacked, length));
    }
    if (unpacked / kMostPacked > own.get("byteLength")) {
        own.refuse("byteLength", fmt::format("found {} bytes for {}, more than any encoder packs",
                                             own.get("byteLength"), unpacked));
    }
    const std::uint64_t end = own.get("byteOffset") + own.get("byteLength");
    const std::uint64_t size = root["buffers"][own.get("buffer")]["byteLength"];
    if (end > size) {
        own.refuse("byteLength", fmt::format("the data ends at byte {}, but buffer {} has {}", end,
                                             own.get("buffer"), size));
    }
}

void check_buffer_view(const JsonPlace& view, json& root) {
    view.index("buffer", "buffers", Need::required);
    view.integer("byteOffset", 0, kMaxBytes);
    view.integer("byteLength", 1, kMaxBytes, Need::required);
    if (view.integer("byteStride", 0, 252) && view.get("byteStride") == 0) {
        view.note("byteStride", "found 0; the elements are read as tightly packed");
        view.value().erase("byteStride");
    }
    if (view.get("byteStride") % 4 != 0) {
        view.note("byteStride", fmt::format("found {}, expected a multiple of 4; it is taken as it is",
                                            view.get("byteStride")));
    }
    const std::uint64_t end = view.get("byteOffset") + view.get("byteLength");
    const std::uint64_t size = root["buffers"][view.get("buffer")]["byteLength"];
    if (end > size) {
        view.refuse("byteLength", fmt::format("the view ends at byte {}, but buffer {} has {}", end,
                                              view.get("buffer"), size));
    }
    view.object("extensions", [&](const JsonPlace& extensions) {
        extensions.object("EXT_meshopt_compression",
                          [&](const JsonPlace& own) { check_meshopt(own, view.value(), root); });
    });
}

// That `count` elements of `size` bytes from `offset`, `stride` apart, lie in the buffer view named by
// `place`.
void check_fits(const JsonPlace& place, json& root, std::uint64_t count, std::uint64_t size) {
    const json& view = root["bufferViews"][place.get("bufferView")];
    const std::uint64_t stride = view.value("byteStride", std::uint64_t{0});
    if (stride != 0 && stride < size) {
        place.refuse(
            "bufferView",
            fmt::format("the view's byteStride {} is smaller than an element of {} bytes", stride, size));
    }
    const std::uint64_t end =
        place.get("byteOffset") + (count - 1) * (stride != 0 ? stride : size) + size;  // below 2^42
    const std::uint64_t length = view["byteLength"];
    if (end > length) {
        place.refuse("bufferView",
                     fmt::format("{} elements of {} bytes end at byte {}, but buffer view {} has {}", count,
                                 size, end, place.get("bufferView"), length));
    }
}

void expect_component(const JsonPlace& place, std::initializer_list<std::uint64_t> allowed) {
    place.integer("componentType", 0, 0xffff, Need::required);
    const std::uint64_t type = place.get("componentType");
    if (std::find(allowed.begin(), allowed.end(), type) == allowed.end()) {
        place.refuse("componentType",
                     fmt::format("found {}, expected one of {}", type, fmt::join(allowed, ", ")));
    }
}

void check_sparse(const JsonPlace& sparse, json& root, std::uint64_t accessor_count,
                  std::uint64_t element_size) {
    sparse.integer("count", 1, std::min<std::uint64_t>(accessor_count, 0x7fffffff), Need::required);
    const std::uint64_t count = sparse.get("count");
    const auto check_part = [&](const JsonPlace& part, std::uint64_t size) {
        part.index("bufferView", "bufferViews", Need::required);
        part.integer("byteOffset", 0, 0x7fffffff);  // tinygltf holds it in an int
        if (root["bufferViews"][part.get("bufferView")].contains("byteStride")) {
            part.refuse("bufferView", "the view has a byteStride, expected none for sparse data");
        }
        check_fits(part, root, count, size);
    };
    sparse.object(
        "indices",
        [&](const JsonPlace& part) {
            expect_component(part, {kUnsignedByte, kUnsignedShort, kUnsignedInt});
            check_part(part, component_size(part.get("componentType")));
        },
        Need::required);
    sparse.object(
        "values", [&](const JsonPlace& part) { check_part(part, element_size); }, Need::required);
}

// A sparse accessor that replaces nothing is what it would be without.
void mend_empty_sparse(const JsonPlace& accessor) {
    const bool is_empty = accessor.object("sparse", [](const JsonPlace& sparse) {
        sparse.integer("count", 0, kMaxCount, Need::required);
    }) && accessor.value()["sparse"]["count"] == 0;
    if (is_empty) {
        accessor.note("sparse", "found 0 elements, expected at least 1; none is replaced");
        accessor.value().erase("sparse");
    }
}

// The member of an object; null where there is none, or no object.
const json& member(const json& value, const char* key) {
    static const json nothing;
    const auto found = value.is_object() ? value.find(key) : value.end();
    return value.is_object() && found != value.end() ? *found : nothing;
}

// Accessors whose elements are in data that Draco has packed (KHR_draco_mesh_compression), however many these
// are: decode_draco() holds them against what the data states.
std::set<std::uint64_t> packed_by_draco(const json& root) {
    std::set<std::uint64_t> result;
    const auto add = [&](const json& accessor) {
        if (accessor.is_number_unsigned()) {
            result.insert(accessor.get<std::uint64_t>());
        }
    };
    for (const json& mesh : member(root, "meshes")) {
        for (const json& primitive : member(mesh, "primitives")) {
            const json& own = member(member(primitive, "extensions"), "KHR_draco_mesh_compression");
            if (own.is_object()) {
                add(member(primitive, "indices"));
                for (const auto& [name, id] : member(own, "attributes").items()) {
                    add(member(member(primitive, "attributes"), name.c_str()));
                }
            }
        }
    }
    return result;
}

void check_accessor(const JsonPlace& accessor, json& root, bool is_packed) {
    expect_component(accessor, {kByte, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt, kFloat});
    accessor.string("type", Need::required);
    accessor.integer("count", 0, kMaxCount, Need::required);
    accessor.boolean("normalized");
    accessor.index("bufferView", "bufferViews");
    accessor.integer("byteOffset", 0, kMaxBytes);
    const std::uint64_t count = accessor.get("count");
    const std::uint64_t size =
        element_size(accessor.get("componentType"), accessor.value()["type"].get_ref<const std::string&>());
    if (size == 0) {
        return;  // a type of an extension; refused where it is used
    }
    if (count == 0) {
        accessor.note("count", "found 0 elements, expected at least 1; what needs them is left out");
        accessor.value().erase("bufferView");
        accessor.value().erase("sparse");
        return;
    }
    if (accessor.has("bufferView")) {
        check_fits(accessor, root, count, size);
    } else if (count > kMaxZeroElements && !is_packed) {
        accessor.refuse("count", fmt::format("found {} elements without a buffer view, expected at most {}",
                                             count, kMaxZeroElements));
    }
    mend_empty_sparse(accessor);
    accessor.object("sparse", [&](const JsonPlace& sparse) { check_sparse(sparse, root, count, size); });
}

}  // namespace

void check_accessor_use(const JsonPlace& place, std::string_view key, json& root, Need need) {
    if (place.index(key, "accessors", need)) {
        const std::string type = root["accessors"][place.get(key)]["type"];
        if (component_count(type) == 0) {
            place.refuse(key, fmt::format("accessor {} has the unknown type '{}'", place.get(key), type));
        }
    }
}

void check_buffers(const JsonPlace& place, json& root) {
    place.objects("buffers", check_buffer);
    place.objects("bufferViews", [&](const JsonPlace& view) { check_buffer_view(view, root); });
    const std::set<std::uint64_t> packed = packed_by_draco(root);
    std::uint64_t number = 0;
    place.objects("accessors", [&](const JsonPlace& accessor) {
        check_accessor(accessor, root, packed.contains(number++));
    });
}

}  // namespace lanthorn
