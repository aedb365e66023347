#include <algorithm>
#include <cmath>

#include "engine/assets/gltf_accessor.h"
#include "engine/assets/gltf_deformation.h"
#include "engine/assets/gltf_format.h"

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

void expect_joint_type(const GltfContext& context, std::size_t index, const std::string& place) {
    const tinygltf::Accessor& accessor = context.model.accessors[index];
    const auto type = static_cast<std::uint64_t>(accessor.componentType);
    if (accessor.type != TINYGLTF_TYPE_VEC4 || (type != kUnsignedByte && type != kUnsignedShort) ||
        accessor.normalized) {
        context.refuse(place,
                       fmt::format("accessor {} is no VEC4 of unsigned bytes or shorts (5121, 5123)", index));
    }
}

void expect_weight_type(const GltfContext& context, std::size_t index, const std::string& place) {
    const tinygltf::Accessor& accessor = context.model.accessors[index];
    const auto type = static_cast<std::uint64_t>(accessor.componentType);
    const bool fraction = (type == kUnsignedByte || type == kUnsignedShort) && accessor.normalized;
    if (accessor.type != TINYGLTF_TYPE_VEC4 || !(type == kFloat || fraction)) {
        context.refuse(place, fmt::format("accessor {} is no VEC4 of floats or normalised unsigned bytes or "
                                          "shorts",
                                          index));
    }
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
        expect_joint_type(context, joint_index, joint_place);
        expect_weight_type(context, weight_index, weight_place);
        if (context.model.accessors[joint_index].count != vertices) {
            context.refuse(joint_place,
                           fmt::format("accessor {} has {} elements, expected {} as POSITION has",
                                       joint_index, context.model.accessors[joint_index].count, vertices));
        }
        joints.push_back(read_indices(context, joint_index, 4));
        weights.push_back(read_attribute(context, weight_index, weight_place, {4, 4, vertices}));
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
