// The end of oneTBB's threads before the end of main.
#pragma once

#include <memory>

namespace lanthorn::ecs {

// Make one first of all in main. Left alone, oneTBB's threads end some time after main returns, while static
// objects that they use are being destroyed (oneTBB's issue 977). The destructor waits for them, or does
// nothing where oneTBB says that waiting is not safe.
class WorkersEndWithMain {
  public:
    WorkersEndWithMain();
    ~WorkersEndWithMain();
    WorkersEndWithMain(const WorkersEndWithMain&) = delete;
    WorkersEndWithMain& operator=(const WorkersEndWithMain&) = delete;

  private:
    struct Handle;
    std::unique_ptr<Handle> handle_;
};

}  // namespace lanthorn::ecs
