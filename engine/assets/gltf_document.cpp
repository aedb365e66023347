#include "lanthorn/assets/gltf_document.h"

#include "engine/assets/gltf_check.h"
#include "engine/assets/gltf_document_state.h"

namespace lanthorn {

GltfDocument::GltfDocument() : state_(std::make_unique<State>()) {}
GltfDocument::GltfDocument(const GltfDocument& other) : state_(std::make_unique<State>(*other.state_)) {}
GltfDocument::GltfDocument(GltfDocument&&) noexcept = default;
GltfDocument& GltfDocument::operator=(GltfDocument&&) noexcept = default;
GltfDocument::~GltfDocument() = default;

GltfDocument& GltfDocument::operator=(const GltfDocument& other) {
    return *this = GltfDocument(other);
}

GltfDocument GltfDocument::open(const std::filesystem::path& path, bool allow_outside) {
    GltfFile file = read_gltf_file(path, Keep::source);
    check_gltf(file);
    GltfDocument document;
    State& state = *document.state_;
    state.name = file.name;
    state.source = path;
    state.is_glb = file.is_glb;
    state.allow_outside = allow_outside;
    const std::size_t begin = file.text.find('{');  // white space may stand before it, and a byte order mark
    const std::size_t end = file.text.substr(0, file.text.find('\0')).rfind('}') + 1;  // parsers end at a NUL
    state.before = file.text.substr(0, begin);
    state.after = file.text.substr(end);
    file.text.resize(end);
    state.root = JsonText(file.text.substr(begin));
    state.other_chunks = std::move(file.other_chunks);
    if (file.chunk) {
        const bool is_buffer =
            state.count("buffers") > 0 && state.element("buffers", 0).find("uri") == nullptr;
        if (is_buffer) {
            state.held[0] = std::make_shared<std::string>(file.chunk->begin(), file.chunk->end());
        } else {
            state.other_chunks.insert(state.other_chunks.begin(), {kBinChunk, std::move(*file.chunk)});
        }
    }
    return document;
}

std::size_t GltfDocument::node_count() const {
    return state_->count("nodes");
}

std::size_t GltfDocument::mesh_count() const {
    return state_->count("meshes");
}

std::size_t GltfDocument::camera_count() const {
    return state_->count("cameras");
}

std::size_t GltfDocument::light_count() const {
    return state_->light_count();
}

std::size_t GltfDocument::material_count() const {
    return state_->count("materials");
}

std::string GltfDocument::node_name(std::size_t node) const {
    const nlohmann::json name = parsed(state_->element("nodes", node), "name");
    return name.is_string() ? name.get<std::string>() : std::string();
}

std::string GltfDocument::extras(std::size_t node) const {
    const JsonText* extras = std::as_const(*state_).element("nodes", node).find("extras");
    return extras == nullptr ? std::string() : extras->text();
}

std::string GltfDocument::json_text() const {
    return state_->before + state_->root.text() + state_->after;
}

}  // namespace lanthorn
