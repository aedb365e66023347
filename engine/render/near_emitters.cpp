#include "engine/render/near_emitters.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "lanthorn/core/colour.h"

namespace lanthorn::render {

namespace {

vec3 facing(const EmissiveFace& face) {  // m^2 along the normal
    return 0.5f * glm::cross(face.p[1] - face.p[0], face.p[2] - face.p[0]);
}

vec3 centre(const EmissiveFace& face) {
    return (face.p[0] + face.p[1] + face.p[2]) / 3.0f;
}

float place(const EmissiveFace& face, int axis) {
    return axis < 3 ? face.at[axis] : face.normal[axis - 3];
}

// Of the six numbers that say where faces lie and how they face, the one in which they differ most.
int widest_axis(std::span<const EmissiveFace> faces) {
    int widest = 0;
    float most = -1;
    for (int axis = 0; axis < 6; ++axis) {
        const auto [least, largest] = std::ranges::minmax_element(
            faces, {}, [axis](const EmissiveFace& face) { return place(face, axis); });
        const float wide = place(*largest, axis) - place(*least, axis);
        // Of two as wide the first, whatever rounding says.
        if (wide > 1.001f * most) {
            widest = axis;
            most = wide;
        }
    }
    return widest;
}

struct Node {
    vec3 middle{0};
    float radius = 0;
    vec3 a{0}, b{0};
    float sine = 0;
    vec3 radiance{0};
};

Node node_of(std::span<const EmissiveFace> faces) {
    Node node;
    vec3 whole(0);
    float area = 0, light = 0;
    for (const EmissiveFace& face : faces) {
        const float own = glm::length(facing(face));
        const float bright = own * luminance(face.radiance);
        node.middle += bright * centre(face);
        node.radiance += own * face.radiance;
        whole += facing(face);
        area += own;
        light += bright;
    }
    node.middle /= light;
    node.radiance /= area;
    const float length = glm::length(whole);
    const vec3 normal = length > 0 ? whole / length : vec3(0, 0, 1);
    float cosine = length > 1e-3f * area ? 1.0f : 0.0f;
    for (const EmissiveFace& face : faces) {
        for (const vec3& p : face.p) {
            node.radius = std::max(node.radius, glm::distance(p, node.middle));
        }
        cosine = std::min(cosine, glm::dot(facing(face), normal) / glm::length(facing(face)));
    }
    node.sine = std::sqrt(std::max(0.0f, 1 - cosine * std::abs(cosine)));
    if (faces.size() == 1) {
        node.a = faces[0].p[0] - node.middle;
        node.b = faces[0].p[1] - node.middle;
        node.sine = 0;
        return node;
    }
    const vec3 u =
        glm::normalize(glm::cross(normal, std::abs(normal.y) < 0.9f ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    const float side = std::sqrt(length / 1.5f);
    node.a = side * u;
    node.b = side * glm::cross(normal, u);
    return node;
}

void add(std::span<EmissiveFace> faces, std::size_t most, std::vector<vec4>& nodes) {
    const Node node = node_of(faces);
    const std::size_t at = nodes.size();
    nodes.insert(nodes.end(), {vec4(node.middle, node.radius), vec4(node.a, 0), vec4(node.b, node.sine),
                               vec4(node.radiance, 0)});
    if (faces.size() > 1 && most > 1) {
        const int axis = widest_axis(faces);
        const auto middle = faces.begin() + static_cast<std::ptrdiff_t>(faces.size() / 2);
        std::ranges::nth_element(faces, middle, {},
                                 [axis](const EmissiveFace& face) { return place(face, axis); });
        add({faces.begin(), middle}, most / 2, nodes);
        add({middle, faces.end()}, most - most / 2, nodes);
    }
    nodes[at + 1].w = static_cast<float>(nodes.size() / kEmitterNodeTexels);
}

}  // namespace

void add_near_emitter(const EmissiveSample& sample, std::size_t most, LightData& light,
                      std::vector<vec4>& nodes) {
    std::vector<EmissiveFace> faces;
    std::ranges::copy_if(sample.faces, std::back_inserter(faces), [](const EmissiveFace& face) {
        return glm::length(facing(face)) > 0 && luminance(face.radiance) > 0;
    });
    if (faces.empty()) {
        return;
    }
    const std::size_t at = nodes.size();
    add(faces, most, nodes);
    light.cone_scale = static_cast<float>(at / kEmitterNodeTexels);
    light.cone_offset = static_cast<float>(nodes.size() / kEmitterNodeTexels);
    light.up = vec3(nodes[at]);
    light.depth_range = nodes[at].w;
}

}  // namespace lanthorn::render
