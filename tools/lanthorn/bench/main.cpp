// lanthorn_bench: `lanthorn bench` for machines without the libraries that files need (tools/bundle).
#include <array>

#include "gi_module/shared/rays/embree_rays.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/command_line.h"

int main(int argc, char** argv) {
    using namespace lanthorn;
    gi::add_embree_rays();
    const std::array commands{tools::add_bench};
    return tools::run_command_line("lanthorn_bench", "Speed beside what others have published.", commands,
                                   argc, argv);
}
