#include <fmt/format.h>
#include <meshoptimizer.h>

#include <string>
#include <utility>
#include <vector>

#include "engine/assets/gltf_compressed.h"

namespace lanthorn {

using nlohmann::json;

namespace {

bool decode(const json& own, const std::uint8_t* from, std::vector<std::uint8_t>& to) {
    const std::size_t count = own["count"], stride = own["byteStride"], size = own["byteLength"];
    const std::string mode = own["mode"], filter = own.value("filter", std::string("NONE"));
    to.resize(count * stride);
    const int failed = mode == "ATTRIBUTES" ? meshopt_decodeVertexBuffer(to.data(), count, stride, from, size)
                       : mode == "TRIANGLES"
                           ? meshopt_decodeIndexBuffer(to.data(), count, stride, from, size)
                           : meshopt_decodeIndexSequence(to.data(), count, stride, from, size);
    if (failed != 0) {
        return false;
    }
    if (filter == "OCTAHEDRAL") {
        meshopt_decodeFilterOct(to.data(), count, stride);
    } else if (filter == "QUATERNION") {
        meshopt_decodeFilterQuat(to.data(), count, stride);
    } else if (filter == "EXPONENTIAL") {
        meshopt_decodeFilterExp(to.data(), count, stride);
    }
    return true;
}

}  // namespace

void decode_meshopt(GltfFile& file, tinygltf::Model& model) {
    const json::json_pointer extension("/extensions/EXT_meshopt_compression");
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        const json& source = std::as_const(file.json)["bufferViews"][i];
        if (!source.contains(extension)) {
            continue;
        }
        const json& own = source[extension];
        tinygltf::BufferView& view = model.bufferViews[i];
        const std::vector<std::uint8_t>& packed = model.buffers[own["buffer"].get<std::size_t>()].data;
        const std::string place = fmt::format("/bufferViews/{}/extensions/EXT_meshopt_compression", i);
        if (!take(file.left.unpacked,
                  own["count"].get<std::uint64_t>() * own["byteStride"].get<std::uint64_t>())) {
            file.refuse(place, "with this the file's data unpacks to more than a file's may");
        }
        tinygltf::Buffer unpacked;
        if (!packed.empty() &&
            !decode(own, packed.data() + own.value("byteOffset", std::size_t{0}), unpacked.data)) {
            file.refuse(place, "found damaged data, expected what meshoptimizer has packed");
        }
        view.buffer = static_cast<int>(model.buffers.size());
        view.byteOffset = 0;
        model.buffers.push_back(std::move(unpacked));
    }
}

}  // namespace lanthorn
