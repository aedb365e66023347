#include <draco/compression/decode.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/assets/gltf_compressed.h"
#include "engine/assets/gltf_format.h"

namespace lanthorn {

using nlohmann::json;

namespace {

struct Counts {
    std::uint32_t vertices = 0, triangles = 0;
    bool edgebreaker = false;
    std::uint8_t seams = 0;  // attributes with a connectivity of their own
};

// What compressed data says it has, before anything is made for it; nothing where its head is damaged. Of
// vertices that differ in their attributes alone, Edgebreaker counts one.
std::optional<Counts> stated_counts(draco::DecoderBuffer buffer) {
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok() ||
        header.encoder_type != draco::TRIANGULAR_MESH) {
        return std::nullopt;
    }
    const auto version = static_cast<std::uint16_t>(header.version_major << 8 | header.version_minor);
    buffer.set_bitstream_version(version);
    draco::GeometryMetadata metadata;
    if ((header.flags & METADATA_FLAG_MASK) != 0 &&
        !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) {
        return std::nullopt;
    }
    const bool edgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
    std::uint8_t traversal = 0;
    if (edgebreaker && !buffer.Decode(&traversal)) {
        return std::nullopt;
    }
    // Edgebreaker: vertices, triangles. Sequential: triangles, vertices.
    std::uint32_t first = 0, second = 0;
    const bool variable = version >= DRACO_BITSTREAM_VERSION(2, 2);
    const bool read = variable ? draco::DecodeVarint(&first, &buffer) && draco::DecodeVarint(&second, &buffer)
                               : buffer.Decode(&first) && buffer.Decode(&second);
    if (!read) {
        return std::nullopt;
    }
    std::uint8_t seams = 0;
    if (edgebreaker && !buffer.Decode(&seams)) {
        return std::nullopt;
    }
    return edgebreaker ? Counts{first, second, true, seams} : Counts{second, first};
}

// Bytes that Draco holds for the connectivity of `counts`, about: corners' vertices and opposites, and marks
// and vertices for each seam.
std::uint64_t connectivity_bytes(const Counts& counts) {
    const std::uint64_t corners = std::uint64_t{counts.triangles} * 3;
    return counts.edgebreaker ? corners * (12 + 12 * std::uint64_t{counts.seams}) : corners * 4;
}

// A decoder of Draco that asks, once it knows what attributes the data states and before their values are
// made, whether there is room.
template <typename Base>
class BudgetedDecoder final : public Base {
  public:
    explicit BudgetedDecoder(std::uint64_t& left) : left_(left) {}
    bool too_much() const { return too_much_; }

