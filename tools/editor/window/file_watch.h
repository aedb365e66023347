// Watches a file's folder, so that a file that another program writes, replaces or moves there is noticed.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

namespace lanthorn::edit_window {

class FileWatch {
  public:
    // `wake` is called from another thread when something has happened; it must not block.
    explicit FileWatch(std::function<void()> wake);
    ~FileWatch();
    FileWatch(const FileWatch&) = delete;
    FileWatch& operator=(const FileWatch&) = delete;

    // Another file, or none. A folder that cannot be watched is looked at every two seconds.
    void watch(const std::filesystem::path& file);
    // Once for all that happened in the folder since the call before, and not before it has been quiet there
    // for 200 ms.
    bool happened();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace lanthorn::edit_window
