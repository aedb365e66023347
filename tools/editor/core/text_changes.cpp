#include "tools/editor/core/text_changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <utility>

namespace lanthorn::editor {

namespace {

constexpr std::size_t kLongLine = 200;          // bytes
constexpr std::size_t kMostDifferences = 2000;  // beyond: what differs is one stretch

struct Piece {
    std::string_view text;
    std::size_t line;
};

void take_apart(std::string_view line, std::size_t number, std::vector<Piece>& pieces) {
    bool quoted = false;
    std::size_t begin = 0;
    int depth = 0;  // of arrays of numbers, which stay whole
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted) {
            i += c == '\\' ? 1 : 0;
            quoted = c != '"';
            continue;
        }
        quoted = c == '"';
        const bool opens_numbers =
            c == '[' && i + 1 < line.size() && line[i + 1] != '{' && line[i + 1] != '[';
        depth += opens_numbers ? 1 : 0;
        depth -= c == ']' && depth > 0 ? 1 : 0;
        const bool ends = depth == 0 && (c == ',' || c == '{' || (c == '[' && !opens_numbers));
        if (ends) {
            pieces.push_back({line.substr(begin, i + 1 - begin), number});
            begin = i + 1;
        }
    }
    if (begin < line.size()) {
        pieces.push_back({line.substr(begin), number});
    }
}

std::vector<Piece> pieces_of(std::string_view text) {
    std::vector<Piece> pieces;
    std::size_t number = 1;
    for (std::size_t at = 0; at < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        if (line.size() > kLongLine) {
            take_apart(line, number, pieces);
        } else {
            pieces.push_back({line, number});
        }
        at = end + 1;
    }
    return pieces;
}

// Pairs of equal pieces, in order: Myers 1986, forwards. Empty if there are too many differences.
std::vector<std::pair<std::size_t, std::size_t>> matches(const std::vector<Piece>& a,
                                                         const std::vector<Piece>& b) {
    const auto n = static_cast<long>(a.size()), m = static_cast<long>(b.size());
    const long most = std::min<long>(n + m, kMostDifferences);
    std::vector<std::vector<long>> trace;
    std::vector<long> reach(2 * static_cast<std::size_t>(most) + 3, 0);
    const auto at = [most](long k) { return static_cast<std::size_t>(k + most + 1); };
    for (long d = 0; d <= most; ++d) {
        trace.emplace_back(reach.begin() + (most + 1 - d - 1), reach.begin() + (most + 1 + d + 2));
        for (long k = -d; k <= d; k += 2) {
            const bool down = k == -d || (k != d && reach[at(k - 1)] < reach[at(k + 1)]);
            long x = down ? reach[at(k + 1)] : reach[at(k - 1)] + 1;
            while (x < n && x - k < m &&
                   a[static_cast<std::size_t>(x)].text == b[static_cast<std::size_t>(x - k)].text) {
                ++x;
            }
            reach[at(k)] = x;
            if (x < n || x - k < m) {
                continue;
            }
            std::vector<std::pair<std::size_t, std::size_t>> pairs;
            long px = n, pk = n - m;
            for (long e = d; e >= 0; --e) {
                const std::vector<long>& before = trace[static_cast<std::size_t>(e)];
                const auto was = [&](long q) { return before[static_cast<std::size_t>(q + e + 1)]; };
                const bool came_down = e > 0 && (pk == -e || (pk != e && was(pk - 1) < was(pk + 1)));
                const long from_k = e == 0 ? pk : came_down ? pk + 1 : pk - 1;
                const long from_x = e == 0 ? 0 : came_down ? was(pk + 1) : was(pk - 1) + 1;
                for (; px > from_x; --px) {
                    pairs.emplace_back(px - 1, px - 1 - pk);
                }
                px = e == 0 ? 0 : was(from_k);
                pk = from_k;
            }
            std::ranges::reverse(pairs);
            return pairs;
        }
    }
    return {};
}

void add_stretch(TextChanges& changes, std::span<const Piece> gone, std::span<const Piece> come) {
    std::size_t gone_bytes = 0, come_bytes = 0;
    for (const Piece& piece : gone) {
        changes.lines.push_back({false, piece.line, std::string(piece.text)});
        gone_bytes += piece.text.size();
    }
    for (const Piece& piece : come) {
        changes.lines.push_back({true, piece.line, std::string(piece.text)});
        come_bytes += piece.text.size();
    }
    changes.changed_lines += std::max(gone.size(), come.size());
    changes.changed_bytes += std::max(gone_bytes, come_bytes);
}

std::string size_text(std::size_t bytes) {
    if (bytes < 1000) {
        return fmt::format("{} byte{}", bytes, bytes == 1 ? "" : "s");
    }
    return bytes < 1000000 ? fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3)
                           : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

}  // namespace

TextChanges text_changes(std::string_view before, std::string_view after) {
    TextChanges changes;
    if (before == after) {
        return changes;
    }
    std::vector<Piece> a = pieces_of(before), b = pieces_of(after);
    std::size_t start = 0;
    while (start < a.size() && start < b.size() && a[start].text == b[start].text) {
        ++start;
    }
    std::size_t end = 0;
    while (end < a.size() - start && end < b.size() - start &&
           a[a.size() - 1 - end].text == b[b.size() - 1 - end].text) {
        ++end;
    }
    a = {a.begin() + static_cast<std::ptrdiff_t>(start), a.end() - static_cast<std::ptrdiff_t>(end)};
    b = {b.begin() + static_cast<std::ptrdiff_t>(start), b.end() - static_cast<std::ptrdiff_t>(end)};
    auto pairs = matches(a, b);
    pairs.emplace_back(a.size(), b.size());
    std::size_t x = 0, y = 0;
    for (const auto& [i, j] : pairs) {
        if (i > x || j > y) {
            add_stretch(changes, std::span(a).subspan(x, i - x), std::span(b).subspan(y, j - y));
        }
        x = i + 1;
        y = j + 1;
    }
    return changes;
}

std::string summary(const TextChanges& changes, std::size_t file_bytes) {
    if (changes.empty()) {
        return "nothing";
    }
    return fmt::format("{} line{}, {} of {}", changes.changed_lines, changes.changed_lines == 1 ? "" : "s",
                       size_text(changes.changed_bytes), size_text(file_bytes));
}

}  // namespace lanthorn::editor
