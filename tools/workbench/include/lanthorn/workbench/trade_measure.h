// One point of the speed-for-accuracy chart, measured: runs in a process of its own.
#pragma once

#include <string>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/render/frame.h"
#include "lanthorn/workbench/load_scene.h"
#include "lanthorn/workbench/trade_point.h"

namespace lanthorn::workbench {

// Path-traced images; of one size.
struct TradeReferences {
    std::string same;   // EXR: indirect, with as many bounces as the point has
    std::string all;    // EXR: indirect, all bounces
    std::string final;  // EXR: the picture, all bounces
};

// How each point is measured.
struct TradeMeasurement {
    ivec2 size{512, 512};
    SceneView view;  // `time`: of the animation, which stands still, or begins to play
    int frames = 15, warmup = 3;
};

// What the last frame shows, which is compared.
struct LastView {
    SceneView view;
    std::string lacking;  // why the scene has no such motion, in words for an error; empty: it has
};
// Looks for room where the motion needs some. Throws as load_scene().
LastView last_view(const ListedScene& scene, TradeMotion motion, const TradeMeasurement& job);

// What a technique showed and how long it took; the errors are not known yet.
struct TradeView {
    TradeFigures figures;
    ImageF indirect, final;
};

// Renders the point: whole frames of an App, in which its motion takes place. TradeMotion::light: geometry
// stands still and light changes in each frame, so that all techniques light it anew: punctual lights that
// carry no geometry move by 0.002 of the scene's diagonal, so that their shadow maps are drawn anew too and
// old light is wrong; with the last frame, which is compared, they come to where the scene has them. Without
// any, all light is altered by its last bit. Techniques that keep light or hits of frames before are shown
// with what they have kept. Path points are timed once, for their indirect light alone. Throws what
// render_scene() does.
TradeView view_point(const TradePoint& point, const TradeMeasurement& job, const SettingsSchema& schema);

// The errors of `view`, into its figures. The references' own noise is uncorrelated with the image's error,
// so its square is taken off that of relRMSE. Throws InputError for references that do not fit.
void compare_with_references(TradeView& view, const TradeReferences& references);

// The picture, display-encoded, and beside it its relative error against `reference` (EXR, indirect), each
// `width` pixels wide, colours from black (none) over purple and orange to white (the mean or more).
ImageF picture_of(const TradeView& view, const std::string& reference, int width);

}  // namespace lanthorn::workbench
