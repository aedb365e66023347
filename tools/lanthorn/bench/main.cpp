// lanthorn_bench: `lanthorn bench` for machines without the libraries that files need (tools/bundle).
#include <array>

#include "gi_module/shared/rays/embree_rays.h"
#include "lanthorn/emc/emc.h"
#include "tools/lanthorn/commands.h"
#include "tools/lanthorn/common/command_line.h"

// The technique that is measured, without the libraries of the others.
void lanthorn::gi::register_techniques() {
    add_embree_rays();
    add_emc();
}

int main(int argc, char** argv) {
    using namespace lanthorn;
    const std::array commands{tools::add_bench};
    return tools::run_command_line("lanthorn_bench", "Speed beside what others have published.", commands,
                                   argc, argv);
}
