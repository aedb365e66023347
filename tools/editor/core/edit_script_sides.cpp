// `compare` of scripts: one scene drawn in two ways.
#include <fmt/format.h>

#include "lanthorn/assets/image_io.h"
#include "lanthorn/core/error.h"
#include "lanthorn/workbench/metrics.h"
#include "tools/editor/core/edit_script.h"
#include "tools/editor/core/two_sides.h"

namespace lanthorn::editor {

void EditScript::compare(const std::vector<std::string>& words) {
    expect_words(words, 4, 6, "compare FILE A B [WIDTHxHEIGHT [FRAMES]]");
    const CheckedFrames what = frames_in(words, 4);
    check_image_writable(words[1]);
    if (holds_linear(words[1])) {
        throw InputError(
            fmt::format("found '{}', expected a picture for screens (PNG, JPEG, WebP)", words[1]));
    }
    const DrawnAs now{settings_, ""};
    const DrawnAs as[2] = {drawn_as(words[2], now), drawn_as(words[3], now)};
    need_context();
    session_.refresh_guests();
    const DrawnSide b = draw_side(session_, as[1], what), a = draw_side(session_, as[0], what, b.ev100);
    write_image(words[1], side_by_side(a.final, b.final, 0.5));
    print_(fmt::format("A: {}, {:.0f} ms", words_of(as[0]), a.ms));
    print_(fmt::format("B: {}, {:.0f} ms", words_of(as[1]), b.ms));
    const workbench::PixelMask lit = workbench::lit_pixels(a.indirect);
    if (workbench::mean_over(a.indirect.pixels, {}) <= 0) {
        print_("A has no indirect light that B could be held against");
        return;
    }
    const workbench::Difference found = workbench::compare(b.indirect, a.indirect, "B", "A", lit).all;
    print_(
        fmt::format("indirect light of B against A: relRMSE {:.3f}, flux {:.3f}", found.relrmse, found.flux));
}

}  // namespace lanthorn::editor
