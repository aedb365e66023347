// Bytes of a document: views and accessors that are added, and where buffers have theirs.
#include <fmt/format.h>

#include "engine/assets/gltf_document_state.h"
#include "engine/assets/uri.h"
#include "engine/assets/uri_file.h"

namespace lanthorn {

using nlohmann::json;

std::size_t GltfDocument::State::add_view(const std::string& bytes, int target) {
    const std::size_t buffer = held.empty() ? count("buffers") : held.rbegin()->first;
    if (held.empty()) {
        append("buffers", JsonText(R"({"byteLength":0})"));
        held[buffer] = std::make_shared<std::string>();
    }
    std::shared_ptr<std::string>& all = held[buffer];
    if (all.use_count() > 1) {
        all = std::make_shared<std::string>(*all);
    }
    JsonText& description = element("buffers", buffer);
    all->resize((index_at(description, "byteLength", 0) + 3) / 4 * 4, '\0');
    json view = {{"buffer", buffer}, {"byteLength", bytes.size()}, {"byteOffset", all->size()}};
    if (target != 0) {
        view["target"] = target;
    }
    *all += bytes;
    all->resize((all->size() + 3) / 4 * 4, '\0');
    description.set("byteLength", JsonText(std::to_string(all->size())));
    return append("bufferViews", JsonText(view.dump()));
}

std::size_t GltfDocument::State::add_accessor(const std::string& bytes, int target, const char* type,
                                              int component, std::size_t count, json members) {
    members["bufferView"] = add_view(bytes, target);
    members["componentType"] = component;
    members["count"] = count;
    members["type"] = type;
    return append("accessors", JsonText(members.dump()));
}

std::size_t GltfDocument::State::share_accessor(const std::string& bytes, int target, const char* type,
                                                int component, std::size_t count, const json& members) {
    const auto [known, added] =
        shared.try_emplace({fmt::format("{}{} {}", type, component, target), bytes}, 0);
    if (added) {
        known->second = add_accessor(bytes, target, type, component, count, members);
    } else {
        for (const auto& [key, value] : members.items()) {
            patch(element("accessors", known->second), key, value, json());
        }
    }
    return known->second;
}

std::string GltfDocument::State::buffer_bytes(std::size_t index) const {
    const JsonText& buffer = element("buffers", index);
    const std::string place = fmt::format("/buffers/{}", index);
    const std::size_t length = index_at(buffer, "byteLength", 0);
    std::string bytes;
    if (const auto found = held.find(index); found != held.end()) {
        bytes = *found->second;
    } else {
        const std::string uri = parsed(buffer, "uri").get<std::string>();
        std::vector<std::uint8_t> read;
        if (is_data_uri(uri)) {
            auto decoded = decode_data_uri(uri);
            if (!decoded) {
                refuse(place + "/uri",
                       "found a broken data URI, expected 'data:...;base64,' and base64 text");
            }
            read = std::move(*decoded);
        } else {
            const UriFile found = find_uri_file(source.parent_path(), uri, allow_outside, *folders);
            if (!found.problem.empty()) {
                refuse(place + "/uri", found.problem);
            }
            read = read_bytes(found.path, name, place + "/uri");
        }
        bytes.assign(read.begin(), read.end());
    }
    if (bytes.size() < length) {
        refuse(place + "/byteLength",
               fmt::format("the buffer holds {} bytes, expected {}", bytes.size(), length));
    }
    bytes.resize(length);
    return bytes;
}

}  // namespace lanthorn
