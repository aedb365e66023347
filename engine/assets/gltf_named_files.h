// The files that a glTF document names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/assets/json_text.h"

namespace lanthorn {

// A relative URI of a document.
struct NamedFile {
    enum class Owner { buffer, image, extension };

    std::vector<std::string> place;  // keys and indices from the root to the JSON string
    std::string uri;
    Owner owner = Owner::buffer;

    std::string pointer() const;                            // "/buffers/0/uri"
    std::filesystem::path path() const;                     // relative to the document's folder, or absolute
    bool leaves_its_folder() const;                         // "../a.png", "/tmp/a.png"
    void rename(JsonText& root, const std::string&) const;  // sets the URI of a path
};

// Those of buffers and images, and members "uri" of extensions whatever these mean. Not data URIs, nor URLs.
std::vector<NamedFile> named_files(const JsonText& root);

}  // namespace lanthorn
