// After Frisvad et al. 2005, Fig. 8: the Cornell box with two mirror balls where its blocks were.
#include <algorithm>
#include <string_view>

#include "tools/scene_generator/builder.h"
#include "tools/scene_generator/scenes.h"

namespace lanthorn::scene_generator {

SceneData mirror_balls() {
    Builder b;
    b.scene = cornell();
    const std::uint32_t silver = b.metal("silver", {0.95f, 0.94f, 0.91f}, 0);
    const auto put = [&](std::string_view block, const char* name, double radius, double x, double z) {
        const auto node = std::ranges::find(b.scene.nodes, block, &NodeData::name);
        const std::uint32_t place = node->meshes.front();
        const std::uint32_t ball = b.mesh(name, icosphere(radius, 4), silver);
        std::swap(b.scene.meshes[place], b.scene.meshes[ball]);
        b.scene.meshes.pop_back();
        node->name = name;
        node->local = at({x, radius, z});
    };
    put("short-block", "small-ball", 0.085, -0.17, -0.17);
    put("tall-block", "large-ball", 0.12, -0.36, -0.36);
    return b.scene;
}

}  // namespace lanthorn::scene_generator
