// Linked programs that nobody holds any more, for whoever asks for the same text next: a second App in a
// context compiles nothing. A context has one store, and a program is lent to one holder at a time, so that
// uniforms are its own.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace lanthorn::gpu {

// A uniform that has been set, and how it is put back to what it is after linking.
struct SetUniform {
    GLint location = -1;  // GL's; -1: the program has none of that name
    GLsizei count = 0;    // elements of an array that have been set
    GLint initial = 0;    // of an int: a sampler's may come from its layout. All else begins as 0
    void (*put_back)(GLuint program, const SetUniform& uniform) = nullptr;
};

// A program without its holder: GL's name and what has been set in it.
struct LinkedProgram {
    GLuint id = 0;
    std::unordered_map<std::string, SetUniform> uniforms;  // by name
};

class IdlePrograms {
  public:
    // Programs of one text. Whoever holds one holds its shelf, which may outlive the store.
    struct Shelf {
        std::vector<LinkedProgram> idle;
        bool open = true;  // the context lives; GL's names went with it otherwise
    };

    IdlePrograms() = default;
    ~IdlePrograms();
    IdlePrograms(const IdlePrograms&) = delete;
    IdlePrograms& operator=(const IdlePrograms&) = delete;

    // The store of this thread's current Context, or null: a context of somebody else's making.
    static std::shared_ptr<IdlePrograms> current();
    // Says that the context of `store` is the thread's current one.
    static void set_current(const std::shared_ptr<IdlePrograms>& store);
    // The shelf of a program's text: its stages' names and sources.
    std::shared_ptr<Shelf> shelf(const std::string& text);
    // An idle program of the shelf as it was after linking, or one with id 0. The context must be current.
    static LinkedProgram take(Shelf& shelf);
    // Deletes what is idle where it has become much: settings that are compiled in may have many values. The
    // context must be current.
    void limit();

  private:
    std::unordered_map<std::string, std::shared_ptr<Shelf>> shelves_;
};

}  // namespace lanthorn::gpu
