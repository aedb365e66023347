// Output files that appear whole or not at all.
#pragma once

#include <filesystem>

namespace lanthorn {

// A file being written. The caller writes `temporary()` (beside the target, same ending), then calls
// commit(), which renames it over the target. Without commit() the destructor removes the temporary and
// leaves an existing target as it was.
class AtomicFile {
  public:
    // Throws InputError if the target's folder does not exist, the target is a folder, or nothing can be
    // written there. Creates the (empty) temporary.
    explicit AtomicFile(std::filesystem::path target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::filesystem::path& target() const { return target_; }
    const std::filesystem::path& temporary() const { return temporary_; }

    // Renames the temporary to the target. Throws InputError if that fails. Call at most once.
    void commit();

  private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    bool committed_ = false;
};

// Throws InputError unless a file could be written at `path` now. For early checks, before hours of work;
// leaves nothing behind.
void check_writable(const std::filesystem::path& path);

}  // namespace lanthorn
