// The same crowd skinned by the CPU and by the GPU of this machine: which is faster?   bench_gpu_skinning
#include <fmt/format.h>

#include <random>

#include "lanthorn/gpu/context.h"
#include "lanthorn/render/gpu_skinning.h"
#include "tests/bench/deformation/crowd.h"

int main() {
    using namespace lanthorn;
    const auto context = gpu::create_headless_context();
    fmt::print("{}\n", context->info().renderer);
    std::mt19937 random(1);
    for (const std::uint32_t vertices : {2000u, 20000u}) {
        const deform::BindPose pose = deform::pack(deformation_bench::figure_mesh(vertices, 60, 4, random));
        std::vector<deform::JointMatrix> joints;
        for (std::uint32_t j = 0; j < 60; ++j) {
            joints.push_back(deform::joint_matrix(deformation_bench::joint_pose(j, 7), mat4(1), dvec3(0)));
        }
        for (const int figures : {1, 10, 100}) {
            const auto times = render::measure_skinning(pose, joints, figures);
            fmt::print("{:3} figures of {:5} vertices: CPU {:8.3f} ms, GPU {:8.3f} ms: the {} is faster\n",
                       figures, vertices, times.cpu_ms, times.gpu_ms, times.gpu_is_faster() ? "GPU" : "CPU");
        }
    }
    return 0;
}
