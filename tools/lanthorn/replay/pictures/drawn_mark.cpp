#include "tools/lanthorn/replay/pictures/drawn_mark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

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
#include "lanthorn/scene/hierarchy.h"
#include "lanthorn/workbench/reference_pairs.h"

namespace lanthorn::tools {

namespace {

// As the game's picture has them (game/presentation/quality.h).
Settings settings_of(const SettingsSchema& schema, const MarkView& view) {
    Settings settings(schema);
    settings.set("gi.seed", view.seed);
    settings.set("render.antialias", true);
    settings.set("render.exposure.darkest", 0.1f);  // nits
    settings.set("render.bloom.share", 0.1f);
    settings.set("render.rim", 0.2f);
    settings.set("render.shoulder", 0.5f);
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

using Places = std::map<ecs::Entity, LocalTransform>;

Places places_of(const ecs::World& world) {
    Places places;
    world.query<ecs::Read<LocalTransform>>().each(
        [&](ecs::Entity e, const LocalTransform& place) { places.emplace(e, place); });
    return places;
}

bool is_drawn(const ecs::World& world, ecs::Entity e) {
    const std::vector<ecs::Entity> below = descendants(world, e);
    const auto has_mesh = [&](ecs::Entity one) { return world.try_get<MeshInstances>(one) != nullptr; };
    return has_mesh(e) || std::ranges::any_of(below, has_mesh);
}

// Of what is drawn, what is not where it was; none below another.
std::vector<ecs::Entity> moved_since(const Places& before, const ecs::World& world) {
    std::set<ecs::Entity> moved;
    for (const auto& [e, place] : places_of(world)) {
        const auto was = before.find(e);
        if ((was == before.end() || !(was->second == place)) && is_drawn(world, e)) {
            moved.insert(e);
        }
    }
    std::vector<ecs::Entity> roots;
    for (const ecs::Entity e : moved) {
        ecs::Entity above = parent_of(world, e);
        while (above != ecs::kNullEntity && !moved.contains(above)) {
            above = parent_of(world, above);
        }
        if (above == ecs::kNullEntity) {
            roots.push_back(e);
        }
    }
    return roots;
}

}  // namespace

MarkArtist::MarkArtist(std::shared_ptr<const LevelFile> level, std::string file,
                       std::shared_ptr<const replay::Recording> recording, std::function<void()> on_frame)
    : level_(std::move(level)),
      file_(std::move(file)),
      recording_(std::move(recording)),
      on_frame_(std::move(on_frame)),
      context_(gpu::create_headless_context()) {}

void MarkArtist::show(App& app, const MarkedMoment& at, int frames) const {
    for (int i = 0; i < frames; ++i) {
        app.show_at(static_cast<double>(at.mark.step) / kStepsPerSecond);
        if (on_frame_) {
            on_frame_();
        }
    }
}

std::unique_ptr<ReplayedLevel> MarkArtist::at(const MarkedMoment& at, const MarkView& view,
                                              std::vector<ecs::Entity>* moved) const {
    auto replayed = std::make_unique<ReplayedLevel>(*level_, file_, recording_);
    App& app = replayed->app();
    const Places before = moved != nullptr ? places_of(app.world()) : Places();
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
    if (moved != nullptr) {
        *moved = moved_since(before, app.world());
    }
    return replayed;
}

std::unique_ptr<ReplayedLevel> MarkArtist::open(const MarkedMoment& at, const MarkView& view,
                                                std::vector<ecs::Entity>* moved) const {
    std::unique_ptr<ReplayedLevel> replayed = this->at(at, view, moved);
    SettingsSchema schema;
    gi::declare_settings(schema);
    gi::add_picture_plugins(replayed->app(), settings_of(schema, view));
    return replayed;
}

MarkPicture MarkArtist::draw(const MarkedMoment& at, const MarkView& view,
                             const std::function<void(App&)>& alter) const {
    const std::unique_ptr<ReplayedLevel> replayed = open(at, view);
    App& app = replayed->app();
    if (alter) {
        alter(app);
    }
    show(app, at, view.frames);
    const render::FrameRenderer& frame = *app.world().resource<Renderer>().frame;
    MarkPicture picture{frame.read(render::Aov::final), frame.read(render::Aov::radiance),
                        frame.read(render::Aov::depth), frame.exposure(), 0};
    picture.nan_count = frame.nan_count() +
                        app.world().resource<gi::ActiveTechnique>().technique->statistics(false).nan_count;
    round_to_8_bits(picture.shown);
    return picture;
}

ImageF MarkArtist::indirect(const MarkedMoment& at, const MarkView& view,
                            const std::function<void(App&)>& alter) const {
    const std::unique_ptr<ReplayedLevel> replayed = open(at, view);
    if (alter) {
        alter(replayed->app());
    }
    show(replayed->app(), at, view.frames);
    return replayed->app().world().resource<Renderer>().frame->read(render::Aov::indirect);
}

ImageF MarkArtist::direct(const MarkedMoment& at, const MarkView& view,
                          const std::function<void(App&)>& alter) const {
    const std::unique_ptr<ReplayedLevel> replayed = open(at, view);
    App& app = replayed->app();
    app.world().resource_mut<gi::GiSettings>().technique = gi::TechniqueKind::none;
    if (alter) {
        alter(app);
    }
    show(app, at, 1);
    return app.world().resource<Renderer>().frame->read(render::Aov::radiance);
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
                                         const std::vector<replay::Mark>& marks, int threads) {
    std::vector<MarkedMoment> moments;
    moments.reserve(marks.size());
    for (const replay::Mark& mark : marks) {
        moments.push_back({mark, ""});
    }
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
