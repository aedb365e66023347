#include "lanthorn/gi/gi_settings.h"

#include <utility>

#include "gi_module/shared/plan_rules.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/gi/setting_list.h"
#include "lanthorn/gi/technique.h"

namespace lanthorn::gi {

namespace {

void declare_shared_settings(SettingList& list) {
    std::string docs = "Indirect light: ";
    for (const TechniqueEntry& technique : techniques()) {
        docs += (&technique == &techniques().front() ? "" : "; ") + technique.name + " is " + technique.docs;
    }
    list.declare<&GiSettings::technique>("gi.technique")
        .choices(technique_names())
        .cost("see docs/measurements.md; none: nothing; path: seconds to hours")
        .docs(docs + '.');
    list.declare<&GiSettings::bounces>("gi.bounces")
        .unit("reflections")
        .range(1, 8)
        .presets({2, 2, 3, 4})
        .as_published(3)
        .cost("linear in ms of bounces and splats")
        .docs(
            "Reflections before the visible surface; the light that arrives after exactly 1..N of them is "
            "indirect. gi.emc.final = gather counts none unless gi.gather.endless is false.");
    list.declare<&GiSettings::photons>("gi.photons")
        .unit("photons")
        .range(1, 4'000'000)
        .presets({6'000, 20'000, 60'000, 250'000})
        .as_published(376'000)
        .cost("linear in ms; 56 bytes and 32 more a bounce each, and the splats' lists")
        .docs("Photons emitted, all lights together, split over them by flux.");
    list.declare<&GiSettings::seed>("gi.seed")
        .range(0, 1'000'000'000)
        .cost("none")
        .docs("Seed of the photons and of the candidates. The same seed gives the same picture.");
    list.declare<&GiSettings::accumulate>("gi.accumulate")
        .unit("passes")
        .range(1, 100'000)
        .cost("linear in ms while nothing moves: one pass a frame, none after the last")
        .docs(
            "While scene and camera stay still, each frame adds to the mean of those before: splat other "
            "photons with smaller splats (Knaus and Zwicker 2011), whose lowest level has pixels of 4 at "
            "most; gather, once its 16 frames are in, other rays from other pixels. Up to so many passes.");
    list.declare<&GiSettings::target_error>("gi.target_error")
        .unit("relRMSE")
        .range(0.0f, 1e6f)
        .cost("an estimate with every pass that changes the picture; none once it is reached")
        .docs(
            "Error of indirect light, as it is estimated without a reference, at which a still picture "
            "needs no more passes of gi.accumulate: gather alone. 0: all of them.");
    list.declare<&GiSettings::specular_roughness>("gi.specular.roughness")
        .range(0.0f, 1.0f)
        .presets({0.4f, 0.5f, 0.6f, 0.7f})
        .cost("a ray a pixel of what is smoother, in frames in which the view or surfaces change")
        .docs(
            "What surfaces up to this roughness mirror, and what is seen through transparent ones, is "
            "traced; "
            "wider lobes reflect what irradiance says. From 0.15 below it on one goes over into the other. "
            "0: "
            "nothing is traced, glass and smooth metal show even light.");
}

template <std::size_t... I>
void declare_plan_rules(SettingList& list, std::index_sequence<I...> /*rules*/) {
    (list.declare<kPlanRules[I].on>(kPlanRules[I].name)
         .for_measuring()
         .cost(std::string("false costs what is left out otherwise: ") + kPlanRules[I].leaves_out)
         .docs("For measuring the plan (docs/plan.md). False: its passes work as if the scene required it."),
     ...);
}

void declare_all(SettingList& list) {
    declare_shared_settings(list);
    declare_plan_rules(list, std::make_index_sequence<kPlanRules.size()>());
    for (const TechniqueEntry& technique : techniques()) {
        if (technique.declare != nullptr) {
            technique.declare(list);
        }
    }
}

// Of all techniques that are known by now.
const std::vector<SettingList::Row>& rows() {
    static std::vector<SettingList::Row> all;
    static std::size_t known = 0;
    if (known != techniques().size()) {
        SettingsSchema scratch;
        SettingList list(scratch);
        declare_all(list);
        all = list.rows();
        known = techniques().size();
    }
    return all;
}

}  // namespace

void declare_gi_settings(SettingsSchema& schema) {
    SettingList list(schema);
    declare_all(list);
}

GiSettings gi_settings(const Settings& settings) {
    GiSettings result;
    for (const SettingList::Row& row : rows()) {
        if (settings.schema().find(row.name) !=
            nullptr) {  // declared before its technique was known: defaults
            row.read(row.name, settings, result);
        }
    }
    return result;
}

}  // namespace lanthorn::gi
