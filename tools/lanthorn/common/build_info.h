#pragma once

namespace lanthorn::tools {

// Of this build, for --version and --stats.
extern const char* const kVersion;  // "0.1.0"
extern const char* const kCommit;   // "c73c764abcde", with "-dirty" for local changes; "unknown" outside git
extern const char* const kBuildType;  // "Release"

}  // namespace lanthorn::tools
