#include "engine/manual/manual_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "engine/manual/declared_options.h"

namespace lanthorn::manual {

namespace {

// Plain text as roff prints it: no character of it is a command.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if ((out.empty() || out.back() == '\n') && (c == '.' || c == '\'')) {
            out += "\\&";
        }
        switch (c) {
            case '\\':
                out += "\\e";
                break;
            case '-':
                out += "\\-";
                break;
            case '\'':
                out += "\\(aq";
                break;
            case '`':
                out += "\\(ga";
                break;
            case '^':
                out += "\\(ha";
                break;
            case '~':
                out += "\\(ti";
                break;
            default:
                out += c;
        }
    }
    return out;
}

std::string bold(const std::string& text) {
    return "\\fB" + escaped(text) + "\\fR";
}
std::string italic(const std::string& text) {
    return "\\fI" + escaped(text) + "\\fR";
}

// "FLOAT" of "FLOAT:NUMBER in [0 - 1]".
std::string value_kind(const DeclaredOption& option) {
    return option.value.substr(0, option.value.find(':'));
}

// What values an option takes beyond their kind, as a sentence; empty: any.
std::string value_limits(const DeclaredOption& option) {
    if (!option.choices.empty()) {
        return fmt::format("One of {}.", fmt::join(option.choices, ", "));
    }
    const std::size_t begin = option.value.find('['), end = option.value.rfind(']');
    const std::size_t dash = option.value.find(" - ", begin);
    if (begin == std::string::npos || end == std::string::npos || dash == std::string::npos) {
        return "";
    }
    return fmt::format("From {} to {}.", option.value.substr(begin + 1, dash - begin - 1),
                       option.value.substr(dash + 3, end - dash - 3));
}

// Begins with a capital, unless its first word has one further on or ends with a colon, and ends with a full
// stop.
std::string sentence(std::string words) {
    if (words.empty()) {
        return words;
    }
    const std::string first = words.substr(0, words.find(' '));
    if (std::ranges::none_of(first, [](unsigned char c) { return std::isupper(c) != 0 || c == ':'; })) {
        words[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(words[0])));
    }
    if (std::string_view(".!?").find(words.back()) == std::string_view::npos) {
        words += '.';
    }
    return words;
}

void add_option(std::string& page, const DeclaredOption& option) {
    page += ".TP\n";
    if (option.positional) {
        page += italic(option.names.front() + option.value) + "\n";
    } else {
        std::vector<std::string> names;
        std::ranges::transform(option.names, std::back_inserter(names), bold);
        page += fmt::format("{}", fmt::join(names, ", "));
        page += option.takes_value() ? " " + italic(value_kind(option)) + "\n" : "\n";
    }
    std::vector<std::string> sentences = {sentence(option.words), value_limits(option)};
    if (!option.initial.empty()) {
        sentences.push_back(sentence("Default: " + option.initial));
    }
    if (option.required && !option.positional) {
        sentences.push_back("Required.");
    }
    std::erase(sentences, "");
    page += escaped(fmt::format("{}\n", fmt::join(sentences, " ")));
}

// "NAME [OPTIONS] SCENE [OUT]"
std::string synopsis(const std::string& command, const CLI::App& app) {
    std::string line = ".B " + escaped(command) + "\n";
    const std::vector<DeclaredOption> options = declared_options(app);
    if (std::ranges::any_of(options, [](const DeclaredOption& o) { return !o.positional; })) {
        line += "[" + italic("OPTIONS") + "]\n";
    }
    for (const DeclaredOption& option : options) {
        if (option.positional) {
            const std::string name = italic(option.names.front() + option.value);
            line += option.required ? name + "\n" : "[" + name + "]\n";
        }
    }
    return line;
}

// Commands with their own commands, "measure hits", at any depth.
void collect(const std::string& name, const CLI::App& app,
             std::vector<std::pair<std::string, const CLI::App*>>& all) {
    all.emplace_back(name, &app);
    for (const CLI::App* command : declared_commands(app)) {
        collect(name + " " + command->get_name(), *command, all);
    }
}

void add_items(std::string& page, const char* heading, const std::vector<PageText::Item>& items) {
    if (items.empty()) {
        return;
    }
    page += fmt::format(".SH {}\n", heading);
    for (const auto& [name, words] : items) {
        page += ".TP\n" + bold(name) + "\n" + escaped(words) + "\n";
    }
}

}  // namespace

std::string manual_page(const CLI::App& app, const PageText& text) {
    const std::string program = app.get_name();
    std::string title = program;
    std::ranges::transform(title, title.begin(), [](unsigned char c) { return std::toupper(c); });
    std::string purpose = app.get_description().substr(0, app.get_description().find('\n'));
    if (purpose.starts_with(program + ": ")) {
        purpose.erase(0, program.size() + 2);
    }
    std::vector<std::pair<std::string, const CLI::App*>> commands;
    collect(program, app, commands);

    std::string page = fmt::format(".TH {} {} \"\" \"{} {}\" \"{}\"\n", escaped(title), text.section, program,
                                   text.version, text.section == 6 ? "Games" : "User Commands");
    page += ".nh\n.ad l\n";
    page += ".SH NAME\n" + escaped(program) + " \\- " +
            escaped(purpose.substr(0, purpose.find_last_not_of('.') + 1)) + "\n";
    page += ".SH SYNOPSIS\n";
    for (const auto& [name, command] : commands) {
        if (command->get_require_subcommand_min() == 0 || declared_commands(*command).empty()) {
            page += (page.ends_with("SYNOPSIS\n") ? "" : ".br\n") + synopsis(name, *command);
        }
    }
    page += ".SH DESCRIPTION\n";
    for (const std::string& paragraph : text.description) {
        page += (page.ends_with("DESCRIPTION\n") ? "" : ".PP\n") + escaped(paragraph) + "\n";
    }
    page += ".SH OPTIONS\n";
    for (const DeclaredOption& option : declared_options(app)) {
        add_option(page, option);
    }
    if (commands.size() > 1) {
        page += ".SH COMMANDS\n";
    }
    for (const auto& [name, command] : commands) {
        if (command == &app) {
            continue;
        }
        page += ".SS " + escaped(name) + "\n" + escaped(sentence(command->get_description())) + "\n";
        for (const DeclaredOption& option : declared_options(*command)) {
            add_option(page, option);
        }
    }
    add_items(page, "EXIT STATUS", text.exit_codes);
    add_items(page, "ENVIRONMENT", text.environment);
    add_items(page, "FILES", text.files);
    if (!text.examples.empty()) {
        page += ".SH EXAMPLES\n";
        for (const auto& [command, words] : text.examples) {
            page += ".PP\n" + escaped(words) + "\n.PP\n.nf\n.RS\n" + escaped(command) + "\n.RE\n.fi\n";
        }
    }
    if (!text.see_also.empty()) {
        page += ".SH SEE ALSO\n" + escaped(fmt::format("{}\n", fmt::join(text.see_also, ", ")));
    }
    return page;
}

}  // namespace lanthorn::manual
