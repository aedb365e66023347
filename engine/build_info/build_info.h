// Of which commit and how a program is built: for --version, --stats and recordings. For programs; nothing of
// it is installed.
#pragma once

#include <string>

namespace lanthorn {

extern const char* const kVersion;  // "0.1.0"
extern const char* const kCommit;   // "c73c764abcde", with "-dirty" for local changes; "unknown" outside git
extern const char* const kBuildType;  // "Release"

// "0.1.0 c73c764abcde Release"
std::string build_words();

}  // namespace lanthorn
