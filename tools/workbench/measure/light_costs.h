// What each light costs in a frame: all lights, and without each in turn.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gi_module/reference/light_source.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/scene/components.h"

namespace lanthorn::workbench {

// What can be put out by itself: a lamp, all that glows by one material, or the sky.
struct Lamp {
    reference::LightKind kind = reference::LightKind::punctual;
    std::string name;
    std::vector<ecs::Entity> entities;  // of a lamp and a sky one; of a backdrop none
    MaterialHandle material = {};       // of what glows
};
// Those with a LightComponent, in the order of their numbers.
std::vector<Lamp> punctual_lamps(const ecs::World& world);
// With what glows and the sky that shines, behind them.
std::vector<Lamp> all_lamps(ecs::World& world);

// Frames after each change: until light has come to rest, and those that are timed, at least one.
struct LightCostFrames {
    int settling = 6, timed = 5;
};

// Milliseconds that a frame is longer for a lamp's being there, by frames with all lamps, and without each in
// turn. One frame a step, so that whoever asks stays free in between.
class LightCosts {
  public:
    // `show` shows a frame of the world and waits for the GPU. The world must live as long as `show` does.
    LightCosts(ecs::World& world, std::vector<Lamp> lamps, std::function<void()> show,
               LightCostFrames frames = {});

    // Draws the next frame; false: all is measured. The world is then as it was.
    bool step();

    struct Cost {
        Lamp lamp;
        // Medians of frames with all lamps, before and after, less that without it: by the clock, and of
        // processor time.
        double ms = 0, cpu_ms = 0;
        // Standard errors: of the three medians, by their frames' spread, and half of what the frames with
        // all lamps have drifted by.
        double noise = 0, cpu_noise = 0;
    };
    const std::vector<Cost>& costs() const { return costs_; }  // so far
    int frames() const { return frames_; }                     // drawn so far
    // That all steps draw, with so many lamps.
    static int all_frames(std::size_t lamps, LightCostFrames frames) {
        return static_cast<int>(rounds(lamps)) * (frames.settling + frames.timed);
    }

  private:
    // Rounds: all lamps, without the first, all, without the second, ..., all.
    static std::size_t rounds(std::size_t lamps) { return lamps == 0 ? 0 : 2 * lamps + 1; }
    void put_out(const Lamp& lamp);
    void light_again(const Lamp& lamp);

    ecs::World* world_;
    std::vector<Lamp> lamps_;
    std::function<void()> show_;
    LightCostFrames each_;
    std::size_t round_ = 0;
    int in_round_ = 0;
    // Of the lamp that is out.
    std::optional<Light> light_;
    std::optional<Sky> sky_;
    vec3 emissive_{0};
    struct Times {
        std::vector<double> ms, cpu_ms;
    };
    Times timed_, medians_, errors_;  // of this round's frames; by round, with their standard errors
    std::vector<Cost> costs_;
    int frames_ = 0;
};

}  // namespace lanthorn::workbench
