// lanthorn: the command line.
#include <array>

#include "engine/core/crash_report.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/command_line.h"

int main(int argc, char** argv) {
    using namespace lanthorn;
    install_crash_report();
    const std::array commands{tools::add_render,      tools::add_compare,   tools::add_inspect,
                              tools::add_convert,     tools::add_measure,   tools::add_trade,
                              tools::add_edit,        tools::add_replay,    tools::add_bench,
                              tools::add_trade_point, tools::add_farm_slice};
    return tools::run_command_line(
        "lanthorn", "Global illumination for dynamic scenes, from the command line.", commands, argc, argv);
}
