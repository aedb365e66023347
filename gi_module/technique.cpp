#include "lanthorn/gi/technique.h"

#include <algorithm>
#include <stdexcept>

namespace lanthorn::gi {

namespace {

GiPlan plan_of_none(const FrameScene&, const GiSettings&) {
    return {{{"indirect_light", false, "", "the technique is 'none': direct light alone"}}, 0};
}

// Direct light alone.
class NoIndirectLight final : public Technique {
  public:
    void plan(const FrameScene&, ivec2, const GiSettings&) override {}
    void update(const render::LightInputs&) override {}
    render::IndirectLight indirect(const render::FrameInputs&) override { return {}; }
    GiStatistics statistics(bool) override {
        GiStatistics result;
        result.plan = plan_of_none({}, {});
        return result;
    }
};

TechniqueEntry none_entry() {
    TechniqueEntry none;
    none.name = "none";
    none.docs = "direct light alone";
    none.make = []() -> std::unique_ptr<Technique> { return std::make_unique<NoIndirectLight>(); };
    none.first_plan = plan_of_none;
    return none;
}

// References stay valid when another is added.
std::deque<TechniqueEntry>& entries() {
    static std::deque<TechniqueEntry> all;
    static bool asked = false;
    if (!asked) {
        asked = true;  // add_technique() comes here again
        register_techniques();
        if (all.empty()) {
            throw std::logic_error("register_techniques() has added no technique, expected one at least");
        }
    }
    return all;
}

}  // namespace

TechniqueKind add_technique(TechniqueEntry entry) {
    std::deque<TechniqueEntry>& all = entries();
    const auto same = std::ranges::find(all, entry.name, &TechniqueEntry::name);
    const auto kind = static_cast<TechniqueKind>(same - all.begin());
    if (same == all.end()) {
        all.push_back(std::move(entry));
    }
    if (all.size() == 1) {
        all.push_back(none_entry());
    }
    return kind;
}

const std::deque<TechniqueEntry>& techniques() {
    return entries();
}

std::vector<std::string> technique_names() {
    std::vector<std::string> names;
    for (const TechniqueEntry& entry : entries()) {
        names.push_back(entry.name);
    }
    return names;
}

const TechniqueEntry& technique_entry(TechniqueKind kind) {
    return entries().at(static_cast<std::size_t>(kind));
}

const TechniqueEntry* find_technique(std::string_view name) {
    const auto found = std::ranges::find(entries(), name, &TechniqueEntry::name);
    return found == entries().end() ? nullptr : &*found;
}

std::unique_ptr<Technique> make_technique(TechniqueKind kind) {
    return technique_entry(kind).make();
}

GiPlan first_plan(const FrameScene& scene, const GiSettings& settings) {
    return technique_entry(settings.technique).first_plan(scene, settings);
}

}  // namespace lanthorn::gi
