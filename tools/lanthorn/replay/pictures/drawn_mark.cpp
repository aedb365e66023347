#include "tools/lanthorn/replay/pictures/drawn_mark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/ecs/snapshot.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gi/gi_settings.h"
#include "lanthorn/gi/technique.h"
#include "lanthorn/reference/path_settings.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/workbench/reference_pairs.h"

namespace lanthorn::tools {

namespace {

// As the game's picture has them (game/presentation/quality.h).
Settings settings_of(const SettingsSchema& schema, const MarkView& view) {
    Settings settings(schema);
    settings.set("gi.seed", view.seed);
    settings.set("render.antialias", true);
    settings.set("render.exposure.darkest", 0.1f);  // nits
    settings.apply_preset(view.preset);
    return settings;
}

ecs::Entity camera_called(const ecs::World& world, const std::string& name) {
    ecs::Entity found = ecs::kNullEntity;
    world.query<ecs::Read<Name>, ecs::Read<CameraComponent>>().each(
        [&](ecs::Entity e, const Name& n, const CameraComponent&) {
            if (found == ecs::kNullEntity && n.value == name) {
                found = e;
            }
        });
    return found;
}

void round_to_8_bits(ImageF& image) {
    for (float& value : image.pixels) {
        value = std::isfinite(value) ? std::round(255 * std::clamp(value, 0.0f, 1.0f)) / 255 : 0.0f;
    }
}

// Draws the frames of a view in an App whose state is there.
void show(App& app, const MarkedMoment& at, const MarkView& view, const std::function<void(App&)>& alter) {
    SettingsSchema schema;
    gi::declare_settings(schema);
    gi::add_picture_plugins(app, settings_of(schema, view));
    if (alter) {
        alter(app);
    }
    for (int i = 0; i < view.frames; ++i) {
        app.show_at(static_cast<double>(at.mark.step) / kStepsPerSecond);
    }
}

}  // namespace

MarkArtist::MarkArtist(std::shared_ptr<const LevelFile> level, std::string file,
                       std::shared_ptr<const replay::Recording> recording)
    : level_(std::move(level)),
      file_(std::move(file)),
      recording_(std::move(recording)),
      context_(gpu::create_headless_context()) {}

std::unique_ptr<ReplayedLevel> MarkArtist::at(const MarkedMoment& at, const MarkView& view) const {
    auto replayed = std::make_unique<ReplayedLevel>(*level_, file_, recording_);
    App& app = replayed->app();
    replayed->session().jump(
        session::Moment(at.mark.step, ecs::Snapshot::from_bytes(at.state, app.registry(), file_)));
    app.view().size = view.size;
    if (!at.mark.camera.empty()) {
        app.view().camera = camera_called(app.world(), at.mark.camera);
        if (app.view().camera == ecs::kNullEntity) {
            throw InputError(file_, fmt::format("mark '{}'", at.mark.name),
                             fmt::format("found no camera called '{}' in {}", at.mark.camera, level_->path));
        }
    }
    return replayed;
}

MarkPicture MarkArtist::draw(const MarkedMoment& at, const MarkView& view,
                             const std::function<void(App&)>& alter) const {
    const std::unique_ptr<ReplayedLevel> replayed = this->at(at, view);
    App& app = replayed->app();
    show(app, at, view, alter);
    const render::FrameRenderer& frame = *app.world().resource<Renderer>().frame;
    MarkPicture picture{frame.read(render::Aov::final), frame.read(render::Aov::radiance), 0};
    picture.nan_count = frame.nan_count() +
                        app.world().resource<gi::ActiveTechnique>().technique->statistics(false).nan_count;
    round_to_8_bits(picture.shown);
    return picture;
}

ImageF MarkArtist::indirect(const MarkedMoment& at, const MarkView& view,
                            const std::function<void(App&)>& alter) const {
    const std::unique_ptr<ReplayedLevel> replayed = this->at(at, view);
    show(replayed->app(), at, view, alter);
    return replayed->app().world().resource<Renderer>().frame->read(render::Aov::indirect);
}

workbench::ReferencePair MarkArtist::truth(const MarkedMoment& at, const MarkView& view, int spp) const {
    const std::unique_ptr<ReplayedLevel> replayed = this->at(at, view);
    SettingsSchema schema;
    gi::declare_settings(schema);
    reference::PathSettings path = reference::path_settings(settings_of(schema, view));
    path.transport = reference::Transport::diffuse;
    path.unlimited = true;
    App& app = replayed->app();
    return workbench::trace_pair(still_scene(app.world(), app.view().camera), view.size, path, spp);
}

std::vector<MarkedMoment> marked_moments(const LevelFile& level, const std::string& file,
                                         const std::shared_ptr<const replay::Recording>& recording,
                                         int threads) {
    std::vector<MarkedMoment> moments;
    for (const replay::Mark& mark : recording->annotations.marks) {
        moments.push_back({mark, ""});
    }
    std::ranges::stable_sort(moments, {}, [](const MarkedMoment& m) { return m.mark.step; });
    ReplayedLevel replayed(level, file, recording, {.threads = threads});
    session::Session& session = replayed.session();
    for (MarkedMoment& m : moments) {
        if (m.mark.step > recording->steps.size()) {
            throw InputError(
                file, fmt::format("mark '{}'", m.mark.name),
                fmt::format("found step {}, expected at most {}", m.mark.step, recording->steps.size()));
        }
        while (session.steps() < m.mark.step) {
            replayed.app().step();
        }
        m.state = ecs::Snapshot::save(replayed.world(), replayed.app().registry()).to_bytes();
    }
    return moments;
}

}  // namespace lanthorn::tools
