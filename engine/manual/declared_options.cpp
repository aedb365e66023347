#include "engine/manual/declared_options.h"

namespace lanthorn::manual {

namespace {

bool is_shown(const CLI::Option* option) {
    return !option->get_group().empty();
}

// "TEXT:{emc,none}" lists emc and none.
std::vector<std::string> listed_choices(const std::string& type) {
    std::vector<std::string> choices;
    const std::size_t begin = type.find('{'), end = type.rfind('}');
    if (begin != std::string::npos && end != std::string::npos && begin < end) {
        choices = CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
    }
    return choices;
}

DeclaredOption declared(const CLI::Option& option) {
    DeclaredOption result;
    result.positional = option.get_positional();
    result.required = option.get_required();
    result.words = option.get_description();
    if (result.positional) {
        result.names = {option.get_name(true, false)};
        result.value = option.get_expected_max() > 1 ? "..." : "";
    } else {
        for (const std::string& name : option.get_snames()) {
            result.names.push_back("-" + name);
        }
        for (const std::string& name : option.get_lnames()) {
            result.names.push_back("--" + name);
        }
        if (option.get_type_size() != 0) {
            result.value = option.get_type_name();
            result.initial = option.get_default_str();
            result.choices = listed_choices(result.value);
        }
    }
    return result;
}

}  // namespace

std::vector<DeclaredOption> declared_options(const CLI::App& app) {
    std::vector<DeclaredOption> positional, others;
    for (const CLI::Option* option : app.get_options(is_shown)) {
        DeclaredOption one = declared(*option);
        (one.positional ? positional : others).push_back(std::move(one));
    }
    positional.insert(positional.end(), std::make_move_iterator(others.begin()),
                      std::make_move_iterator(others.end()));
    return positional;
}

std::vector<const CLI::App*> declared_commands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

}  // namespace lanthorn::manual
