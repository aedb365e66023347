// Scripts: the editor's commands from a file, and what is expected of them.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gpu/context.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/core/light_wishes.h"
#include "tools/editor/core/same_as_game.h"
#include "tools/editor/core/traced_samples.h"
#include "tools/editor/core/why_light.h"

namespace lanthorn::editor {

// Runs lines: the commands of EditSession::run(), and
//
//   open FILE   new-room   save [FILE]   reload   recover LOG
//   begin TEXT   commit   cancel           (the lines between are one step)
//   pose X,Y,Z,YAW,PITCH[,FOV]
//   expect PATH FIELD VALUE   expect material NAME FIELD VALUE   expect gone PATH
//   expect hash HEX   expect changes TEXT   expect dirty   expect clean   expect steps N   expect nodes N
//   expect warning KIND   expect no-warning KIND   expect selection PATH...
//   clip [NAME|none [SECONDS]]   expect clip NAME [SECONDS]   expect starts-with NAME
//   expect solvable [RECORDING]   print solvable [RECORDING]
//   picture FILE [WIDTHxHEIGHT [FRAMES]]   same-as-game [WIDTHxHEIGHT [FRAMES]]
//   compare FILE A B [WIDTHxHEIGHT [FRAMES]]   (A, B: TECHNIQUE, TECHNIQUE/PRESET or /PRESET)
//   wish WHERE LUX [RADIUS]   keep PATH...   solve   forget-wishes   expect wishes met|missed
//   technique TECHNIQUE|TECHNIQUE/PRESET|/PRESET|back   trace [WIDTHxHEIGHT [FRAMES]]
//   expect technique TECHNIQUE   expect progress DONE WANTED   print progress [MS]
//   print changes|clips|hash|history|lights|left|nodes|warnings|wishes   print render-line [WIDTHxHEIGHT
//   [FRAMES]]
//
// Files are found from the working directory. # begins a comment.
class EditScript {
  public:
    // Whether a recorded session still solves the scene, and how, in one line. An empty recording: the one
    // that belongs to it. Throws InputError where there is none, Error(no_gl).
    struct Solved {
        bool solved = false;
        std::string words;
    };
    using Solver = std::function<Solved(const EditSession&, const std::filesystem::path& recording)>;
    // For `expect solvable` and `print solvable`; without one they are refused.
    void set_solver(Solver solver) { solver_ = std::move(solver); }

    // `print` takes lines of output. The settings are the pictures'.
    EditScript(SessionOptions options, const Settings& settings,
               std::function<void(const std::string&)> print);
    ~EditScript();

    // Throws Error "FILE:LINE: ...": bad_input for a line that is none or cannot be done, check_failed for an
    // expectation that is not met; nothing behind it is run. Pictures throw Error(ExitCode::no_gl) where
    // there is no OpenGL.
    void run_file(const std::filesystem::path& file);
    void run_text(const std::string& text, const std::string& name);
    void run_line(const std::string& line);  // throws without a place

    EditSession& session() { return session_; }

  private:
    void need_context();
    void expect(const std::vector<std::string>& words);
    void expect_value(const std::string& what, const std::string& found, const std::string& wanted);
    void picture(const std::vector<std::string>& words);
    void compare_with_game(const std::vector<std::string>& words);
    void print(const std::vector<std::string>& words);
    void print_why(const std::vector<std::string>& words);
    void review(const std::vector<std::string>& words);
    void print_error(const std::vector<std::string>& words);
    // Throws InputError with the usage if a line does not have `low` to `high` words.
    static void expect_words(const std::vector<std::string>& words, std::size_t low, std::size_t high,
                             const char* usage);
    // [WIDTHxHEIGHT [FRAMES]] from word `at` on.
    static CheckedFrames frames_in(const std::vector<std::string>& words, std::size_t at);
    void compare(const std::vector<std::string>& words);  // edit_script_sides.cpp
    // edit_script_tracing.cpp
    void choose_technique(const std::vector<std::string>& words);
    void trace(const std::vector<std::string>& words);
    std::string progress_words() const;
    void print_progress(const std::vector<std::string>& words);
    void expect_progress(const std::vector<std::string>& words);
    // edit_script_clips.cpp
    void show_clip(const std::vector<std::string>& words);
    void expect_clip(const std::vector<std::string>& words);
    void print_clips();
    Solved solve(const std::vector<std::string>& words);  // WHAT solvable [RECORDING]
    // edit_script_wishes.cpp
    bool run_wishes(const std::vector<std::string>& words);  // false: the line is about something else
    WishSolution solution();
    void expect_wishes(const std::string& wanted);

    std::unique_ptr<gpu::Context> context_;  // before what draws in it
    EditSession session_;
    Settings settings_;
    std::optional<Settings> settings_before_;  // of `technique`
    ivec2 traced_size_{0};                     // of the frames that `trace` drew last; 0: others were drawn
    std::uint64_t traced_version_ = 0;         // of the session
    TracedSamples traced_;
    std::function<void(const std::string&)> print_;
    Solver solver_;
    std::vector<std::string> gathered_;  // of begin
    WhyLight why_;
    std::vector<LightWish> wishes_;
    std::vector<std::string> kept_;  // paths of lamps that `solve` leaves alone
};

// XXH3 of the document's JSON, as expect hash takes it.
std::string document_hash(const GltfDocument& document);

}  // namespace lanthorn::editor
