#include "engine/gpu/shader_source.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "lanthorn/core/error.h"
#include "lanthorn/core/installation.h"

namespace lanthorn::gpu {

namespace fs = std::filesystem;

namespace {

class Loader {
  public:
    Loader(const fs::path& root, const std::vector<std::string>& defines,
           const std::vector<std::string>& extensions)
        : root_(root), defines_(defines), extensions_(extensions) {}

    void append(const fs::path& file, const std::string& included_from) {
        const auto number = result.files.size();
        result.files.push_back(file);
        std::ifstream stream(file);
        if (!stream) {
            throw Error(ExitCode::bad_input,
                        file.string() + ": shader file not found" +
                            (included_from.empty() ? std::string() : ", included from " + included_from));
        }
        if (number > 0) {
            line_directive(1, number);
        }
        std::string line;
        bool for_cpp = false;  // in a header's part that only C++ reads
        for (int row = 1; std::getline(stream, line); ++row) {
            if (line.starts_with("#ifdef __cplusplus")) {
                for_cpp = true;
            } else if (line.starts_with("#else") || line.starts_with("#endif")) {
                for_cpp = false;
            }
            if (line.starts_with("#version")) {
                result.text += line + "\n";
                for (const std::string& extension : extensions_) {
                    result.text += "#extension " + extension + " : require\n";
                }
                for (const std::string& define : defines_) {
                    result.text += "#define " + define + "\n";
                }
                line_directive(row + 1, number);
            } else if (line.starts_with("#include") && for_cpp) {
                result.text += "\n";
            } else if (line.starts_with("#include")) {
                include(line, file, row);
                line_directive(row + 1, number);
            } else {
                result.text += line + "\n";
            }
        }
    }

    ShaderSource result;

  private:
    void line_directive(int row, std::size_t number) {
        result.text += "#line " + std::to_string(row) + " " + std::to_string(number) + "\n";
    }

    void include(const std::string& line, const fs::path& file, int row) {
        const std::string place = file.string() + ":" + std::to_string(row);
        const auto open = line.find('"');
        const auto close = line.rfind('"');
        if (open == std::string::npos || close <= open) {
            throw Error(ExitCode::bad_input, place + ": expected #include \"FILE\"");
        }
        const fs::path name = line.substr(open + 1, close - open - 1);
        fs::path found = file.parent_path() / name;
        if (!fs::exists(found)) {
            found = root_ / name;
        }
        found = found.lexically_normal();
        if (std::ranges::find(result.files, found) == result.files.end()) {
            append(found, place);
        }
    }

    fs::path root_;
    const std::vector<std::string>& defines_;
    const std::vector<std::string>& extensions_;
};

}  // namespace

fs::path shader_root() {
    if (const char* chosen = std::getenv("LANTHORN_SHADERS")) {
        return chosen;
    }
    const fs::path share = installed_share();
    return share.empty() ? fs::path(LANTHORN_SHADER_ROOT) : share / "shaders";
}

ShaderSource load_shader(const fs::path& path, const std::vector<std::string>& defines,
                         const std::vector<std::string>& extensions) {
    const fs::path root = shader_root();
    Loader loader(root, defines, extensions);
    loader.append((root / path).lexically_normal(), "");
    return std::move(loader.result);
}

std::string name_files(const std::string& log, const std::vector<fs::path>& files) {
    static const std::regex place(R"(^(?:ERROR: |WARNING: )?(\d+)[:(](\d+))");
    std::istringstream lines(log);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_search(line, match, place)) {
            const auto number = std::stoul(match[1]);
            if (number < files.size()) {
                line = files[number].string() + ":" + match[2].str() + match.suffix().str();
            }
        }
        result += (result.empty() ? "" : "\n") + line;
    }
    return result;
}

}  // namespace lanthorn::gpu
