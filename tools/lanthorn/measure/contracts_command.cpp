// lanthorn measure contracts LEVEL: whether its light is what its light_contracts ask for; exit code 1 where
// not.
#include "tools/lanthorn/measure/contracts_command.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "lanthorn/core/error.h"
#include "lanthorn/core/progress.h"
#include "lanthorn/core/stop_signal.h"
#include "lanthorn/runtime/shown_scene.h"
#include "lanthorn/workbench/load_scene.h"
#include "tools/lanthorn/common/common_options.h"
#include "tools/lanthorn/common/warnings.h"
#include "tools/lanthorn/common/workbench.h"
#include "tools/workbench/measure/light_contracts.h"
#include "tools/workbench/scene/stopping.h"

namespace lanthorn::tools {

namespace {

struct ContractsOptions {
    std::string scene;
    ContractEffort effort;
    SceneView view;
    SettingsChoice settings;
    bool json = false;
};

ExitCode run(const ContractsOptions& options) {
    const ChosenSettings chosen(options.settings);
    const StopSignal stop;
    SceneView view = options.view;
    view.camera = "auto";  // light does not depend on who looks
    ShownScene shown(tell_warnings(options.scene, load_scene(options.scene, view)), view);
    shown.show_at(options.view.time.value_or(0));
    const std::vector<PlacedContract> contracts = contracts_of(shown.world(), shown.frame());
    if (contracts.empty()) {
        throw InputError(options.scene, "",
                         "found no light_contract, expected {\"light_contract\": {...}} in a node's extras");
    }
    const reference::LightSplitter light(shown.frame(), reference::path_settings(chosen.settings));
    Progress progress("contracts", contracts.size());
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    std::string lines;
    std::size_t broken = 0, done = 0;
    for (const PlacedContract& contract : contracts) {
        const ContractVerdict verdict = check_contract(contract, light, options.effort);
        broken += verdict.kept ? 0 : 1;
        list.push_back(contract_json(verdict));
        lines += contract_words(verdict) + '\n';
        progress.update(++done);
        stop_if_asked("measure", "not all contracts were looked at");
    }
    if (options.json) {
        const nlohmann::ordered_json root{{"measure", "contracts"},
                                          {"scene", options.scene},
                                          {"contracts", std::move(list)},
                                          {"broken", broken}};
        fmt::print("{}\n", root.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    } else {
        fmt::print("{}", lines);
    }
    return broken > 0 ? ExitCode::check_failed : ExitCode::ok;
}

}  // namespace

Command add_measure_contracts(CLI::App& measure) {
    auto options = std::make_shared<ContractsOptions>();
    CLI::App* command = measure.add_subcommand("contracts",
                                               "Whether the light of a level is what its light_contracts ask "
                                               "for (docs/levels.md), by the path tracer. Ends "
                                               "with 1 where one is broken.");
    add_scene_option(*command, options->scene)->required();
    command->add_option("--places", options->effort.places, "places in a box, or on a sensor's disc")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command->add_option("--paths", options->effort.paths, "paths that are followed from each")
        ->check(CLI::Range(16, 1'000'000))
        ->capture_default_str();
    add_moment_options(*command, options->view, "that is looked at, standing still (default: 0)");
    add_settings_options(*command, options->settings);
    command->add_flag("--json", options->json, "print one JSON object");
    return [options] { return run(*options); };
}

}  // namespace lanthorn::tools
