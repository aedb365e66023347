// `vertex-map` in an App.
#pragma once

#include <gtest/gtest.h>

#include "gi_module/techniques/vertex-map/vertex_map_technique.h"
#include "lanthorn/vertex-map/vertex_map.h"
#include "tests/gpu/gi/test_scene.h"

namespace lanthorn::gi::test {

inline constexpr ivec2 kSize(128);

// A Bench of this technique; tells the door of it first.
struct VertexMap : Bench {
    VertexMap() : Bench(add_vertex_map()) {}
    VertexMapSettings& own() { return settings.edit<VertexMapSettings>(); }
    VertexMapStatistics now() { return technique().statistics(false).of<VertexMapStatistics>(); }
    // The scene as it is until it changes no more.
    ImageF settled(FrameScene& scene, ivec2 size = kSize) {
        ImageF image = frame(scene, size);
        hold_still(scene);
        for (int i = 0; i < 100; ++i) {
            image = frame(scene, size);
            if (now().left == 0 && now().estimates == 0) {
                return image;
            }
        }
        ADD_FAILURE() << "it has not settled";
        return image;
    }
};

}  // namespace lanthorn::gi::test
