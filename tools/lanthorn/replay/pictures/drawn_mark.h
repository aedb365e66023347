// Pictures of a recording's marks: each drawn from the state alone, by an App that has drawn nothing before,
// so that the same state, settings and machine give the same bits however the session came there.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lanthorn/core/image.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/workbench/image_error.h"
#include "tools/lanthorn/replay/replayed_level.h"

namespace lanthorn::tools {

// How a mark is drawn.
struct MarkView {
    ivec2 size{320, 180};           // pixels
    int frames = 12;                // from cold; the last is the picture
    int seed = 1;                   // gi.seed
    std::string preset = "medium";  // of the picture's settings

    bool operator==(const MarkView&) const = default;
};

struct MarkPicture {
    ImageF shown;        // display-encoded, to 8 bits as a PNG holds them
    ImageF radiance;     // nits
    ImageF depth;        // metres from the camera; 0: background
    float exposure = 0;  // factor from nits to display-linear
    std::uint64_t nan_count = 0;
};

// The state at a mark, before its step, as ecs::Snapshot::to_bytes writes it.
struct MarkedMoment {
    replay::Mark mark;
    std::string state;
};

// Draws marks of a recording. Needs OpenGL (throws Error with ExitCode::no_gl without it); the context is
// current as long as it lives.
class MarkArtist {
  public:
    // `level` and `recording` are kept; `file` is the recording's name in messages; `on_frame` is called
    // after every frame.
    MarkArtist(std::shared_ptr<const LevelFile> level, std::string file,
               std::shared_ptr<const replay::Recording> recording, std::function<void()> on_frame = {});

    // `alter`: called before the first frame, with the App as it is to be drawn: faults of a test. Throws
    // InputError where the mark names a camera that is not there.
    MarkPicture draw(const MarkedMoment& at, const MarkView& view,
                     const std::function<void(App&)>& alter = {}) const;
    // The irradiance of indirect light there, lux, as the technique has it.
    ImageF indirect(const MarkedMoment& at, const MarkView& view,
                    const std::function<void(App&)>& alter = {}) const;
    // Direct light alone, nits. Nothing of it is sampled: it has no noise, whatever the seed.
    ImageF direct(const MarkedMoment& at, const MarkView& view,
                  const std::function<void(App&)>& alter = {}) const;
    // Indirect light by the path tracer, `spp` samples a pixel in two independent halves.
    workbench::ReferencePair truth(const MarkedMoment& at, const MarkView& view, int spp) const;

    // The level's App in that state and with that view's plugins, before its first frame. `moved`: gets what
    // has moved since the session began, of what is drawn: entities whose LocalTransform is another, none
    // below another.
    std::unique_ptr<ReplayedLevel> open(const MarkedMoment& at, const MarkView& view,
                                        std::vector<ecs::Entity>* moved = nullptr) const;

    // Draws frames of an App in the state of a mark.
    void show(App& app, const MarkedMoment& at, int frames) const;

  private:
    std::unique_ptr<ReplayedLevel> at(const MarkedMoment& at, const MarkView& view,
                                      std::vector<ecs::Entity>* moved = nullptr) const;

    std::shared_ptr<const LevelFile> level_;
    std::string file_;
    std::shared_ptr<const replay::Recording> recording_;
    std::function<void()> on_frame_;
    std::unique_ptr<gpu::Context> context_;
};

// The states at marks of a recording, which are sorted by step; plays it once, up to the last of them.
std::vector<MarkedMoment> marked_moments(const LevelFile& level, const std::string& file,
                                         const std::shared_ptr<const replay::Recording>& recording,
                                         const std::vector<replay::Mark>& marks, int threads = 1);

}  // namespace lanthorn::tools
