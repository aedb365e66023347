#include "tools/lanthorn/trade/advice_command.h"

#include <fmt/format.h>

#include "tools/lanthorn/common/common_options.h"

namespace lanthorn::tools {

void add_advice_options(CLI::App& command, AdviceOptions& options) {
    command
        .add_option("--from", options.from,
                    "a finished chart, its folder or its CSV: measure nothing, advise from it")
        ->type_name("CHART");
    Wishes& wishes = options.wishes;
    command
        .add_option(
            "--for-ms", wishes.ms,
            "print what has the least error within so many milliseconds, separated by commas; exit code "
            "1 where nothing is as cheap")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(number_between(1e-3, 1e6));
    command
        .add_option("--for-error", wishes.errors,
                    "print what takes the least time up to such a relRMSE of indirect light, separated by "
                    "commas; exit code 1 where nothing is as good")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(number_between(1e-6, 1e6));
    command
        .add_option("--share", wishes.share,
                    "of the scenes in which that limit must hold: 1 is all of them, 0.75 three of four")
        ->check(number_between(1e-3, 1))
        ->capture_default_str();
    CLI::Option* markdown =
        command.add_flag("--markdown", options.markdown, "print that advice as a Markdown table");
    command.add_flag("--json", options.json, "print that advice as one JSON object")->excludes(markdown);
}

ExitCode advise_by(const std::vector<ChartRow>& rows, const AdviceOptions& options) {
    if (options.json) {
        fmt::print("{}\n", advice_json(rows, options.wishes).dump(2));
    } else if (options.markdown) {
        fmt::print("{}", advice_markdown(rows, options.wishes));
    } else {
        fmt::print("{}", advice_text(rows, options.wishes, scenes_of(rows).size() > 1));
    }
    const std::string missing = unmet(rows, options.wishes);
    if (!missing.empty()) {
        throw Error(ExitCode::check_failed, "trade: " + missing);
    }
    return ExitCode::ok;
}

ExitCode advise_from_chart(const AdviceOptions& options, const std::vector<std::string>& scenes) {
    if (!options.wishes.any()) {
        throw InputError("trade: found --from alone, expected --for-ms or --for-error with it");
    }
    const std::vector<ChartRow> rows = read_chart(options.from);
    return advise_by(scenes.empty() ? rows : of_scenes(rows, scenes), options);
}

}  // namespace lanthorn::tools
