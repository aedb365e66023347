// Both trees against a look at every photon, after any number of frames.
#include "gi_module/techniques/vertex-map/photon_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "gi_module/techniques/vertex-map/kept_tree.h"

namespace lanthorn::gi {
namespace {

using Places = std::vector<std::uint32_t>;

Places by_looking_at_all(const PhotonStore& store, const vec3& point, float radius) {
    Places found;
    for (std::size_t i = 0; i < store.places().size(); ++i) {
        const vec3 span = store[i].position - point;
        if (store[i].used && glm::dot(span, span) <= radius * radius) {
            found.push_back(static_cast<std::uint32_t>(i));
        }
    }
    return found;
}

Places by_tree(const PhotonTree& tree, const vec3& point, float radius) {
    std::vector<NearPhoton> near;
    tree.within(0, point, radius, near);
    Places found;
    for (const NearPhoton& n : near) {
        found.push_back(n.place);
    }
    std::ranges::sort(found);
    return found;
}

class Photons {
  public:
    explicit Photons(std::uint32_t seed) : random_(seed) {}

    // `kind`: 0 spread through space, 1 on a plane, 2 on few points, 3 all in one.
    std::vector<StoredPhoton> walk(int kind) {
        std::vector<StoredPhoton> hits(random_() % 4);
        for (StoredPhoton& hit : hits) {
            hit.used = random_() % 5 != 0;
            hit.position = kind == 3 ? vec3(1) : vec3(number(), number(), number());
            hit.position = kind == 2 ? glm::floor(hit.position * 3.0f) : hit.position;
            hit.position.y = kind == 1 ? 0.25f : hit.position.y;
        }
        return hits;
    }
    float number() { return std::uniform_real_distribution<float>(-1, 1)(random_); }

