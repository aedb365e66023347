#include "gi_module/techniques/emc/gather/remembered_hits.h"

#include <algorithm>
#include <string>
#include <utility>

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr std::uint32_t kNoRay = 0x00fffffcu;  // lit_hits.glsl
constexpr std::uint32_t kUnlit = 0x00fffffdu;  // the same
constexpr int kStaleEnd = 3;                   // frames after motion has ended until none is stale
constexpr std::uint32_t kSlotsAtOnce = 4;      // that a point with less than a quarter of them fills
constexpr int kStaleFrames = 2;                // of rays that are traced again in a frame, at most
// Of a point's slots, that are enough while the view alone changes. All take a quarter more time, for 2 to 5
// % less error.
constexpr std::uint32_t kEnough = 12;

// A view that has turned by more than 45 degrees, or gone a tenth of EnvironmentMaps::extent(), shows other
// places: what guided the rays there tells nothing.
constexpr float kOtherView = 0.7f;  // cosine
constexpr double kOtherPlace = 0.1;

// Where movers make so large a share of all rays stale in a frame, fewer frames are remembered: most of the
// rays would be traced again for others that are traced again before they have told much. Half the frames
// cost a fifth of a walking figure's indirect light, and err 1.2 times as much.
constexpr float kShortLived = 0.03f;
constexpr int kFewFrames = 8;
// A point, through the maps. Of 32 a picture in which a box moves is 1.2 times as wrong.
constexpr int kFewestRays = 64;
constexpr int kLongerLived = 8;  // frames of less, until more are remembered again

constexpr int kRaysAtOnce = 8;  // that an invocation verifies, at most
constexpr int kKeysAtOnce = 8;  // that one looks for starts in

int verified_runs(int rays) {
    return (rays + kRaysAtOnce - 1) / kRaysAtOnce;
}

}  // namespace

void RememberedHits::build_programs(Search search) {
    const std::string in_picture = of_ == Of::picture ? "IN_PICTURE 1" : "IN_PICTURE 0";
    if (!list_) {
        follow_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_follow.comp"});
        carry_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_carry.comp"});
        again_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_again.comp"});
        retrace_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_retrace.comp"});
        const std::string slots_define = "SLOTS " + std::to_string(slots());
        list_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_list.comp"},
                             {in_picture, slots_define});
        guide_.build_programs();
    }
    trace_.build_programs(search);
}

void RememberedHits::forget() {
    frame_ = 0;
    slots_in_use_ = kFrames;
    guide_.forget();
    frames_since_motion_ = kStaleEnd + 1;
    if (texels_) {
        texels_.fill(kNoRay);
    }
    if (counts_) {
        counts_.clear();
        cells_.fill(0xffffffffu);
    }
}

void RememberedHits::allocate(const SurfacePoints& points) {
    if (points.capacity() == capacity_ && points.rays() == rays_) {
        return;
    }
    capacity_ = points.capacity();
    rays_ = points.rays();
    const std::vector<std::string> defines{of_ == Of::picture ? "IN_PICTURE 1" : "IN_PICTURE 0",
                                           "RAYS " + std::to_string(std::min(rays_, kRaysAtOnce)) + "u",
                                           "RUNS " + std::to_string(verified_runs(rays_)) + "u"};
    verify_.emplace(
        std::vector<std::filesystem::path>{"gi_module/techniques/emc/gather/remembered_verify.comp"},
        defines);
    there_program_ = gpu::Program({"gi_module/techniques/emc/gather/remembered_there.comp"},
                                  {defines[2], "KEYS " + std::to_string(kKeysAtOnce) + "u"});
    limbs_.emplace(
        std::vector<std::filesystem::path>{"gi_module/techniques/emc/gather/remembered_limbs.comp"}, defines);
    const auto keys = static_cast<std::size_t>(capacity_);
    starts_ = gpu::Buffer(starts() * sizeof(vec4));
    flights_ = gpu::Buffer(entries() * 2 * sizeof(std::uint32_t));
    texels_ = gpu::Buffer(entries() * sizeof(std::uint32_t));
    if (of_ == Of::picture) {
        cells_ = gpu::Buffer(starts() * 2 * sizeof(std::uint32_t));
        counts_ = gpu::Buffer(keys * sizeof(std::uint32_t));
        counts_before_ = gpu::Buffer(counts_.bytes());
        guide_.resize({points.row(), points.capacity() / points.row()}, starts());
    }
    there_.resize(starts() * static_cast<std::size_t>(verified_runs(rays_)));
    stale_.resize(entries());
    near_.resize(entries());
    listed_.resize(entries());
    shading_.resize(of_ == Of::picture, capacity_, slots(), rays_);
    trace_.resize(entries());
    forget();
}

