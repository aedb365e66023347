#version 450 core
// Morph targets and linear blend skinning of one vertex an invocation: what engine/deformation does on the CPU.
#include "gpu_skinning_data.h"

layout(local_size_x = 64) in;

layout(std430, binding = kBindPoseBinding) readonly buffer BindPose { float bind_pose[]; };
layout(std430, binding = kFirstRoundBinding) readonly buffer FirstRound { uint first_round[]; };
layout(std430, binding = kRoundsBinding) readonly buffer Rounds { InfluenceRound rounds[]; };
layout(std430, binding = kJointsBinding) readonly buffer Joints { vec4 joints[]; };
layout(std430, binding = kMorphListBinding) readonly buffer MorphList { uint morph_list[]; };
layout(std430, binding = kMorphDeltasBinding) readonly buffer MorphDeltas { float morph_deltas[]; };
layout(std430, binding = kMorphsBinding) readonly buffer Morphs { ActiveMorphData morphs[]; };
layout(std430, binding = kFramesBinding) writeonly buffer Frames { float frames[]; };

uniform int vertex_count;
uniform int morph_count;
uniform int placement;
uniform int last_joint;

vec3 bound(uint at) {
    return vec3(bind_pose[at], bind_pose[at + 1u], bind_pose[at + 2u]);
}

// `v` at unit length whatever its length, or `fallback` if it has no direction.
vec3 unit_or(vec3 v, vec3 fallback) {
    float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    if (!(largest > 0.0) || isinf(largest)) return fallback;
    return normalize(v / largest);
}

// Where vertex `v` is in the target's list: its index there, or -1.
int listed(ActiveMorphData morph, uint v) {
    uint low = morph.first;
    uint high = morph.first + morph.count;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (morph_list[middle] < v) {
            low = middle + 1u;
        } else {
            high = middle;
        }
    }
    return low < morph.first + morph.count && morph_list[low] == v ? int(low - morph.first) : -1;
}

vec3 delta(uint offset, uint first, uint stride) {
    if (offset == kNoDeltas) return vec3(0.0);
    uint at = offset + first;
    return vec3(morph_deltas[at], morph_deltas[at + stride], morph_deltas[at + 2u * stride]);
}

void add_morphs(uint v, inout vec3 position, inout vec3 normal, inout vec3 tangent) {
    vec3 bound_normal = normal;
    vec3 bound_tangent = tangent;
    for (int i = 0; i < morph_count; ++i) {
        ActiveMorphData morph = morphs[i];
        uint first = v / 4u * 12u + v % 4u;
        uint stride = 4u;
        if (morph.dense == 0u) {
            int index = listed(morph, v);
            if (index < 0) continue;
            first = uint(index) * 3u;
            stride = 1u;
        }
        position += morph.weight * delta(morph.positions, first, stride);
        normal += morph.weight * delta(morph.normals, first, stride);
        tangent += morph.weight * delta(morph.tangents, first, stride);
    }
    if (morph_count > 0) {
        normal = unit_or(normal, bound_normal);
        tangent = unit_or(tangent, bound_tangent);
    }
}

void blend(uint v, out vec4 x, out vec4 y, out vec4 z) {
    x = y = z = vec4(0.0);
    uint lane = v % 4u;
    for (uint round = first_round[v / 4u]; round < first_round[v / 4u + 1u]; ++round) {
        InfluenceRound influence = rounds[round];
        uint pair = lane < 2u ? influence.joints_01 : influence.joints_23;
        uint joint = 3u * ((lane & 1u) == 0u ? pair & 0xffffu : pair >> 16);
        float weight = lane < 2u ? (lane == 0u ? influence.weight_0 : influence.weight_1)
                                 : (lane == 2u ? influence.weight_2 : influence.weight_3);
        x += weight * joints[joint];
        y += weight * joints[joint + 1u];
        z += weight * joints[joint + 2u];
    }
}

// Normals by the inverse transpose, here the cofactors of the matrix at a size that they can be computed at.
void place(vec4 x, vec4 y, vec4 z, inout vec3 position, inout vec3 normal, inout vec4 tangent) {
    position = vec3(dot(x.xyz, position) + x.w, dot(y.xyz, position) + y.w, dot(z.xyz, position) + z.w);
    vec3 largest = max(abs(x.xyz), max(abs(y.xyz), abs(z.xyz)));
    float size = max(largest.x, max(largest.y, largest.z));
    if (!(size > 0.0)) return;
    vec3 a = x.xyz / size;
    vec3 b = y.xyz / size;
    vec3 c = z.xyz / size;
    vec3 across = cross(b, c);
    float turn = dot(a, across) < 0.0 ? -1.0 : 1.0;
    normal = unit_or(turn * vec3(dot(across, normal), dot(cross(c, a), normal), dot(cross(a, b), normal)), normal);
    tangent.xyz = unit_or(vec3(dot(a, tangent.xyz), dot(b, tangent.xyz), dot(c, tangent.xyz)), tangent.xyz);
    tangent.w *= turn;
}

void main() {
    uint v = gl_GlobalInvocationID.x;
    if (v >= uint(vertex_count)) return;
    uint at = v * 10u;
    vec3 position = bound(at);
    vec3 normal = bound(at + 3u);
    vec4 tangent = vec4(bound(at + 6u), bind_pose[at + 9u]);
    add_morphs(v, position, normal, tangent.xyz);
    if (placement != kPlaceAsTheyAre) {
        vec4 x, y, z;
        if (placement == kPlaceBySkin) {
            blend(v, x, y, z);
        } else {
            x = joints[3 * last_joint];
            y = joints[3 * last_joint + 1];
            z = joints[3 * last_joint + 2];
        }
        place(x, y, z, position, normal, tangent);
    }
    for (uint i = 0u; i < 3u; ++i) {
        frames[at + i] = position[i];
        frames[at + 3u + i] = normal[i];
    }
    for (uint i = 0u; i < 4u; ++i) frames[at + 6u + i] = tangent[i];
}
