#include "tools/lanthorn/common/program_page.h"

#include "engine/build_info/build_info.h"
#include "lanthorn/core/settings_schema.h"
#include "lanthorn/workbench/all_settings.h"
#include "tools/lanthorn/common/workbench.h"

namespace lanthorn::tools {

manual::PageText program_page() {
    manual::PageText text;
    text.version = kVersion;
    text.description = {
        "Renders glTF 2.0 scenes with indirect light that is never baked, by a choice of techniques, and by "
        "a path tracer as their "
        "reference; compares pictures, and measures where and why they differ.",
        "Output files are written completely or not at all. SIGINT and SIGTERM end a command after the frame "
        "at hand; what can be "
        "kept is written, pictures marked as unfinished. A second signal ends it at once."};
    text.exit_codes = {
        {"0", "Done."},
        {"1", "A check failed: an image differs by more than --max allows, say."},
        {"2", "Bad usage or bad input: one line on standard error names file, place and what was expected."},
        {"3", "There is no usable OpenGL 4.5."},
        {"130, 143", "Stopped by SIGINT, by SIGTERM."}};
    text.environment = {{"LANTHORN_SHADERS", "Folder of shaders, instead of the installation's."},
                        {"LANTHORN_IMAGE_MODULE",
                         "The library that reads images by OpenImageIO, instead of the installation's."},
                        {"LIBGL_ALWAYS_SOFTWARE", "1 renders on the CPU, by Mesa's llvmpipe."}};
    text.files = {{"/usr/share/lanthorn/assets/", "Scenes to try, where Lanthorn is installed below /usr."},
                  {"/usr/share/lanthorn/shaders/", "Shaders, likewise."}};
    text.examples = {
        {"lanthorn render /usr/share/lanthorn/assets/cornell.glb -o box.png", "A picture:"},
        {"lanthorn render scene.glb -o ref.exr --aov indirect --technique path --target-noise 0.02",
         "The reference of its indirect light, with an error of its own below 2 %:"},
        {"lanthorn compare now.exr ref.exr --max 0.1", "Does another picture agree with it?"},
        {"lanthorn render --list-settings", "What --set can change, with unit, range, default and cost:"}};
    text.see_also = {"lamplighter(6)"};
    return text;
}

manual::Values option_values() {
    SettingsSchema schema;
    declare_all_settings(schema);
    manual::Values values = {
        {"--preset", preset_names()},
        {"--technique", schema.find_or_throw("gi.technique").choices},
        {"--aov", {"final", "indirect", "direct", "albedo", "normal", "depth", "radiance"}},
        {"--size", {}},
        {"--camera", {}},
        {"--pose", {}},
        {"--animation", {}},
        {"--variant", {}}};
    for (const SettingInfo& setting : schema.all()) {
        values["--set"].push_back(setting.name + "=");
    }
    return values;
}

}  // namespace lanthorn::tools
