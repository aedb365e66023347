// App: a world, its resources and two schedules, to which plugins add named systems. It has no logic itself.
//
//   App app;
//   app.add<ScenePlugin>().add<AnimationPlugin>();
//   spawn(app.world(), import_gltf("scene.glb"));
//   app.fixed_schedule().add("drift", drift).in("gameplay");
//   app.frame(1.0 / 144);   // the steps that are due, then a picture between the last two
//
// fixed_schedule() is the simulation, 1/60 s a run; what it makes is a function of what is in the world,
// whether frames are shown or not, at any rate. frame_schedule() makes a picture of it.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lanthorn/ecs/registry.h"
#include "lanthorn/ecs/schedule.h"
#include "lanthorn/ecs/world.h"
#include "lanthorn/runtime/plugin.h"
#include "lanthorn/runtime/time.h"
#include "lanthorn/runtime/view.h"

namespace lanthorn {

class App {
  public:
    App();
    App(const App&) = delete;
    App& operator=(const App&) = delete;
    ~App();

    ecs::World& world() { return world_; }              // entities, resources and events
    const ecs::World& world() const { return world_; }  // the same to read
    // What the plugins' components are: fields, units, ranges; from it come JSON, extras, hashes and
    // snapshots.
    ecs::Registry& registry() { return registry_; }
    const ecs::Registry& registry() const { return registry_; }   // the same to read
    ecs::Schedule& fixed_schedule() { return fixed_; }            // of fixed steps; plugins add systems to it
    ecs::Schedule& frame_schedule() { return frame_; }            // of frames; plugins add systems to it
    const Time& time() const { return world_.resource<Time>(); }  // steps done and the picture's moment

    // The first view, which is always there.
    View& view() { return world_.resource_mut<View>(); }
    // Another view of the same world, with a size, camera and settings of its own, drawn from the next frame
    // on. What precedes the FrameScene runs once a frame however many there are, and so do upload and light
    // maps; what follows (G-buffer, direct and indirect light, composite) once a view.
    ViewId add_view(View view);
    // Holds until it is removed. Throws Error where there is none of that id.
    View& view(ViewId id);
    // Its GPU memory is freed by the next frame. Throws Error for the first view and where there is none.
    void remove_view(ViewId id);
    // The first, then in the order in which they were added.
    std::vector<ViewId> views() const;

    // Throws Error for a plugin of a name that is there already.
    App& add(std::unique_ptr<Plugin> plugin);
    // The same of a P made from `args`.
    template <class P, class... Args>
    App& add(Args&&... args) {
        return add(std::make_unique<P>(std::forward<Args>(args)...));
    }
    bool has(std::string_view plugin) const;  // whether one of that name was added

    // One fixed step. The picture's moment is its end.
    void step();
    // The picture's moment moves on by `seconds` (0 or more): the fixed steps that are due, then the frame
    // schedule. After more than `most_steps` the moment waits instead: slow motion rather than frames that
    // take ever longer.
    void frame(double seconds, int most_steps = 8);
    // The frame schedule alone, at the present moment.
    void show() { frame_.run(world_); }
    // The same as frame() up to a moment in seconds since the start, however many steps that takes. Throws
    // Error for one before the present one.
    void show_at(double moment);
    // Moves on to a moment without simulating what is between, for a world in which nothing is simulated.
    // Throws Error for one before the present one.
    void skip_to(double moment);

    // Of both schedules; 1: everything on the calling thread, 0 (default): as many as oneTBB has.
    void set_threads(int threads);

    // Both schedules in Graphviz's language, one graph each.
    std::string schedule_dot();

  private:
    void check_moment(double moment) const;
    void move_to(double moment);

    ecs::Registry registry_;
    ecs::World world_;
    ecs::Schedule fixed_{"fixed"}, frame_{"frame"};
    std::vector<std::unique_ptr<Plugin>> plugins_;
};

}  // namespace lanthorn
