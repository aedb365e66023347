// lanthorn: the command line.
#include <array>

#include "lanthorn/coarse/coarse_path_technique.h"
#include "lanthorn/coarse/embree_rays.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/command_line.h"

int main(int argc, char** argv) {
    using namespace lanthorn;
    gi::add_coarse_path();
    gi::add_embree_rays();
    const std::array commands{tools::add_render,  tools::add_compare,    tools::add_inspect,
                              tools::add_convert, tools::add_measure,    tools::add_trade,
                              tools::add_bench,   tools::add_trade_point};
    return tools::run_command_line(
        "lanthorn", "Global illumination for dynamic scenes, from the command line.", commands, argc, argv);
}
