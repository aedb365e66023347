#include "tools/lanthorn/replay/pictures/picture_check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/build_info/build_info.h"
#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/error.h"
#include "lanthorn/workbench/flip.h"
#include "lanthorn/workbench/metrics.h"
#include "tools/lanthorn/replay/pictures/picture_difference.h"
#include "tools/replay_suite/files.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;

bool all_finite(const ImageF& image) {
    return std::ranges::all_of(image.pixels, [](float v) { return std::isfinite(v); });
}

// One recording's marks.
class Checker {
  public:
    Checker(const MarkArtist& artist, const std::string& file, const PictureChoice& choice)
        : artist_(artist), file_(file), choice_(choice) {}

    PictureVerdict picture(const MarkedMoment& at) const;
    PictureVerdict light(const MarkedMoment& at, PictureVerdict verdict) const;

  private:
    // What a fault that is asked for is made of; found once a mark.
    FaultTargets targets_of(const MarkedMoment& at, const MarkView& view) const {
        return choice_.fault ? fault_targets(artist_, at, view) : FaultTargets();
    }
    // Makes the fault in a world that is to be drawn.
    std::function<void(App&)> faulty(const FaultTargets& targets) const {
        return [this, &targets](App& app) {
            if (choice_.fault) {
                make_fault(*choice_.fault, targets, app);
            }
        };
    }
    MarkPicture drawn(const MarkedMoment& at, const MarkView& view, const FaultTargets& targets) const;
    std::string judged(const MarkedMoment& at, const Baseline& baseline, MarkView view,
                       const FaultTargets& targets, const MarkPicture& first, PictureVerdict& verdict) const;
    LightError error(const MarkedMoment& at, const MarkView& view, const FaultTargets& targets,
                     const workbench::ReferencePair& truth) const;
    void write(const std::string& mark, const ImageF& actual, const Baseline* expected,
               PictureVerdict& verdict) const;

    const MarkArtist& artist_;
    const std::string& file_;
    const PictureChoice& choice_;
};

MarkPicture Checker::drawn(const MarkedMoment& at, const MarkView& view, const FaultTargets& targets) const {
    return choice_.fault ? draw_with_fault(artist_, at, view, *choice_.fault, targets)
                         : artist_.draw(at, view);
}

void Checker::write(const std::string& mark, const ImageF& actual, const Baseline* expected,
                    PictureVerdict& verdict) const {
    if (choice_.out.empty()) {
        return;
    }
    const fs::path folder = fs::path(choice_.out) / fs::path(file_).filename();
    suite::make_folder(folder);
    const auto keep = [&](const char* what, const ImageF& image) {
        const fs::path file = folder / fmt::format("{}-{}.png", mark, what);
        write_image(file, image);
        return file.string();
    };
    verdict.actual = keep("actual", actual);
    if (expected != nullptr) {
        verdict.expected = keep("expected", expected->shown);
        verdict.difference = keep("difference", workbench::heat_map(workbench::flip(actual, expected->shown),
                                                                    actual.width, actual.height));
    }
}

PictureVerdict Checker::picture(const MarkedMoment& at) const {
    PictureVerdict verdict{.mark = at.mark.name, .step = at.mark.step};
    const std::optional<Baseline> baseline = read_baseline(file_, at.mark.name);
    MarkView view = baseline ? baseline->view : MarkView();
    view.seed = choice_.seed.value_or(view.seed);
    const FaultTargets targets = targets_of(at, view);
    if (choice_.fault) {
        verdict.fault = fault_words(*choice_.fault, targets);
    }
    const MarkPicture now = drawn(at, view, targets);
    verdict.failed = true;
    if (now.nan_count > 0 || !all_finite(now.radiance)) {
        verdict.text = fmt::format("{} values are no numbers", std::max<std::uint64_t>(now.nan_count, 1));
        write(at.mark.name, now.shown, nullptr, verdict);
        return verdict;
    }
    if (!baseline) {
        verdict.text = fmt::format("no {}: `lanthorn replay accept` makes it",
                                   baseline_file(file_, at.mark.name).string());
        write(at.mark.name, now.shown, nullptr, verdict);
        return verdict;
    }
    if (equal_in_8_bits(now.shown, baseline->shown) &&
        picture_figures(now.shown, now.radiance).light == baseline->figures.at(0).light) {
        verdict.failed = false;
        verdict.text = "equal to the bit";
        return verdict;
    }
    const std::string wrong = judged(at, *baseline, view, targets, now, verdict);
    verdict.failed = !wrong.empty();
    if (verdict.failed) {
        verdict.text = wrong + "; " + verdict.text;
        write(at.mark.name, now.shown, &*baseline, verdict);
    }
    return verdict;
}

