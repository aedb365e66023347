#include "tools/editor/core/recovery_log.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "engine/core/json.h"
#include "lanthorn/core/error.h"

namespace lanthorn::editor {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kFirstLine = "# lanthorn edit log 1";
constexpr std::string_view kNote = " #@ ";  // what a line says beside its command

// # begins a comment, so no string of a note may hold one.
std::string note(const std::string& json) {
    std::string text;
    for (const char c : json) {
        text += c == '#' ? std::string("\\u0023") : std::string(1, c);
    }
    return std::string(kNote) + text;
}

std::pair<std::string, std::string> split_note(const std::string& line) {
    const std::size_t at = line.rfind(kNote);
    return at == std::string::npos ? std::pair(line, std::string())
                                   : std::pair(line.substr(0, at), line.substr(at + kNote.size()));
}

std::string unused_name(std::string_view ending) {
    static std::atomic<unsigned> counter{0};
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return fmt::format("{}-{}-{}{}", std::chrono::duration_cast<std::chrono::milliseconds>(now).count(),
                       ::getpid(), counter++, ending);
}

std::string head_line(const char* key, const fs::path& value) {
    return fmt::format("# {} {}\n", key, nlohmann::json(value.string()).dump());
}

// "# file "/home/ann/crypt.glb"": what stands there as JSON; empty: another line.
std::string head_value(const std::string& line, const char* key) {
    const std::string start = fmt::format("# {} ", key);
    if (!line.starts_with(start)) {
        return {};
    }
    const auto value = json_if_valid(std::string_view(line).substr(start.size()));
    return value && value->is_string() ? value->get<std::string>() : std::string();
}

// Whether a living process writes it: it holds a lock on it.
bool is_written(const fs::path& log) {
    const int file = ::open(log.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return false;
    }
    const bool is_free = ::flock(file, LOCK_EX | LOCK_NB) == 0;
    ::close(file);
    return !is_free;
}

double written_at(const fs::path& file) {
    std::error_code ignored;
    const auto age = fs::file_time_type::clock::now() - fs::last_write_time(file, ignored);
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count() - std::chrono::duration<double>(age).count();
}

}  // namespace

fs::path recovery_folder() {
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && value[0] == '/' ? fs::path(value) : fs::path();
    };
    if (const fs::path state = variable("XDG_STATE_HOME"); !state.empty()) {
        return state / "lanthorn" / "recovery";
    }
    const fs::path home = variable("HOME");
    return home.empty() ? home : home / ".local" / "state" / "lanthorn" / "recovery";
}

fs::path new_base(const fs::path& folder) {
    return folder / unused_name(".base.glb");
}

RecoveryLog::RecoveryLog(const fs::path& folder, const fs::path& edited, std::uint64_t hash,
                         const fs::path& base)
    : path_(folder / unused_name(".edits")),
      base_(base),
      head_(fmt::format("{}\n{}# hash \"{:016x}\"\n{}", kFirstLine, head_line("file", edited), hash,
                        base.empty() ? std::string() : head_line("base", base))) {}

RecoveryLog::~RecoveryLog() {
    close();
}

RecoveryLog::RecoveryLog(RecoveryLog&& other) noexcept {
    *this = std::move(other);
}

RecoveryLog& RecoveryLog::operator=(RecoveryLog&& other) noexcept {
    close();
    path_ = std::exchange(other.path_, {});
    base_ = std::exchange(other.base_, {});
    head_ = std::exchange(other.head_, {});
    problem_ = std::exchange(other.problem_, {});
    file_ = std::exchange(other.file_, -1);
    return *this;
}

void RecoveryLog::close() {
    if (file_ >= 0) {
        ::close(file_);
    }
    file_ = -1;
}

void RecoveryLog::open() {
    std::error_code ignored;
    fs::create_directories(path_.parent_path(), ignored);
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    if (file_ >= 0) {
        ::flock(file_, LOCK_EX | LOCK_NB);  // held while this process lives
    }
}

void RecoveryLog::append(std::string_view block) {
    if (path_.empty() || !problem_.empty()) {
        return;
    }
    std::string bytes(block);
    if (file_ < 0) {
        open();
        bytes = head_ + bytes;
    }
    std::string_view rest = bytes;
    while (file_ >= 0 && !rest.empty()) {
        const ssize_t written = ::write(file_, rest.data(), rest.size());
        if (written < 0 && errno != EINTR) {
            break;
        }
        rest.remove_prefix(written < 0 ? 0 : static_cast<std::size_t>(written));
    }
    if (file_ < 0 || !rest.empty() || ::fsync(file_) != 0) {
        problem_ = fmt::format("{}: cannot be written ({}): edits are not kept for a crash", path_.string(),
                               std::strerror(errno));
    }
}