// Each slot's starts, and each slot's and ray's flights, are a row of all keys.
KeptRays RememberedHits::kept(int first, int keys) const {
    if (!starts_ || first + keys > capacity_) {
        return {};
    }
    KeptRays rays{gpu::Buffer(static_cast<std::size_t>(slots() * keys) * sizeof(vec4)),
                  gpu::Buffer(static_cast<std::size_t>(slots() * rays_ * keys) * sizeof(glm::uvec2))};
    for (int row = 0; row < slots() * rays_; ++row) {
        const auto copy = [&](const gpu::Buffer& from, const gpu::Buffer& to, GLsizeiptr size) {
            glCopyNamedBufferSubData(from.id(), to.id(), (row * capacity_ + first) * size, row * keys * size,
                                     keys * size);
        };
        copy(flights_, rays.flights, sizeof(glm::uvec2));
        if (row < slots()) {
            copy(starts_, rays.starts, sizeof(vec4));
        }
    }
    return rays;
}

void RememberedHits::put_back(int first, int keys, const KeptRays& rays) {
    if (!starts_ || first + keys > capacity_ ||
        rays.flights.bytes() != static_cast<std::size_t>(slots() * rays_ * keys) * sizeof(glm::uvec2)) {
        return;
    }
    for (int row = 0; row < slots() * rays_; ++row) {
        const auto copy = [&](const gpu::Buffer& from, const gpu::Buffer& to, GLsizeiptr size) {
            glCopyNamedBufferSubData(from.id(), to.id(), row * keys * size, (row * capacity_ + first) * size,
                                     keys * size);
        };
        copy(rays.flights, flights_, sizeof(glm::uvec2));
        constexpr GLsizeiptr kWord = sizeof(std::uint32_t);
        glClearNamedBufferSubData(texels_.id(), GL_R32UI, (row * capacity_ + first) * kWord, keys * kWord,
                                  GL_RED_INTEGER, GL_UNSIGNED_INT, &kUnlit);
        if (row < slots()) {
            copy(rays.starts, starts_, sizeof(vec4));
        }
    }
}

void RememberedHits::use(const gpu::Program& program) {
    program.use();
    texels_view_.bind(8, texels_, GL_R32UI);
    starts_view_.bind(9, starts_, GL_RGBA32F);
    flights_view_.bind(10, flights_, GL_RG32UI);
    program.set("remembered", 8);
    program.set("starts", 9);
    program.set("started", 9);
    program.set("flights", 10);
    program.set("directions", 10);
    program.set("rays", rays_);
    program.set("capacity", capacity_);
    program.set("more_first", more_first_);
}

void RememberedHits::bind(const gpu::Program& program) {
    use(program);
    cells_view_.bind(7, cells_, GL_RG32UI);
    program.set("cells", 7);
}

void RememberedHits::forget_other_guides(const FrameScene& scene, float local_length) {
    const mat3 turned = glm::transpose(mat3(scene.camera.view));
    const vec3 ahead = -turned[2];
    const dvec3 place = scene.origin + dvec3(scene.camera.position);
    if (glm::dot(ahead, looked_) < kOtherView || glm::distance(place, stood_) > kOtherPlace * local_length) {
        guide_.forget();
    }
    looked_ = ahead;
    stood_ = place;
}

void RememberedHits::fit_memory(const RayScene& rays) {
    if (frames_since_motion_ != 1) {
        stale_share_.forget();
        return;
    }
    // Exact rays wait for the GPU in any case.
    const std::optional<float> share = rays.exact != nullptr
                                           ? StaleShare::now(there_, stale_, std::min(rays_, kRaysAtOnce))
                                           : stale_share_.late();
    if (!share) {
        return;
    }
    const bool suffice = rays.exact != nullptr || kFewFrames * rays_ >= kFewestRays;
    const int wanted = *share > kShortLived && suffice ? kFewFrames : kFrames;
    long_lived_ = wanted > slots_in_use_ ? long_lived_ + 1 : 0;
    if (wanted < slots_in_use_ || long_lived_ == kLongerLived) {
        use_slots(wanted);
    }
}

