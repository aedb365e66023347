#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_deformation.h"
#include "engine/assets/gltf_format.h"
#include "engine/assets/gltf_integers.h"

namespace lanthorn {

namespace {

struct Influence {
    std::uint32_t joint;
    float weight;
};

// The influences of every vertex, four a set.
struct InfluenceSets {
    std::size_t sets = 0;
    std::vector<std::uint32_t> joints;  // by vertex, then set
    std::vector<float> weights;
};

void expect_vec4(const GltfContext& context, std::size_t index, const std::string& place,
                 std::string_view of) {
    if (context.model.accessors[index].type != TINYGLTF_TYPE_VEC4) {
        context.refuse(place, fmt::format("accessor {} is no VEC4 of {}", index, of));
    }
}

// Indices are whole numbers, of whatever type and marked as they may be.
std::vector<std::uint32_t> read_joints(const GltfContext& context, std::size_t index,
                                       const std::string& place) {
    expect_vec4(context, index, place, "unsigned bytes or shorts (5121, 5123)");
    const tinygltf::Accessor& accessor = context.model.accessors[index];
    const auto type = static_cast<std::uint64_t>(accessor.componentType);
    if (accessor.normalized) {
        context.warn(place, "'normalized' says nothing of joints");
    }
    if (type == kUnsignedByte || type == kUnsignedShort) {
        return read_indices(context, index, 4);
    }
    context.warn(place, "expected unsigned bytes or shorts (5121, 5123); read as whole numbers");
    std::vector<std::uint32_t> joints;
    for (const float value : read_floats(context, index, 4, 0, Integers::numbers)) {
        if (!(value >= 0 && value < 65536 && value == std::floor(value))) {
            context.refuse(accessor_place(index),
                           fmt::format("element {} has the joint {}, expected a whole number of 0 to 65535",
                                       joints.size() / 4, value));
        }
        joints.push_back(static_cast<std::uint32_t>(value));
    }
    return joints;
}

// The weights of a vertex are divided by their sum: what 1 is of integers says nothing.
std::vector<float> read_weights(const GltfContext& context, std::size_t index, const std::string& place,
                                std::size_t vertices) {
    expect_vec4(context, index, place, "floats or normalised unsigned bytes or shorts");
    const tinygltf::Accessor& accessor = context.model.accessors[index];
    if (static_cast<std::uint64_t>(accessor.componentType) != kFloat && !accessor.normalized) {
        context.warn(place, kReadAsFractions);
    }
    return read_attribute(context, index, place, {4, 4, vertices}, 0, Integers::fractions);
}

InfluenceSets read_sets(const GltfContext& context, const tinygltf::Primitive& primitive,
                        const std::string& place, std::size_t vertices) {
    InfluenceSets result;
    const auto attribute = [&](const char* kind) {
        return primitive.attributes.find(fmt::format("{}_{}", kind, result.sets));
    };
    std::vector<std::vector<std::uint32_t>> joints;
    std::vector<std::vector<float>> weights;
    for (;; ++result.sets) {
        const auto joint = attribute("JOINTS");
        const auto weight = attribute("WEIGHTS");
        const auto none = primitive.attributes.end();
        if ((joint == none) != (weight == none)) {
            const std::string& alone = joint == none ? weight->first : joint->first;
            context.warn(fmt::format("{}/attributes/{}", place, alone),
                         "found without its partner of joints or weights; left out");
        }
        if (joint == none || weight == none) {
            break;
        }
        const auto joint_index = static_cast<std::size_t>(joint->second);
        const auto weight_index = static_cast<std::size_t>(weight->second);
        const std::string joint_place = fmt::format("{}/attributes/{}", place, joint->first);
        const std::string weight_place = fmt::format("{}/attributes/{}", place, weight->first);
        std::vector<std::uint32_t> joints_of_set = read_joints(context, joint_index, joint_place);
        if (context.model.accessors[joint_index].count != vertices) {
            context.refuse(joint_place,
                           fmt::format("accessor {} has {} elements, expected {} as POSITION has",
                                       joint_index, context.model.accessors[joint_index].count, vertices));
        }
        joints.push_back(std::move(joints_of_set));
        weights.push_back(read_weights(context, weight_index, weight_place, vertices));
    }
    result.joints.resize(vertices * result.sets * 4);
    result.weights.resize(vertices * result.sets * 4);
    for (std::size_t v = 0; v < vertices; ++v) {
        for (std::size_t s = 0; s < result.sets; ++s) {
            for (std::size_t k = 0; k < 4; ++k) {
                result.joints[(v * result.sets + s) * 4 + k] = joints[s][v * 4 + k];
                result.weights[(v * result.sets + s) * 4 + k] = weights[s][v * 4 + k];
            }
        }
    }
    return result;
}

// The largest kMost, divided by their sum.
SkinInfluences packed(std::vector<Influence>& given) {
    std::stable_sort(given.begin(), given.end(),
                     [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    given.resize(std::min(given.size(), SkinInfluences::kMost));
    double sum = 0;
    for (const Influence& influence : given) {
        sum += influence.weight;
    }
    SkinInfluences result;
    for (std::size_t k = 0; k < given.size(); ++k) {
        result.joints[k] = static_cast<std::uint16_t>(given[k].joint);
        result.weights[k] = static_cast<float>(given[k].weight / sum);
    }
    return result;
}

}  // namespace

std::vector<SkinInfluences> read_influences(const GltfContext& context, const tinygltf::Primitive& primitive,
                                            const std::string& place, std::size_t vertices,
                                            const JointLimit& limit) {
    const InfluenceSets sets = read_sets(context, primitive, place, vertices);
    if (sets.sets == 0) {
        return {};
    }
    std::vector<SkinInfluences> result(vertices);
    std::size_t bad = 0;
    std::size_t unbound = 0;
    std::size_t cut = 0;
    std::vector<Influence> given;
    for (std::size_t v = 0; v < vertices; ++v) {
        given.clear();
        for (std::size_t k = 0; k < sets.sets * 4; ++k) {
            const Influence influence{sets.joints[v * sets.sets * 4 + k],
                                      sets.weights[v * sets.sets * 4 + k]};
            bad += !(influence.weight >= 0 && std::isfinite(influence.weight));
            if (!(influence.weight > 0) || !std::isfinite(influence.weight)) {
                continue;  // without weight, the joint means nothing
            }
            if (influence.joint >= limit.joints) {
                context.refuse(fmt::format("{}/attributes/JOINTS_{}", place, k / 4),
                               fmt::format("vertex {} is bound to joint {}, expected an index below {} (the "
                                           "joints of skin {})",
                                           v, influence.joint, limit.joints, limit.skin));
            }
            given.push_back(influence);
        }
        unbound += given.empty();
        cut += given.size() > SkinInfluences::kMost;
        if (given.empty()) {
            given.push_back({0, 1.0f});
        }
        result[v] = packed(given);
    }
    const std::string weights_place = place + "/attributes/WEIGHTS_0";
    if (bad > 0) {
        context.warn(weights_place, fmt::format("{} weights are negative or not finite; 0 is used", bad));
    }
    if (unbound > 0) {
        context.warn(weights_place,
                     fmt::format("the weights of {} vertices are all zero; bound to joint 0", unbound));
    }
    if (cut > 0) {
        context.warn(weights_place,
                     fmt::format("{} vertices have more than {} influences; the largest are used", cut,
                                 SkinInfluences::kMost));
    }
    return result;
}

std::vector<SkinInfluences> remapped(const std::vector<SkinInfluences>& influences,
                                     const VertexSources& sources) {
    std::vector<SkinInfluences> result;
    result.reserve(influences.empty() ? 0 : sources.size());
    for (std::size_t i = 0; i < sources.size() && !influences.empty(); ++i) {
        result.push_back(influences[sources[i]]);
    }
    return result;
}

}  // namespace lanthorn
