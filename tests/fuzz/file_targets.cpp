// The targets of lanthorn_fuzz: files.
#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "engine/replay/recording_format.h"
#include "gi_module/reference/checkpoint.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/settings.h"
#include "lanthorn/workbench/flip.h"
#include "lanthorn/workbench/hdr_flip.h"
#include "lanthorn/workbench/metrics.h"
#include "lanthorn/workbench/ssim.h"
#include "tests/fuzz/gltf_target.h"
#include "tests/fuzz/reading.h"
#include "tests/fuzz/sealed.h"
#include "tests/fuzz/target.h"
#include "tests/unit/assets/image_files.h"
#include "tests/unit/tools/run_program.h"

namespace lanthorn::fuzz {

namespace {

// --- recording: as it is, and with right checksums

replay::Recording decoded(std::string_view bytes) {
    return replay::decoded_recording("session.rec", std::as_bytes(std::span(bytes.data(), bytes.size())));
}

void read_recording(std::string_view input) {
    expect_refused_or_read([&] { decoded(input); });
    expect_refused_or_read([&] {
        const replay::Recording once = decoded(sealed_recording(input));
        const replay::Recording again = decoded(replay::encoded_recording(once));
        // Readings may be NaN, which equals nothing: sizes and the rest.
        if (again.header != once.header || again.steps.size() != once.steps.size() ||
            again.annotations.states != once.annotations.states) {
            throw Finding("a recording that was written again differs");
        }
    });
}

std::vector<std::string> recordings() {
    replay::Recording recording;
    recording.header = {"room.glb",           7,      1,      60, "a build", "lamplighter-1", 4,
                        {"world", "physics"}, {3, 4}, {"eye"}};
    std::vector<std::uint64_t> before;
    for (int i = 0; i < 3; ++i) {
        replay::RecordedStep step{std::vector<std::byte>(4, std::byte(i)), {{0, 1, 0.5f}}};
        replay::mark_state(std::vector<std::uint64_t>{11, 12u + static_cast<unsigned>(i)}, before, step);
        recording.steps.push_back(step);
    }
    replay::Annotations& said = recording.annotations;
    said.marks = {{2, "door", "", "", ""}};
    said.expectations = {"solved"};
    said.notes = {"a note"};
    said.states = {{2, "state"}};
    said.line = {{"a build", "a reason", {1, 2}}};
    const std::string whole =
        replay::encoded_beginning(recording.header) + replay::encoded_annotations(said) +
        replay::encoded_steps(recording.header, 0, std::span(recording.steps).first(2)) +
        replay::encoded_steps(recording.header, 2, std::span(recording.steps).last(1));
    return {whole + replay::encoded_end(3), whole, replay::encoded_recording(recording)};
}

// --- settings: a file, else KEY=VALUE lines

enum class Way { march, secant };

const SettingsSchema& schema() {
    static const SettingsSchema& one = [&]() -> const SettingsSchema& {
        static SettingsSchema s;
        s.declare<int>("gi.maps")
            .unit("maps")
            .range(1, 64)
            .initially(8)
            .presets({4, 8, 8, 16})
            .cost("linear")
            .docs("maps");
        s.declare<float>("gi.limit").unit("s").range(0, 1e6f).initially(0.1f).cost("none").docs("seconds");
        s.declare<bool>("gi.exhaustive")
            .initially(false)
            .presets({false, false, true, true})
            .cost("twice")
            .docs("ask all");
        s.declare<Way>("gi.way").choices({"march", "secant"}).initially(Way::march).cost("half").docs("how");
        return s;
    }();
    return one;
}

void read_settings(std::string_view input) {
    expect_refused_or_read([&] {
        Settings settings(schema());
        settings.load_json(input, "settings.json");
        Settings again(schema());
        again.load_json(settings.to_json(), "again.json");
        for (const SettingInfo& info : schema().all()) {
            if (again.text(info.name) != settings.text(info.name)) {
                throw Finding(info.name + " is " + again.text(info.name) + " after writing and reading " +
                              settings.text(info.name));
            }
        }
    });
    for (std::size_t at = 0; at < input.size();) {
        const std::size_t end = std::min(input.find('\n', at), input.size());
        expect_refused_or_read([&] { Settings(schema()).set_from_text(input.substr(at, end - at)); });
        at = end + 1;
    }
}

std::vector<std::string> settings_inputs() {
    return {R"({"gi.maps": 12, "gi.limit": 0.25, "gi.exhaustive": true, "gi.way": "secant"})",
            "gi.maps=3\ngi.limit=1e3\ngi.exhaustive=false\ngi.way=march\n"};
}

// --- checkpoint

constexpr reference::CheckpointHeader kCheckpoint = {5, 2, 2, 4, 3, 0, 0, 0, 2, 0};

void read_checkpoint_bytes(const std::string& bytes) {
    const auto path = write_input("path.checkpoint", bytes);
    std::array<reference::Film, 2> films = {reference::Film({2, 2}), reference::Film({2, 2})};
    expect_refused_or_read([&] {
        reference::read_checkpoint(path, kCheckpoint, films);
        for (const reference::Film& film : films) {
            film.mean();
            film.noise();
        }
    });
}

void read_checkpoint_input(std::string_view input) {
    read_checkpoint_bytes(std::string(input));
    read_checkpoint_bytes(sealed_checkpoint(input));
}

std::vector<std::string> checkpoints() {
    std::array<reference::Film, 2> films = {reference::Film({2, 2}), reference::Film({2, 2})};
    for (std::uint32_t sample = 0; sample < 4; ++sample) {
        films[0].add(sample, sample, vec3(1, 0.5f, 0.25f));
    }
    const auto path = folder() / "seed.checkpoint";
    reference::write_checkpoint(path, kCheckpoint, films);
    return {testing_tools::file_bytes(path)};
}

// --- image: read, and compared with itself in black and white

constexpr int kMostCompared = 64;  // pixels a side

// By content, but for formats that have no signature.
const char* image_name(std::string_view bytes) {
    return bytes.starts_with("\x89PNG") ? "image.png" : "image.tga";
}

void compare_image(std::string_view input) {
    const auto path = write_input(image_name(input), input);
    expect_refused_or_read([&] {
        const ImageF image = read_image(path);
        if (image.pixels.size() != static_cast<std::size_t>(image.width) * image.height * image.channels) {
            throw Finding("an image with more or fewer values than pixels");
        }
        if (image.width > kMostCompared || image.height > kMostCompared) {
            return;
        }
        ImageF reference = image;
        for (float& value : reference.pixels) {
            value = 0.5f * value + 0.25f;
        }
        const auto c = workbench::compare(image, reference, "image", "reference");
        workbench::ssim(image, reference, c.peak, c.valid);
        // As `lanthorn compare` does: what each is for.
        const auto all_in = [&](float low, float high) {
            return std::ranges::all_of(image.pixels, [&](float v) { return v >= low && v <= high; });
        };
        if (image.channels >= 3 && all_in(0, 1)) {
            workbench::flip(image, reference, workbench::Encoding::srgb);
        }
        if (image.channels >= 3 && all_in(0, std::numeric_limits<float>::max())) {
            workbench::hdr_flip(image, reference);
        }
    });
}

std::vector<std::string> images() {
    ImageF image;
    image.width = 12;
    image.height = 9;
    image.channels = 3;
    for (int i = 0; i < 12 * 9 * 3; ++i) {
        image.pixels.push_back(static_cast<float>(i % 37) / 37);
    }
    image.metadata["scene"] = "1234";
    std::vector<std::string> inputs;
    for (const char* name :
         {"seed.png", "seed.exr", "seed.hdr", "seed.tif", "seed.bmp", "seed.tga", "seed.dpx"}) {
        write_image(folder() / name, image);
        inputs.push_back(testing_tools::file_bytes(folder() / name));
    }
    const std::vector<std::uint8_t> texels(12 * 9 * 3, 77);
    inputs.push_back(make_jpeg(12, 9, texels, 3));
    inputs.push_back(make_jpeg(12, 9, texels, 3, JpegKind::progressive));
    inputs.push_back(make_webp(12, 9, texels));
    return inputs;
}

}  // namespace

std::span<const Target> targets() {
    static constexpr std::array kTargets = {
        Target{"gltf", "glTF files: import, invariants, animation, deformation", read_gltf, gltf_inputs,
               damage_gltf},
        Target{"recording", "recorded sessions, checksums made right", read_recording, recordings, nullptr},
        Target{"settings", "settings files and KEY=VALUE", read_settings, settings_inputs, nullptr},
        Target{"checkpoint", "checkpoints of the path tracer, checksums made right", read_checkpoint_input,
               checkpoints, nullptr},
        Target{"image", "images of every format, read and compared", compare_image, images, nullptr}};
    return kTargets;
}

}  // namespace lanthorn::fuzz
