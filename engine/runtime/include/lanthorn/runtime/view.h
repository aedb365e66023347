// What a picture shows. Every App has a view; programs that show the world several times at once (panes of an
// editor, a picture in a picture, one technique beside another) add more.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "lanthorn/core/math.h"
#include "lanthorn/ecs/entity.h"
#include "lanthorn/render/lines.h"
#include "lanthorn/render/render_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn {

// Of a view of an App. One that was removed is not given again.
enum class ViewId : std::uint32_t { first = 0 };

// A resource of every App is the first one, App::view(). Altered between frames.
//
// Precision. All views share FrameScene::origin, which follows the scene and no camera. What a view shows is
// computed relative to its own camera, whose position is a float relative to the origin: it is exact to 2^-24
// of the distance between them (0.06 mm at 1 km, 6 mm at 100 km), however far away other views are.
struct View {
    ivec2 size{512, 512};  // pixels; one of them 0 or less: the view is not drawn
    // With a CameraComponent and a WorldTransform; null: a camera that sees everything.
    ecs::Entity camera = ecs::kNullEntity;
    // Instead of the entity: in the render space of the FrameScene before (FrameScene::origin).
    std::optional<CameraView> placed = {};
    // Radians: the angle of view that the picture has upwards, in place of the camera's own.
    std::optional<float> y_fov = {};
    // As error messages and times of passes call it; empty: "view 2", by its id.
    std::string name = {};
    // Null: the resource render::RenderSettings. Views whose settings ask the same of light maps (shadows,
    // area lights, detail) share them; others have sets of their own.
    std::optional<render::RenderSettings> settings = {};
    // Over its picture, with those of the resource render::Lines.
    render::Lines lines = {};
    // Pixels of the picture that render.upscale makes of it; 0: as many as `size`.
    ivec2 whole{0};
    // Of views beside the first: it is not drawn, and all that was kept for it waits (its textures, its
    // technique's maps). When it is drawn again it goes on from there, told what has changed meanwhile;
    // where things came or went, or assets changed, it starts without history.
    bool rests = false;
    // Of views beside the first: its picture is exposed as that one's, which is drawn before it.
    std::optional<ViewId> exposed_as = {};

    bool is_drawn() const { return size.x > 0 && size.y > 0 && !rests; }  // has a size of 1 by 1 or more
};

// The views beside the first: a resource of every App, altered by App::add_view and App::remove_view.
class Views {
  public:
    // Returns its id, which no view had before.
    ViewId add(View view);
    // Null where there is none of that id.
    View* find(ViewId id);
    // The same to read.
    const View* find(ViewId id) const;
    bool remove(ViewId id);  // returns whether it was there
    // In the order in which they were added, which is the order that they are drawn in.
    const std::map<ViewId, View>& all() const { return views_; }

  private:
    std::map<ViewId, View> views_;
    std::uint32_t next_ = 1;
};

// As error messages call it: "view 'left'" or "view 2".
std::string described_view(ViewId id, const View& view);

}  // namespace lanthorn
