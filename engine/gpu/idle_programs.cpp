#include "engine/gpu/idle_programs.h"

#include <utility>

namespace lanthorn::gpu {

namespace {
constexpr std::size_t kMostIdle = 512;  // a full set of all techniques is about 200
thread_local std::weak_ptr<IdlePrograms> current_store;
}  // namespace

std::shared_ptr<IdlePrograms> IdlePrograms::current() {
    return current_store.lock();
}

void IdlePrograms::set_current(const std::shared_ptr<IdlePrograms>& store) {
    current_store = store;
}

IdlePrograms::~IdlePrograms() {
    for (const auto& [text, shelf] : shelves_) {
        shelf->open = false;
    }
}

std::shared_ptr<IdlePrograms::Shelf> IdlePrograms::shelf(const std::string& text) {
    std::shared_ptr<Shelf>& shelf = shelves_[text];
    if (!shelf) {
        shelf = std::make_shared<Shelf>();
    }
    return shelf;
}

LinkedProgram IdlePrograms::take(Shelf& shelf) {
    if (shelf.idle.empty()) {
        return {};
    }
    LinkedProgram program = std::move(shelf.idle.back());
    shelf.idle.pop_back();
    for (const auto& [name, uniform] : program.uniforms) {
        if (uniform.put_back != nullptr) {
            uniform.put_back(program.id, uniform);
        }
    }
    return program;
}

void IdlePrograms::limit() {
    std::size_t idle = 0;
    for (const auto& [text, shelf] : shelves_) {
        idle += shelf->idle.size();
    }
    if (idle <= kMostIdle) {
        return;
    }
    std::erase_if(shelves_, [](const auto& entry) {
        for (const LinkedProgram& program : entry.second->idle) {
            glDeleteProgram(program.id);
        }
        entry.second->idle.clear();
        return entry.second.use_count() == 1;
    });
}

}  // namespace lanthorn::gpu
