// Nodes, their transforms, cameras and lights.
#include <limits>

#include "engine/assets/matrix_parts.h"
#include "tests/unit/assets/import_fixture.h"

namespace lanthorn {
namespace {

using nlohmann::json;

class NodeImport : public ImportTest {};

TEST_F(NodeImport, ParentsComeBeforeChildrenWhateverTheFilesOrder) {
    builder.json["nodes"] = {{{"name", "leaf"}},
                             {{"name", "middle"}, {"children", {0}}},
                             {{"name", "root"}, {"children", {1, 3}}},
                             {{"name", "second"}}};
    const SceneData scene = import();
    ASSERT_EQ(scene.nodes.size(), 4u);
    EXPECT_EQ(scene.nodes[0].name, "root");
    EXPECT_EQ(scene.nodes[0].parent, kNone);
    EXPECT_EQ(scene.nodes[1].name, "middle");
    EXPECT_EQ(scene.nodes[1].parent, 0u);
    EXPECT_EQ(scene.nodes[2].name, "leaf");
    EXPECT_EQ(scene.nodes[2].parent, 1u);
    EXPECT_EQ(scene.nodes[3].name, "second");
    EXPECT_EQ(scene.nodes[3].parent, 0u);
}

TEST_F(NodeImport, OnlyTheDefaultScenesNodes) {
    builder.json["nodes"] = {{{"name", "a"}}, {{"name", "b"}}, {{"name", "c"}}};
    EXPECT_EQ(import().nodes.size(), 3u) << "no scenes: all roots";
    builder.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {2, 1}}}};
    EXPECT_EQ(import().nodes.at(0).name, "a") << "no default: scene 0";
    builder.json["scene"] = 1;
    const SceneData scene = import();
    ASSERT_EQ(scene.nodes.size(), 2u);
    EXPECT_EQ(scene.nodes[0].name, "c");
    EXPECT_EQ(scene.nodes[1].name, "b");
}

TEST_F(NodeImport, AChainOfFiftyThousandNodes) {
    for (int i = 0; i < 50000; ++i) {
        json node = json::object();
        if (i + 1 < 50000) {
            node["children"] = {i + 1};
        }
        builder.json["nodes"].push_back(node);
    }
    const SceneData scene = import();
    EXPECT_EQ(scene.nodes.size(), 50000u);
    EXPECT_EQ(scene.nodes.back().parent, 49998u);
}

TEST_F(NodeImport, CyclesAreRefused) {
    builder.json["nodes"] = {{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}}};
    EXPECT_EQ(import().nodes.size(), 3u) << "no cycle: node 1 stays with node 0";
    builder.json["nodes"] = {json::object(), {{"children", {2}}}, {{"children", {1}}}};
    expect_refused("/nodes/1/children", "its own ancestor");
    builder.json["nodes"] = {{{"children", {0}}}};
    expect_refused("/nodes/0/children", "its own ancestor");
    builder.json["nodes"] = {
        {{"children", {1}}}, {{"children", {2}}}, {{"children", {3}}}, {{"children", {0}}}};
    expect_refused("/nodes/0/children", "its own ancestor");
}

