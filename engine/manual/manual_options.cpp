#include "engine/manual/manual_options.h"

#include <functional>
#include <utility>

namespace lanthorn::manual {

void add_manual_options(CLI::App& app, std::function<PageText()> text, std::function<Values()> values) {
    app.add_flag_callback(
        "--print-manual",
        [&app, text = std::move(text)] { throw CLI::CallForVersion(manual_page(app, text()), 0); },
        "print the manual page and end");
    app.add_flag_callback(
        "--print-completion",
        [&app, values = std::move(values)] { throw CLI::CallForVersion(bash_completion(app, values()), 0); },
        "print what bash completes and end: source <(" + app.get_name() + " --print-completion)");
}

}  // namespace lanthorn::manual
