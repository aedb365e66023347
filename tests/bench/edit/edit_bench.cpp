// What an edit costs in the nave: a still frame, the frame after another colour of one material, after a lamp
// of another strength, and after a light that moved, which all re-light; by turns, so that what disturbs the
// machine disturbs all alike. Prints medians by pass and their ratios.
//   bench_edit [ROUNDS]
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "lanthorn/assets/gltf_import.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/gpu/context.h"
#include "lanthorn/runtime/render_plugin.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/scene/spawn.h"
#include "tests/support/clocks.h"
#include "tests/support/median.h"
#include "tests/support/repository.h"

using namespace lanthorn;

namespace {

constexpr ivec2 kSize(512, 288);

enum Kind { kStill, kColour, kLight, kKinds };
constexpr std::array kTitles{"still", "colour", "light"};

struct Figures {
    std::map<std::string, std::array<std::vector<double>, kKinds>> passes;

    void add(Kind kind, const std::vector<gpu::PassTimer::Span>& spans) {
        std::map<std::string, double> sums;
        for (const auto& span : spans) {
            sums[span.name] += span.ms;
        }
        for (const auto& [name, ms] : sums) {
            passes[name][kind].push_back(ms);
        }
    }
    double of(const std::string& pass, Kind kind) const {
        const auto found = passes.find(pass);
        return found == passes.end() ? 0 : support::median(found->second[kind]);
    }
};

class Nave {
  public:
    Nave() {
        add_scene_plugins(app_);
        app_.add<RenderPlugin>(true).add<gi::GiPlugin>();
        ecs::World& world = app_.world();
        SceneData data = import_gltf(support::repository_file("assets/nave.glb"));
        // The material that most triangles show: the colour of the walls.
        std::vector<std::size_t> triangles(data.materials.size(), 0);
        for (const Mesh& mesh : data.meshes) {
            triangles[mesh.material] += mesh.indices.size();
        }
        const auto most = std::ranges::max_element(triangles) - triangles.begin();
        const std::vector<ecs::Entity> entities = spawn(world, std::move(data));
        for (const ecs::Entity e : entities) {
            if (world.has<CameraComponent>(e) && !app_.view().camera) {
                app_.view().camera = e;
            }
            if (world.has<LightComponent>(e) && !light_) {
                light_ = e;
            }
        }
        AssetStore& store = asset_store(world);
        const SceneHandle scene = world.get<Source>(entities.at(0)).scene;
        material_ = store.get(scene).materials.at(static_cast<std::size_t>(most));
        app_.view().size = kSize;
    }

    // The whole, edit included, is the span "frame".
    std::vector<gpu::PassTimer::Span> frame_of(Kind kind) {
        const double start = support::wall_ms();
        const float other = ++edits_[kind] % 2 == 0 ? 0.5f : 0.6f;
        if (kind == kColour) {
            asset_store(app_.world()).edit_material(material_, [&](Material& m) { m.base_colour.g = other; });
        }
        if (kind == kLight) {
            Light& light = app_.world().get_mut<LightComponent>(light_).light;
            light.colour.b = other;
        }
        app_.show();
        glFinish();
        const double wall = support::wall_ms() - start;
        auto spans = app_.world().resource<Renderer>().timer->end_frame();
        spans.push_back({"frame", 0, wall});
        return spans;
    }
    bool selected() {
        return app_.world().resource<gi::ActiveTechnique>().technique->statistics(false).plan.on("selection");
    }
    bool lit() const { return static_cast<bool>(light_); }
    const std::string& material() { return asset_store(app_.world()).get(material_).name; }

  private:
    App app_;
    ecs::Entity light_;
    MaterialHandle material_;
    std::array<int, kKinds> edits_{};
};

int run(int rounds) {
    const auto context = gpu::create_headless_context();
    Nave nave;
    if (!nave.lit()) {
        throw InputError("assets/nave.glb", "", "found no light, expected one");
    }
    constexpr int kWarm = 12;  // what stands still is static after a few
    for (int i = 0; i < kWarm; ++i) {
        nave.frame_of(kStill);
    }
    for (const Kind kind : {kColour, kLight, kStill}) {
        nave.frame_of(kind);
    }
    Figures figures;
    int selections = 0;
    for (int i = 0; i < rounds; ++i) {
        for (const Kind kind : {kStill, kColour, kStill, kLight}) {
            figures.add(kind, nave.frame_of(kind));
            selections += kind == kColour && nave.selected() ? 1 : 0;
        }
    }
    fmt::print("{}, OpenGL {}; nave {}x{}, material '{}'; medians of {} rounds, ms\n",
               context->info().renderer, context->info().version, kSize.x, kSize.y, nave.material(), rounds);
    fmt::print("  {:<22}{:>10}{:>10}{:>10}\n", "pass", kTitles[kStill], kTitles[kColour], kTitles[kLight]);
    for (const auto& [name, values] : figures.passes) {
        fmt::print("  {:<22}{:10.3f}{:10.3f}{:10.3f}\n", name, support::median(values[kStill]),
                   support::median(values[kColour]), support::median(values[kLight]));
    }
    const double light = figures.of("frame", kLight);
    fmt::print("still / light {:.3f}, colour / light {:.3f}; frames that chose maps anew: {}\n",
               figures.of("frame", kStill) / light, figures.of("frame", kColour) / light, selections);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 9);
    } catch (const Error& error) {
        fmt::print(stderr, "bench_edit: {}\n", error.what());
        return static_cast<int>(error.code());
    }
}