TEST_F(NodeImport, OfTwoParentsTheFirstCounts) {
    builder.json["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, json::object()};
    const SceneData scene = import();
    expect_warning(scene, "/nodes/1/children/0", "node 2 already is a child of node 0");
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_EQ(scene.nodes[1].parent, 0u);
}

TEST_F(NodeImport, ANodeListedTwiceIsShownOnce) {
    builder.json["nodes"] = {{{"children", {1}}}, json::object()};
    builder.json["scenes"] = {{{"nodes", {0, 0}}}};
    const SceneData scene = import();
    expect_warning(scene, "/scenes/0/nodes/1", "node 0 is listed twice; it is shown once");
    EXPECT_EQ(scene.nodes.size(), 2u);
}

// Kenney's cake: an empty root that the scene does not list, and its only child, which the scene lists.
TEST_F(NodeImport, AListedNodeWhoseParentIsNotListedIsARoot) {
    builder.json["nodes"] = {{{"name", "outside"}, {"translation", {7, 0, 0}}, {"children", {1}}},
                             {{"name", "cake"}, {"children", {2, 3}}},
                             {{"name", "plate"}},
                             {{"name", "candle"}}};
    builder.json["scenes"] = {{{"nodes", {1}}}};
    const SceneData scene = import();
    expect_warning(scene, "/scenes/0/nodes/0",
                   "node 1 is a child of node 0, expected a root; it is shown as a root, without its parent");
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_EQ(scene.nodes[0].name, "cake");
    EXPECT_EQ(scene.nodes[0].parent, kNone);
    EXPECT_EQ(scene.nodes[2].parent, 0u);
}

TEST_F(NodeImport, AListedNodeUnderAListedOneIsShownOnce) {
    builder.json["nodes"] = {
        {{"name", "root"}, {"children", {1}}}, {{"name", "between"}, {"children", {2}}}, {{"name", "leaf"}}};
    builder.json["scenes"] = {{{"nodes", {2, 0}}}};
    const SceneData scene = import();
    expect_warning(scene, "/scenes/0/nodes/0",
                   "node 2 is a child of node 1, expected a root; it is shown there alone");
    ASSERT_EQ(scene.nodes.size(), 3u);
    EXPECT_EQ(scene.nodes[0].name, "root");
    EXPECT_EQ(scene.nodes[2].name, "leaf");
    EXPECT_EQ(scene.nodes[2].parent, 1u);
}

TEST_F(NodeImport, OnlyTheLoadedSceneIsMended) {
    builder.json["nodes"] = {{{"children", {1}}}, json::object()};
    builder.json["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    EXPECT_TRUE(import().warnings.empty());
}

TEST_F(NodeImport, TranslationRotationScale) {
    builder.json["nodes"] = {{{"translation", {1e6 + 0.125, -2, 3}},
                              {"rotation", {0, 0, 0.70710678, 0.70710678}},
                              {"scale", {2, -3, 4}}}};
    const NodeData node = import().nodes.at(0);
    EXPECT_EQ(node.local.translation, dvec3(1e6 + 0.125, -2, 3)) << "in double precision";
    expect_near(node.local.rotation * vec3(1, 0, 0), vec3(0, 1, 0));
    EXPECT_EQ(node.local.scale, vec3(2, -3, 4));
    EXPECT_EQ(node.shear, mat3(1));
}

TEST_F(NodeImport, ZeroRotationIsNone) {
    builder.json["nodes"] = {{{"rotation", {0, 0, 0, 0}}}};
    const SceneData scene = import();
    EXPECT_EQ(scene.nodes.at(0).local.rotation, quat(1, 0, 0, 0));
    expect_warning(scene, "/nodes/0/rotation", "zero quaternion");
}

// T * R * S * shear is the matrix that went in.
void expect_recomposed(const dmat4& matrix) {
    Transform transform;
    mat3 shear;
    decompose(matrix, transform, shear);
    EXPECT_NEAR(glm::length(transform.rotation), 1, 1e-6);
    const dmat4 result = transform.matrix() * dmat4(glm::dmat3(shear));
    double size = 0;
    for (int c = 0; c < 3; ++c) {
        size = std::max(size, glm::length(matrix[c]));
    }
    for (int c = 0; c < 3; ++c) {
        EXPECT_LE(glm::length(result[c] - matrix[c]), 4e-6 * size) << "column " << c;
    }
    EXPECT_EQ(result[3], matrix[3]);
}

TEST(MatrixParts, AnyAffineMatrixComesBack) {
    expect_recomposed(dmat4(1));
    expect_recomposed({dvec4(0, 2, 0, 0), dvec4(-3, 0, 0, 0), dvec4(0, 0, 4, 0), dvec4(5, 6, 7, 1)});
    expect_recomposed({dvec4(-1, 0, 0, 0), dvec4(0, 1, 0, 0), dvec4(0, 0, 1, 0), dvec4(0, 0, 0, 1)});
    expect_recomposed({dvec4(1, 0, 0, 0), dvec4(0.5, 1, 0, 0), dvec4(0.25, -2, 3, 0), dvec4(0, 0, 0, 1)});
    expect_recomposed({dvec4(1, 2, 3, 0), dvec4(4, 5, 6, 0), dvec4(7, 8, 10, 0), dvec4(0, 0, 0, 1)});
    expect_recomposed({dvec4(1e-12, 0, 0, 0), dvec4(0, 1e12, 0, 0), dvec4(0, 0, 1, 0), dvec4(0, 0, 0, 1)});
}

TEST(MatrixParts, SingularMatricesComeBack) {
    expect_recomposed({dvec4(0), dvec4(0), dvec4(0), dvec4(0, 0, 0, 1)});
    expect_recomposed({dvec4(1, 0, 0, 0), dvec4(0), dvec4(0, 0, 1, 0), dvec4(0, 0, 0, 1)});
    expect_recomposed({dvec4(1, 1, 0, 0), dvec4(2, 2, 0, 0), dvec4(3, 3, 0, 0), dvec4(0, 0, 0, 1)});
    expect_recomposed({dvec4(0), dvec4(0, 1, 1, 0), dvec4(1, 0, 0, 0), dvec4(0, 0, 0, 1)});
}

TEST_F(NodeImport, MatrixWithoutShearHasExactlyNone) {
    builder.json["nodes"] = {{{"matrix", {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 7, 8, 9, 1}}}};
    const NodeData node = import().nodes.at(0);
    EXPECT_EQ(node.shear, mat3(1));
    EXPECT_EQ(node.local.translation, dvec3(7, 8, 9));
    expect_near(node.local.scale, vec3(2));
}

TEST_F(NodeImport, BadTransformsAreRefused) {
    builder.json["nodes"] = {{{"matrix", {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}};
    expect_refused("/nodes/0/matrix", "projective");
    builder.json["nodes"] = {{{"matrix", {1, 0, 0}}}};
    expect_refused("/nodes/0/matrix", "expected an array of 16 numbers");
    builder.json["nodes"] = {{{"translation", {1e39, 0, 0}}}};
    expect_refused("/nodes/0/translation/0", "finite 32-bit number");
    builder.json["nodes"] = {{{"translation", {0, "1", 0}}}};
    expect_refused("/nodes/0/translation/1", "found \"1\"");
    builder.json["nodes"] = {{{"scale", {1e30, 1, 1}}, {"children", {1}}}, {{"scale", {1e30, 1, 1}}}};
    expect_refused("/nodes/1", "not finite");
    expect_file_refused(
        folder.write("inf.gltf", R"({"asset":{"version":"2.0"},"nodes":[{"scale":[1e999,1,1]}]})"),
        "JSON line 1, column 47", "1e999");
}

TEST_F(NodeImport, MeshesBeyondTheRangeOfFloatsAreRefused) {
    builder.add_primitive({{"POSITION", builder.add_vec3({0, 0, 0, 1e38f, 0, 0, 0, 1e38f, 0})}});
    builder.json["nodes"][0]["scale"] = {100, 1, 1};
    expect_refused("/nodes/0", "beyond the range");
}

TEST_F(NodeImport, ExtrasAreKeptAsJson) {
    builder.json["nodes"] = {
        {{"extras", {{"door", "left"}, {"speed", 1.5}}}}, {{"extras", 7}}, json::object()};
    const SceneData scene = import();
    EXPECT_EQ(json::parse(scene.nodes.at(0).extras), json({{"door", "left"}, {"speed", 1.5}}));
    EXPECT_EQ(scene.nodes.at(1).extras, "7");
    EXPECT_EQ(scene.nodes.at(2).extras, "");
}

TEST_F(NodeImport, Cameras) {
    builder.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.01}}}},
        {{"type", "perspective"},
         {"perspective", {{"yfov", 1}, {"znear", 0.1}, {"zfar", 50}, {"aspectRatio", 2}}}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0}, {"zfar", 9}}}}};
    builder.json["nodes"] = {{{"camera", 2}}};
    const SceneData scene = import();
    ASSERT_EQ(scene.cameras.size(), 3u);
    EXPECT_EQ(scene.cameras[0], (Camera{.y_fov = 0.8f, .z_near = 0.01f, .z_far = 0}));
    EXPECT_EQ(scene.cameras[1], (Camera{.y_fov = 1, .z_near = 0.1f, .z_far = 50}));
    EXPECT_TRUE(scene.cameras[2].orthographic);
    EXPECT_EQ(scene.cameras[2].x_mag, 3);
    EXPECT_EQ(scene.cameras[2].y_mag, 2);
    EXPECT_EQ(scene.cameras[2].z_far, 9);
    EXPECT_EQ(scene.nodes.at(0).camera, 2u);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(NodeImport, ImpossibleCamerasAreMended) {
    builder.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 0.1}}}},
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", -1}}}},
        {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 2}, {"zfar", 1}}}},
        {{"type", "orthographic"}, {"orthographic", {{"xmag", 0}, {"ymag", 2}, {"znear", 0}, {"zfar", 9}}}},
        {{"type", "fisheye"}}};
    const SceneData scene = import();
    EXPECT_EQ(scene.warnings.size(), 5u) << testing::PrintToString(scene.warnings);
}

