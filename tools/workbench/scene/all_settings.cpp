#include "lanthorn/workbench/all_settings.h"

#include "lanthorn/gi/gi_plugin.h"
#include "lanthorn/reference/path_settings.h"

namespace lanthorn::workbench {

void declare_all_settings(SettingsSchema& schema) {
    gi::declare_settings(schema);
    reference::declare_path_settings(schema);
}

Settings counted_settings(const SettingsSchema& schema) {
    Settings settings(schema);
    settings.set<bool>("gi.gather.endless", false);
    return settings;
}

}  // namespace lanthorn::workbench
