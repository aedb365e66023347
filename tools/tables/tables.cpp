#include "tools/tables/tables.h"

#include "lanthorn/core/error.h"
#include "lanthorn/ecs/component_json.h"
#include "lanthorn/lamplighter/lamplighter.h"
#include "lanthorn/runtime/scene_plugins.h"
#include "lanthorn/workbench/all_settings.h"

namespace lanthorn::tools {

std::vector<std::string_view> table_names() {
    return {"components", "settings"};
}

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
    std::string result = page;
    bool any = false;
    for (const std::string_view name : table_names()) {
        const std::string begin = "<!-- table " + std::string(name) + " -->\n";
        const std::string end = "<!-- end of " + std::string(name) + " -->\n";
        const std::size_t from = result.find(begin);
        if (from == std::string::npos) {
            continue;
        }
        any = true;
        const std::size_t first = from + begin.size();
        const std::size_t last = result.find(end, first);
        if (last == std::string::npos) {
            throw InputError(source, "table " + std::string(name), "has no end");
        }
        result.replace(first, last - first, table(name));
    }
    if (!any) {
        throw InputError(source, "", "found no line <!-- table NAME -->");
    }
    return result;
}

}  // namespace lanthorn::tools
