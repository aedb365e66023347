#include "gi_module/techniques/emc/gather/remembered_trace.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/pass_end.h"
#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn::gi {

namespace {

// March steps of a ray, of those of a photon (gi.emc.steps). A photon that misses a chair's leg is one of
// many; a remembered ray that does is seen for 16 frames.
constexpr int kStepsOfRays = 3;

// Exact rays that are traced before a window may answer: some 10 ms of two cores in a large scene.
constexpr std::size_t kAtOnce = 1u << 14;

// One invocation for each of them, of the program in use.
void dispatch_listed(const EntryList& list) {
    list.bind_storage(6);
    list.dispatch();
    wait_for_shaders();
}

gpu::Program trace_program(const std::vector<std::string>& defines) {
    return gpu::Program({"gi_module/techniques/emc/gather/remembered_trace.comp"}, defines);
}

}  // namespace

void RememberedTrace::build_programs(Search search) {
    if (!requests_) {
        requests_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_requests.comp"});
        for (const int close : {0, 1}) {
            const std::string define = "CLOSE " + std::to_string(close);
            arrivals_[close] = gpu::Program({"gi_module/techniques/emc/gather/remembered_arrivals.comp"},
                                            {"FIRST 1", define});
            left_arrivals_[close] = gpu::Program({"gi_module/techniques/emc/gather/remembered_arrivals.comp"},
                                                 {"FIRST 0", define});
        }
    }
    if (!one_map_ || search != search_) {
        search_ = search;
        const char* secant = search == Search::secant ? "SEARCH_SECANT 1" : "SEARCH_SECANT 0";
        one_map_ = trace_program({"MAPS ONE"});
        every_map_ = trace_program({"MAPS ALL", secant});
    }
}

void RememberedTrace::trace(const RayScene& rays, const Listed& listed) {
    if (rays.exact != nullptr) {
        trace_exactly(rays, listed);
    } else {
        march(rays, listed);
    }
}

void RememberedTrace::march(const RayScene& rays, const Listed& listed) {
    listed.texels.bind_storage(4);
    listed.flights.bind_storage(5);
    GiSettings settings = rays.settings;
    settings.edit<EmcSettings>().steps *= kStepsOfRays;
    const auto prepare = [&](const gpu::Program& program) {
        listed.use(program);
        rays.maps.bind(program, 0, 1, settings, rays.scene);
        rays.texels.bind(program, lit_points_view_, 2);
    };
    const LastRound last = settings.of<EmcSettings>().last_round;
    const bool at_once = last == LastRound::device ? !gpu::draws_in_software() : last == LastRound::at_once;
    if (at_once && !nobody_) {
        nobody_ = trace_program({"MAPS NOBODY"});
        each_map_ = trace_program({"MAPS EACH"});
        nearest_ = trace_program({"MAPS NEAREST"});
    }
    const MapRounds::EachMap apart{nobody_, each_map_, nearest_, rays.maps.slots()};
    rounds_.run(
        one_map_, every_map_, settings, prepare,
        [&](const gpu::Program&) { dispatch_listed(listed.entries); }, at_once ? &apart : nullptr);
}

void RememberedTrace::trace_exactly(const RayScene& rays, const Listed& listed) {
    const auto count = static_cast<std::size_t>(listed.entries.count());
    if (count == 0) {
        return;
    }
    if (request_list_.bytes() < count * sizeof(ExactRay)) {
        request_list_ = gpu::Buffer((count + count / 4) * sizeof(ExactRay));
        arrival_list_ = gpu::Buffer((count + count / 4) * sizeof(Arrival));
    }
    listed.use(requests_);
    requests_.set("origin_offset", kRayOriginOffset * rays.maps.extent(rays.scene));
    request_list_.bind_storage(4);
    dispatch_listed(listed.entries);
    const std::vector<ExactRay> requests = request_list_.read<ExactRay>(count);
    std::vector<Arrival> arrivals(count);
    const bool albedo = rays.close != nullptr && rays.close->of() == CloseHits::Of::every_hit;
    for (std::size_t at = 0; at < count; at += kAtOnce) {
        const std::size_t some = std::min(kAtOnce, count - at);
        rays.exact->trace(std::span(requests).subspan(at, some), std::span(arrivals).subspan(at, some),
                          albedo);
        gpu::PassEnd::tell();
    }
    arrival_list_.write(0, std::span<const Arrival>(arrivals));
    listed.left.clear();
    const auto look_up = [&](const gpu::Program& program, const std::function<void()>& dispatch) {
        listed.use(program);
        rays.maps.bind(program, 0, 1, rays.settings, rays.scene);
        rays.texels.bind(program, lit_points_view_, 2);
        arrivals_view_.bind(4, arrival_list_, GL_RGBA32UI);
        program.set("arrivals", 4);
        listed.texels.bind_storage(4);
        listed.flights.bind_storage(5);
        listed.entries.bind_storage(6);
        listed.left.bind_storage(7);
        if (rays.close != nullptr) {
            rays.close->bind(program, *rays.nearness, 5);
        }
        dispatch();
        wait_for_shaders();
    };
    const int close = rays.close != nullptr ? 1 : 0;
    const auto look_up_all = [&](const std::function<void()>& first) {
        look_up(arrivals_[close], first);
        look_up(left_arrivals_[close], [&] { listed.left.dispatch(); });
    };
    if (rays.close == nullptr) {
        look_up_all([&] { listed.entries.dispatch(); });
        return;
    }
    rays.close->open();
    look_up_all([&] { listed.entries.dispatch(); });
    rays.close->settle(listed.entries, listed.left);
    look_up_all([&] { rays.close->dispatch_again(); });
}

}  // namespace lanthorn::gi
