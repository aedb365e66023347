// Values to JSON and back through their descriptions.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/ecs/value_ops.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/ecs/registry.h"

namespace lanthorn::ecs::detail {

using Json = nlohmann::ordered_json;

// What was found, shortened, as messages quote it.
std::string quoted(const Json& found);

Json value_to_json(const Field& field, const ValueType& type, const void* value, const EntityNames& names,
                   Fields fields = Fields::all);
// An object of all fields that can be written.
Json structure_to_json(const ValueType& type, const void* value, const EntityNames& names,
                       Fields fields = Fields::all);

class ValueReader {
  public:
    // `unknown` gets keys that are no fields.
    ValueReader(const EntityNames& names, std::vector<JsonProblem>& unknown)
        : names_(names), unknown_(unknown) {}

    // Fields that `json` does not name stay as they are. Throw a JsonProblem for what cannot be read; the
    // value is half read then.
    void structure(const ValueType& type, void* value, const Json& json, const std::string& place);
    void field(const Field& field, void* value, const Json& json, const std::string& place) {
        read(field, *field.type, value, json, place);
    }

  private:
    void read(const Field& field, const ValueType& type, void* value, const Json& json,
              const std::string& place);
    void read_number(const Field& field, const ValueType& type, void* value, const Json& json,
                     const std::string& place);
    void read_list(const Field& field, const ValueType& type, void* value, const Json& json,
                   const std::string& place);

    const EntityNames& names_;
    std::vector<JsonProblem>& unknown_;
};

}  // namespace lanthorn::ecs::detail
