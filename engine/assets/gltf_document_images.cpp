// A document that takes in the files that it names.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "engine/assets/gltf_document_state.h"
#include "engine/assets/gltf_named_files.h"
#include "engine/assets/uri.h"
#include "engine/assets/uri_file.h"
#include "lanthorn/core/printable.h"

namespace lanthorn {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

struct Signature {
    std::string_view bytes;
    const char* type;
};

// Empty for other formats.
std::string media_type_of(std::string_view bytes) {
    using namespace std::string_view_literals;
    static constexpr std::array kSignatures = {
        Signature{"\x89PNG\r\n\x1a\n"sv, "image/png"}, Signature{"\xff\xd8\xff"sv, "image/jpeg"},
        Signature{"\xabKTX 20\xbb"sv, "image/ktx2"}, Signature{"DDS "sv, "image/vnd-ms.dds"},
        Signature{"BM"sv, "image/bmp"}};
    if (bytes.starts_with("RIFF") &&
        bytes.substr(std::min<std::size_t>(8, bytes.size())).starts_with("WEBP")) {
        return "image/webp";
    }
    const auto* const found = std::ranges::find_if(
        kSignatures, [&](const Signature& signature) { return bytes.starts_with(signature.bytes); });
    return found == kSignatures.end() ? "" : found->type;
}

}  // namespace

std::optional<std::string> GltfDocument::State::file_bytes(const NamedFile& file,
                                                           std::vector<std::string>& warnings) const {
    const UriFile found = find_uri_file(source.parent_path(), file.uri, allow_outside, *folders);
    std::error_code ignored;
    if (!found.problem.empty()) {
        warnings.push_back(
            printable(fmt::format("{}: {}: {}; it stays named", name, file.pointer(), found.problem)));
        return std::nullopt;
    }
    if (!fs::is_regular_file(found.path, ignored)) {
        warnings.push_back(printable(fmt::format("{}: {}: found no file '{}'; the image stays named", name,
                                                 file.pointer(), found.path.string())));
        return std::nullopt;
    }
    const std::vector<std::uint8_t> bytes = read_bytes(found.path, name, file.pointer());
    return std::string(bytes.begin(), bytes.end());
}

// Buffer 0 becomes one without a URI, which a .glb has in its chunk; those behind it data URIs.
void GltfDocument::State::hold_buffers() {
    for (std::size_t i = 0; i < count("buffers"); ++i) {
        const json uri = parsed(element("buffers", i), "uri");
        if (i == 0 && uri.is_string()) {
            held[0] = std::make_shared<std::string>(buffer_bytes(0));
            element("buffers", 0).erase("uri");
        } else if (uri.is_string() && !is_data_uri(uri.get<std::string>())) {
            element("buffers", i).set("uri", JsonText('"' + data_uri(buffer_bytes(i)) + '"'));
        }
    }
    if (count("buffers") > 0 && !held.contains(0)) {
        refuse("/buffers/0", "has no bytes of its own, expected a buffer that images can be put behind");
    }
}

std::vector<std::string> GltfDocument::take_in_files() {
    State& state = *state_;
    state.hold_buffers();
    std::vector<std::string> warnings;
    for (const NamedFile& file : named_files(state.root)) {
        if (file.owner != NamedFile::Owner::image) {
            continue;
        }
        const std::optional<std::string> bytes = state.file_bytes(file, warnings);
        if (!bytes) {
            continue;
        }
        JsonText& image = state.element("images", std::stoul(file.place.at(1)));
        const std::string found = media_type_of(*bytes);
        const std::string type = found.empty() ? parsed(image, "mimeType").is_string()
                                                     ? parsed(image, "mimeType").get<std::string>()
                                                     : "application/octet-stream"
                                               : found;
        if (parsed(image, "name").is_null()) {
            image.set("name", JsonText(json_quoted(file.path().stem().string())));
        }
        image.erase("uri");
        image.set("mimeType", JsonText(json_quoted(type)));
        image.set("bufferView", JsonText(std::to_string(state.add_view(*bytes, 0))));
    }
    return warnings;
}

}  // namespace lanthorn