void RememberedHits::use_slots(int slots) {
    long_lived_ = 0;
    if (slots < slots_in_use_) {
        const auto clear = [&](const gpu::Buffer& buffer, std::size_t a_slot, std::uint32_t value) {
            const std::size_t first = static_cast<std::size_t>(slots) * a_slot;
            glClearNamedBufferSubData(buffer.id(), GL_R32UI, static_cast<GLintptr>(first),
                                      static_cast<GLsizeiptr>(kFrames * a_slot - first), GL_RED_INTEGER,
                                      GL_UNSIGNED_INT, &value);
        };
        const std::size_t row = static_cast<std::size_t>(capacity_) * sizeof(std::uint32_t);
        clear(texels_, static_cast<std::size_t>(rays_) * row, kNoRay);
        clear(cells_, 2 * row, 0xffffffffu);
        frame_ %= slots;
    }
    slots_in_use_ = slots;
}

void RememberedHits::follow(const SurfacePoints& points, ivec2 grid, int stride, const RayScene& rays,
                            const render::FrameInputs& inputs) {
    build_programs(trace_.search());
    allocate(points);
    followed_ = true;
    fit_memory(rays);
    forget_other_guides(inputs.scene, rays.maps.extent(inputs.scene));
    counts_.clear();
    listed_.clear();
    const auto begin = [&](const gpu::Program& program) {
        use(program);
        inputs.camera.set(program);
        points_view_.bind(0, points.points(), GL_RGBA32F);
        keys_view_.bind(1, points.keys(), GL_R32UI);
        program.set("points", 0);
        program.set("keys", 1);
        program.set("grid", grid);
        program.set("stride", stride);
        program.set("image_size", inputs.gbuffer.size());
        counts_.bind_storage(1);
    };
    const float margin = kRayOriginOffset * rays.maps.extent(inputs.scene);
    Aabb moved;
    for (const Mover& mover : rays.movers.movers()) {
        moved.add(mover.before);
    }
    begin(follow_);
    follow_.set("carried_lower", moved.lower - margin);
    follow_.set("carried_upper", moved.upper + margin);
    cells_.bind_storage(6);
    listed_.bind_storage(7);
    dispatch_rows(capacity_, slots_in_use_);
    wait_for_shaders();
    begin(carry_);
    set_carries(rays.movers, margin);
    starts_.bind_storage(2);
    cells_.bind_storage(3);
    texels_.bind_storage(4);
    flights_.bind_storage(5);
    dispatch_listed(listed_);
}

// The uniforms of remembered_carry.comp.
void RememberedHits::set_carries(const SweptBoxes& movers, float margin) {
    constexpr std::size_t kPartRows = 5;
    std::vector<vec4> lower, upper, parts;
    for (const std::vector<SweptBoxes::Carry>& mover : movers.carries()) {
        Aabb all;
        const std::size_t first = parts.size() / kPartRows;
        for (const SweptBoxes::Carry& part : mover) {
            all.add(part.before);
            const mat4 rows = glm::transpose(part.carry);
            parts.insert(parts.end(),
                         {vec4(part.before.lower - margin, 0),
                          vec4(part.before.upper + margin, part.bends ? 1 : 0), rows[0], rows[1], rows[2]});
        }
        const std::size_t end = parts.size() / kPartRows;
        lower.emplace_back(all.lower - margin, static_cast<float>(first));
        upper.emplace_back(all.upper + margin, static_cast<float>(end));
    }
    carry_.set("margin", margin);
    carry_.set("mover_count", static_cast<int>(lower.size()));
    if (lower.empty()) {
        return;
    }
    carry_.set("mover_lower", lower);
    carry_.set("mover_upper", upper);
    const std::size_t bytes = parts.size() * sizeof(vec4);
    if (parts_.bytes() < bytes) {
        parts_ = gpu::Buffer(2 * bytes);
    }
    parts_.write(0, std::span<const vec4>(parts));
    parts_view_.bind(2, parts_, GL_RGBA32F);
    carry_.set("parts", 2);
}

