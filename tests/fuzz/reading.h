// What the targets share.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "lanthorn/core/error.h"

namespace lanthorn::fuzz {

// A folder of this process, removed when it ends by itself.
const std::filesystem::path& folder();

// Writes `bytes` into a file of that name there, in the place of the one before.
std::filesystem::path write_input(std::string_view name, std::string_view bytes);

// Throws Finding unless the refusal is one line of at most 500 characters beside the names of files.
void check_refusal(const Error& refusal);

// Runs `read`; a refusal is checked, everything else goes on.
template <class Read>
void expect_refused_or_read(Read read) {
    try {
        read();
    } catch (const InputError& refusal) {
        check_refusal(refusal);
    }
}

}  // namespace lanthorn::fuzz
