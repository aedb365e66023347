// One program in as many variants as its defines take values, each compiled when it is first asked for.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/gpu/program.h"

namespace lanthorn::gpu {

class ProgramVariants {
  public:
    explicit ProgramVariants(std::vector<std::filesystem::path> stages) : stages_(std::move(stages)) {}

    // The same defines in another order are another variant.
    const Program& with(const std::vector<std::string>& defines) {
        auto entry = programs_.find(defines);
        if (entry == programs_.end()) {
            entry = programs_.emplace(defines, Program(stages_, defines)).first;
        }
        return entry->second;
    }

  private:
    std::vector<std::filesystem::path> stages_;
    std::map<std::vector<std::string>, Program> programs_;
};

}  // namespace lanthorn::gpu