  private:
    bool DecodeAllAttributes() override {
        const draco::PointCloud& cloud = *this->point_cloud();
        std::uint64_t bytes = 0;  // a point; as decoded and as meant
        for (int i = 0; i < cloud.num_attributes(); ++i) {
            const draco::PointAttribute& attribute = *cloud.attribute(i);
            bytes += std::uint64_t{attribute.num_components()} *
                     (sizeof(std::int32_t) +
                      static_cast<std::uint64_t>(draco::DataTypeLength(attribute.data_type())));
        }
        too_much_ = !take(left_, bytes * cloud.num_points());
        return !too_much_ && Base::DecodeAllAttributes();
    }
    std::uint64_t& left_;
    bool too_much_ = false;
};

template <typename T>
bool append_values(const draco::PointAttribute& attribute, std::size_t points, std::size_t components,
                   std::vector<std::uint8_t>& to) {
    std::vector<T> value(components);
    to.resize(points * components * sizeof(T));
    for (std::size_t i = 0; i < points; ++i) {
        const auto index = attribute.mapped_index(draco::PointIndex(static_cast<std::uint32_t>(i)));
        if (!attribute.ConvertValue<T>(index, static_cast<std::int8_t>(components), value.data())) {
            return false;
        }
        std::memcpy(to.data() + i * components * sizeof(T), value.data(), components * sizeof(T));
    }
    return true;
}

std::size_t components_of(const tinygltf::Accessor& accessor) {
    return static_cast<std::size_t>(
        tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

bool append_values(const draco::PointAttribute& attribute, std::size_t points, const tinygltf::Accessor& as,
                   std::vector<std::uint8_t>& to) {
    const std::size_t components = components_of(as);
    switch (static_cast<std::uint64_t>(as.componentType)) {
        case kByte:
            return append_values<std::int8_t>(attribute, points, components, to);
        case kUnsignedByte:
            return append_values<std::uint8_t>(attribute, points, components, to);
        case kShort:
            return append_values<std::int16_t>(attribute, points, components, to);
        case kUnsignedShort:
            return append_values<std::uint16_t>(attribute, points, components, to);
        case kUnsignedInt:
            return append_values<std::uint32_t>(attribute, points, components, to);
        default:
            return append_values<float>(attribute, points, components, to);
    }
}

class DracoPrimitive {
  public:
    DracoPrimitive(GltfFile& file, tinygltf::Model& model, std::size_t mesh, std::size_t primitive)
        : file_(file),
          model_(model),
          primitive_(model.meshes[mesh].primitives[primitive]),
          own_(std::as_const(file.json)["meshes"][mesh]["primitives"][primitive]["extensions"]
                                       ["KHR_draco_mesh_compression"]),
          place_(fmt::format("/meshes/{}/primitives/{}/extensions/KHR_draco_mesh_compression", mesh,
                             primitive)) {}

    void run();

  private:
    tinygltf::Accessor& accessor(int index) { return model_.accessors[static_cast<std::size_t>(index)]; }
    std::unique_ptr<draco::Mesh> decoded();
    template <typename Base>
    std::unique_ptr<draco::Mesh> decoded_by(draco::DecoderBuffer& buffer);
    void take_room(std::uint64_t bytes);
    [[noreturn]] void refuse_size();
    // Lets `index` read `bytes`, tightly packed.
    void give(tinygltf::Accessor& accessor, std::vector<std::uint8_t> bytes, std::size_t count);
    void give_attributes(const draco::Mesh& mesh);
    void give_indices(const draco::Mesh& mesh);
    void give_nothing();

    GltfFile& file_;
    tinygltf::Model& model_;
    tinygltf::Primitive& primitive_;
    const json& own_;
    std::string place_;
};

void DracoPrimitive::refuse_size() {
    file_.refuse(place_, "with this the file's data unpacks to more than a file's may");
}

void DracoPrimitive::take_room(std::uint64_t bytes) {
    if (!take(file_.left.unpacked, bytes)) {
        refuse_size();
    }
}

template <typename Base>
std::unique_ptr<draco::Mesh> DracoPrimitive::decoded_by(draco::DecoderBuffer& buffer) {
    BudgetedDecoder<Base> decoder(file_.left.unpacked);
    auto mesh = std::make_unique<draco::Mesh>();
    const draco::Status status = decoder.Decode(draco::DecoderOptions(), &buffer, mesh.get());
    if (decoder.too_much()) {
        refuse_size();
    }
    if (!status.ok()) {
        file_.refuse(place_, fmt::format("found damaged data, expected a mesh that Draco has packed: {}",
                                         status.error_msg_string()));
    }
    return mesh;
}

std::unique_ptr<draco::Mesh> DracoPrimitive::decoded() {
    const auto& view = model_.bufferViews[own_["bufferView"].get<std::size_t>()];
    const std::vector<std::uint8_t>& packed = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (packed.empty()) {
        return nullptr;  // the accessors have no data then, which is told where they are read
    }
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(packed.data() + view.byteOffset), view.byteLength);
    const std::optional<Counts> counts = stated_counts(buffer);
    if (!counts) {
        file_.refuse(place_, "found a damaged head, expected a mesh that Draco has packed");
    }
    const auto position = primitive_.attributes.find("POSITION");
    const std::uint64_t vertices =
        position != primitive_.attributes.end() ? accessor(position->second).count : 0;
    const std::uint64_t triangles =
        primitive_.indices >= 0 ? accessor(primitive_.indices).count / 3 : kMaxZeroElements / 3;
    if (counts->triangles > triangles || counts->vertices > vertices) {
        file_.refuse(place_,
                     fmt::format("the data has {} vertices and {} triangles, expected {} and {} as the "
                                 "accessors say",
                                 counts->vertices, counts->triangles, vertices, triangles));
    }
    take_room(connectivity_bytes(*counts));
    return counts->edgebreaker ? decoded_by<draco::MeshEdgebreakerDecoder>(buffer)
                               : decoded_by<draco::MeshSequentialDecoder>(buffer);
}

void DracoPrimitive::give(tinygltf::Accessor& accessor, std::vector<std::uint8_t> bytes, std::size_t count) {
    tinygltf::BufferView view;
    view.buffer = static_cast<int>(model_.buffers.size());
    view.byteLength = bytes.size();
    accessor.bufferView = static_cast<int>(model_.bufferViews.size());
    accessor.byteOffset = 0;
    accessor.count = count;
    accessor.sparse.isSparse = false;
    model_.bufferViews.push_back(std::move(view));
    model_.buffers.emplace_back().data = std::move(bytes);
}

void DracoPrimitive::give_attributes(const draco::Mesh& mesh) {
    for (const auto& [name, id] : own_["attributes"].items()) {
        const auto found = primitive_.attributes.find(name);
        if (found == primitive_.attributes.end()) {
            continue;
        }
        const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id.get<std::uint32_t>());
        std::vector<std::uint8_t> bytes;
        tinygltf::Accessor& as = accessor(found->second);
        take_room(std::uint64_t{mesh.num_points()} * components_of(as) *
                  component_size(static_cast<std::uint64_t>(as.componentType)));
        if (attribute == nullptr || !append_values(*attribute, mesh.num_points(), as, bytes)) {
            file_.refuse(place_ + "/attributes/" + name,
                         fmt::format("the data has no such attribute {}", id.get<std::uint32_t>()));
        }
        if (as.count != mesh.num_points()) {
            file_.refuse(place_ + "/attributes/" + name,
                         fmt::format("the data has {} vertices, expected {} as the accessor says",
                                     mesh.num_points(), as.count));
        }
        give(as, std::move(bytes), mesh.num_points());
    }
}

void DracoPrimitive::give_indices(const draco::Mesh& mesh) {
    take_room(std::uint64_t{mesh.num_faces()} * 3 * sizeof(std::uint32_t));
    std::vector<std::uint8_t> bytes(std::size_t{mesh.num_faces()} * 3 * sizeof(std::uint32_t));
    for (std::uint32_t f = 0; f < mesh.num_faces(); ++f) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t index = mesh.face(draco::FaceIndex(f))[c].value();
            std::memcpy(bytes.data() + (f * std::size_t{3} + c) * sizeof index, &index, sizeof index);
        }
    }
    if (primitive_.indices < 0) {
        primitive_.indices = static_cast<int>(model_.accessors.size());
        model_.accessors.emplace_back();
    }
    tinygltf::Accessor& indices = accessor(primitive_.indices);
    indices.type = TINYGLTF_TYPE_SCALAR;
    indices.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    give(indices, std::move(bytes), std::size_t{mesh.num_faces()} * 3);
    primitive_.mode = TINYGLTF_MODE_TRIANGLES;  // strips are unrolled
}

// Instead of as many zeros as the accessors say.
void DracoPrimitive::give_nothing() {
    const auto empty = [&](int index) {
        accessor(index).count = 0;
        accessor(index).sparse.isSparse = false;
    };
    for (const auto& [name, id] : own_["attributes"].items()) {
        if (const auto found = primitive_.attributes.find(name); found != primitive_.attributes.end()) {
            empty(found->second);
        }
    }
    if (primitive_.indices >= 0) {
        empty(primitive_.indices);
    }
}

void DracoPrimitive::run() {
    if (const std::unique_ptr<draco::Mesh> mesh = decoded()) {
        give_attributes(*mesh);
        give_indices(*mesh);
    } else {
        give_nothing();
    }
}

}  // namespace

void decode_draco(GltfFile& file, tinygltf::Model& model) {
    const json::json_pointer extension("/extensions/KHR_draco_mesh_compression");
    for (std::size_t m = 0; m < model.meshes.size(); ++m) {
        for (std::size_t p = 0; p < model.meshes[m].primitives.size(); ++p) {
            if (std::as_const(file.json)["meshes"][m]["primitives"][p].contains(extension)) {
                DracoPrimitive(file, model, m, p).run();
            }
        }
    }
}

}  // namespace lanthorn