// A perspective camera and an orthographic one, of what is left of them.
TEST_F(NodeImport, CamerasMayLackNumbers) {
    builder.json["cameras"] = {{{"type", "perspective"}},
                               {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}}}}};
    const SceneData scene = import();
    EXPECT_EQ(scene.cameras.at(0), Camera());
    EXPECT_TRUE(scene.cameras.at(1).orthographic);
    EXPECT_EQ(scene.cameras.at(1).x_mag, 3);
    EXPECT_EQ(scene.cameras.at(1).y_mag, 1);
    EXPECT_GT(scene.cameras.at(1).z_far, scene.cameras.at(1).z_near);
    EXPECT_EQ(scene.warnings.size(), 4u)
        << "near planes in one line: " << testing::PrintToString(scene.warnings);
}

TEST_F(NodeImport, CamerasWithExchangedPlanesSeeWhatLiesBetween) {
    const json lens = {{"yfov", 1}, {"xmag", 2}, {"ymag", 2}, {"znear", 100}, {"zfar", 0.5}};
    builder.json["cameras"] = {{{"type", "perspective"}, {"perspective", lens}},
                               {{"type", "orthographic"}, {"orthographic", lens}}};
    const SceneData scene = import();
    for (const Camera& camera : scene.cameras) {
        EXPECT_EQ(camera.z_near, 0.5f);
        EXPECT_EQ(camera.z_far, 100);
    }
    expect_warning(scene, "/cameras/0/perspective/znear", "(and at 1 more place)");
}

