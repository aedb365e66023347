// What can be set of the indirect light. What techniques share is declared in gi_settings.cpp with unit,
// range, default and cost; what is a technique's own, in its folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

namespace lanthorn {
class Settings;
class SettingsSchema;
}  // namespace lanthorn

namespace lanthorn::gi {

// A technique by its place among those that this program knows (technique.h). These are always there: `first`
// is the default, the first that is registered. Others have the value that add_technique() returned.
enum class TechniqueKind : int { first, none };

// Settings that techniques keep in types of their own, one of a type. Copies share them until they are
// edited.
class SettingParts {
  public:
    // One with its defaults where there is none. O(parts).
    template <typename Part>
    const Part& of() const {
        for (const auto& [type, part] : parts_) {
            if (type == std::type_index(typeid(Part))) {
                return *static_cast<const Part*>(part.get());
            }
        }
        static const Part kDefaults;
        return kDefaults;
    }

    // Holds until a copy of these is made.
    template <typename Part>
    Part& edit() {
        auto own = std::make_shared<Part>(of<Part>());
        Part& result = *own;
        for (auto& [type, part] : parts_) {
            if (type == std::type_index(typeid(Part))) {
                part = std::move(own);
                return result;
            }
        }
        parts_.emplace_back(std::type_index(typeid(Part)), std::move(own));
        return result;
    }

  private:
    std::vector<std::pair<std::type_index, std::shared_ptr<const void>>> parts_;
};

struct GiSettings {
    TechniqueKind technique = TechniqueKind::first;
    int bounces = 2;      // reflections before the visible surface
    int photons = 20000;  // emitted a frame, all lights together
    std::uint32_t seed = 1;
    int accumulate = 1;               // passes that a still picture is made of; 1: the first one stays
    float target_error = 0;           // estimated relRMSE with which it has passes enough; 0: none is
    float specular_roughness = 0.5f;  // of the roughest surface whose specular lobe is traced; 0: none

    // A technique's own: settings.of<CoarseSettings>().samples, settings.edit<CoarseSettings>().samples = 4.
    template <typename Part>
    const Part& of() const {
        return parts.of<Part>();
    }
    // The same to write to. The reference holds until these settings are copied, as SettingParts::edit()
    // says.
    template <typename Part>
    Part& edit() {
        return parts.edit<Part>();
    }
    SettingParts parts;
};

// Those of every technique that this program knows by then.
void declare_gi_settings(SettingsSchema& schema);
// What `settings` say. Where their schema was declared before a technique was known, that technique's own are
// at their defaults. O(settings).
GiSettings gi_settings(const Settings& settings);

}  // namespace lanthorn::gi
