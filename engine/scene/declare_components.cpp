#include "engine/scene/declare_components.h"

#include <limits>

#include "engine/scene/clear_sky.h"
#include "lanthorn/scene/components.h"
#include "lanthorn/scene/light_sensor.h"

namespace lanthorn {
namespace {

using ecs::field;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostValue = std::numeric_limits<double>::max();

void declare_transforms(ecs::Registry& registry) {
    registry.structure("transform",
                       field("translation", &Transform::translation).unit("m").words("from the parent"),
                       field("rotation", &Transform::rotation).words("a unit quaternion"),
                       field("scale", &Transform::scale).words("along the node's own axes"));
    registry
        .component<LocalTransform>("local_transform", "where it is, relative to its parent",
                                   field("value", &LocalTransform::value).flat())
        .not_in_extras();
    registry
        .component<Shear>("shear", "what a matrix has beyond translation, rotation and scale",
                          field("value", &Shear::value))
        .not_in_extras();
    registry.component<Parent>("parent", "what it is fixed to", field("entity", &Parent::entity))
        .not_in_extras();
    registry
        .component<Children>("children", "what is fixed to it, in order",
                             field("entities", &Children::entities))
        .derived()
        .runtime()
        .not_in_extras();
    registry
        .component<WorldTransform>("world_transform", "object to world space, derived from local_transform",
                                   field("matrix", &WorldTransform::matrix))
        .transient()
        .runtime()
        .not_in_extras();
}

void declare_looks(ecs::Registry& registry) {
    registry.opaque_component<MeshInstances>("mesh_instances", "the meshes that are drawn there");
    registry.opaque_component<Source>("source", "the file and the node that it came from");
    registry.opaque_component<DeformedMeshes>("deformed_meshes", "what deformation made of the meshes")
        .runtime();
    registry
        .component<SkinInstance>("skin_instance", "the joints that pose its skinned meshes",
                                 field("joints", &SkinInstance::joints),
                                 field("inverse_binds", &SkinInstance::inverse_binds).transient())
        .not_in_extras();
    registry
        .component<MorphWeights>("morph_weights", "how much of each morph target there is",
                                 field("weights", &MorphWeights::weights))
        .not_in_extras();
    registry
        .component<AnimationSet>("animation_set", "the clips of its file, and what they move",
                                 field("clips", &AnimationSet::clips).opaque(),
                                 field("nodes", &AnimationSet::nodes))
        .not_in_extras();
}

void declare_light(ecs::Registry& registry) {
    registry.structure(
        "light_data", field("type", &Light::type).choices({"directional", "point", "spot"}),
        field("colour", &Light::colour).range(0, kMostValue).words("linear RGB"),
        field("intensity", &Light::intensity).unit("cd").range(0, kMostValue).words("lux if directional"),
        field("range", &Light::range).unit("m").range(0, kInfinity).words("where it is cut off"),
        field("inner_cone", &Light::inner_cone).unit("rad").range(0, 1.5708).words("less than the outer"),
        field("outer_cone", &Light::outer_cone).unit("rad").range(0, 1.5708).words("of a spot light"));
    registry
        .component<LightComponent>("light", "a lamp that shines along its node's -Z",
                                   field("light", &LightComponent::light).flat())
        .not_in_extras();
    registry.structure("sky_data", field("image", &Sky::image).opaque(), field("light", &Sky::light).opaque(),
                       field("colour", &Sky::colour).range(0, kMostValue).words("a factor, linear RGB"),
                       field("intensity", &Sky::intensity).range(0, kMostValue).words("a factor"));
    registry
        .component<SkyComponent>("sky", "light from far away all around, turned with its node",
                                 field("sky", &SkyComponent::sky).flat())
        .not_in_extras();
    registry.component<ClearSky>("clear_sky",
                                 "the sky of a clear day about the sun that its node's directional light is",
                                 field("turbidity", &ClearSky::turbidity).range(2, 10).words("clear to hazy"),
                                 field("intensity", &ClearSky::intensity)
                                     .range(0, kMostValue)
                                     .words("a factor; 1: as that day's beside its sun"));
    registry.structure(
        "camera_data", field("orthographic", &Camera::orthographic),
        field("y_fov", &Camera::y_fov).unit("rad").more_than(0, 3.1416).words("of a perspective camera"),
        field("x_mag", &Camera::x_mag).unit("m").words("half width of an orthographic one"),
        field("y_mag", &Camera::y_mag).unit("m").words("half height of an orthographic one"),
        field("z_near", &Camera::z_near).unit("m").range(0, kMostValue),
        field("z_far", &Camera::z_far).unit("m").range(0, kMostValue).words("0: infinite"));
    registry
        .component<CameraComponent>("camera", "looks along its node's -Z",
                                    field("camera", &CameraComponent::camera).flat())
        .not_in_extras();
    registry.component<LightSensor>(
        "light_sensor", "measures the light on a disc at its place, on the side that its -Z looks to",
        field("radius", &LightSensor::radius).unit("m").more_than(0, 100).words("of the disc"),
        field("filter", &LightSensor::filter)
            .range(-1000, 1000)
            .words("weights of red, green and blue; the luminance where it is left out"),
        field("lux", &LightSensor::lux).unit("lux").runtime().words("the last reading, through the filter"),
        field("readings", &LightSensor::readings).runtime().words("how many there were"));
    registry.component<LightContract>(
        "light_contract",
        "how bright it is to be in a box around its node, or what the sensor beside it is to read; nothing "
        "reads it "
        "but the editor and `lanthorn measure contracts`",
        field("lower", &LightContract::lower).unit("lux").range(0, kMostValue).words("at least"),
        field("upper", &LightContract::upper).unit("lux").range(0, kMostValue).words("at most; 0: no limit"),
        field("size", &LightContract::size)
            .unit("m")
            .range(0, kMostValue)
            .words("of the box, along the node's axes"),
        field("share", &LightContract::share).range(0, 1).words("of the surfaces' area that must be within"));
}

}  // namespace

void declare_scene_components(ecs::Registry& registry) {
    registry.component<Name>("name", "what people call it", field("value", &Name::value)).not_in_extras();
    declare_transforms(registry);
    declare_looks(registry);
    declare_light(registry);
    registry
        .component<Extras>("extras", "what the file says besides, as JSON text",
                           field("json", &Extras::json).transient())
        .not_in_extras();
}

}  // namespace lanthorn