void RecoveryLog::discard() {
    close();
    std::error_code ignored;
    if (!path_.empty()) {
        fs::remove(path_, ignored);
    }
    if (!base_.empty()) {
        fs::remove(base_, ignored);
    }
    path_.clear();
    base_.clear();
}

std::string log_block(const EditStep& step) {
    std::string block = fmt::format("begin {}{}\n", word(step.text), note(number(step.seconds)));
    for (const Command& command : step.commands) {
        nlohmann::json marks = nlohmann::json::array();
        for (const NodeMark& mark : command.marks) {
            marks.push_back(parse_json(to_text(mark), "mark"));
        }
        const nlohmann::json beside = {
            {"marks", marks}, {"path", command.path}, {"before", command.before}, {"made", command.made}};
        block += command.text + note(beside.dump()) + '\n';
    }
    return block + "commit\n";
}

LeftLog read_log(const fs::path& log) {
    std::ifstream stream(log, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream || !text.starts_with(kFirstLine)) {
        throw InputError(log.string(), "", "found no log of edits, expected one");
    }
    LeftLog left;
    left.log = log;
    left.seconds = written_at(log);
    bool inside = false;
    std::vector<std::string> block;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        if (end == std::string::npos) {
            break;  // cut off
        }
        std::string line = text.substr(at, end - at);
        at = end + 1;
        if (line.starts_with("# ")) {
            if (std::string value = head_value(line, "file"); !value.empty()) {
                left.edited = value;
            } else if (value = head_value(line, "base"); !value.empty()) {
                left.base = value;
            } else if (value = head_value(line, "hash"); !value.empty()) {
                std::from_chars(value.data(), value.data() + value.size(), left.hash, 16);
            }
            continue;
        }
        const std::string verb = line.substr(0, line.find(' '));
        inside = inside || verb == "begin";
        block.push_back(std::move(line));
        if (!inside || verb == "commit") {
            left.lines.insert(left.lines.end(), block.begin(), block.end());
            left.steps += inside ? 1 : 0;
            block.clear();
            inside = false;
        }
    }
    return left;
}

std::vector<LeftLog> left_logs(const fs::path& folder) {
    std::vector<LeftLog> found;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
        if (entry.path().extension() != ".edits" || is_written(entry.path())) {
            continue;
        }
        try {
            LeftLog log = read_log(entry.path());
            if (log.steps > 0) {
                found.push_back(std::move(log));
            }
        } catch (const InputError&) {
            continue;  // somebody else's
        }
    }
    std::ranges::sort(found, std::greater(), &LeftLog::seconds);
    return found;
}

void discard_log(const LeftLog& log) {
    std::error_code ignored;
    fs::remove(log.log, ignored);
    if (!log.base.empty()) {
        fs::remove(log.base, ignored);
    }
}

namespace {

Command command_from(const std::string& line) {
    const auto [text, beside] = split_note(line);
    Command command;
    command.text = text;
    if (beside.empty()) {
        return command;
    }
    const nlohmann::json json = parse_json_object(beside, "recovery log", "what a command was applied to");
    for (const nlohmann::json& mark : json.value("marks", nlohmann::json::array())) {
        command.marks.push_back(mark_from(mark.dump()));
    }
    command.path = json.value("path", std::string());
    command.before = json.value("before", std::string());
    command.made = json.value("made", std::vector<std::uint32_t>());
    return command;
}

std::size_t count_of(const std::vector<std::string>& words) {
    std::size_t count = 1;
    if (words.size() > 1) {
        std::from_chars(words[1].data(), words[1].data() + words[1].size(), count);
    }
    return count;
}

}  // namespace

std::vector<EditStep> steps_of(const LeftLog& log) {
    std::vector<EditStep> steps;
    std::size_t done = 0;
    EditStep step;
    bool inside = false;
    for (const std::string& line : log.lines) {
        const std::vector<std::string> words = words_of(line);
        if (words.empty()) {
            continue;
        }
        if (words[0] == "begin" && words.size() > 1) {
            inside = true;
            step = {words[1], {}, {}, std::strtod(split_note(line).second.c_str(), nullptr)};
        } else if (words[0] == "commit") {
            steps.resize(done);
            steps.push_back(std::exchange(step, {}));
            done = steps.size();
            inside = false;
        } else if (inside) {
            step.commands.push_back(command_from(line));
        } else if (words[0] == "undo") {
            done -= std::min(done, count_of(words));
        } else if (words[0] == "redo") {
            done = std::min(steps.size(), done + count_of(words));
        }
    }
    steps.resize(done);
    return steps;
}

}  // namespace lanthorn::editor
