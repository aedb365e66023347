#include "lanthorn/replay/recording.h"

#include <fstream>
#include <iterator>
#include <span>

#include "engine/replay/recording_format.h"
#include "lanthorn/core/atomic_file.h"
#include "lanthorn/core/error.h"

namespace lanthorn::replay {

void write_recording(const std::string& path, const Recording& recording) {
    const std::string end = recording.cut_off.empty() ? encoded_end(recording.steps.size()) : "";
    write_file(path, encoded_beginning(recording.header) +
                         encoded_steps(recording.header, 0, recording.steps) + end);
}

Recording read_recording(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    if (!in) {
        throw InputError(path, "", "cannot be opened");
    }
    const std::vector<char> file{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    return decoded_recording(path, std::as_bytes(std::span(file)));
}

}  // namespace lanthorn::replay
