// Where the milliseconds of one step of a drag go, as the editor draws it: a level's first lamp moves by 2 cm
// a picture, and the picture is as large as the editor's smallest (a quarter of 700 x 468 each way). From the
// command to the texture that the panels show; processor time of all threads, medians by pass.
//   bench_drag [LEVEL [STEPS [WIDTHxHEIGHT [KEY=VALUE...]]]]    settings beside those of a drag
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/core/error.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/present_plugin.h"
#include "lanthorn/runtime/render_plugin.h"
#include "tests/support/clocks.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"
#include "tools/editor/core/edit_session.h"
#include "tools/editor/window/drag_quality.h"
#include "tools/editor/window/lines.h"
#include "tools/editor/window/picture.h"

using namespace lanthorn;

namespace {

constexpr ivec2 kWhole(700, 468);

// The first node that has a lamp which stands somewhere.
std::uint32_t first_lamp(const editor::EditModel& model) {
    for (std::uint32_t i = 0; i < model.nodes.size(); ++i) {
        const Light* light = model.find(i) != nullptr ? editor::light_of(model, i) : nullptr;
        if (light != nullptr && light->type == LightType::point) {
            return i;
        }
    }
    throw InputError("the level", "", "found no light, expected one");
}

int run(const std::string& level, int steps, ivec2 small, std::span<char*> more) {
    const auto context = gpu::create_headless_context();
    SettingsSchema schema;
    gi::declare_settings(schema);
    Settings settings(schema);
    settings.apply_preset("low");
    settings.set_from_text("render.upscale", "temporal");
    editor::EditSession session;
    gi::add_picture_plugins(session.app(), settings, true);
    session.app().add<PresentPlugin>();
    session.open(support::repository_file(level));
    const std::uint32_t lamp = first_lamp(session.model());
    const Transform stood = session.model().node(lamp).local;
    edit_window::Picture picture;
    const auto draw = [&](ivec2 size) {
        picture.draw(session.app(), size, edit_window::drag_whole(size, kWhole), std::nullopt, [] {});
    };
    for (int i = 0; i < 8; ++i) {
        draw(kWhole);
    }
    gpu::PassTimer& timer = *session.world().resource<Renderer>().timer;
    Settings dragged = edit_window::drag_settings(settings);
    for (const std::string_view each : more) {
        dragged.set_from_text(each);
    }
    gi::apply_settings(session.app(), dragged);
    std::map<std::string, std::vector<double>> passes;
    session.begin("drag");
    constexpr int kWarm = 4;
    for (int step = 0; step < kWarm + steps; ++step) {
        const double begun = support::processor_ms();
        Transform to = stood;
        to.translation.y += 0.02 * (1 + step % 16);
        to.translation.x += 0.02 * (step / 16 + step % 2);
        session.preview(edit_window::transform_lines(session.path_of(lamp), stood, to));
        const double edited = support::processor_ms();
        draw(small);
        const double end = support::processor_ms();
        std::map<std::string, double> sums;
        for (const auto& span : timer.end_frame()) {
            sums[span.name] += span.cpu_ms;
        }
        if (step < kWarm) {
            continue;
        }
        sums["(command)"] = edited - begun;
        sums["(picture)"] = end - edited;
        for (const auto& [name, ms] : sums) {
            passes[name].push_back(ms);
        }
    }
    session.cancel();
    fmt::print("{}, {}x{}, lamp '{}'; medians of {} steps, ms of processor time\n", level, small.x, small.y,
               session.path_of(lamp), steps);
    for (const auto& [name, values] : passes) {
        fmt::print("  {:<22}{:10.2f}  in {} steps\n", name, support::median(values), values.size());
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        ivec2 small = kWhole / 4;
        if (argc > 3 && std::sscanf(argv[3], "%dx%d", &small.x, &small.y) != 2) {
            throw InputError(argv[3], "", "found no size, expected WIDTHxHEIGHT");
        }
        return run(argc > 1 ? argv[1] : "assets/levels/red-wall.glb",
                   argc > 2 ? std::max(1, std::atoi(argv[2])) : 24, small,
                   std::span(argv, static_cast<std::size_t>(argc))
                       .subspan(static_cast<std::size_t>(std::min(argc, 4))));
    } catch (const Error& error) {
        fmt::print(stderr, "bench_drag: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
