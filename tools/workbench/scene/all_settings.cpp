#include "lanthorn/workbench/all_settings.h"

#include "lanthorn/gi/gi_plugin.h"

namespace lanthorn::workbench {

void declare_all_settings(SettingsSchema& schema) {
    gi::declare_settings(schema);
}

Settings counted_settings(const SettingsSchema& schema) {
    Settings settings(schema);
    settings.set<bool>("gi.gather.endless", false);
    return settings;
}

Settings measured_settings(const SettingsSchema& schema) {
    Settings settings = counted_settings(schema);
    settings.set_from_text("path.transport=diffuse");
    return settings;
}

}  // namespace lanthorn::workbench
