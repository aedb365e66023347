// Which commit a recording differs since: commits between a good and a bad one are built and asked.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lanthorn::tools {

enum class CommitVerdict { good, bad, untestable };

// Of `count` commits, oldest first, of which the one before the first is good and the last is bad: the place
// of the first bad one, by halving; and those that cannot be tested and lie directly before it, one of which
// may be it. O(log count) questions where all can be tested.
struct FirstBad {
    std::size_t place = 0;
    std::vector<std::size_t> perhaps;
};
FirstBad find_first_bad(std::size_t count, const std::function<CommitVerdict(std::size_t)>& ask);

// How commits are built and asked.
struct CommitChoice {
    std::string range;        // "GOOD..BAD", as git names commits
    std::string repository;   // folder
    std::string build;        // shell command in a checkout; builds `program`
    std::string program;      // path in the checkout, with `replay verify`
    std::string file, level;  // recording; level or empty
    double build_seconds = 3600;
};

struct FoundCommit {
    std::string hash, title;             // 12 digits; first line of its message
    std::vector<std::string> perhaps;    // "hash title" of those that could not be tested before it
    std::size_t built = 0, commits = 0;  // how many were built, of how many
};

// Checks out one commit after another in a worktree of its own in a temporary folder, which goes afterwards;
// the repository's own checkout stays as it is. Throws InputError for a range, a repository or a build that
// cannot be used, for GOOD that differs and for BAD that does not. `told`: a line for each commit asked.
FoundCommit find_commit(const CommitChoice& choice, const std::function<void(const std::string&)>& told);

}  // namespace lanthorn::tools