  private:
    std::mt19937 random_;
};

class TreesByKind : public ::testing::TestWithParam<int> {};

TEST_P(TreesByKind, FindWhatLiesWithin) {
    Photons photons(7);
    PhotonStore store;
    store.reset(600, 3);
    KeptTree kept;
    const auto rebuilt = make_rebuilt_tree();
    for (int frame = 0; frame < 60; ++frame) {
        for (std::size_t i = 0; i < (frame == 0 ? 600u : 50u); ++i) {
            // Every third frame is of another kind, so that the tree's shape has to change.
            store.replace((i + static_cast<std::size_t>(frame) * 50) % 600,
                          photons.walk(frame % 3 == 2 ? (GetParam() + 1) % 4 : GetParam()));
        }
        kept.update(store, frame == 0);
        rebuilt->update(store, frame == 0);
        store.forget_changed();
        ASSERT_EQ(kept.size(), store.used());
        ASSERT_EQ(rebuilt->size(), store.used());
        for (int i = 0; i < 20; ++i) {
            const vec3 point(photons.number(), photons.number(), photons.number());
            const float radius = 0.5f + 0.5f * photons.number();
            const Places wanted = by_looking_at_all(store, point, radius);
            ASSERT_EQ(by_tree(kept, point, radius), wanted) << frame;
            ASSERT_EQ(by_tree(*rebuilt, point, radius), wanted) << frame;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, TreesByKind, ::testing::Range(0, 4));

TEST(KeptTree, FindsPhotonsThatAllLieInOnePoint) {
    PhotonStore store;
    store.reset(1000, 1);
    StoredPhoton photon;
    photon.position = vec3(0.1f, 0.2f, 0.3f);
    photon.used = true;
    for (std::size_t i = 0; i < 1000; ++i) {
        store.replace(i, std::span(&photon, 1));
    }
    KeptTree tree;
    tree.update(store, true);
    EXPECT_EQ(by_tree(tree, photon.position, 0).size(), 1000u);
    EXPECT_EQ(by_tree(tree, photon.position + vec3(0.01f), 0.005f).size(), 0u);
    // Once others come, they are told apart.
    store.forget_changed();
    for (std::size_t i = 0; i < 500; ++i) {
        photon.position = vec3(static_cast<float>(i), 0, 0);
        store.replace(i, std::span(&photon, 1));
    }
    tree.update(store, false);
    EXPECT_EQ(by_tree(tree, vec3(0.1f, 0.2f, 0.3f), 0).size(), 500u);
    EXPECT_EQ(by_tree(tree, vec3(250, 0, 0), 0.5f).size(), 1u);
    EXPECT_LT(tree.depth(), 16u);
}

// A lamp that moves on carries all photons to one side: the tree must not become a list.
TEST(KeptTree, StaysShallowWhenAllPhotonsWander) {
    PhotonStore store;
    store.reset(4096, 1);
    KeptTree tree;
    Photons photons(3);
    StoredPhoton photon;
    photon.used = true;
    std::size_t deepest = 0;
    for (std::size_t frame = 0; frame < 400; ++frame) {
        for (std::size_t i = 0; i < (frame == 0 ? 4096u : 128u); ++i) {
            photon.position = vec3(static_cast<float>(frame) * 0.05f) +
                              vec3(photons.number(), photons.number(), photons.number());
            store.replace((frame * 128 + i) % 4096, std::span(&photon, 1));
        }
        tree.update(store, frame == 0);
        store.forget_changed();
        deepest = std::max(deepest, tree.depth());
    }
    EXPECT_LE(deepest, 2 * 9u);  // a balanced one of 4096 photons has 9 levels
    // And what balancing costs: each photon that came was put into a part built anew a few times.
    EXPECT_LT(static_cast<double>(tree.rebuilt()), 10.0 * 400 * 128);
}

// Photons that come to other surfaces, and back: each is found on its own alone, or, together, on any.
TEST(PhotonTrees, KeepSurfacesApart) {
    PhotonStore store;
    store.reset(300, 1);
    KeptTree apart, together(TreeSurfaces::together);
    const auto rebuilt = make_rebuilt_tree();
    const auto rebuilt_together = make_rebuilt_tree(TreeSurfaces::together);
    Photons photons(9);
    for (std::size_t frame = 0; frame < 20; ++frame) {
        for (std::size_t i = 0; i < 300; ++i) {
            StoredPhoton photon;
            photon.used = true;
            photon.position = vec3(photons.number(), photons.number(), photons.number());
            photon.surface = (i + frame) % 3;
            store.replace(i, std::span(&photon, 1));
        }
        for (PhotonTree* tree : {static_cast<PhotonTree*>(&apart), static_cast<PhotonTree*>(&together),
                                 rebuilt.get(), rebuilt_together.get()}) {
            tree->update(store, frame == 0);
            EXPECT_EQ(tree->size(), 300u);
        }
        store.forget_changed();
        for (const PhotonTree* tree :
             {static_cast<const PhotonTree*>(&apart), static_cast<const PhotonTree*>(rebuilt.get())}) {
            for (SurfaceKey surface = 0; surface < 4; ++surface) {
                std::vector<NearPhoton> found;
                tree->within(surface, vec3(0), 10, found);
                EXPECT_EQ(found.size(), surface < 3 ? 100u : 0u);
                for (const NearPhoton& near : found) {
                    EXPECT_EQ(store[near.place].surface, surface);
                }
            }
        }
        EXPECT_EQ(by_tree(together, vec3(0), 10).size(), 300u);
        EXPECT_EQ(by_tree(*rebuilt_together, vec3(0), 10).size(), 300u);
    }
}

TEST(KeptTree, AnEmptyStoreHasNothingToFind) {
    PhotonStore store;
    store.reset(0, 3);
    KeptTree kept;
    kept.update(store, true);
    const auto rebuilt = make_rebuilt_tree();
    rebuilt->update(store, true);
    EXPECT_TRUE(by_tree(kept, vec3(0), 10).empty());
    EXPECT_TRUE(by_tree(*rebuilt, vec3(0), 10).empty());
}

}  // namespace
}  // namespace lanthorn::gi
