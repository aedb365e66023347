// What an EditSession holds, and what its parts share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/edit_world.h"
#include "tools/editor/core/recovery_log.h"

namespace lanthorn::editor {

struct EditSession::State {
    explicit State(SessionOptions given);

    // A file as it was read, and not yet shown.
    struct Loaded {
        SceneData scene;
        std::size_t own = 0;  // nodes of the file; those behind are lent
        EditHistory history;
        std::string text;  // the document's JSON
        std::uint64_t hash = 0;
        std::size_t bytes = 0;
        std::vector<std::string> notes;
    };
    // Throws InputError.
    Loaded load(const std::filesystem::path& file) const;
    // Shows it. Nothing of what was open is left but the App and what is in `left`.
    void take(Loaded loaded, const std::filesystem::path& as);
    // The steps on the file that was taken last, by rebase(); they are logged.
    Rebased redo_all(const std::vector<EditStep>& steps);

    CommandContext context() const;  // valid while this is
    void show(const EditModel& now);
    void shown_again() { ++version; }
    // Does a step that is not in a gesture, and logs it.
    void add_step(std::string text, std::vector<Command> commands);
    void go_to(std::size_t position);
    void log_step(const EditStep& step);
    void log_move(std::size_t from);  // undo or redo, from that position
    void log_from_start();
    void check_no_gesture(std::string_view what) const;
    // Whether a light is lent follows the document, as it would in a program that opens it.
    void lend_if_dark();
    bool is_lit() const;
    // A light of the file that is shown; of a file that is not lit they are directional.
    struct Sun {
        std::uint32_t node = 0;
        Light light;
        glm::dmat3 axes{1};  // of its node, to the world
        bool operator==(const Sun&) const = default;
    };
    std::vector<Sun> suns() const;

    SessionOptions options;
    App app;
    EditWorld world;
    ecs::Entity eye;
    workbench::CameraPose pose, file_pose;

    std::filesystem::path path;
    bool open = false;
    EditHistory history;
    std::string saved_text;                         // the JSON that is on disk
    std::optional<std::size_t> saved_position = 0;  // nothing: no step is what is on disk
    std::uint64_t saved_hash = 0;
    std::size_t bytes = 0;
    std::vector<std::string> notes;
    RecoveryLog log;
    std::vector<LeftCommand> left;
    std::size_t log_base = 0;   // the position that the log begins with
    bool lent = false;          // a light
    bool decided_dark = false;  // what is lent to this dark scene has been found out, while it had these suns
    std::vector<Sun> lent_to;

    std::vector<std::uint32_t> selection;
    std::uint64_t version = 1;

    struct Gesture {
        std::string text;
        std::vector<Command> commands;  // of the last preview
        std::vector<std::uint32_t> selection;
    };
    std::optional<Gesture> gesture;
    std::optional<EditModel> previewed;  // null: nothing but history.model() is shown
};

// Seconds since the epoch, now.
double now_seconds();

// A closed room with a lamp, as a document.
GltfDocument room_document();

}  // namespace lanthorn::editor
