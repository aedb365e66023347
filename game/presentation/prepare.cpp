#include "game/presentation/prepare.h"

#include <cstdio>
#include <memory>
#include <string>

#include "game/level/level_files.h"
#include "game/level/title_camera.h"
#include "game/presentation/playthrough.h"
#include "game/presentation/prepared_programs.h"
#include "game/presentation/quality.h"
#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn::game {

namespace {

constexpr ivec2 kSize(160, 90);  // of pictures that nobody sees
constexpr double kFrame = 1.0 / 15;

// Mesa compiles a program that it has read from its cache into other machine code, by the cache's key, than
// one that it has just read from source. So what the second round needs is what every start after it needs.
constexpr int kRounds = 2;

// As on the title, then as in play, where frames take too long for all pixels. All passes have run in the
// third frame, those of the smaller picture in its second.
void draw(Playthrough& level, const StopSignal& stop) {
    constexpr int kTitle = 3, kPlay = 2;
    App& app = level.app();
    app.view().size = app.view().whole = kSize;
    for (int i = 0; i < kTitle + kPlay && !stop.asked(); ++i) {
        if (i < kTitle) {
            look_from_title(level.shown(), i * kFrame);
        } else {
            look_with_eyes(level.shown());
            app.view().whole = 2 * kSize;
        }
        app.frame(kFrame);
    }
}

void prepare(const Options& options, const std::string& preset, const StopSignal& stop) {
    for (int round = 0; round < kRounds && !stop.asked(); ++round) {
        const std::unique_ptr<gpu::Context> context = gpu::create_headless_context();
        Playthrough level(options, import_gltf(options.level));
        Quality(options, level.session().seed()).draw(level.app(), {preset});
        draw(level, stop);
    }
}

}  // namespace

ExitCode run_prepare(const Options& options, const StopSignal& stop) {
    const gpu::GlInfo gl = gpu::create_headless_context()->info();
    const std::string preset = options.preset.empty() ? shell::usual_preset(gl.software) : options.preset;
    PreparedPrograms prepared(gl, PreparedPrograms::usual_path());
    for (const LevelFile& file : level_files(options)) {
        Options of_level = options;
        of_level.level = file.path.string();
        prepare(of_level, preset, stop);
        if (stop.asked()) {
            break;
        }
        prepared.add(file.name(), preset, options);
        std::printf("%s, %s: prepared\n", file.title.c_str(), preset.c_str());
        std::fflush(stdout);
    }
    return ExitCode::ok;
}

}  // namespace lanthorn::game
