#include "tests/unit/animation/gltf_evaluator.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

namespace animation_test {

using nlohmann::json;

namespace {

std::vector<unsigned char> bytes_of(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw std::runtime_error("cannot read " + path.string());
    }
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<unsigned char> from_base64(const std::string& text) {
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<unsigned char> bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        const std::size_t value = alphabet.find(c);
        if (value == std::string::npos) {
            break;
        }
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes.push_back(static_cast<unsigned char>(bits >> count));
        }
    }
    return bytes;
}

std::uint32_t word(const std::vector<unsigned char>& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

std::size_t size_of(int type) {
    return type == 5120 || type == 5121 ? 1 : type == 5122 || type == 5123 ? 2 : 4;
}

// 3.6.2.2 and the table of 3.11: normalised integers as fractions.
double number(const unsigned char* at, int type, bool normalised) {
    const auto read = [&](auto value) {
        std::memcpy(&value, at, sizeof value);
        return static_cast<double>(value);
    };
    switch (type) {
        case 5120:
            return normalised ? std::max(read(std::int8_t{}) / 127.0, -1.0) : read(std::int8_t{});
        case 5121:
            return normalised ? read(std::uint8_t{}) / 255.0 : read(std::uint8_t{});
        case 5122:
            return normalised ? std::max(read(std::int16_t{}) / 32767.0, -1.0) : read(std::int16_t{});
        case 5123:
            return normalised ? read(std::uint16_t{}) / 65535.0 : read(std::uint16_t{});
        case 5125:
            return read(std::uint32_t{});
        default:
            return read(float{});
    }
}

void make_unit(std::vector<double>& q) {
    double length = 0;
    for (const double v : q) {
        length += v * v;
    }
    for (double& v : q) {
        v /= std::sqrt(length);
    }
}

}  // namespace

GltfEvaluator::GltfEvaluator(const std::filesystem::path& file) {
    const std::vector<unsigned char> bytes = bytes_of(file);
    std::vector<unsigned char> chunk;
    if (bytes.size() > 20 && std::memcmp(bytes.data(), "glTF", 4) == 0) {
        const std::size_t length = word(bytes, 12);
        json_ = json::parse(bytes.begin() + 20, bytes.begin() + 20 + static_cast<std::ptrdiff_t>(length));
        const std::size_t binary = 20 + length;
        if (bytes.size() > binary + 8) {
            chunk.assign(bytes.begin() + static_cast<std::ptrdiff_t>(binary) + 8, bytes.end());
        }
    } else {
        json_ = json::parse(bytes);
    }
    for (const json& buffer : json_.value("buffers", json::array())) {
        const std::string uri = buffer.value("uri", std::string());
        if (uri.empty()) {
            buffers_.push_back(chunk);
        } else if (uri.starts_with("data:")) {
            buffers_.push_back(from_base64(uri.substr(uri.find(',') + 1)));
        } else {
            buffers_.push_back(bytes_of(file.parent_path() / uri));
        }
    }
}

std::vector<double> GltfEvaluator::accessor(std::size_t index) const {
    const json& a = json_["accessors"][index];
    const std::map<std::string, std::size_t> widths = {{"SCALAR", 1}, {"VEC3", 3}, {"VEC4", 4}};
    const std::size_t width = widths.at(a["type"]);
    const std::size_t count = a["count"];
    const int type = a["componentType"];
    const bool normalised = a.value("normalized", false);
    std::vector<double> values(count * width, 0.0);
    const auto element = [&](std::size_t view, std::size_t offset, std::size_t i, std::size_t to) {
        const json& v = json_["bufferViews"][view];
        const std::size_t stride = v.value("byteStride", width * size_of(type));
        const unsigned char* at =
            buffers_[v["buffer"]].data() + v.value("byteOffset", std::size_t{0}) + offset + i * stride;
        for (std::size_t c = 0; c < width; ++c) {
            values[to * width + c] = number(at + c * size_of(type), type, normalised);
        }
    };
    for (std::size_t i = 0; a.contains("bufferView") && i < count; ++i) {
        element(a["bufferView"], a.value("byteOffset", std::size_t{0}), i, i);
    }
    if (a.contains("sparse")) {
        const json& sparse = a["sparse"];
        const json& v = json_["bufferViews"][sparse["indices"]["bufferView"].get<std::size_t>()];
        const int index_type = sparse["indices"]["componentType"];
        for (std::size_t i = 0; i < sparse["count"].get<std::size_t>(); ++i) {
            const unsigned char* at = buffers_[v["buffer"]].data() + v.value("byteOffset", std::size_t{0}) +
                                      sparse["indices"].value("byteOffset", std::size_t{0}) +
                                      i * size_of(index_type);
            element(sparse["values"]["bufferView"], sparse["values"].value("byteOffset", std::size_t{0}), i,
                    static_cast<std::size_t>(number(at, index_type, false)));
        }
    }
    return values;
}

