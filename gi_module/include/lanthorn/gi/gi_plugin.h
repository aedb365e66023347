// Indirect light in an App.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/runtime/plugin.h"
#include "lanthorn/runtime/view.h"

namespace lanthorn {
class App;
class Settings;
class SettingsSchema;
}  // namespace lanthorn

namespace lanthorn::gi {

// The technique at work in the first view: a resource. The one that the resource GiSettings names.
struct ActiveTechnique {
    std::unique_ptr<Technique> technique;  // null before the first frame, which makes it
    TechniqueKind kind = TechniqueKind::none;
};

// Indirect light of the views beside the first: a resource. Each has a technique of its own, with its own
// maps and memory.
struct ViewTechniques {
    // Of one view.
    struct Entry {
        std::optional<GiSettings> settings;  // null: the resource GiSettings
        ActiveTechnique active;
    };
    std::map<ViewId, Entry> entries;  // those of views that are gone leave with the next frame
};

// Needs RenderPlugin, whose systems its own stand between.
//
//   frame:  extract -> gi.plan;  light_maps -> gi.update (maps, photons);  gbuffer -> gi.indirect (gather) ->
//   composite
//
// Each runs once a view. A technique that does not exist is an Error that names the view.
//
// After a SensorPlugin, also `sensors` behind gi.update: it measures the light sensors, with the technique of
// the first view that is drawn, and puts what has come back into the SensorInbox.
class GiPlugin final : public Plugin {
  public:
    std::string_view name() const override { return "gi"; }
    void build(App& app) override;
};

// RenderPlugin and GiPlugin with these settings. `timed` as RenderPlugin takes it.
void add_picture_plugins(App& app, const Settings& settings, bool timed = false);
// The same with a preset's: low, medium, high, ultra or paper. Throws InputError for another.
void add_picture_plugins(App& app, std::string_view preset);

// Declares every setting of the picture, for programs that let a user choose: render.* and gi.*.
void declare_settings(SettingsSchema& schema);
// Makes the App's next frame one of these settings: the resources RenderSettings and GiSettings.
void apply_settings(App& app, const Settings& settings);
// The same with a preset's settings; all others are as declared. Throws InputError for a preset that is none.
void apply_preset(App& app, std::string_view preset);

// The same for one view, which then has settings of its own (the first: the resources). Throws Error for a
// view that is not there.
void apply_settings(App& app, const Settings& settings, ViewId view);
// The settings of the indirect light alone, for one view (the first: the resource GiSettings), from the next
// frame on; its RenderSettings stay. Throws Error for a view that is not there.
void set_gi_settings(App& app, const GiSettings& settings, ViewId view);
// The technique at work in a view. Throws Error before the first frame that draws the view.
Technique& technique_of(App& app, ViewId view);

}  // namespace lanthorn::gi
