#include "lanthorn/ecs/registry.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>

#include "engine/ecs/value_ops.h"
#include "lanthorn/core/error.h"
#include "tests/unit/ecs/declared.h"

namespace lanthorn::ecs {
namespace {

using test::Door;
using test::line_of;

struct Mixed {
    int a = 0;
    std::optional<double> b;
    std::vector<std::string> c;
    std::array<float, 3> d{};
    std::shared_ptr<int> e;
    dvec3 f{0};
    bool g = false;
};
struct Empty {};
static_assert(kMemberCount<Mixed> == 7);
static_assert(kMemberCount<Empty> == 0);

struct Pair {
    int first = 0;
    int second = 0;
};

// A field left out is no program: the declaration has no overload for it.
template <class... Fields>
concept Declarable = requires(Registry& registry, Fields... fields) {
    registry.component<Pair>("pair", "", std::move(fields)...);
};
using IntField = FieldDeclaration<Pair, int>;
static_assert(Declarable<IntField, IntField>);
static_assert(!Declarable<IntField>);
static_assert(!Declarable<IntField, IntField, IntField>);

TEST(Registry, KnowsWhatIsDeclared) {
    Registry registry;
    test::declare(registry);
    const ComponentType* door = registry.find("door");
    ASSERT_NE(door, nullptr);
    EXPECT_EQ(door, registry.find<Door>());
    ASSERT_EQ(door->value->fields.size(), kMemberCount<Door>);
    const Field& angle = door->value->fields[0];
    EXPECT_EQ(angle.name, "open_angle");
    EXPECT_EQ(angle.unit, "rad");
    EXPECT_EQ(angle.expectation(), "a number from 0 to 3.1 rad");
    EXPECT_FLOAT_EQ(static_cast<const Door*>(door->initial.get())->open_angle, 1.9f);
    EXPECT_EQ(registry.find("dor"), nullptr);
    EXPECT_EQ(line_of([&] { registry.find_or_throw("dor"); }),
              "component 'dor' is not declared, did you mean 'door'?");
}

TEST(Registry, RefusesASecondDeclaration) {
    Registry registry;
    registry.component<Pair>("pair", "", field("first", &Pair::first), field("second", &Pair::second));
    EXPECT_EQ(line_of([&] { registry.component<Empty>("pair", ""); }),
              "component 'pair' is declared already");
    EXPECT_EQ(line_of([&] {
                  registry.component<Pair>("other", "", field("first", &Pair::first),
                                           field("second", &Pair::second));
              }),
              "'other': lanthorn::ecs::{anonymous}::Pair is declared already");
    EXPECT_EQ(line_of([&] { registry.component<Empty>("Two words", ""); }),
              "component 'Two words': malformed name, expected letters, digits and _");
}

TEST(Registry, RefusesFieldsThatCannotBe) {
    const auto line = [](auto... fields) {
        return line_of([&] { Registry().component<Pair>("pair", "", std::move(fields)...); });
    };
    EXPECT_EQ(line(field("first", &Pair::first), field("second", &Pair::first)),
              "'pair.second' and 'pair.first' are the same member");
    EXPECT_EQ(line(field("first", &Pair::first), field("first", &Pair::second)),
              "'pair.first' is declared twice");
    EXPECT_EQ(line(field("first", &Pair::first).range(1, 5), field("second", &Pair::second)),
              "'pair.first': its default is 0, expected an integer from 1 to 5");
    EXPECT_EQ(line(field("first", &Pair::first), field("second", &Pair::second).flat()),
              "'pair.second': only a structure can be flat");

    struct Lamp {
        enum class Kind { warm, cold } kind = Kind::warm;
    };
    EXPECT_EQ(line_of([] { Registry().component<Lamp>("lamp", "", field("kind", &Lamp::kind)); }),
              "'lamp.kind': an enumeration needs the names of its choices");
    struct Outer {
        Pair pair;
    };
    EXPECT_NE(line_of([] {
                  Registry().component<Outer>("outer", "", field("pair", &Outer::pair));
              }).find("declare it with Registry::structure"),
              std::string::npos);
}

TEST(Registry, ValuesAreComparedBitForBitWithoutPadding) {
    Registry registry;
    test::declare(registry);
    const ValueType& type = *registry.find<Door>()->value;
    alignas(Door) std::array<unsigned char, sizeof(Door)> dirty{};
    dirty.fill(0xaa);
    Door* one = new (dirty.data()) Door;
    Door other;
    EXPECT_TRUE(equal(type, one, &other));
    other.angle = -0.0f;
    EXPECT_FALSE(equal(type, one, &other));
    other = Door{};
    other.tags.emplace_back("old");
    EXPECT_FALSE(equal(type, one, &other));
    other = Door{};
    other.drawn = 7;  // transient
    EXPECT_FALSE(equal(type, one, &other));
    EXPECT_TRUE(equal(type, one, &other, Fields::state));
    one->~Door();
}

TEST(Registry, BytesAreReadBack) {
    Registry registry;
    test::declare(registry);
    const ValueType& type = *registry.find<Door>()->value;
    Door door;
    door.open_angle = 0.5f;
    door.keeper = {12, 3};
    door.tags = {"a", "", "long enough to be on the heap, surely"};
    door.size = dvec3(1, 2, 3);
    door.hinge.axis = vec3(0, 0, 1);
    std::string bytes;
    append_bytes(type, &door, Fields::all, bytes);
    Door read;
    std::span<const std::byte> rest = std::as_bytes(std::span(bytes));
    ASSERT_TRUE(read_bytes(type, &read, rest));
    EXPECT_TRUE(rest.empty());
    EXPECT_TRUE(equal(type, &door, &read));
    for (std::size_t n = 0; n < bytes.size(); ++n) {
        Door half;
        rest = std::as_bytes(std::span(bytes)).first(n);
        EXPECT_FALSE(read_bytes(type, &half, rest)) << n;
    }
}

TEST(Registry, SchemasDifferByNamesAndTypes) {
    Registry one, same, other;
    one.component<Pair>("pair", "", field("first", &Pair::first), field("second", &Pair::second));
    same.component<Pair>("pair", "words", field("first", &Pair::first), field("second", &Pair::second));
    other.component<Pair>("pair", "", field("first", &Pair::first), field("third", &Pair::second));
    EXPECT_EQ(one.schema_hash(), same.schema_hash());
    EXPECT_NE(one.schema_hash(), other.schema_hash());
}

}  // namespace
}  // namespace lanthorn::ecs