// What is wrong with a picture that is not equal; empty: nothing. Its text says how far it is.
std::string Checker::judged(const MarkedMoment& at, const Baseline& baseline, MarkView view,
                            const FaultTargets& targets, const MarkPicture& first,
                            PictureVerdict& verdict) const {
    const std::string name = baseline_file(file_, at.mark.name).string();
    const ImageF direct = artist_.direct(at, view, faulty(targets));
    const std::vector<double> direct_light = light_of_tiles(direct);
    const FigureDifference brighter =
        direct_difference(baseline.direct, direct_light, baseline.figures.at(0).columns, name);
    const PictureDifference found = picture_difference(first.shown, baseline.shown, name);
    verdict.flip = found.flip;
    if (std::abs(brighter.change) > kDirectLight) {
        verdict.text = difference_words(found);
        return fmt::format("{} {:+.1f} % in tile ({}, {})", brighter.figure, 100 * brighter.change,
                           brighter.x, brighter.y);
    }
    std::vector<PictureFigures> figures{picture_figures(first.shown, first.radiance)};
    PictureDifference floor;
    while (figures.size() < static_cast<std::size_t>(kSeeds)) {
        ++view.seed;
        const MarkPicture picture = drawn(at, view, targets);
        figures.push_back(picture_figures(picture.shown, picture.radiance));
        floor.widen(picture_difference(picture.shown, first.shown, name));
    }
    verdict.text = fmt::format("{} (other seeds: {}), direct light {:+.3f} % at most",
                               difference_words(found), difference_words(floor), 100 * brighter.change);
    const FigureDifference sure = sure_difference(baseline.figures, figures, name);
    if (!sure.figure.empty()) {
        return fmt::format(
            "{} {:+.1f} % {}, p {:.1g}", sure.figure, 100 * sure.change,
            sure.x < 0 ? std::string("on the whole") : fmt::format("in tile ({}, {})", sure.x, sure.y),
            sure.p);
    }
    const std::string beyond = found.beyond(floor);
    return beyond.empty() ? "" : beyond + " beyond the noise";
}

LightError Checker::error(const MarkedMoment& at, const MarkView& view, const FaultTargets& targets,
                          const workbench::ReferencePair& truth) const {
    return light_error(artist_.indirect(at, view, faulty(targets)), truth);
}

PictureVerdict Checker::light(const MarkedMoment& at, PictureVerdict verdict) const {
    const std::optional<Baseline> baseline = read_baseline(file_, at.mark.name);
    if (!baseline || baseline->errors.empty()) {
        verdict.light_failed = true;
        verdict.light = "no baseline of the error of light: `lanthorn replay accept` makes it";
        return verdict;
    }
    MarkView view = baseline->view;
    view.size = kLightSize;
    view.seed = choice_.seed.value_or(view.seed);
    const FaultTargets targets = targets_of(at, view);
    if (choice_.fault) {
        verdict.fault = fault_words(*choice_.fault, targets);
    }
    const workbench::ReferencePair truth = artist_.truth(at, view, kLightSpp);
    const LightComparison comparison = compare_until_sure(baseline->errors, [&] {
        const LightError found = error(at, view, targets, truth);
        ++view.seed;
        return found;
    });
    verdict.light_failed = comparison.verdict == LightVerdict::worse;
    verdict.light = fmt::format("{}: {}", verdict_word(comparison.verdict), light_words(comparison));
    return verdict;
}