TEST_F(NodeImport, ImpossibleAnglesOfViewAreTheDefault) {
    for (const double angle : {0.0, -1.0, 3.3}) {
        builder.json["cameras"] = {
            {{"type", "perspective"}, {"perspective", {{"yfov", angle}, {"znear", 1}}}}};
        const SceneData scene = import();
        EXPECT_EQ(scene.cameras.at(0).y_fov, Camera().y_fov);
        expect_warning(scene, "/cameras/0/perspective/yfov");
    }
}

TEST_F(NodeImport, Lights) {
    builder.json["extensionsRequired"] = {"KHR_lights_punctual"};
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 100000}},
        {{"type", "point"}, {"color", {1, 0.5, 0}}, {"intensity", 40}, {"range", 10}},
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}},
        {{"type", "spot"}, {"spot", json::object()}},
        {{"type", "spot"}}};
    builder.json["nodes"] = {{{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}}};
    const SceneData scene = import();
    ASSERT_EQ(scene.lights.size(), 5u);
    EXPECT_EQ(scene.lights[0].type, LightType::directional);
    EXPECT_EQ(scene.lights[0].intensity, 100000);
    EXPECT_EQ(scene.lights[1].type, LightType::point);
    EXPECT_EQ(scene.lights[1].colour, vec3(1, 0.5f, 0));
    EXPECT_EQ(scene.lights[1].range, 10);
    EXPECT_EQ(scene.lights[2].type, LightType::spot);
    EXPECT_EQ(scene.lights[2].inner_cone, 0.2f);
    EXPECT_EQ(scene.lights[2].outer_cone, 0.4f);
    EXPECT_TRUE(std::isinf(scene.lights[2].range));
    EXPECT_FLOAT_EQ(scene.lights[3].outer_cone, kPi / 4);
    EXPECT_EQ(scene.lights[3].inner_cone, 0);
    EXPECT_EQ(scene.lights[4].outer_cone, scene.lights[3].outer_cone);
    EXPECT_EQ(scene.nodes.at(0).light, 1u);
    expect_warning(scene, "/extensions/KHR_lights_punctual/lights/4/spot",
                   "found nothing; the default angles are used");
}

TEST_F(NodeImport, ImpossibleLightsAreMended) {
    builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "point"}, {"intensity", -1}},
        {{"type", "point"}, {"range", 0}},
        {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 0.4}}}},
        {{"type", "spot"}, {"spot", {{"outerConeAngle", 3}}}},
        {{"type", "area"}}};
    const SceneData scene = import();
    EXPECT_EQ(scene.warnings.size(), 5u) << testing::PrintToString(scene.warnings);
    EXPECT_EQ(scene.lights.at(0).intensity, 0);
    EXPECT_EQ(scene.lights.at(4).intensity, 0);
}

TEST_F(NodeImport, DanglingReferencesAreRefused) {
    builder.json["nodes"] = {{{"mesh", 0}}};
    expect_refused("/nodes/0/mesh", "there are no meshes");
    builder.json["nodes"] = {{{"camera", 3}}};
    expect_refused("/nodes/0/camera");
    builder.json["nodes"] = {{{"children", {5}}}};
    expect_refused("/nodes/0/children/0", "found 5, expected an index below 1");
    builder.json["nodes"] = {{{"children", {-1}}}};
    expect_refused("/nodes/0/children/0", "found -1");
    builder.json["nodes"] = {{{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}}};
    expect_refused("/nodes/0/extensions/KHR_lights_punctual/light", "0 (the number of lights)");
    builder.json["nodes"] = {json::object()};
    builder.json["scene"] = 0;
    expect_refused("/scene", "there are no scenes");
}

TEST_F(NodeImport, IntegersMayBeWrittenAsFloats) {
    builder.add_triangle();
    builder.json["nodes"][0]["mesh"] = 0.0;
    EXPECT_EQ(import().triangle_count(), 1u);
    builder.json["nodes"][0]["mesh"] = 0.5;
    expect_refused("/nodes/0/mesh", "found 0.5");
}

}  // namespace
}  // namespace lanthorn
