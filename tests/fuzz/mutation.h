// Deterministic damage to files.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

namespace lanthorn {

// The same seed does the same damage on every platform (no std:: distributions).
class Mutator {
  public:
    explicit Mutator(std::uint64_t seed) : engine_(seed) {}

    // 0 <= result < limit; 0 if limit is 0.
    std::size_t below(std::size_t limit) {
        return limit == 0 ? 0 : static_cast<std::size_t>(engine_() % limit);
    }

    // Flips, overwrites, removes, repeats or cuts off bytes, one to four times.
    void damage_bytes(std::string& bytes);

    // Replaces, removes, repeats or exchanges values anywhere in the tree, one to three times.
    void damage_json(nlohmann::json& root);

  private:
    void damage_bytes_once(std::string& bytes);
    void damage_json_once(nlohmann::json& root);
    nlohmann::json any_value();

    std::mt19937_64 engine_;
};

}  // namespace lanthorn
