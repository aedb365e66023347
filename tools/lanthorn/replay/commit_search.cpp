#include "tools/lanthorn/replay/commit_search.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <system_error>

#include "lanthorn/core/error.h"
#include "lanthorn/core/stop_signal.h"
#include "tools/replay_suite/limited_child.h"

namespace lanthorn::tools {

namespace {

namespace fs = std::filesystem;
using suite::ChildRun;

constexpr double kGitSeconds = 600, kVerifySeconds = 600;

ChildRun run(const std::vector<std::string>& command, double seconds) {
    ChildRun run =
        suite::run_limited(command, {}, {.seconds = seconds, .stuck_seconds = seconds, .memory_mib = 0}, "",
                           [] { return StopSignal::asked(); });
    if (run.end == ChildRun::End::stopped) {
        throw InputError("replay bisect: stopped");
    }
    return run;
}

bool went_well(const ChildRun& run) {
    return run.end == ChildRun::End::exited && run.code == 0;
}

std::string last_line(std::string text) {
    text.erase(text.find_last_not_of(" \r\n") + 1);
    return text.substr(text.find_last_of('\n') + 1);
}

// A checkout of its own, which goes with its folder.
class Worktree {
  public:
    explicit Worktree(const CommitChoice& choice)
        : choice_(choice), path_(fs::temp_directory_path() / fmt::format("lanthorn-bisect-{}", getpid())) {}
    ~Worktree() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
        try {
            run({"/usr/bin/env", "git", "-C", choice_.repository, "worktree", "prune"}, kGitSeconds);
        } catch (const Error&) {
        }
    }
    Worktree(const Worktree&) = delete;
    Worktree& operator=(const Worktree&) = delete;

    // What git says; throws InputError with its last line where it refuses.
    std::string git(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"/usr/bin/env", "git", "-C", choice_.repository});
        const ChildRun done = run(arguments, kGitSeconds);
        if (!went_well(done)) {
            throw InputError("--commits", choice_.range, "git: " + last_line(done.err));
        }
        return done.out;
    }

    CommitVerdict ask(const std::string& hash, std::string& why) {
        if (!fs::exists(path_)) {
            git({"worktree", "add", "--detach", "--force", path_.string(), hash});
        } else if (const ChildRun out = run(
                       {"/usr/bin/env", "git", "-C", path_.string(), "checkout", "--force", "--detach", hash},
                       kGitSeconds);
                   !went_well(out)) {
            throw InputError("--commits", hash, "git: " + last_line(out.err));
        }
        const ChildRun built =
            run({"/bin/sh", "-c", "cd \"$0\" && " + choice_.build, path_.string()}, choice_.build_seconds);
        if (!went_well(built)) {
            why = "does not build: " + last_line(built.err.empty() ? built.out : built.err);
            return CommitVerdict::untestable;
        }
        std::vector<std::string> command = {(path_ / choice_.program).string(), "replay", "verify",
                                            choice_.file};
        if (!choice_.level.empty()) {
            command.insert(command.end(), {"--level", choice_.level});
        }
        const ChildRun judged = run(command, kVerifySeconds);
        // A crash is what is looked for as well.
        if (judged.end == ChildRun::End::signalled ||
            (judged.end == ChildRun::End::exited && judged.code == 1)) {
            why = "differs";
            return CommitVerdict::bad;
        }
        if (went_well(judged)) {
            why = "as recorded";
            return CommitVerdict::good;
        }
        why = "cannot be asked: " + last_line(judged.err);
        return CommitVerdict::untestable;
    }

  private:
    const CommitChoice& choice_;
    const fs::path path_;
};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        lines.push_back(line);
    }
    return lines;
}

}  // namespace

FirstBad find_first_bad(std::size_t count, const std::function<CommitVerdict(std::size_t)>& ask) {
    // All before `good` are good, `bad` is bad.
    std::size_t good = 0, bad = count - 1;
    std::vector<bool> untestable(count, false);
    while (good < bad) {
        // The one nearest to the middle that is not known to be untestable.
        std::optional<std::size_t> next;
        for (std::size_t i = good; i < bad; ++i) {
            const auto off = [&](std::size_t k) {
                return k > (good + bad) / 2 ? k - (good + bad) / 2 : (good + bad) / 2 - k;
            };
            if (!untestable[i] && (!next || off(i) < off(*next))) {
                next = i;
            }
        }
        if (!next) {
            break;
        }
        switch (ask(*next)) {
            case CommitVerdict::good:
                good = *next + 1;
                break;
            case CommitVerdict::bad:
                bad = *next;
                break;
            case CommitVerdict::untestable:
                untestable[*next] = true;
        }
    }
    FirstBad found{bad, {}};
    for (std::size_t i = good; i < bad; ++i) {
        found.perhaps.push_back(i);
    }
    return found;
}

FoundCommit find_commit(const CommitChoice& choice, const std::function<void(const std::string&)>& told) {
    const std::size_t dots = choice.range.find("..");
    if (dots == std::string::npos || dots == 0 || dots + 2 >= choice.range.size()) {
        throw InputError(fmt::format("--commits: found '{}', expected GOOD..BAD", choice.range));
    }
    Worktree worktree(choice);
    const std::vector<std::string> commits = lines_of(
        worktree.git({"log", "--first-parent", "--reverse", "--abbrev=12", "--format=%h %s", choice.range}));
    if (commits.empty()) {
        throw InputError("--commits", choice.range, "found no commits, expected GOOD before BAD");
    }
    const std::string good =
        lines_of(worktree.git({"log", "-1", "--abbrev=12", "--format=%h %s", choice.range.substr(0, dots)}))
            .at(0);
    FoundCommit found;
    found.commits = commits.size();
    const auto ask = [&](const std::string& commit) {
        std::string why;
        const CommitVerdict verdict = worktree.ask(commit.substr(0, commit.find(' ')), why);
        ++found.built;
        told(fmt::format("{}: {}", commit, why));
        return verdict;
    };
    if (ask(commits.back()) != CommitVerdict::bad) {
        throw InputError("--commits", commits.back(), "does not differ, expected BAD to");
    }
    if (ask(good) != CommitVerdict::good) {
        throw InputError("--commits", good, "is not as recorded, expected GOOD to be");
    }
    const FirstBad first = find_first_bad(commits.size(), [&](std::size_t i) { return ask(commits[i]); });
    const std::string& commit = commits[first.place];
    found.hash = commit.substr(0, commit.find(' '));
    found.title = commit.substr(std::min(commit.find(' ') + 1, commit.size()));
    for (const std::size_t i : first.perhaps) {
        found.perhaps.push_back(commits[i]);
    }
    return found;
}

}  // namespace lanthorn::tools
