// How a technique declares its settings: each once, with where it is kept.
//
//   struct CoarseSettings { float samples = 2; };                      // the defaults
//
//   void declare_coarse_settings(SettingList& list) {
//       list.declare<&CoarseSettings::samples>("gi.coarse-path.samples")
//           .unit("paths a point a frame").range(0.125f, 1024.0f).cost("linear in ms").docs("...");
//   }
#pragma once

#include <cstdint>
#include <type_traits>
#include <vector>

#include "lanthorn/core/settings.h"
#include "lanthorn/gi/gi_settings.h"

namespace lanthorn::gi {

template <typename Member>
struct MemberTypes;
// The two types of a pointer to a member: the class that has the member, and the type of its value.
template <typename Class, typename Value>
struct MemberTypes<Value Class::*> {
    using Holder = Class;
    using Kept = Value;
};

// The settings as they are declared, each with where it is kept.
class SettingList {
  public:
    // A declared setting and how its value gets from Settings to GiSettings.
    struct Row {
        const char* name;
        void (*read)(const char* name, const Settings& from, GiSettings& to);
    };

    explicit SettingList(SettingsSchema& schema) : schema_(schema) {}

    // `Member`: of GiSettings, or of a technique's own type. The default is the one that it is made with.
    // `name` must stay. A std::uint32_t is declared as an int.
    template <auto Member>
    auto declare(const char* name) {
        using Holder = typename MemberTypes<decltype(Member)>::Holder;
        using Kept = typename MemberTypes<decltype(Member)>::Kept;
        using Declared = std::conditional_t<std::is_same_v<Kept, std::uint32_t>, int, Kept>;
        rows_.push_back({name, [](const char* setting, const Settings& from, GiSettings& to) {
                             edited<Holder>(to).*Member = static_cast<Kept>(from.get<Declared>(setting));
                         }});
        SettingDeclaration<Declared> declaration = schema_.declare<Declared>(name);
        declaration.initially(static_cast<Declared>(Holder().*Member));
        return declaration;
    }

    // In the order of their declaration. Valid until the next one.
    const std::vector<Row>& rows() const { return rows_; }

  private:
    template <typename Holder>
    static Holder& edited(GiSettings& settings) {
        if constexpr (std::is_same_v<Holder, GiSettings>) {
            return settings;
        } else {
            return settings.edit<Holder>();
        }
    }

    SettingsSchema& schema_;
    std::vector<Row> rows_;
};

}  // namespace lanthorn::gi
