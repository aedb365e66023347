#include <fmt/format.h>

#include "engine/assets/gltf_check_parts.h"

namespace lanthorn {

using nlohmann::json;

namespace {

void check_skin(const JsonPlace& skin, json& root) {
    skin.string("name");
    check_accessor_use(skin, "inverseBindMatrices", root);
    skin.index("skeleton", "nodes");
    if (!skin.indices("joints", "nodes") || skin.value()["joints"].empty()) {
        skin.refuse("joints", "found no joints, expected at least one node");
    }
}

void check_channel(const JsonPlace& channel, std::size_t samplers) {
    channel.integer("sampler", 0, 0x7fffffff, Need::required);
    if (channel.get("sampler") >= samplers) {
        channel.refuse("sampler", fmt::format("found {}, expected an index below {} (the number of samplers)",
                                              channel.get("sampler"), samplers));
    }
    channel.object(
        "target",
        [](const JsonPlace& target) {
            target.index("node", "nodes");
            target.string("path", Need::required);
            target.object("extensions", [](const JsonPlace& extensions) {
                extensions.object("KHR_animation_pointer",
                                  [](const JsonPlace& own) { own.string("pointer", Need::required); });
            });
        },
        Need::required);
}

void check_animation(const JsonPlace& animation, json& root) {
    animation.string("name");
    animation.objects(
        "samplers",
        [&](const JsonPlace& sampler) {
            check_accessor_use(sampler, "input", root, Need::required);
            check_accessor_use(sampler, "output", root, Need::required);
            sampler.string("interpolation");
        },
        Need::required);
    const std::size_t samplers = animation.value()["samplers"].size();
    animation.objects(
        "channels", [&](const JsonPlace& channel) { check_channel(channel, samplers); }, Need::required);
}

}  // namespace

void check_skins(const JsonPlace& place, json& root) {
    place.objects("skins", [&](const JsonPlace& skin) { check_skin(skin, root); });
}

void check_animations(const JsonPlace& place, json& root) {
    place.objects("animations", [&](const JsonPlace& animation) { check_animation(animation, root); });
}

}  // namespace lanthorn
