#include <fmt/format.h>
#include <meshoptimizer.h>

#include <string>
#include <vector>

#include "lanthorn/assets/gltf_compressed.h"

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

void decode_meshopt(const GltfFile& file, tinygltf::Model& model) {
    const json::json_pointer extension("/extensions/EXT_meshopt_compression");
    for (std::size_t i = 0; i < model.bufferViews.size(); ++i) {
        const json& source = file.json["bufferViews"][i];
        if (!source.contains(extension)) {
            continue;
        }
        const json& own = source[extension];
        tinygltf::BufferView& view = model.bufferViews[i];
        const std::vector<std::uint8_t>& packed = model.buffers[own["buffer"].get<std::size_t>()].data;
        tinygltf::Buffer unpacked;
        if (!packed.empty() &&
            !decode(own, packed.data() + own.value("byteOffset", std::size_t{0}), unpacked.data)) {
            file.refuse(fmt::format("/bufferViews/{}/extensions/EXT_meshopt_compression", i),
                        "found damaged data, expected what meshoptimizer has packed");
        }
        view.buffer = static_cast<int>(model.buffers.size());
        view.byteOffset = 0;
        model.buffers.push_back(std::move(unpacked));
    }
}

}  // namespace lanthorn
