#include "gi_module/techniques/emc/maps/map_rounds.h"

#include "lanthorn/emc/emc_settings.h"
#include "lanthorn/gi/passes.h"

namespace lanthorn::gi {

namespace {

constexpr int kOneMapRounds = 3;
constexpr std::uint32_t kHeader[4] = {0, 0, 1, 1};  // nothing listed; groups x, y, z

}  // namespace

void MapRounds::resize(std::size_t rays) {
    for (gpu::Buffer& unsettled : unsettled_) {
        unsettled = gpu::Buffer(sizeof(kHeader) + rays * sizeof(std::uint32_t));
    }
}

void MapRounds::run(const gpu::Program& one_map, const gpu::Program& every_map, const GiSettings& settings,
                    const std::function<void(const gpu::Program&)>& prepare,
                    const std::function<void(const gpu::Program&)>& start, const EachMap* apart) {
    const bool all_at_once =
        settings.of<EmcSettings>().search == Search::secant || settings.of<EmcSettings>().exhaustive;
    const int rounds = all_at_once ? 0 : kOneMapRounds;
    for (int round = 0; round <= rounds; ++round) {
        const gpu::Program& program = round < rounds ? one_map : every_map;
        const gpu::Buffer& listed = unsettled_[(round + 1) % 2];
        gpu::Buffer& unsettled = unsettled_[round % 2];
        listed.bind_storage(6);
        if (apart != nullptr && round > 0 && round == rounds) {
            run_apart(*apart, listed, unsettled, prepare);
            return;
        }
        unsettled.write_bytes(0, kHeader, sizeof(kHeader));
        unsettled.bind_storage(7);
        prepare(program);
        program.set("listed", round > 0 ? 1 : 0);
        if (round == 0) {
            start(program);
        } else {
            glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, listed.id());
            glDispatchComputeIndirect(sizeof(std::uint32_t));
        }
        wait_for_shaders();
    }
}

void MapRounds::run_apart(const EachMap& apart, const gpu::Buffer& listed, const gpu::Buffer& nearest,
                          const std::function<void(const gpu::Program&)>& prepare) {
    constexpr std::size_t kGroupsZ = 3 * sizeof(std::uint32_t);
    nearest.bind_storage(7);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, listed.id());
    for (const gpu::Program* program : {&apart.nobody, &apart.each, &apart.nearest}) {
        const GLuint maps = program == &apart.each ? static_cast<GLuint>(apart.maps) : 1;
        glClearNamedBufferSubData(listed.id(), GL_R32UI, kGroupsZ, sizeof(maps), GL_RED_INTEGER,
                                  GL_UNSIGNED_INT, &maps);
        glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
        prepare(*program);
        program->set("listed", 1);
        glDispatchComputeIndirect(sizeof(std::uint32_t));
        wait_for_shaders();
    }
}

}  // namespace lanthorn::gi