void RememberedHits::verify(const SurfacePoints& points, const RayScene& rays, const gpu::Buffer* index) {
    build_programs(rays.settings.of<EmcSettings>().search);
    allocate(points);
    stale_.clear();
    near_.clear();
    listed_.clear();
    const float margin = kRayOriginOffset * rays.maps.extent(rays.scene);
    const bool other_maps = std::exchange(maps_version_, rays.maps.version()) != rays.maps.version();
    const auto begin = [&](const gpu::Program& program) {
        use(program);
        program.set("scene_diagonal", rays.scene.diagonal());
        program.set("local_length", rays.maps.extent(rays.scene));
        changed_view_.bind(6, rays.texels.changed(), GL_R32UI);
        program.set("changed", 6);
        program.set("frame", frame_);
        program.set("other_maps", other_maps ? 1 : 0);
        if (of_ == Of::picture) {
            cells_view_.bind(7, cells_, GL_RG32UI);
            program.set("cells", 7);
        }
        listed_.bind_storage(7);
    };
    there_.clear();
    use(there_program_);
    there_.bind_storage(7);
    dispatch_rows((capacity_ + kKeysAtOnce - 1) / kKeysAtOnce, std::min(slots(), slots_in_use_));
    wait_for_shaders();
    constexpr GLuint kGridUnit = 11;  // after those of use()
    const bool many = rays.movers.are_many(), limbs = rays.movers.has_limbs() && !many;
    const gpu::Program& verify =
        many ? verify_->use(rays.movers.grid(), kGridUnit) : verify_->use(rays.movers.whole(), margin);
    begin(verify);
    verify.set("limbs_follow", limbs ? 1 : 0);
    if (index != nullptr) {
        index_view_.bind(4, *index, GL_R32UI);
        points_view_.bind(5, points.points(), GL_RGBA32F);
        verify.set("key_index", 4);
        verify.set("points", 5);
    }
    texels_.bind_storage(4);
    there_.bind_storage(5);
    (limbs ? near_ : stale_).bind_storage(6);
    there_.dispatch();
    wait_for_shaders();
    if (limbs) {
        begin(limbs_->use(rays.movers.boxes(), margin));
        stale_.bind_storage(5);
        dispatch_listed(near_);
    }
    if (of_ == Of::picture && rays.exact == nullptr) {
        stale_share_.note(there_, stale_, std::min(rays_, kRaysAtOnce));
    }
    use(again_);
    rays.maps.bind(again_, 0, 1, rays.settings, rays.scene);
    rays.texels.bind(again_, lit_points_view_, 2);
    texels_.bind_storage(4);
    dispatch_listed(listed_);
    frames_since_motion_ = 0;
}

RememberedGuide::Hits RememberedHits::guided_hits(const SurfacePoints& points) {
    return {{points.row(), points.capacity() / points.row()},      cells_,       counts_, irradiance(),
            [this](const gpu::Program& program) { use(program); }, slots_in_use_};
}

void RememberedHits::list(const SurfacePoints& points, const RayScene& rays, Round round) {
    listed_.clear();
    const bool still = frames_since_motion_ > kStaleEnd;
    if (still) {
        use_slots(kFrames);
    }
    if (!still) {
        use(retrace_);
        // Once nothing moves any more, what was left over is traced within a few frames.
        retrace_.set("least_share", frames_since_motion_ == 0
                                        ? 0.0f
                                        : 1.0f / static_cast<float>(kStaleEnd + 1 - frames_since_motion_));
        retrace_.set("just_found", frames_since_motion_ == 0 ? 1 : 0);
        ++frames_since_motion_;
        texels_.bind_storage(4);
        retrace_.set("budget", kStaleFrames * capacity_ * rays_);
        retrace_.set("frame", frame_);
        listed_.bind_storage(7);
        dispatch_listed(stale_);
    }
    use(list_);
    points_view_.bind(0, points.points(), GL_RGBA32F);
    keys_view_.bind(1, points.keys(), GL_R32UI);
    list_.set("points", 0);
    list_.set("keys", 1);
    list_.set("frame", frame_);
    list_.set("row", points.row());
    list_.set("seed", rays.settings.seed);
    list_.set("pass", round.pass);
    list_.set("slots_at_once", round.slots);
    list_.set("same_place", kRayOriginOffset * rays.maps.extent(rays.scene));
    points.bind_storage();
    starts_.bind_storage(2);
    texels_.bind_storage(4);
    flights_.bind_storage(5);
    listed_.bind_storage(7);
    if (of_ == Of::picture) {
        glCopyNamedBufferSubData(counts_.id(), counts_before_.id(), 0, 0,
                                 static_cast<GLsizeiptr>(counts_.bytes()));
        counts_view_.bind(2, counts_before_, GL_R32UI);
        cells_view_.bind(3, cells_, GL_RG32UI);
        list_.set("counts_before", 2);
        list_.set("cells_before", 3);
        list_.set("view_changes", std::exchange(followed_, false));
        list_.set("slots_in_use", static_cast<std::uint32_t>(slots_in_use_));
        list_.set("enough", std::min(still ? kEnough : static_cast<std::uint32_t>(kFrames),
                                     static_cast<std::uint32_t>(slots_in_use_)));
        counts_.bind_storage(1);
        cells_.bind_storage(6);
        guide_.bind(list_, 4, 3);
        list_.set("has_guides", round.guided);
        list_.set("shoot_again", round.again);
    }
    points.dispatch();
    wait_for_shaders();
    if (round.guided) {
        texels_.bind_storage(4);
        flights_.bind_storage(5);
        guide_.guide(guided_hits(points), rays.settings.seed);
    }
}

