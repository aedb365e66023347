#include "gi_module/reference/sparse_paths.h"

#include <algorithm>
#include <array>
#include <optional>

#include "gi_module/reference/camera_rays.h"
#include "gi_module/reference/integrator.h"

namespace lanthorn::reference {

struct SparsePaths::State {
    State(const FrameScene& given, ivec2 picture, int step, const PathSettings& wanted)
        : frame(given),
          size(picture),
          stride(step),
          settings(settled(wanted, false)),
          materials(*frame.assets),
          scene(frame, materials),
          emitters(scene, materials),
          lights(frame),
          sky(frame),
          integrator(scene, materials, emitters, lights, sky, settings),
          cells(picture / step),
          film(cells),
          starts(static_cast<std::size_t>(cells.x) * static_cast<std::size_t>(cells.y)) {
        const CameraRays rays(frame.camera, size);
        for (std::size_t cell = 0; cell < starts.size(); ++cell) {
            const vec2 middle = vec2(pixel(static_cast<int>(cell))) + 0.5f;
            const std::optional<FirstSurface> seen = integrator.first_surface(rays.ray(middle.x, middle.y));
            if (seen && !materials[scene.instances()[seen->hit.instance].material].unlit) {
                starts[cell] = IrradianceStart{
                    seen->hit.position, seen->hit.normal, scene.triangles()[seen->hit.triangle].offset, {}};
            }
        }
    }
    ivec2 pixel(int cell) const { return ivec2(cell % cells.x, cell / cells.x) * stride + stride / 2; }

    FrameScene frame;
    ivec2 size;
    int stride;
    PathSettings settings;
    MaterialTable materials;
    TraceScene scene;
    Emitters emitters;
    PunctualLights lights;
    SkyLight sky;
    Integrator integrator;
    ivec2 cells;
    Film film;
    std::vector<std::optional<IrradianceStart>> starts;  // by cell
    int spp = 0;
};

SparsePaths::SparsePaths(const FrameScene& scene, ivec2 size, int stride, const PathSettings& settings)
    : state_(std::make_unique<State>(scene, size, stride, settings)) {}
SparsePaths::~SparsePaths() = default;

ivec2 SparsePaths::cells() const {
    return state_->cells;
}
ivec2 SparsePaths::pixel(int cell) const {
    return state_->pixel(cell);
}
bool SparsePaths::lit(int cell) const {
    return state_->starts[static_cast<std::size_t>(cell)].has_value();
}
int SparsePaths::spp() const {
    return state_->spp;
}
const Film& SparsePaths::film() const {
    return state_->film;
}

bool SparsePaths::trace(int samples, const std::function<bool()>& go_on) {
    State& s = *state_;
    constexpr int kBetween = 64;  // groups of lanes
    std::array<IrradianceStart, kLanes> starts;
    std::array<vec3, kLanes> lux;
    std::array<std::size_t, kLanes> cells;
    std::size_t count = 0;
    int groups = 0;
    for (int n = 0; n < samples; ++n) {
        const auto number = static_cast<std::uint32_t>(s.spp);
        const auto finish = [&] {
            s.integrator.irradiance(std::span(starts).first(count), lux);
            for (std::size_t i = 0; i < count; ++i) {
                s.film.add(cells[i], number, lux[i]);
            }
            count = 0;
            return ++groups % kBetween != 0 || !go_on || go_on();
        };
        for (std::size_t cell = 0; cell < s.starts.size(); ++cell) {
            if (!s.starts[cell]) {
                continue;
            }
            const ivec2 at = s.pixel(static_cast<int>(cell));
            starts[count] = *s.starts[cell];
            starts[count].random =
                RandomNumbers(s.settings.seed, static_cast<std::uint32_t>(at.y * s.size.x + at.x), number);
            cells[count++] = cell;
            if (count == kLanes && !finish()) {
                return false;
            }
        }
        if (count > 0 && !finish()) {
            return false;
        }
        ++s.spp;
    }
    return true;
}

}  // namespace lanthorn::reference
