// `path`: a progressive path tracer (Kajiya 1986) on Embree, the reference that techniques are measured by.
//
//   PathTracer tracer(frame, {512, 512}, settings, {.indirect = true});
//   tracer.render({});
//   std::vector<float> lux = tracer.image(PathAov::indirect);
//
// Needs no OpenGL. The image is a pure function of scene, size, settings and number of samples: any number of
// threads, and any number of interruptions, give the same bits.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "lanthorn/reference/path_settings.h"
#include "lanthorn/scene/frame_scene.h"

namespace lanthorn::reference {

struct RayLog;

// The rasteriser's AOVs. Three channels, but for depth.
enum class PathAov {
    indirect,  // lux: irradiance at the first visible surface, albedo not applied
    direct,    // nits
    radiance,  // nits; unlit surfaces: their colour
    albedo,    // diffuse albedo
    normal,    // shading normal, render space
    depth,     // one channel: metres from the camera's position (orthographic: its plane); 0: background
};

// Which of the sampled AOVs to estimate; the others (albedo, normal, depth) are always there.
struct PathParts {
    bool indirect = false;
    bool direct = false;
    bool radiance = false;
};

// How far a rendering is.
struct PathProgress {
    int spp = 0;         // samples a pixel so far
    double seconds = 0;  // of render() so far
    double share = 0;    // 0..1 of what the nearest stop criterion asks for
    double noise = 0;    // the largest of the images', as last estimated; infinite before
};

// Who is told of a rendering's progress and may stop it.
struct PathControl {
    // Called between passes from the calling thread; false: stop and keep what is done. May be empty.
    std::function<bool(const PathProgress&)> progress;
};

// A part of a picture that another process can trace: some samples of some rows.
struct PathPiece {
    int first = 0, samples = 0;  // the number of the first sample, and how many; at most a block of Film's
    int top = 0, rows = 0;       // from the top
};
// A picture of `spp` samples a pixel in pieces, in the order in which they are added up: blocks of samples,
// each in `bands` bands of about as many rows (at least one, at most the picture's height).
std::vector<PathPiece> path_pieces(ivec2 size, int spp, int bands);

class PathTracer {
  public:
    // `scene` must outlive this. The settings are settled() for a picture if `parts` has radiance. Throws
    // InputError for what Embree cannot hold.
    PathTracer(const FrameScene& scene, ivec2 size, const PathSettings& settings, PathParts parts);
    ~PathTracer();

    // Traces until a stop criterion of the settings holds: path.spp, path.time_limit or path.target_noise. At
    // least one sample a pixel unless progress() refuses; continues where it or resume() left off. O(pixels *
    // spp * bounces * log triangles).
    PathProgress render(const PathControl& control);

    // Rows from the top. Of indirect, direct and radiance only what was asked for.
    std::vector<float> image(PathAov aov) const;
    // Estimated relRMSE of such an image against the truth, by its two halves; see Film::noise().
    double noise(PathAov aov) const;
    // By pixel: 0 background, 1 lit, 2 unlit.
    std::vector<float> coverage() const;

    int spp() const;                  // samples a pixel so far, with those that resume() brought
    std::uint64_t nan_count() const;  // samples that were NaN or infinite and are left out
    // What a reader of the image should know of it, for its metadata.
    std::vector<std::pair<std::string, std::string>> description(PathAov aov) const;

    // Writes all sums to a file, whole or not at all.
    void save(const std::filesystem::path& checkpoint) const;
    // Goes on from what save() wrote: its sums and samples replace those here. Throws InputError, naming the
    // file, if it is damaged or of another scene, camera, size or setting; then nothing has changed.
    void resume(const std::filesystem::path& checkpoint);

    // Traces a piece alone, in place of what was here, and writes its sums to a file, whole or not at all.
    // False, and no file, if progress() refuses; it is told the piece's samples.
    bool trace_piece(const PathPiece& piece, const std::filesystem::path& file, const PathControl& control);
    // Adds up what trace_piece() wrote, in place of what was here: the bits are those that render() has.
    // `pieces`: all of path_pieces(), `files` one each. Throws InputError as resume(), and then what is here
    // is of no picture.
    void add_up(const std::vector<PathPiece>& pieces, const std::vector<std::filesystem::path>& files);
    // Whether a file is one that trace_piece() wrote for this scene, camera, size and settings.
    bool has_piece(const PathPiece& piece, const std::filesystem::path& file) const;

    // The rays of the next sample of all pixels, path after path; the sample does not count.
    RayLog log_rays();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lanthorn::reference