// One invocation for each listed entry, of the program in use.
void RememberedHits::dispatch_listed(const EntryList& list) {
    list.bind_storage(6);
    list.dispatch();
    wait_for_shaders();
}

void RememberedHits::shoot_round(const SurfacePoints& points, const RayScene& rays, Round round) {
    {
        const gpu::PassTimer::Scope scope(rays.timer, span("gather_list", "lit_list"));
        list(points, rays, round);
    }
    {
        const gpu::PassTimer::Scope scope(rays.timer, span("gather_trace", "lit_trace"));
        // Nobody else needs what is near any more.
        trace_.trace(
            rays, {listed_, near_, texels_, flights_, [this](const gpu::Program& program) { use(program); }});
    }
    if (of_ == Of::picture) {
        const gpu::PassTimer::Scope scope(rays.timer, "gather_sort");
        shading_.sort(shaded_hits(), slots_in_use_);
    }
}

void RememberedHits::shoot(const SurfacePoints& points, const RayScene& rays, const gpu::Buffer* radiosity,
                           int pass) {
    build_programs(rays.settings.of<EmcSettings>().search);
    allocate(points);
    Round round{.guided = radiosity != nullptr, .slots = kSlotsAtOnce, .pass = pass};
    if (!shot_before_) {
        shot_before_ = gpu::Buffer(sizeof(std::uint32_t));
    }
    shot_before_.clear();
    if (round.guided && !guide_.knows()) {
        // What close hits reflect is not known before they are lit: a slot says what another hit reflected,
        // and which one is chance.
        RayScene by_texels = rays;
        by_texels.close = nullptr;
        shoot_round(points, by_texels, {.slots = 1});
        listed_.copy_count(shot_before_);
        shade(points, *radiosity);
        round.again = true;
    }
    if (round.guided) {
        const gpu::PassTimer::Scope scope(rays.timer, "gather_guide");
        guide_.update(guided_hits(points), *radiosity, frame_);
    }
    shoot_round(points, rays, round);
    frame_ = (frame_ + 1) % std::min(slots(), slots_in_use_);
}

void RememberedHits::collect(const RayScene& rays) {
    more_first_ = rays.close->of() == CloseHits::Of::every_hit ? rays.close->first() : 0;
    rays.close->collect([this](const gpu::Program& program) { use(program); }, entries(),
                        kRayOriginOffset * rays.maps.extent(rays.scene));
}

RememberedShading::Hits RememberedHits::shaded_hits() {
    return {cells_, counts_, [this](const gpu::Program& program) { use(program); }};
}

const gpu::Buffer& RememberedHits::shade(const SurfacePoints& points, const gpu::Buffer& radiosity) {
    return shading_.shade(shaded_hits(), points, radiosity);
}

const gpu::Buffer& RememberedHits::halves(const SurfacePoints& points, const gpu::Buffer& radiosity) {
    return shading_.halves(shaded_hits(), points, radiosity);
}

std::uint64_t RememberedHits::shot() const {
    return (shot_before_ ? shot_before_.read<std::uint32_t>(1).front() : 0) + listed_.count();
}

std::size_t RememberedHits::bytes() const {
    return starts_.bytes() + flights_.bytes() + texels_.bytes() + cells_.bytes() + counts_.bytes() +
           shading_.bytes() + stale_.bytes() + near_.bytes() + listed_.bytes() + there_.bytes();
}

}  // namespace lanthorn::gi
