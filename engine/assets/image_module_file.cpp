#include "engine/assets/image_module_file.h"

#include <dlfcn.h>
#include <elf.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <system_error>

#include "engine/assets/image_metadata.h"
#include "lanthorn/core/installation.h"

namespace lanthorn {

namespace {

namespace fs = std::filesystem;

constexpr const char* kPackage = "lanthorn-images";

// Whether all of a library is there: one that was cut off would end the program while it is loaded.
bool is_whole(const fs::path& path) {
    Elf64_Ehdr head = {};
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(&head), sizeof head);
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    const std::uint64_t table = std::uint64_t{head.e_shnum} * head.e_shentsize;
    return file && !error && std::equal(ELFMAG, ELFMAG + SELFMAG, head.e_ident) &&
           head.e_ident[EI_CLASS] == ELFCLASS64 && head.e_shoff > 0 && head.e_shoff <= size &&
           table <= size - head.e_shoff;
}

}  // namespace

const char* image_module_version() {
    return LANTHORN_IMAGE_MODULE_VERSION;
}

const ImageModule* load_image_module(const fs::path& path, std::string& problem) {
    std::error_code error;
    if (!fs::exists(path, error)) {
        problem = fmt::format("is read and written by OpenImageIO, expected package {} ({} is not there)",
                              kPackage, path.string());
        return nullptr;
    }
    const std::string again = fmt::format("install package {} again", kPackage);
    if (!is_whole(path)) {
        problem = fmt::format("needs {}, which is damaged: {}", path.string(), again);
        return nullptr;
    }
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr) {
        problem = fmt::format("needs OpenImageIO: {}: {}", again, first_line(::dlerror()));
        return nullptr;
    }
    const auto* const version = static_cast<const char*>(::dlsym(library, kImageModuleVersionSymbol));
    const auto* const module = static_cast<const ImageModule*>(::dlsym(library, kImageModuleSymbol));
    if (version == nullptr || module == nullptr ||
        std::string_view(version) != LANTHORN_IMAGE_MODULE_VERSION) {
        problem = fmt::format("needs {}, which is of version {:.40}, expected {}: {}", path.string(),
                              version == nullptr ? "unknown" : version, LANTHORN_IMAGE_MODULE_VERSION, again);
        ::dlclose(library);
        return nullptr;
    }
    return module;
}

fs::path image_module_path() {
    if (const char* chosen = std::getenv("LANTHORN_IMAGE_MODULE")) {
        return chosen;
    }
    const fs::path share = installed_share();
    return share.empty() ? fs::path(LANTHORN_BUILT_IMAGE_MODULE)
                         : (share / LANTHORN_IMAGE_MODULE_FROM_SHARE).lexically_normal();
}

const ImageModule* image_module(std::string& problem) {
    static std::mutex mutex;
    static const ImageModule* loaded = nullptr;
    const std::scoped_lock lock(mutex);
    if (loaded == nullptr) {
        loaded = load_image_module(image_module_path(), problem);
    }
    return loaded;
}

}  // namespace lanthorn
