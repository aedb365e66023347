#include "tools/tables/tables.h"

#include <filesystem>

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/lamplighter/lamplighter.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/workbench/all_settings.h"
#include "tools/lanthorn/measure/plan_figures.h"
#include "tools/lanthorn/trade/advice_report.h"

namespace lanthorn::tools {

namespace {

constexpr std::string_view kAdvice = "advice from ", kPlan = "plan from ";

std::string advice(const std::filesystem::path& chart) {
    Wishes wishes;
    wishes.ms = kPageBudgets;
    wishes.share = kPageShare;
    return advice_markdown(read_chart(chart), wishes);
}

// The table of that name in the page.
std::string table_of(const std::string& name, std::string_view page) {
    const auto beside = [&](std::string_view kind) {
        return std::filesystem::path(page).parent_path() / name.substr(kind.size());
    };
    return name.starts_with(kAdvice) ? advice(beside(kAdvice))
           : name.starts_with(kPlan) ? plan_markdown(read_plan(beside(kPlan)))
                                     : table(name);
}

}  // namespace

std::string table(std::string_view name) {
    if (name == "components") {
        App app;
        add_scene_plugins(app);
        app.add<game::GamePlugin>();
        return ecs::list_markdown(app.registry());
    }
    if (name == "settings") {
        SettingsSchema schema;
        workbench::declare_all_settings(schema);
        return schema.list_markdown();
    }
    throw InputError("found '" + std::string(name) + "', expected components or settings");
}

std::string with_tables(const std::string& page, std::string_view source) {
    constexpr std::string_view kMark = "<!-- table ", kEnd = " -->\n";
    std::string result = page;
    bool any = false;
    for (std::size_t at = 0; (at = result.find(kMark, at)) != std::string::npos;) {
        const std::size_t named = at + kMark.size(), name_end = result.find(kEnd, named);
        if (name_end == std::string::npos) {
            break;
        }
        const std::string name = result.substr(named, name_end - named);
        const std::size_t first = name_end + kEnd.size();
        const std::size_t last = result.find("<!-- end of " + name + " -->\n", first);
        if (last == std::string::npos) {
            throw InputError(source, "table " + name, "has no end");
        }
        const std::string now = table_of(name, source);
        result.replace(first, last - first, now);
        at = first + now.size();
        any = true;
    }
    if (!any) {
        throw InputError(source, "", "found no line <!-- table NAME -->");
    }
    return result;
}

}  // namespace lanthorn::tools
