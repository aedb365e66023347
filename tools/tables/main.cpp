// tables NAME prints a table of components or settings; tables --update PAGE... puts them into pages.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>

#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"
#include "tools/tables/tables.h"

namespace {

void update(const char* path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw lanthorn::InputError(path, "", "cannot be opened");
    }
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    lanthorn::write_file(path, lanthorn::tools::with_tables(page, path));
}

}  // namespace

int main(int argc, char** argv) {
    const std::span<char*> words(argv + 1, static_cast<std::size_t>(argc > 0 ? argc - 1 : 0));
    try {
        if (words.size() > 1 && std::string_view(words[0]) == "--update") {
            for (const char* path : words.subspan(1)) {
                update(path);
            }
            return 0;
        }
        if (words.size() != 1) {
            throw lanthorn::InputError("expected components, settings, or --update PAGE...");
        }
        std::fputs(lanthorn::tools::table(words[0]).c_str(), stdout);
        return 0;
    } catch (const lanthorn::Error& error) {
        std::fprintf(stderr, "tables: %s\n", error.what());
        return 2;
    }
}
