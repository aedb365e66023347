// A document's way to files: containers, and the files that it names.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <system_error>

#include "engine/assets/gltf_document_state.h"
#include "engine/assets/gltf_named_files.h"
#include "engine/assets/uri.h"
#include "engine/assets/uri_file.h"
#include "engine/assets/written_files.h"
#include "lanthorn/core/error.h"
#include "lanthorn/core/printable.h"

namespace lanthorn {

namespace fs = std::filesystem;

namespace {

void append_u32(std::string& out, std::uint64_t value) {
    for (int shift = 0; shift < 32; shift += 8) {
        out.push_back(static_cast<char>(value >> shift));
    }
}

struct GlbChunk {
    std::uint32_t type;
    std::string_view bytes;
};

// glTF 2.0, 4.4. Chunks are filled up to multiples of four bytes.
std::string glb_of(const std::string& name, const std::vector<GlbChunk>& chunks) {
    std::uint64_t length = 12;
    for (const GlbChunk& chunk : chunks) {
        length += 8 + (chunk.bytes.size() + 3) / 4 * 4;
    }
    if (length > 0xffffffff) {
        throw InputError(
            name, "",
            fmt::format("cannot be written: it has {} bytes, a .glb holds at most 4294967295", length));
    }
    std::string out = "glTF";
    out.reserve(length);
    append_u32(out, 2);
    append_u32(out, length);
    for (const GlbChunk& chunk : chunks) {
        append_u32(out, (chunk.bytes.size() + 3) / 4 * 4);
        append_u32(out, chunk.type);
        out += chunk.bytes;
        out.resize((out.size() + 3) / 4 * 4, chunk.type == kJsonChunk ? ' ' : '\0');
    }
    return out;
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code error;
    return fs::equivalent(a.empty() ? "." : a, b.empty() ? "." : b, error);
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

enum class Container { gltf, glb };

Container container_of(const fs::path& path) {
    std::string ending = path.extension().string();
    for (char& c : ending) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    if (ending != ".gltf" && ending != ".glb") {
        throw InputError(path.string(), "",
                         fmt::format("found the ending '{}', expected .gltf or .glb", ending));
    }
    return ending == ".glb" ? Container::glb : Container::gltf;
}

// By the document that is at `path` now, if one is.
std::set<fs::path> files_named_by(const fs::path& path) {
    std::set<fs::path> names;
    if (is_file(path)) {
        try {
            for (const NamedFile& file : named_files(JsonText(read_gltf_file(path).json.dump()))) {
                names.insert(file.path().lexically_normal());
            }
        } catch (const std::exception&) {  // no glTF file, or a broken one
            names.clear();
        }
    }
    return names;
}

}  // namespace

// One writing of a document: a copy of its JSON that says where buffers are in the new place.
class GltfWriting {
  public:
    GltfWriting(const GltfDocument& document, Container container)
        : state_(*document.state_), container_(container), root_(state_.root) {}

    GltfDocument::Written to(const fs::path& path);
    std::string glb();

  private:
    void fill_chunk();
    void place_named_files();
    void place_held_buffers(const std::string& stem);
    bool is_somebodys(const fs::path& name, std::string_view bytes) const;
    std::string free_name(const std::string& wanted, std::string_view bytes);
    std::string bytes();
    bool is_left_named(const NamedFile& file, const UriFile& found);
    void copy(const NamedFile& file, const fs::path& source, const std::string& name);
    void add(const fs::path& name, std::string_view bytes);

