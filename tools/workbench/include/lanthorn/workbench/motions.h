// Scenes in which one thing moves, frame by frame, for measurements of light in motion. With the last frame
// everything stands where the scene has it, so that one reference serves most motions.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lanthorn/runtime/shown_scene.h"

namespace lanthorn::workbench {

class DimmedLights;
class MovedNodes;

// What moves in a MovingScene.
enum class Motion {
    rest,      // nothing moves
    lamp,      // all punctual lights (without any, all emissive meshes) move; directional ones turn
    dim,       // the first of them grows dimmer
    walk,      // the camera moves sideways
    pan,       // the camera turns about its own upright
    cut,       // as `lamp`, seen from behind, until the camera turns round at once for the last frame
    box,       // a box that is put into the scene moves
    box_rest,  // it stands
    figure,    // the scene's animation plays
};
// By their place in Motion; box_rest is no motion of its own.
inline constexpr std::array<std::string_view, 9> kMotionNames = {"rest", "lamp", "dim",  "walk",  "pan",
                                                                 "cut",  "box",  "rest", "figure"};
// Its name there.
std::string name_of(Motion motion);
// The motion of that name, `rest` for "rest". Throws InputError, which lists the names, for another.
Motion motion_named(std::string_view name);

// A frame of each motion.
inline constexpr double kLampStep = 0.02;        // metres
inline constexpr double kLampTurn = 0.01;        // radians
inline constexpr double kDimStep = 0.02;         // share of the strength
inline constexpr double kWalkStep = 0.02;        // metres
inline constexpr double kPanStep = 0.01;         // radians
inline constexpr double kBoxStep = 0.03;         // metres
inline constexpr double kFigureStep = 1.0 / 60;  // seconds
inline constexpr float kBoxSide = 0.3f;          // metres; less in small scenes

// An upright grey cube that a measurement puts into a scene: matte, Lambertian.
struct PlacedBox {
    dvec3 centre{0};  // metres, the scene's own
    double side = 0;  // metres, more than 0
};
// Adds it as a node.
void place_box(SceneData& scene, const PlacedBox& box);

// A straight way that ends where it began: from there to `reach` metres away and back, again and again. As
// long as what is travelled is shorter than `reach`, the way is straight to its end.
struct Swing {
    dvec3 direction{0};  // unit, world
    double reach = 0;    // metres; 0: there is no room

    // Where one is who has `travelled` metres still to go, relative to the end.
    dvec3 before_end(double travelled) const;
};

// A scene in which one motion takes place.
class MovingScene {
  public:
    // A copy of `scene` at choice.time (default: 0). Lamps, camera and box keep clear of what is in their
    // way: they swing where there is no room to come from afar. Throws as ShownScene. `frames`: the last
    // frame's number.
    MovingScene(const SceneData& scene, const SceneChoice& choice, Motion motion, int frames);
    ~MovingScene();

    // Why the scene has no such motion; empty: it has.
    const std::string& lacking() const { return lacking_; }
    // The App that shows it, for settings, plugins and pictures.
    ShownScene& shown() { return *shown_; }
    // Shows frame 0..frames; in order.
    const FrameScene& show(int frame);
    // Metres that what moves comes from; 0 for turns and what does not move from its place.
    double reach() const { return swing_.reach; }
    const Aabb& box() const { return box_; }  // of motions with a box, in the end; render space
    // The same, as place_box() puts it into a copy of the scene, which then shows what the last frame does.
    const std::optional<PlacedBox>& placed_box() const { return placed_; }

  private:
    void prepare_lamp();
    void prepare_dim();
    void prepare_walk();
    // Of a scene without the box that `shown_` shows.
    void prepare_box(const SceneData& scene, const SceneChoice& choice);
    void look(int left);

    Motion motion_;
    int frames_;
    double time_;
    std::string lacking_;
    std::unique_ptr<ShownScene> shown_;
    CameraView camera_;
    Swing swing_;
    Aabb box_;
    std::optional<PlacedBox> placed_;
    std::unique_ptr<MovedNodes> moved_;
    std::unique_ptr<DimmedLights> dimmed_;
};

}  // namespace lanthorn::workbench
