#include "game/level/campaign.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/core/json.h"
#include "game/level/asset_path.h"
#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/world.h"

namespace lanthorn::game {

namespace {

constexpr std::array<std::string_view, 9> kCampaign = {"red-wall",      "shutter",     "green-screen",
                                                       "two-glasses",   "mirrors",     "pool",
                                                       "burning-glass", "lamp-bearer", "other-light"};

// The first chunk of a binary glTF file (glTF 2.0, 4.4): its JSON.
std::string json_of(const std::string& path) {
    constexpr std::uint32_t kMagic = 0x46546c67, kJson = 0x4e4f534a;  // "glTF", "JSON"
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw InputError(path, "", "cannot be opened");
    }
    std::array<std::uint32_t, 5> head{};  // magic, version, length; length and kind of the chunk
    file.read(reinterpret_cast<char*>(head.data()), sizeof head);
    if (!file || head[0] != kMagic || head[4] != kJson) {
        throw InputError(path, "beginning", "is not binary glTF");
    }
    // The file itself says how much there is: a damaged head may name any length.
    file.seekg(0, std::ios::end);
    if (file.tellg() - std::streamoff{sizeof head} < std::streamoff{head[3]}) {
        throw InputError(path, "first chunk", "is cut off");
    }
    std::string json(head[3], '\0');
    file.seekg(sizeof head);
    file.read(json.data(), static_cast<std::streamsize>(json.size()));
    if (!file) {
        throw InputError(path, "first chunk", "cannot be read");
    }
    return json;
}

std::string name_of(const nlohmann::json& node) {
    const auto name = node.find("name");
    return name != node.end() && name->is_string() ? name->get<std::string>() : "";
}

}  // namespace

std::span<const std::string_view> campaign() {
    return kCampaign;
}

std::string level_path(std::string_view stem) {
    return asset_path("levels/" + std::string(stem) + ".glb");
}

LevelInfo read_level_info(const std::string& path) {
    const std::string text = json_of(path);
    const nlohmann::json document = parse_json_object(text, path, "glTF");
    ecs::Registry registry;
    declare_level_info(registry);
    ecs::World world;
    const auto nodes = document.find("nodes");
    if (nodes == document.end() || !nodes->is_array()) {
        return {};
    }
    for (const nlohmann::json& node : *nodes) {
        const auto extras = node.find("extras");
        if (extras == node.end() || !extras->is_object() || !extras->contains("level")) {
            continue;
        }
        const ecs::Entity e = world.create(LevelInfo{});
        try {
            ecs::set_json(registry, world, e, "level", (*extras)["level"].dump());
        } catch (const InputError& error) {
            throw InputError(path, "node '" + name_of(node) + "'", error.what());
        }
        return world.get<LevelInfo>(e);
    }
    return {};
}

}  // namespace lanthorn::game
