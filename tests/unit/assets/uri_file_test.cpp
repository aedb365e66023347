// Where files are looked for that a glTF names in another case, and how often folders are read for it.
#include <fmt/format.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <filesystem>

#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

// How often a folder's entries are read: to read them it must be opened. inotify(7).
class FolderWatch {
  public:
    explicit FolderWatch(const fs::path& folder) : queue_(inotify_init1(IN_NONBLOCK | IN_CLOEXEC)) {
        EXPECT_GE(inotify_add_watch(queue_, folder.c_str(), IN_OPEN | IN_CLOSE), 0) << std::strerror(errno);
    }
    ~FolderWatch() { close(queue_); }
    FolderWatch(const FolderWatch&) = delete;
    FolderWatch& operator=(const FolderWatch&) = delete;

    // Since the last call.
    int times_read() const {
        int count = 0;
        alignas(inotify_event) std::array<char, 1 << 16> events{};
        for (ssize_t size = 0; (size = read(queue_, events.data(), events.size())) > 0;) {
            inotify_event event{};
            for (std::size_t at = 0; at < static_cast<std::size_t>(size); at += sizeof(event) + event.len) {
                std::memcpy(&event, events.data() + at, sizeof(event));
                const bool itself = event.len == 0;  // an event of an entry has its name
                count += itself && (event.mask & IN_OPEN) != 0 ? 1 : 0;
            }
        }
        return count;
    }

  private:
    int queue_;
};

class UriFiles : public ImportTest {
  protected:
    void SetUp() override {
        builder.add_triangle();
        for (const char* name : {"inner/Textures", "outside"}) {
            fs::create_directories(folder.path() / name);
        }
    }
    // Of a file in inner/ whose materials show the images of these names.
    SceneData import_naming(const std::vector<std::string>& uris) {
        for (const char* key : {"images", "textures", "materials"}) {
            builder.json[key] = json::array();
        }
        for (std::size_t i = 0; i < uris.size(); ++i) {
            builder.json["images"].push_back({{"uri", uris[i]}});
            builder.json["textures"].push_back({{"source", i}});
            builder.json["materials"].push_back({{"emissiveTexture", {{"index", i}}}});
        }
        return import_gltf(folder.write("inner/scene.gltf", builder.gltf()));
    }
};

TEST_F(UriFiles, TheNoteHasTheWholePath) {
    folder.write("inner/Textures/red.png", make_png(1, 1, {200, 0, 0}, 3));
    const SceneData scene = import_naming({"./textures/red.png"});
    expect_warning(scene, "/images/0", "is taken for the file './Textures/red.png'");
    EXPECT_EQ(scene.images.size(), 1u);
}

TEST_F(UriFiles, FoldersOutsideAreNotRead) {
    fs::create_symlink("../outside", folder.path() / "inner/link");
    const FolderWatch outside(folder.path() / "outside");
    const FolderWatch above(folder.path());
    const std::vector<std::string> uris = {"../outside/none.png", "../OUTSIDE/none.png",
                                           "../outside/none/../../inner/none.png", "link/none.png",
                                           "LINK/none.png"};
    EXPECT_TRUE(import_naming(uris).images.empty());
    EXPECT_EQ(outside.times_read(), 0);
    EXPECT_EQ(above.times_read(), 0);
}

TEST_F(UriFiles, AFolderIsReadOnce) {
    folder.write("inner/Textures/red.png", make_png(1, 1, {200, 0, 0}, 3));
    const FolderWatch inner(folder.path() / "inner");
    const FolderWatch textures(folder.path() / "inner/Textures");
    std::string winding;
    for (int i = 0; i < 50; ++i) {
        winding += "TEXTURES/../";
    }
    std::vector<std::string> uris = {winding + "Textures/RED.png"};
    for (int i = 0; i < 50; ++i) {
        uris.push_back(fmt::format("Textures\\none%20{}.png", i));
        uris.push_back(fmt::format("none{}.png", i));
    }
    EXPECT_EQ(import_naming(uris).images.size(), 1u);
    EXPECT_EQ(inner.times_read(), 1);
    EXPECT_EQ(textures.times_read(), 1);
}

}  // namespace
}  // namespace lanthorn
