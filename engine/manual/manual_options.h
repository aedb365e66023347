// --print-manual and --print-completion, which every program has: packages are made with what they print.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "engine/manual/bash_completion.h"
#include "engine/manual/manual_page.h"

namespace lanthorn::manual {

// Adds them. Asked for one, `app.parse` throws CLI::CallForVersion, whose what() is to be printed. `text` and
// `values` are called then: declaring the options costs nothing more.
void add_manual_options(CLI::App& app, std::function<PageText()> text, std::function<Values()> values);

}  // namespace lanthorn::manual
