// Places of photons, and what comes into them.
#include "gi_module/techniques/vertex-map/photon_store.h"

#include <gtest/gtest.h>

namespace lanthorn::gi {
namespace {

StoredPhoton photon(float x, bool used = true) {
    StoredPhoton p;
    p.position = vec3(x, 0, 0);
    p.flux = vec3(1);
    p.used = used;
    return p;
}

// Fig. 11: the second hits of all photons lie behind the first ones.
TEST(PhotonStore, HasAPlaceForEveryHitOfEveryPhoton) {
    PhotonStore store;
    store.reset(10, 3);
    EXPECT_EQ(store.places().size(), 30u);
    EXPECT_EQ(store.place(4, 0), 4u);
    EXPECT_EQ(store.place(4, 2), 24u);
    EXPECT_EQ(store.used(), 0u);
}

TEST(PhotonStore, ANewPhotonTakesThePlacesOfTheOldOne) {
    PhotonStore store;
    store.reset(4, 3);
    store.replace(1, std::vector{photon(1), photon(2), photon(3)});
    EXPECT_EQ(store.used(), 3u);
    store.forget_changed();
    store.replace(1, std::vector{photon(9)});
    EXPECT_EQ(store.used(), 1u);
    EXPECT_EQ(store[store.place(1, 0)].position.x, 9);
    EXPECT_FALSE(store[store.place(1, 1)].used);
    EXPECT_FALSE(store[store.place(1, 2)].used);
    EXPECT_EQ(std::vector<std::uint32_t>(store.changed().begin(), store.changed().end()),
              (std::vector<std::uint32_t>{1, 5, 9}));
}

TEST(PhotonStore, AHitAtAMirrorIsNotUsedAndTheNextOneIs) {
    PhotonStore store;
    store.reset(2, 3);
    store.replace(0, std::vector{photon(1), photon(2, false), photon(3)});
    EXPECT_EQ(store.used(), 2u);
    EXPECT_FALSE(store[store.place(0, 1)].used);
    EXPECT_TRUE(store[store.place(0, 2)].used);
}

TEST(PhotonStore, HitsPastTheLastLevelAreDropped) {
    PhotonStore store;
    store.reset(1, 2);
    store.replace(0, std::vector{photon(1), photon(2), photon(3)});
    EXPECT_EQ(store.used(), 2u);
}

TEST(PhotonStore, TellsEveryChangedPlaceOnce) {
    PhotonStore store;
    store.reset(3, 1);
    store.replace(2, std::vector{photon(1)});
    store.replace(2, std::vector{photon(2)});
    store.replace(0, {});  // it had none and gets none
    EXPECT_EQ(std::vector<std::uint32_t>(store.changed().begin(), store.changed().end()),
              (std::vector<std::uint32_t>{2}));
    store.forget_changed();
    EXPECT_TRUE(store.changed().empty());
    store.replace(2, {});
    EXPECT_EQ(store.changed().size(), 1u);
    EXPECT_EQ(store.used(), 0u);
}

TEST(PhotonStore, PhotonsGoAlongWithTheSurfaceThatTheyLieOn) {
    PhotonStore store;
    store.reset(2, 1);
    StoredPhoton moved = photon(1), other = photon(2);
    moved.surface = 7;
    moved.normal = other.normal = vec3(1, 0, 0);
    store.replace(0, std::span(&moved, 1));
    store.replace(1, std::span(&other, 1));
    store.forget_changed();
    // A quarter turn about y, and up.
    store.carry({{7, mat4(vec4(0, 0, -1, 0), vec4(0, 1, 0, 0), vec4(1, 0, 0, 0), vec4(0, 5, 0, 1))}});
    EXPECT_LT(glm::distance(store[0].position, vec3(0, 5, -1)), 1e-6f);
    EXPECT_LT(glm::distance(store[0].normal, vec3(0, 0, -1)), 1e-6f);
    EXPECT_EQ(store[1].position, vec3(2, 0, 0));
    EXPECT_EQ(std::vector<std::uint32_t>(store.changed().begin(), store.changed().end()),
              (std::vector<std::uint32_t>{0}));
}

TEST(PhotonStore, NoPhotonsHaveNoPlaces) {
    PhotonStore store;
    store.reset(0, 3);
    EXPECT_TRUE(store.places().empty());
}

}  // namespace
}  // namespace lanthorn::gi
