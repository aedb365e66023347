// The one door to indirect light: a technique takes a frame's scene and G-buffer and yields indirect
// irradiance, in three steps that are systems of the frame (gi_plugin.h).
#pragma once

#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/deformation/detail.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/statistics.h"
#include "lanthorn/render/frame.h"

namespace lanthorn {
struct BudgetLadder;
}  // namespace lanthorn

namespace lanthorn::render {
struct SensorTargets;
}  // namespace lanthorn::render

namespace lanthorn::gi {

class Technique {
  public:
    virtual ~Technique() = default;

    // A frame is these three, in this order, once each: what changed is relative to the frame before
    // (FrameScene::changes).
    //
    // Decides what the frame does and why; statistics() has it. Draws nothing, O(instances + lights). `size`:
    // of the picture, pixels. What light maps decide, too, may be left to the beginning of update().
    virtual void plan(const FrameScene& scene, ivec2 size, const GiSettings& settings) = 0;
    // Which specular lobes indirect() will have in this frame. After plan().
    virtual render::TracedLobes traced_lobes() const { return {}; }
    // What does not depend on the camera: maps, photons. After the light maps are drawn.
    virtual void update(const render::LightInputs& inputs) = 0;
    // Irradiance in lux at the first visible surface (RGBA32F, full size; null: none) and specular radiance
    // where the technique has any. The textures belong to the technique and hold until the next frame. After
    // the G-buffer is drawn.
    virtual render::IndirectLight indirect(const render::FrameInputs& inputs) = 0;

    // Adds the centres of maps that the technique sees the scene from. `origin`: world position of the last
    // frame's render space.
    virtual void add_eyes(DetailHints&, const dvec3& /*origin*/) const {}

    // Adds the indirect light on light sensors to their irradiances, after update() and with its inputs; what
    // sensors alone need is done here. By default there is none.
    virtual void add_irradiance(const render::LightInputs& /*inputs*/,
                                const render::SensorTargets& /*targets*/) {}
    // Grows whenever what add_irradiance() adds may differ.
    virtual std::uint64_t light_version() const { return 0; }

    // Draws one of the technique's debug views of the last frame, after indirect() and with its inputs:
    // RGBA32F, of the picture's size or an atlas of its own; none where the frame has nothing of the kind.
    // For inspection: may wait for the GPU, and alters nothing that frames are made from.
    virtual gpu::Texture debug_view(std::string_view /*name*/, const render::FrameInputs& /*inputs*/) {
        return {};
    }

    // How far the last frame's picture is likely to be off, after indirect(). Waits for the GPU; costs about
    // what shading and filtering the picture once more do. Alters nothing that frames are made from.
    virtual ErrorEstimate estimate_error() { return {}; }

    // Of the last frame's picture. Reads what is known: no cost.
    virtual SampleProgress progress() const { return {}; }

    // Of the last frame. `count_photons` reads photons back from the GPU: slow, for reports.
    virtual GiStatistics statistics(bool count_photons) = 0;
};

class SettingList;

// A setting and values of it.
struct TurnedSetting {
    std::string name;
    std::vector<std::string> values;
};

// A picture of what a technique makes its light from (Technique::debug_view()).
struct DebugView {
    // How its values are to be shown.
    enum class Shown {
        colour,  // as they are, linear, 0..1
        light,   // by an exposure that suits their mean
        amount,  // the first channel alone, from 0 up
    };

    std::string name;  // as lanthorn render --aov takes it
    std::string docs;  // ends a sentence that begins with "NAME shows"
    std::string unit;  // of the values; empty: none
    Shown shown = Shown::colour;
};

// All that the rest of a program needs to know of a technique: it is offered, set, planned, made, measured
// and drawn on charts by this.
struct TechniqueEntry {
    std::string name;          // as in gi.technique
    std::string docs;          // ends a sentence that begins with "NAME is"
    bool has_presets = false;  // low, medium, high and ultra differ
    // What the others are held against: commands make its pictures by reference::PathTracer, without frames.
    bool is_reference = false;
    std::vector<std::string>
        reads;  // names, or their beginnings, of settings beside render.* that matter to it
    std::vector<TurnedSetting> turns;  // what a chart of error against time turns, one at a time
    std::vector<DebugView> debug_views;

    void (*declare)(SettingList& list) = nullptr;  // its settings; null: none
    std::unique_ptr<Technique> (*make)() = nullptr;
    GiPlan (*first_plan)(const FrameScene& scene, const GiSettings& settings) = nullptr;
    // What it spares first, from these settings down, where a picture of `size` pixels takes too long, by
    // groups of passes (quality_ladder.h); null: nothing but pixels.
    BudgetLadder (*ladder)(const Settings& settings, ivec2 size) = nullptr;
    // Its own statistics, an object; null: none.
    std::string (*statistics_json)(const GiStatistics& statistics) = nullptr;
};

// Which techniques a program has: calls add_technique() for each, the default first, one at least. Called
// once, by the first use of the list. A program that links this library defines it or links one that does:
// lanthorn::techniques has all, lanthorn::emc-only `emc`.
void register_techniques();

// Makes a technique known, after those of register_techniques(). Before settings are declared and before any
// technique is made; not thread-safe. One of the same name is left as it is. Returns what stands for it.
TechniqueKind add_technique(TechniqueEntry entry);

// All that are known, in the order of their TechniqueKind: the default, none, then the others. The
// first use is not thread-safe (GiPlugin and declare_gi_settings() make it).
const std::deque<TechniqueEntry>& techniques();
// Their names, in the same order: the choices of gi.technique.
std::vector<std::string> technique_names();
// What is known of a technique; valid as long as the program runs. Throws std::out_of_range for a kind that
// this program does not have.
const TechniqueEntry& technique_entry(TechniqueKind kind);
// Null where this program has none of that name.
const TechniqueEntry* find_technique(std::string_view name);

// A technique that has rendered nothing yet, to be used with the OpenGL context that is current. Throws
// std::out_of_range for a kind that this program does not have, and what the technique's constructor throws.
std::unique_ptr<Technique> make_technique(TechniqueKind kind);

// What the scene's first frame requires by the technique that the settings name. No GL.
GiPlan first_plan(const FrameScene& scene, const GiSettings& settings);

}  // namespace lanthorn::gi
