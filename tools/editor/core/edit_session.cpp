// An editing session: files that come and go.
#include "tools/editor/core/edit_session.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/query.h"
#include "lanthorn/replay/content_hash.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/transforms.h"
#include "tools/editor/core/node_path.h"
#include "tools/editor/core/session_state.h"

namespace lanthorn::editor {

namespace fs = std::filesystem;

double now_seconds() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

namespace {

// An entity with a number behind those of all but the largest scenes: nodes then have the numbers that they
// have in a program that shows the file alone, on which the order of what is drawn and lit depends.
ecs::Entity last_entity(ecs::World& world) {
    constexpr std::size_t kBefore = 65536;
    std::vector<ecs::Entity> before(kBefore);
    for (ecs::Entity& e : before) {
        e = world.create();
    }
    const ecs::Entity last = world.create();
    for (std::size_t i = kBefore; i-- > 0;) {  // what is freed last is given first
        world.destroy(before[i]);
    }
    return last;
}

}  // namespace

EditSession::State::State(SessionOptions given)
    : options(std::move(given)), world((add_scene_plugins(app), app)) {
    if (options.view.declare) {
        options.view.declare(app.registry());
    }
    eye = last_entity(app.world());
    app.world().add(eye, LocalTransform{});
    app.world().add(eye, WorldTransform{});
    app.world().add(eye, CameraComponent{workbench::camera_of(pose)});
    app.view().camera = eye;
}

CommandContext EditSession::State::context() const {
    return {app.registry(), {}, [this](std::uint32_t mesh) { return world.mesh_hash(mesh); }};
}

EditSession::State::Loaded EditSession::State::load(const fs::path& file) const {
    Loaded loaded;
    loaded.hash = fs::is_regular_file(file) ? replay::hash_file(file.string()) : 0;
    loaded.scene = workbench::load_scene(file.string(), options.view);
    GltfDocument document = GltfDocument::open(file, options.view.allow_outside);
    loaded.own = loaded.scene.file.nodes.size();
    loaded.notes = loaded.scene.warnings;
    loaded.text = document.json_text();
    std::error_code ignored;
    loaded.bytes = static_cast<std::size_t>(fs::file_size(file, ignored));
    EditModel model = model_of(loaded.scene, document);
    loaded.history = EditHistory(std::move(model), std::move(document));
    return loaded;
}

void EditSession::State::take(Loaded loaded, const fs::path& as) {
    gesture.reset();
    previewed.reset();
    EditModel model = loaded.history.model();
    lent = loaded.scene.nodes.size() > loaded.own;
    log_base = 0;
    world.load(std::move(loaded.scene), loaded.own, model, options.view);
    history = EditHistory(std::move(model), loaded.history.document());
    path = as;
    open = true;
    saved_text = std::move(loaded.text);
    saved_position = 0;
    saved_hash = loaded.hash;
    bytes = loaded.bytes;
    notes = std::move(loaded.notes);
    selection.clear();
    decided_dark = !is_lit();
    lent_to = suns();
    log = options.recovery.empty() ? RecoveryLog() : RecoveryLog(options.recovery, path, saved_hash);
    shown_again();
}

EditSession::EditSession(SessionOptions options) : state_(std::make_unique<State>(std::move(options))) {}
EditSession::~EditSession() = default;

void EditSession::open(const fs::path& path) {
    const fs::path whole = fs::absolute(path);
    State::Loaded loaded = state_->load(whole);
    state_->take(std::move(loaded), whole);
    state_->left.clear();
    state_->file_pose = file_pose();
    set_pose(state_->file_pose);
}

void EditSession::new_room() {
    const Copy room(room_document());
    State::Loaded loaded = state_->load(room.file());
    loaded.hash = 0;
    loaded.bytes = 0;
    loaded.text.clear();
    state_->take(std::move(loaded), {});
    state_->saved_position.reset();
    state_->left.clear();
    set_pose({{2.4, 1.6, 1.5}, 50, -5, 70});
}

void EditSession::save(const fs::path& path) {
    State& s = *state_;
    s.check_no_gesture("save");
    const fs::path target = path.empty() ? s.path : fs::absolute(path);
    if (target.empty()) {
        throw InputError("save: found no file name, expected one for a room that is in no file yet");
    }
    document().write(target);
    s.path = target;
    s.saved_text = document().json_text();
    s.saved_position = s.history.position();
    s.saved_hash = replay::hash_file(target.string());
    std::error_code ignored;
    s.bytes = static_cast<std::size_t>(fs::file_size(target, ignored));
    s.log.discard();
    s.log_base = s.history.position();
    s.log =
        s.options.recovery.empty() ? RecoveryLog() : RecoveryLog(s.options.recovery, target, s.saved_hash);
}

TextChanges EditSession::changes() const {
    return text_changes(state_->saved_text, document().json_text());
}

std::size_t EditSession::file_bytes() const {
    return state_->bytes;
}

const fs::path& EditSession::path() const {
    return state_->path;
}

bool EditSession::is_open() const {
    return state_->open;
}

bool EditSession::is_dirty() const {
    return state_->open && state_->saved_position != state_->history.position() &&
           state_->saved_text != document().json_text();
}

bool EditSession::changed_outside() const {
    if (state_->path.empty()) {
        return false;
    }
    try {
        return replay::hash_file(state_->path.string()) != state_->saved_hash;
    } catch (const InputError&) {
        return true;  // it is gone
    }
}

const std::vector<LeftCommand>& EditSession::left() const {
    return state_->left;
}

void EditSession::drop_left() {
    state_->left.clear();
}

const std::vector<std::string>& EditSession::notes() const {
    return state_->notes;
}

App& EditSession::app() {
    return state_->app;
}

const ecs::Registry& EditSession::registry() const {
    return std::as_const(state_->app).registry();
}

const EditModel& EditSession::model() const {
    return state_->previewed ? *state_->previewed : state_->history.model();
}

const GltfDocument& EditSession::document() const {
    return state_->history.document();
}

ecs::Entity EditSession::entity_of(std::uint32_t node) const {
    return state_->world.entity_of(node);
}

std::uint32_t EditSession::node_of(ecs::Entity e) const {
    return state_->world.node_of(e);
}

std::vector<ecs::Entity> EditSession::entities() const {
    return state_->world.entities();
}

std::vector<ecs::Entity> EditSession::guests() const {
    return state_->world.guests();
}

MaterialHandle EditSession::material_handle(std::uint32_t material) const {
    return state_->world.material(material);
}

std::string EditSession::path_of(std::uint32_t node) const {
    return editor::path_of(model(), node);
}

std::uint32_t EditSession::node_at(std::string_view path) const {
    return editor::node_at(model(), path);
}

std::uint64_t EditSession::mesh_hash(std::uint32_t mesh) const {
    return state_->world.mesh_hash(mesh);
}

std::uint64_t EditSession::version() const {
    return state_->version;
}

const workbench::SceneView& EditSession::view() const {
    return state_->options.view;
}

const workbench::CameraPose& EditSession::pose() const {
    return state_->pose;
}

void EditSession::set_pose(const workbench::CameraPose& pose) {
    State& s = *state_;
    s.pose = pose;
    s.app.world().insert(s.eye, LocalTransform{workbench::transform_of(pose)});
    s.app.world().insert(s.eye, CameraComponent{workbench::camera_of(pose)});
}

void EditSession::show_moment(const std::optional<std::string>& clip, double seconds) {
    state_->world.show_moment(clip, seconds);
}

double EditSession::moment() const {
    return state_->app.time().moment;
}

const std::optional<std::string>& EditSession::shown_clip() const {
    return state_->world.clip();
}

workbench::CameraPose EditSession::file_pose() const {
    const EditModel& model = state_->history.model();
    const std::string& wanted = state_->options.view.camera;
    for (const std::uint32_t node : model.in_order()) {
        const ModelNode& found = model.node(node);
        const bool is_meant = wanted.empty() || found.name == wanted;
        if (found.camera < model.cameras.size() && model.cameras[found.camera] != nullptr && is_meant) {
            return workbench::pose_of(model.world_matrix(node), *model.cameras[found.camera]);
        }
    }
    const FrameScene frame = still_scene(state_->app.world());
    dmat4 world = glm::inverse(dmat4(frame.camera.view));
    world[3] = dvec4(frame.origin + dvec3(frame.camera.position), 1);
    return workbench::pose_of(world, frame.camera.camera);
}

ecs::Entity EditSession::eye() const {
    return state_->eye;
}

// Beside nothing of the user's: a folder of its own, named by the process.
EditSession::Copy::Copy(const GltfDocument& document) {
    std::string name = (fs::temp_directory_path() / "lanthorn-edit-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        throw InputError(name, "", "cannot be made: a folder for a copy of the scene");
    }
    folder_ = name;
    file_ = folder_ / "scene.glb";
    try {
        document.write(file_);
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
        throw;
    }
}

EditSession::Copy::~Copy() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

}  // namespace lanthorn::editor