std::vector<std::size_t> GltfEvaluator::walk() const {
    std::vector<std::size_t> order;
    std::vector<std::size_t> open;
    if (json_.contains("scenes")) {
        open = json_["scenes"][json_.value("scene", std::size_t{0})].value("nodes", open);
    } else {
        std::vector<bool> child(json_["nodes"].size(), false);
        for (const json& node : json_["nodes"]) {
            for (const std::size_t c : node.value("children", std::vector<std::size_t>())) {
                child[c] = true;
            }
        }
        for (std::size_t i = 0; i < child.size(); ++i) {
            if (!child[i]) {
                open.push_back(i);
            }
        }
    }
    std::reverse(open.begin(), open.end());
    while (!open.empty()) {
        order.push_back(open.back());
        open.pop_back();
        auto children = json_["nodes"][order.back()].value("children", std::vector<std::size_t>());
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return order;
}

std::vector<double> GltfEvaluator::key_times(std::size_t animation) const {
    std::vector<double> all;
    for (const json& sampler : json_["animations"][animation]["samplers"]) {
        const std::vector<double> times = accessor(sampler["input"]);
        all.insert(all.end(), times.begin(), times.end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

// Appendix C, with its names.
std::vector<double> GltfEvaluator::value(const json& sampler, std::size_t width, bool rotation,
                                         double seconds) const {
    const std::vector<double> t = accessor(sampler["input"]);
    const std::vector<double> out = accessor(sampler["output"]);
    const std::string mode = sampler.value("interpolation", std::string("LINEAR"));
    const bool cubic = mode == "CUBICSPLINE";
    const auto part = [&](std::size_t key, std::size_t which) {  // of a spline: 0 a_k, 1 v_k, 2 b_k
        const std::size_t first = (cubic ? key * 3 + which : key) * width;
        return std::vector<double>(out.begin() + static_cast<std::ptrdiff_t>(first),
                                   out.begin() + static_cast<std::ptrdiff_t>(first + width));
    };
    std::vector<double> v;
    if (seconds <= t.front()) {
        v = part(0, 1);
    } else if (seconds >= t.back()) {
        v = part(t.size() - 1, 1);
    } else {
        std::size_t k = 0;
        while (!(t[k] <= seconds && seconds < t[k + 1])) {
            ++k;
        }
        const double td = t[k + 1] - t[k];
        const double u = (seconds - t[k]) / td;
        const std::vector<double> here = part(k, 1);
        const std::vector<double> next = part(k + 1, 1);
        v.resize(width);
        if (mode == "STEP") {
            v = here;
        } else if (cubic) {
            const std::vector<double> b = part(k, 2);
            const std::vector<double> a = part(k + 1, 0);
            for (std::size_t i = 0; i < width; ++i) {
                v[i] = (2 * u * u * u - 3 * u * u + 1) * here[i] + td * (u * u * u - 2 * u * u + u) * b[i] +
                       (-2 * u * u * u + 3 * u * u) * next[i] + td * (u * u * u - u * u) * a[i];
            }
        } else if (!rotation) {
            for (std::size_t i = 0; i < width; ++i) {
                v[i] = (1 - u) * here[i] + u * next[i];
            }
        } else {
            double d = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                d += here[i] * next[i];
            }
            const double a = std::acos(std::min(std::abs(d), 1.0));
            const double s = d < 0 ? -1 : 1;
            for (std::size_t i = 0; i < 4; ++i) {
                v[i] = a < 1e-9 ? (1 - u) * here[i] + s * u * next[i]
                                : std::sin(a * (1 - u)) / std::sin(a) * here[i] +
                                      s * std::sin(a * u) / std::sin(a) * next[i];
            }
        }
    }
    if (rotation) {
        make_unit(v);
    }
    return v;
}

std::vector<NodePose> GltfEvaluator::evaluate(std::size_t animation, double seconds) const {
    std::vector<NodePose> poses(json_["nodes"].size());
    const json& source = json_["animations"][animation];
    for (const json& channel : source["channels"]) {
        if (!channel["target"].contains("node")) {
            continue;
        }
        const std::size_t node = channel["target"]["node"];
        const std::string path = channel["target"]["path"];
        const json& sampler = source["samplers"][channel["sampler"].get<std::size_t>()];
        std::size_t width = path == "rotation" ? 4 : 3;
        if (path == "weights") {
            const json& mesh = json_["meshes"][json_["nodes"][node]["mesh"].get<std::size_t>()];
            width = mesh["primitives"][0]["targets"].size();
        }
        const std::vector<double> v = value(sampler, width, path == "rotation", seconds);
        NodePose& pose = poses[node];
        pose.moved = true;
        if (path == "translation") {
            std::copy(v.begin(), v.end(), pose.translation.begin());
        }
        if (path == "rotation") {
            std::copy(v.begin(), v.end(), pose.rotation.begin());
        }
        if (path == "scale") {
            std::copy(v.begin(), v.end(), pose.scale.begin());
        }
        if (path == "weights") {
            pose.weights = v;
        }
    }
    return poses;
}

}  // namespace animation_test
