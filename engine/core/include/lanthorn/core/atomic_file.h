// Output files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <string_view>

namespace lanthorn {

// A file being written: write() fills a temporary beside the target, commit() renames it over the target.
// Without commit() the destructor removes the temporary and leaves an existing target as it was.
class AtomicFile {
  public:
    // Throws InputError if the target's folder does not exist, the target is a folder or a device, or nothing
    // can be written there. Creates the (empty) temporary.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    // Appends. Throws InputError with the system's reason: a full disk, say.
    void write(std::string_view bytes);

    // Says that all is written; commit() does so too. For several files that are to appear together: finish
    // all, then commit all. Throws InputError with the system's reason.
    void finish();

    // Renames the temporary to the target. Throws InputError if that fails. Call at most once, and last.
    void commit();

  private:
    [[noreturn]] void fail(int error) const;

    std::filesystem::path target_;
    std::filesystem::path temporary_;
    int file_ = -1;
    bool committed_ = false;
};

// The whole of a file at once. Throws InputError as AtomicFile does.
void write_file(const std::filesystem::path& path, std::string_view bytes);

// Throws InputError unless a file could be written at `path` now. For early checks, before hours of work;
// leaves nothing behind.
void check_writable(const std::filesystem::path& path);

}  // namespace lanthorn
