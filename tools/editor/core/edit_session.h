// A scene that is edited: a file, the commands that were given, and the world that shows it.
//
//   EditSession session({.view = {.declare = game::declare_components}});
//   session.open("crypt.glb");
//   session.run("move /crypt/lamp_2 1.2 2 0.5");
//   session.undo();
//   session.save("crypt.glb");
//
// No OpenGL: who shows it adds gi::add_picture_plugins() to app(). One thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/runtime/app.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/editor/core/edit_history.h"
#include "tools/editor/core/edit_model.h"
#include "tools/editor/core/rebase.h"
#include "tools/editor/core/text_changes.h"

namespace lanthorn::editor {

struct SessionOptions {
    // What is shown of files: camera, clip, environment, whether a light is lent, and the components that the
    // program declares.
    workbench::SceneView view = {};
    std::filesystem::path recovery = {};  // folder of logs; empty: none is kept
};

// A row of the list of steps; row 0 is the file as it was opened.
struct HistoryRow {
    std::string text;
    double seconds = 0;    // since the epoch
    bool saved = false;    // the file on disk is as after this row
    bool current = false;  // what is shown
};

class EditSession {
  public:
    explicit EditSession(SessionOptions options = {});
    ~EditSession();
    EditSession(const EditSession&) = delete;
    EditSession& operator=(const EditSession&) = delete;

    // --- files ---

    // Throws InputError as import_gltf() does; what was open stays then. Unsaved edits of what was open are
    // lost to the session, not to its recovery log.
    void open(const std::filesystem::path& path);
    // A room of 6 x 3 x 4 m with a lamp, in no file yet.
    void new_room();
    // Writes whole or not at all. Empty: the file that is open. The log is discarded then. Throws InputError.
    void save(const std::filesystem::path& path = {});
    // What saving would change.
    TextChanges changes() const;
    std::size_t file_bytes() const;             // of the file as it was opened or saved last
    const std::filesystem::path& path() const;  // empty: none yet
    bool is_open() const;
    bool is_dirty() const;  // other than on disk
    // The file is not what was opened or saved last. Reads it: O(bytes).
    bool changed_outside() const;
    // Reads the file again and does the unsaved steps on it. What no longer fits is in left(). Throws
    // InputError for a file that cannot be read: everything stays as it was.
    Rebased reload();
    const std::vector<LeftCommand>& left() const;  // of all reloads and recoveries
    void drop_left();
    // Opens the file of a log that was left behind and does its steps.
    Rebased recover(const std::filesystem::path& log);
    // Why edits are not kept for a crash, one line; empty: they are, or nobody asked for it.
    const std::string& recovery_problem() const;
    // What was mended or left out when the file was read, a line each.
    const std::vector<std::string>& notes() const;

    // --- the scene ---

    App& app();  // the same for the session's life
    ecs::World& world() { return app().world(); }
    const ecs::Registry& registry() const;
    const EditModel& model() const;  // as previewed
    const GltfDocument& document() const;
    // Of a node, and back; null and kNone for what is not there. O(entities): look it up, do not keep it.
    ecs::Entity entity_of(std::uint32_t node) const;
    std::uint32_t node_of(ecs::Entity e) const;
    // All at once: by node, null where there is none. O(entities).
    std::vector<ecs::Entity> entities() const;
    // The light that is lent to a file without any: shown, never saved. Empty: none.
    std::vector<ecs::Entity> guests() const;
    // Finds the lent light again, as a program that opens the file as it is now would: edits of a scene
    // without a light of its own may have given it another place. Costs an import; nothing where none is
    // lent.
    void refresh_guests();
    MaterialHandle material_handle(std::uint32_t material) const;
    std::string path_of(std::uint32_t node) const;
    std::uint32_t node_at(std::string_view path) const;  // throws InputError
    // As CommandContext::mesh_hash.
    std::uint64_t mesh_hash(std::uint32_t mesh) const;
    // Increases whenever model() is another one.
    std::uint64_t version() const;

    // --- the camera of the editor, which is in no file ---

    const workbench::CameraPose& pose() const;
    void set_pose(const workbench::CameraPose& pose);
    // That of a camera of the file, or one that sees everything.
    workbench::CameraPose file_pose() const;
    ecs::Entity eye() const;  // the entity that is View::camera

    // --- the moment that is shown, which is in no file either ---

    // That second of a clip, by its name or number; "none": of none; null: of the one that the file begins
    // with. Another file is shown at its beginning. Throws InputError for a clip that is none.
    void show_moment(const std::optional<std::string>& clip, double seconds);
    double moment() const;
    const std::optional<std::string>& shown_clip() const;

    // --- commands ---

    // A line: a command (command.h), or undo [N], redo [N], go-to ROW, select PATH..., adopt. Throws
    // InputError with what was found and what was expected; nothing has changed then.
    void run(std::string_view line);
    // The lines as one step.
    void run(std::string_view text, std::span<const std::string> lines);

    // The lent light becomes the file's own, as one step: a sky as the clear_sky of its sun. Throws
    // InputError where nothing is lent. run("adopt") is the same.
    void adopt();

    // A gesture: one step, however many previews. `text` is for the list of steps.
    void begin(std::string_view text);
    // Shows the lines on top of what there was at begin(), instead of the preview before. Throws as run().
    void preview(std::span<const std::string> lines);
    void commit();  // nothing if nothing was previewed
    void cancel();  // as it was at begin()
    bool in_gesture() const;

    bool can_undo() const;
    bool can_redo() const;
    // What was undone or redone, for a line to the user; null: there was nothing.
    const EditStep* undo();
    const EditStep* redo();
    void go_to(std::size_t row);
    std::vector<HistoryRow> history() const;
    const EditHistory& steps() const;

    // Nodes; a selection is no step, but undo brings that of the step back.
    const std::vector<std::uint32_t>& selection() const;
    void select(std::vector<std::uint32_t> nodes);

    // The document of now in a file of its own, beside nothing else of the user's: what the game would read.
    // Removed with the object.
    class Copy {
      public:
        explicit Copy(const GltfDocument& document);
        ~Copy();
        Copy(const Copy&) = delete;
        const std::filesystem::path& file() const { return file_; }

      private:
        std::filesystem::path folder_, file_;
    };
    // What is shown of it: for load_scene() of the copy.
    const workbench::SceneView& view() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lanthorn::editor