    const GltfDocument::State& state_;
    Container container_;
    JsonText root_;
    std::string moved_;                      // what buffer 0 held outside of the container
    std::optional<std::string_view> chunk_;  // BIN
    fs::path folder_;
    std::set<fs::path> taken_;       // names in folder_
    std::set<fs::path> replaced_;    // names in folder_ that the document there now has
    std::vector<fs::path> sources_;  // files that the document was read from or names
    WrittenFiles files_;
    GltfDocument::Written written_;
};

void GltfWriting::fill_chunk() {
    if (container_ != Container::glb) {
        for (const GltfFile::Chunk& chunk : state_.other_chunks) {
            if (chunk.type != kBinChunk) {
                state_.refuse(
                    "", fmt::format("has a GLB chunk of type 0x{:08x}, which a .gltf cannot hold, expected a "
                                    ".glb to write",
                                    chunk.type));
            }
            written_.warnings.push_back(
                fmt::format("{}: the BIN chunk of {} bytes is left out: no buffer is in it", state_.name,
                            chunk.bytes.size()));
        }
        return;
    }
    if (const auto held = state_.held.find(0); held != state_.held.end()) {
        chunk_ = *held->second;
    } else if (!state_.is_glb && state_.count("buffers") > 0) {
        const nlohmann::json uri = parsed(state_.element("buffers", 0), "uri");
        const bool moves = uri.is_string() && !has_foreign_scheme(uri.get<std::string>());
        // Data that is not base64 stays as it is.
        if (moves && (!is_data_uri(uri.get<std::string>()) || decode_data_uri(uri.get<std::string>()))) {
            moved_ = state_.buffer_bytes(0);
            chunk_ = moved_;
            root_.find("buffers")->at(0).erase("uri");
        }
    }
}

// Whether something else than a document that was here before may need what is at folder_ / name.
bool GltfWriting::is_somebodys(const fs::path& name, std::string_view bytes) const {
    const fs::path target = folder_ / name;
    if (!is_file(target) || replaced_.contains(name)) {
        return false;
    }
    const std::vector<std::uint8_t> there = read_bytes(target, target.string(), "");
    return std::string_view(reinterpret_cast<const char*>(there.data()), there.size()) != bytes;
}

// `wanted`, or that with a number, so that it is nobody's.
std::string GltfWriting::free_name(const std::string& wanted, std::string_view bytes) {
    const fs::path path(wanted);
    std::string name = wanted;
    for (int number = 1; taken_.contains(name) || is_somebodys(name, bytes); ++number) {
        name = fmt::format("{}-{}{}", path.stem().string(), number, path.extension().string());
    }
    taken_.insert(name);
    return name;
}

void GltfWriting::add(const fs::path& name, std::string_view bytes) {
    const fs::path target = folder_ / name;
    for (const fs::path& source : sources_) {
        if (is_same_file(source, target)) {
            throw InputError(
                target.string(), "",
                fmt::format("cannot be written: '{}' is made of it, expected another folder", state_.name));
        }
    }
    files_.add(folder_, name, bytes);
    written_.files.push_back(target);
}

// Buffers must be there; an image may be missing, and an extension's URI need not be a file's.
bool GltfWriting::is_left_named(const NamedFile& file, const UriFile& found) {
    if (!found.problem.empty() && file.owner == NamedFile::Owner::buffer) {
        throw InputError(state_.name, file.pointer(), found.problem);
    }
    if (!found.problem.empty()) {
        written_.warnings.push_back(
            printable(fmt::format("{}: {}: {}; it stays named", state_.name, file.pointer(), found.problem)));
        return true;
    }
    if (file.owner == NamedFile::Owner::buffer || is_file(found.path)) {
        return false;
    }
    if (file.owner == NamedFile::Owner::image) {
        written_.warnings.push_back(printable(fmt::format("{}: {}: found no file '{}'; the image stays named",
                                                          state_.name, file.pointer(), found.path.string())));
    }
    return true;
}

void GltfWriting::copy(const NamedFile& file, const fs::path& source, const std::string& name) {
    if (is_same_file(source, folder_ / name)) {
        return;
    }
    const std::vector<std::uint8_t> read = read_bytes(source, state_.name, file.pointer());
    const std::string_view bytes(reinterpret_cast<const char*>(read.data()), read.size());
    if (is_somebodys(name, bytes)) {
        throw InputError(
            (folder_ / name).string(), "",
            fmt::format(
                "cannot be written: another file is there, and '{}' needs this name, expected another "
                "folder",
                state_.name));
    }
    add(name, bytes);
}

// In the folder that they are in, named files stay; elsewhere they are copied.
void GltfWriting::place_named_files() {
    const fs::path old_folder = state_.source.parent_path();
    const bool stay = state_.source.empty() || is_same_file(old_folder, folder_);
    const std::vector<NamedFile> files = named_files(root_);
    std::vector<UriFile> found;
    for (const NamedFile& file : files) {
        found.push_back(find_uri_file(old_folder, file.uri, state_.allow_outside, *state_.folders));
        sources_.push_back(found.back().path.empty() ? old_folder / file.path() : found.back().path);
        if (stay || !file.leaves_its_folder()) {
            taken_.insert(file.path().lexically_normal());
        }
    }
    std::map<fs::path, std::string> names;  // new by old
    for (std::size_t i = 0; i < files.size(); ++i) {
        const NamedFile& file = files[i];
        if (stay || is_left_named(file, found[i])) {
            continue;
        }
        const fs::path path = file.path().lexically_normal();
        const auto [name, is_new] = names.try_emplace(path, path.string());
        if (is_new && file.leaves_its_folder()) {
            const std::vector<std::uint8_t> read = read_bytes(found[i].path, state_.name, file.pointer());
            name->second = free_name(path.filename().string(),
                                     {reinterpret_cast<const char*>(read.data()), read.size()});
        }
        if (is_new) {
            copy(file, found[i].path, name->second);
        }
        if (file.leaves_its_folder()) {
            file.rename(root_, name->second);
        }
    }
}

// Buffers without a URI that are not in the chunk: NAME.bin.
void GltfWriting::place_held_buffers(const std::string& stem) {
    for (const auto& held : state_.held) {
        const std::size_t index = held.first;
        if (index == 0 && container_ == Container::glb) {
            continue;
        }
        const std::string bytes = state_.buffer_bytes(index);
        const std::string name = free_name(stem + ".bin", bytes);
        root_.find("buffers")->at(index).set("uri", JsonText(json_quoted(percent_encoded(name))));
        add(name, bytes);
    }
}

std::string GltfWriting::bytes() {
    const bool same = state_.is_glb == (container_ == Container::glb);
    std::string text = same ? state_.before + root_.text() + state_.after : root_.text();
    if (container_ == Container::gltf) {
        return text;
    }
    std::vector<GlbChunk> chunks{{kJsonChunk, text}};
    if (chunk_) {
        chunks.push_back({kBinChunk, *chunk_});
    }
    for (const GltfFile::Chunk& chunk : state_.other_chunks) {
        chunks.push_back(
            {chunk.type, {reinterpret_cast<const char*>(chunk.bytes.data()), chunk.bytes.size()}});
    }
    return glb_of(state_.name, chunks);
}

GltfDocument::Written GltfWriting::to(const fs::path& path) {
    check_writable(path);
    folder_ = path.parent_path();
    taken_.insert(path.filename());
    replaced_ = files_named_by(path);
    fill_chunk();
    place_named_files();
    const std::vector<fs::path> named = sources_;
    if (!state_.source.empty()) {
        sources_.push_back(state_.source);
    }
    place_held_buffers(path.stem().string());
    sources_ = named;  // the document itself may be written over
    add(path.filename(), bytes());
    files_.commit();
    std::rotate(written_.files.begin(), written_.files.end() - 1, written_.files.end());
    return std::move(written_);
}

std::string GltfWriting::glb() {
    fill_chunk();
    if (!state_.held.empty() && state_.held.rbegin()->first > 0) {
        state_.refuse(fmt::format("/buffers/{}", state_.held.rbegin()->first),
                      "is a second buffer without a URI, expected one at most");
    }
    return bytes();
}

GltfDocument::Written GltfDocument::write(const fs::path& path) const {
    return GltfWriting(*this, container_of(path)).to(path);
}

std::string GltfDocument::glb_bytes() const {
    return GltfWriting(*this, Container::glb).glb();
}

}  // namespace lanthorn
