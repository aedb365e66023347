// What a program's steps take in, and where it comes from.
#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include "lanthorn/ecs/world.h"
#include "lanthorn/replay/recording.h"

namespace lanthorn::session {

// Makes the input of every step, and hands it to the simulation as the world's resource of type Input.
//
//   struct Keys { std::uint8_t held = 0; };
//   auto keys = InputStream::of<Keys>("walker-1", [&](const ecs::World&, std::uint64_t) { return read_keys();
//   });
class InputStream {
  public:
    // `format`: name and version of Input's layout, which recordings hold; change it with the layout.
    // `source` is asked once a step, before the program's own systems, with the world before it and the
    // step's number; without a source every input is Input(). `length`: steps until the source ends; none: it
    // does not.
    template <replay::StepInput Input>
    static InputStream of(
        std::string format,
        std::type_identity_t<std::function<Input(const ecs::World&, std::uint64_t step)>> source = {},
        std::optional<std::uint64_t> length = {}) {
        static_assert(std::has_unique_object_representations_v<Input>, "equal inputs must be equal bytes");
        InputStream stream;
        stream.format_ = std::move(format);
        stream.size_ = sizeof(Input);
        stream.length_ = length;
        stream.make_ = [source = std::move(source)](const ecs::World* world, std::uint64_t step,
                                                    std::span<std::byte> to) {
            const Input input = world != nullptr && source ? source(*world, step) : Input();
            std::memcpy(to.data(), &input, sizeof input);
        };
        stream.give_ = [](ecs::World& world, std::span<const std::byte> from) {
            Input input;
            std::memcpy(static_cast<void*>(&input), from.data(), sizeof input);
            world.insert_resource(std::move(input));
        };
        return stream;
    }

    const std::string& format() const { return format_; }  // name and version of Input's layout
    std::uint32_t size() const { return size_; }           // bytes a step
    // Steps until the source ends; none: no end is known.
    std::optional<std::uint64_t> length() const { return length_; }

    // The input of a step, from the source; `to` has size() bytes.
    void make(const ecs::World& world, std::uint64_t step, std::span<std::byte> to) const {
        assert(to.size() == size_);
        make_(&world, step, to);
    }
    // The input of a step in which nothing is done.
    void make_none(std::span<std::byte> to) const {
        assert(to.size() == size_);
        make_(nullptr, 0, to);
    }
    // Writes the resource.
    void give(ecs::World& world, std::span<const std::byte> input) const {
        assert(input.size() == size_);
        give_(world, input);
    }

  private:
    InputStream() = default;

    std::string format_;
    std::uint32_t size_ = 0;
    std::optional<std::uint64_t> length_;
    std::function<void(const ecs::World*, std::uint64_t, std::span<std::byte>)> make_;
    std::function<void(ecs::World&, std::span<const std::byte>)> give_;
};

}  // namespace lanthorn::session