Check check_of(const std::string& name, const std::vector<PictureVerdict>& pictures,
               bool PictureVerdict::*failed, std::string PictureVerdict::*text) {
    Check check{name, Check::Verdict::ok, ""};
    if (pictures.empty()) {
        return {name, Check::Verdict::none, "no marks: nothing to look at (pack --mark)"};
    }
    std::size_t bad = 0;
    for (const PictureVerdict& p : pictures) {
        if (p.*failed) {
            if (bad++ == 0) {
                check.text = fmt::format("'{}' (step {}) {}", p.mark, p.step, p.*text);
            }
        }
    }
    if (bad > 0) {
        check.verdict = Check::Verdict::failed;
        check.text = fmt::format("{} of {} marks: {}", bad, pictures.size(), check.text);
        return check;
    }
    const auto equal = std::ranges::count(pictures, std::string("equal to the bit"), &PictureVerdict::text);
    check.text = name == "pictures" ? fmt::format("{} marks, {} equal to the bit", pictures.size(), equal)
                                    : fmt::format("{} marks; '{}' {}", pictures.size(), pictures.front().mark,
                                                  pictures.front().*text);
    return check;
}

}  // namespace

std::vector<replay::Mark> chosen_marks(const std::string& file, const replay::Recording& recording,
                                       const std::vector<std::string>& names) {
    std::vector<replay::Mark> marks = recording.annotations.marks;
    for (const std::string& name : names) {
        if (std::ranges::find(marks, name, &replay::Mark::name) == marks.end()) {
            throw InputError(file, "mark", fmt::format("found none called '{}'", name));
        }
    }
    std::erase_if(marks, [&](const replay::Mark& mark) {
        return !names.empty() && std::ranges::find(names, mark.name) == names.end();
    });
    std::ranges::stable_sort(marks, {}, &replay::Mark::step);
    return marks;
}

PictureResults check_pictures(const std::shared_ptr<const LevelFile>& level, const std::string& file,
                              const std::shared_ptr<const replay::Recording>& recording,
                              const PictureChoice& choice, int threads) {
    std::vector<PictureVerdict> pictures;
    if (!choice.pictures && !choice.light) {
        return {};
    }
    if (!recording->annotations.marks.empty()) {
        const MarkArtist artist(level, file, recording, choice.drawn);
        const Checker checker(artist, file, choice);
        for (const MarkedMoment& at :
             marked_moments(*level, file, recording, chosen_marks(file, *recording, choice.marks), threads)) {
            PictureVerdict verdict{.mark = at.mark.name, .step = at.mark.step};
            if (choice.pictures) {
                verdict = checker.picture(at);
            }
            if (choice.light) {
                verdict = checker.light(at, std::move(verdict));
            }
            pictures.push_back(std::move(verdict));
        }
    }
    return results_of(std::move(pictures), choice);
}

PictureResults results_of(std::vector<PictureVerdict> pictures, const PictureChoice& choice) {
    PictureResults results{{}, std::move(pictures)};
    if (choice.pictures) {
        results.checks.push_back(
            check_of("pictures", results.pictures, &PictureVerdict::failed, &PictureVerdict::text));
    }
    if (choice.light) {
        results.checks.push_back(
            check_of("light", results.pictures, &PictureVerdict::light_failed, &PictureVerdict::light));
    }
    return results;
}

void make_baselines(const std::shared_ptr<const LevelFile>& level, const std::string& file,
                    const std::shared_ptr<const replay::Recording>& recording,
                    const std::vector<std::string>& marks, const MarkView& view, const std::string& reason,
                    const std::string& day, bool with_light) {
    const MarkArtist artist(level, file, recording);
    for (const MarkedMoment& at :
         marked_moments(*level, file, recording, chosen_marks(file, *recording, marks))) {
        Baseline baseline{view,          {},     {}, light_of_tiles(artist.direct(at, view)), {},
                          build_words(), reason, day};
        for (MarkView one = view; baseline.figures.size() < static_cast<std::size_t>(kSeeds); ++one.seed) {
            const MarkPicture picture = artist.draw(at, one);
            if (picture.nan_count > 0 || !all_finite(picture.radiance)) {
                throw InputError(file, fmt::format("mark '{}'", at.mark.name),
                                 "the picture has values that are no numbers");
            }
            if (baseline.figures.empty()) {
                baseline.shown = picture.shown;
            }
            baseline.figures.push_back(picture_figures(picture.shown, picture.radiance));
        }
        MarkView small = view;
        small.size = kLightSize;
        const auto truth = with_light ? artist.truth(at, small, kLightSpp) : workbench::ReferencePair();
        for (int i = 0; with_light && i < kMostSeeds; ++i, ++small.seed) {
            baseline.errors.push_back(light_error(artist.indirect(at, small), truth));
        }
        write_baseline(file, at.mark.name, baseline);
    }
}

}  // namespace lanthorn::tools
