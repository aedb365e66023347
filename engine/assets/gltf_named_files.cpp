#include "engine/assets/gltf_named_files.h"

#include <nlohmann/json.hpp>

#include "engine/assets/uri.h"
#include "engine/core/json.h"

namespace lanthorn {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

void find_in_extensions(const json& value, std::vector<std::string>& place, bool inside,
                        std::vector<NamedFile>& found) {
    const auto step = [&](const std::string& key, const json& member) {
        place.push_back(key);
        if (inside && key == "uri" && member.is_string()) {
            found.push_back({place, member, NamedFile::Owner::extension});
        }
        find_in_extensions(member, place, inside || key == "extensions", found);
        place.pop_back();
    };
    if (value.is_object()) {
        for (const auto& [key, member] : value.items()) {
            if (key != "extras") {
                step(key, member);
            }
        }
    } else if (value.is_array()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
            step(std::to_string(i), value[i]);
        }
    }
}

}  // namespace

std::string NamedFile::pointer() const {
    std::string text;
    for (const std::string& key : place) {
        text += '/' + key;
    }
    return text;
}

fs::path NamedFile::path() const {
    return percent_decoded(uri);
}

bool NamedFile::leaves_its_folder() const {
    const fs::path normal = path().lexically_normal();
    return normal.is_absolute() || (!normal.empty() && *normal.begin() == "..");
}

void NamedFile::rename(JsonText& root, const std::string& name) const {
    JsonText* at = &root;
    for (const std::string& key : place) {
        at = at->is_array() ? &at->at(std::stoul(key)) : at->find(key);
    }
    *at = JsonText(json_quoted(percent_encoded(name)));
}

std::vector<NamedFile> named_files(const JsonText& root) {
    std::vector<NamedFile> found;
    const json document = parse_json(root.text(), "document");
    for (const auto& [key, owner] :
         {std::pair("buffers", NamedFile::Owner::buffer), std::pair("images", NamedFile::Owner::image)}) {
        const json list = document.value(key, json::array());
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i].contains("uri")) {
                found.push_back({{key, std::to_string(i), "uri"}, list[i]["uri"], owner});
            }
        }
    }
    std::vector<std::string> place;
    find_in_extensions(document, place, false, found);
    std::erase_if(
        found, [](const NamedFile& file) { return is_data_uri(file.uri) || has_foreign_scheme(file.uri); });
    return found;
}

}  // namespace lanthorn
