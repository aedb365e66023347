#include "tools/lanthorn/common/command_line.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/build_info/build_info.h"
#include "engine/manual/manual_options.h"
#include "lanthorn/core/printable.h"
#include "lanthorn/ecs/workers_end.h"
#include "tools/lanthorn/common/program_page.h"

namespace lanthorn::tools {

namespace {

constexpr std::size_t kLine = 500;  // bytes: arguments may be as long as anybody likes

class Reporter {
  public:
    explicit Reporter(std::string program) : program_(std::move(program)) {}

    int fail(ExitCode code, std::string line) const {
        std::replace(line.begin(), line.end(), '\n', ' ');
        std::fprintf(stderr, "%s: %s\n", program_.c_str(),
                     shortened(printable(line), kLine - program_.size() - 2).c_str());
        return static_cast<int>(code);
    }

    // The exit code once everything printed has truly arrived: a full disk may be behind standard output.
    int finish(int code) const {
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
            return fail(ExitCode::bad_input,
                        std::string("standard output: cannot be written: ") + std::strerror(errno));
        }
        return code;
    }

  private:
    std::string program_;
};

using Commands = std::vector<std::pair<CLI::App*, Command>>;

// " render, compare, ...": those that --help lists.
std::string names_of(const Commands& commands) {
    std::string names;
    for (const auto& [subcommand, command] : commands) {
        if (!subcommand->get_group().empty()) {
            names += (names.empty() ? " " : ", ") + subcommand->get_name();
        }
    }
    return names;
}

}  // namespace

int run_command_line(const std::string& program, const std::string& purpose,
                     std::span<const AddCommand> to_add, int argc, char** argv) {
    const ecs::WorkersEndWithMain workers;
    const Reporter report(program);
    CLI::App app(purpose, program);
    app.set_version_flag("--version", program + ' ' + kVersion);
    manual::add_manual_options(app, program_page, option_values);
    app.require_subcommand(1);
    const Commands commands = [&] {
        Commands list;
        for (const AddCommand add : to_add) {
            Command command = add(app);
            list.emplace_back(app.get_subcommands({}).back(), std::move(command));
        }
        return list;
    }();
    try {
        const auto is_named = [&](const auto& c) { return c.first->get_name() == argv[1]; };
        if (argc > 1 && argv[1][0] != '-' && std::none_of(commands.begin(), commands.end(), is_named)) {
            return report.fail(ExitCode::bad_input, std::string("found '") + argv[1] +
                                                        "', expected a command:" + names_of(commands));
        }
        app.parse(argc, argv);
        for (const auto& [subcommand, command] : commands) {
            if (subcommand->parsed()) {
                return report.finish(static_cast<int>(command()));
            }
        }
    } catch (const CLI::Success& help) {  // --help, --version and their like
        return report.finish(app.exit(help));
    } catch (const CLI::ParseError& error) {
        return report.fail(ExitCode::bad_input,
                           std::string(error.what()) + " (" + program + " --help shows what there is)");
    } catch (const Error& error) {
        return report.fail(error.code(), error.what());
    } catch (const std::bad_alloc&) {
        return report.fail(ExitCode::bad_input, "out of memory, expected a smaller scene or picture");
    } catch (const std::system_error& error) {
        const int printed = report.finish(0);
        return printed != 0
                   ? printed
                   : report.fail(ExitCode::bad_input, std::string("internal error: ") + error.what());
    } catch (const std::exception& error) {
        return report.fail(ExitCode::bad_input, std::string("internal error: ") + error.what());
    }
    return 0;
}

}  // namespace lanthorn::tools
