#include "engine/manual/bash_completion.h"

#include <fmt/format.h>

#include <algorithm>

#include "engine/manual/declared_options.h"

namespace lanthorn::manual {

namespace {

// What is offered behind one option: the words of a bash list; "" files, "-" nothing.
std::string offered_values(const DeclaredOption& option, const Values& values) {
    for (const std::string& name : option.names) {
        if (const auto found = values.find(name); found != values.end()) {
            return found->second.empty() ? "-" : fmt::format("{}", fmt::join(found->second, " "));
        }
    }
    if (!option.choices.empty()) {
        return fmt::format("{}", fmt::join(option.choices, " "));
    }
    return option.value.starts_with("TEXT") ? "" : "-";
}

// The branches of the script for a command and all below it: by its whole name, what may follow.
void add_branches(std::string& script, const std::string& name, const CLI::App& app, const Values& values) {
    std::vector<std::string> commands, names, cases;
    for (const CLI::App* command : declared_commands(app)) {
        commands.push_back(command->get_name());
    }
    for (const DeclaredOption& option : declared_options(app)) {
        if (option.positional) {
            continue;
        }
        names.insert(names.end(), option.names.begin(), option.names.end());
        if (option.takes_value()) {
            cases.push_back(fmt::format("                {}) values='{}' ;;\n",
                                        fmt::join(option.names, " | "), offered_values(option, values)));
        }
    }
    script += fmt::format("        '{}')\n            commands='{}'\n            options='{}'\n", name,
                          fmt::join(commands, " "), fmt::join(names, " "));
    if (!cases.empty()) {
        script += fmt::format("            case $before in\n{}            esac\n", fmt::join(cases, ""));
    }
    script += "            ;;\n";
    for (const CLI::App* command : declared_commands(app)) {
        add_branches(script, name + " " + command->get_name(), *command, values);
    }
}

// Whole names of commands, for the script to walk: "lanthorn render".
void add_names(std::vector<std::string>& names, const std::string& name, const CLI::App& app) {
    for (const CLI::App* command : declared_commands(app)) {
        const std::string whole = name + " " + command->get_name();
        names.push_back(fmt::format("'{}'", whole));
        add_names(names, whole, *command);
    }
}

}  // namespace

std::string bash_completion(const CLI::App& app, const Values& values) {
    const std::string program = app.get_name();
    std::vector<std::string> names;
    add_names(names, program, app);
    std::string branches;
    add_branches(branches, program, app, values);
    return fmt::format(R"(# bash completion for {0}, made by `{0} --print-completion`
_{0}() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}}
    local command={0} commands= options= values=none i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        case "$command ${{COMP_WORDS[i]}}" in
            {1}) command+=" ${{COMP_WORDS[i]}}" ;;
        esac
    done
    case $command in
{2}    esac
    COMPREPLY=()
    if [[ $values != none && -n $values ]]; then
        mapfile -t COMPREPLY < <(compgen -W "${{values#-}}" -- "$current")
        [[ ${{COMPREPLY[0]-}} != *= ]] || compopt -o nospace 2> /dev/null
    elif [[ $values == none && $current == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$current")
    elif [[ $values == none && -n $commands ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$commands" -- "$current")
    else
        mapfile -t COMPREPLY < <(compgen -f -- "$current")
        compopt -o filenames 2> /dev/null
    fi
}}
complete -F _{0} {0}
)",
                       program, names.empty() ? "''" : fmt::format("{}", fmt::join(names, " | ")), branches);
}

}  // namespace lanthorn::manual
