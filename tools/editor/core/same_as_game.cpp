#include "tools/editor/core/same_as_game.h"

#include <fmt/format.h>

#include <initializer_list>
#include <span>
#include <utility>

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/scene/extract.h"

namespace lanthorn::editor {

namespace {

using render::Aov;

std::uint64_t hash_of(const render::FrameRenderer& frame, std::initializer_list<Aov> aovs) {
    std::uint64_t hash = 0;
    for (const Aov aov : aovs) {
        const ImageF image = frame.read(aov);
        hash = 31 * hash + replay::hash_bytes(std::as_bytes(std::span(image.pixels)));
    }
    return hash;
}

std::string in_quotes(const std::string& text) {
    const bool is_plain = !text.empty() && text.find_first_not_of(
                                               "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                               "0123456789_-+./,=:@%") == std::string::npos;
    if (is_plain) {
        return text;
    }
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return quoted + '\'';
}

}  // namespace

FrameHashes frame_hashes(const App& app) {
    const render::FrameRenderer& frame = *app.world().resource<Renderer>().frame;
    return {hash_of(frame, {Aov::albedo, Aov::normal, Aov::depth}), hash_of(frame, {Aov::direct}),
            hash_of(frame, {Aov::indirect}), hash_of(frame, {Aov::final})};
}

void make_cold(App& app) {
    ecs::World& world = app.world();
    Renderer renderer;
    renderer.timed = world.resource<Renderer>().timed;
    world.insert_resource(gi::ActiveTechnique());  // before the renderer that it draws with
    world.insert_resource(gi::ViewTechniques());
    world.insert_resource(std::move(renderer));
    world.insert_resource(render::IndirectLight());
    world.insert_resource(render::TracedLobes());
    world.insert_resource(Extractor());
    world.insert_resource(FrameScene());
}

void begin_cold(EditSession& session, const Settings& settings, ivec2 size) {
    App& app = session.app();
    if (!app.has("render")) {
        gi::add_picture_plugins(app, settings);
    } else {
        gi::apply_settings(app, settings);
    }
    make_cold(app);
    app.view().size = size;
    app.view().whole = ivec2(0);
    app.view().camera = session.eye();
}

FrameHashes editor_frames(EditSession& session, const Settings& settings, const CheckedFrames& what) {
    begin_cold(session, settings, what.size);
    for (int i = 0; i < what.frames; ++i) {
        session.app().show();
    }
    return frame_hashes(session.app());
}

FrameHashes game_frames(const EditSession& session, const Settings& settings, const CheckedFrames& what) {
    const EditSession::Copy copy(session.document());
    workbench::SceneView view = session.view();
    SceneData scene = workbench::load_scene(copy.file().string(), view);
    view.camera = workbench::add_pose_camera(scene, session.pose());
    view.animation = session.shown_clip().value_or(view.animation);
    ShownScene shown(std::move(scene), view);
    gi::add_picture_plugins(shown.app(), settings);
    shown.app().view().size = what.size;
    for (int i = 0; i < what.frames; ++i) {
        shown.show_at(session.moment());
    }
    return frame_hashes(shown.app());
}

SameAsGame same_as_game(EditSession& session, const Settings& settings, const CheckedFrames& what) {
    session.refresh_guests();
    SameAsGame result;
    result.editor = editor_frames(session, settings, what);
    result.game = game_frames(session, settings, what);
    const std::pair<const char*, bool> passes[] = {
        {"gbuffer", result.editor.gbuffer == result.game.gbuffer},
        {"direct", result.editor.direct == result.game.direct},
        {"indirect", result.editor.indirect == result.game.indirect},
        {"final", result.editor.final == result.game.final}};
    for (const auto& [name, is_same] : passes) {
        if (!is_same && result.first_difference.empty()) {
            result.first_difference = name;
        }
    }
    return result;
}

std::string render_line(const EditSession& session, const Settings& settings, const CheckedFrames& what) {
    const workbench::SceneView& view = session.view();
    const std::string path = session.path().empty() ? "room.glb" : session.path().string();
    std::string line = fmt::format(
        "lanthorn render {} --pose={} --size {}x{} --frames 1 --warmup {} --time {}", in_quotes(path),
        workbench::text_of(session.pose()), what.size.x, what.size.y, what.frames - 1, session.moment());
    const std::string animation = session.shown_clip().value_or(view.animation);
    const std::pair<const char*, const std::string*> texts[] = {{"--camera", &view.camera},
                                                                {"--animation", &animation},
                                                                {"--environment", &view.environment},
                                                                {"--variant", &view.variant}};
    for (const auto& [option, text] : texts) {
        if (!text->empty()) {
            line += fmt::format(" {} {}", option, in_quotes(*text));
        }
    }
    if (view.environment_intensity != 1) {
        line += fmt::format(" --environment-intensity {}", view.environment_intensity);
    }
    if (!view.default_light) {
        line += " --no-default-light";
    }
    if (view.allow_outside) {
        line += " --allow-outside";
    }
    for (const SettingInfo& info : settings.schema().all()) {
        if (!settings.is_default(info.name)) {
            line += fmt::format(" --set {}", in_quotes(info.name + '=' + settings.text(info.name)));
        }
    }
    return line + " -o " + in_quotes(std::filesystem::path(path).stem().string() + ".png");
}

}  // namespace lanthorn::editor
