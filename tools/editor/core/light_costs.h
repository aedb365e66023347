// What each light gives to a view and what it costs in a frame of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "gi_module/reference/light_split.h"
#include "lanthorn/core/settings.h"
#include "tools/editor/core/edit_session.h"

namespace lanthorn::editor {

// What a lamp, emissive surfaces and sky included, gives of all light that falls on what the camera sees.
struct LightShare {
    reference::LightSource source;
    std::uint32_t entity = 0;  // the lamp's; of the sky 0
    double lux = 0;            // the mean of all places
    double share = 0;          // 0..1 of all lamps' together
};
inline constexpr double kWorthHaving = 0.005;  // share below which a lamp is hardly seen

// By so many places of the picture, by so many paths from each. Most first.
std::vector<LightShare> light_shares(const reference::LightSplitter& light, const CameraView& camera,
                                     ivec2 size, int places = 256, int paths = 64);

// Milliseconds that a frame is longer for a light's being there: frames of a fresh App of the document's
// bytes with all lights, and without each in turn. One frame a step, so that whoever asks stays free in
// between.
class LightCosts {
  public:
    // A current OpenGL context that outlives this.
    LightCosts(const EditSession& session, const Settings& settings, ivec2 size);
    ~LightCosts();

    // Draws the next frame; false: all is measured.
    bool step();
    struct Cost {
        std::uint32_t entity = 0;  // LightInstance::id, in the session's world as well
        double ms = 0;     // the frames' median with all lights, before and after, less that without it
        double noise = 0;  // by how the frames with all lights differ
    };
    const std::vector<Cost>& costs() const { return costs_; }  // so far
    int frames() const { return frames_; }                     // drawn so far

    static constexpr int kSettling = 6, kTimed = 5;  // frames after each change

  private:
    struct Shown;
    std::unique_ptr<Shown> shown_;
    std::vector<Cost> costs_;
    int frames_ = 0;
};

}  // namespace lanthorn::editor
