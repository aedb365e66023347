#include "tests/gpu/gi/gl_calls.h"

#include <epoxy/gl.h>

#include <set>
#include <type_traits>
#include <utility>

namespace lanthorn::gi::test {

namespace {

GlCalls::Counts waited, allocated;
std::set<GLsync> fences;  // since the last next_frame()

// A function of OpenGL, which is a pointer of libepoxy's, with another in front of it. Libepoxy puts the
// driver's function there when it is called first, and calls what it finds there. `Which`: one a function.
template <int Which, typename Result, typename... Arguments>
struct Fronted {
    using Function = Result(GLAPIENTRY*)(Arguments...);
    static inline Function real = nullptr;
    static inline Function* place = nullptr;
    static inline Function front = nullptr;

    static void swap(Function& function, Function in_front) {
        if (real == nullptr) {
            place = &function;
            front = in_front;
            real = std::exchange(function, front);
        } else {
            function = std::exchange(real, nullptr);
        }
    }
    static Result forward(Arguments... arguments) {
        *place = real;
        const auto after = [] { real = std::exchange(*place, front); };
        if constexpr (std::is_void_v<Result>) {
            real(arguments...);
            after();
        } else {
            const Result result = real(arguments...);
            after();
            return result;
        }
    }
};

template <int Which, typename Result, typename... Arguments>
struct Counted {
    using Self = Fronted<Which, Result, Arguments...>;
    static inline GlCalls::Counts* counts = nullptr;
    static inline const char* name = nullptr;

    static Result GLAPIENTRY call(Arguments... arguments) {
        ++(*counts)[name];
        return Self::forward(arguments...);
    }
    static void swap(typename Self::Function& function, GlCalls::Counts& into, const char* called) {
        counts = &into;
        name = called;
        Self::swap(function, &call);
    }
};

template <int Which, typename Result, typename... Arguments>
Counted<Which, Result, Arguments...> counted(Result(GLAPIENTRY*)(Arguments...)) {
    return {};
}

using Fence = Fronted<-1, GLsync, GLenum, GLbitfield>;
using Wait = Fronted<-2, GLenum, GLsync, GLbitfield, GLuint64>;

GLsync GLAPIENTRY set_fence(GLenum condition, GLbitfield flags) {
    const GLsync fence = Fence::forward(condition, flags);
    fences.insert(fence);
    return fence;
}

GLenum GLAPIENTRY wait_for_fence(GLsync fence, GLbitfield flags, GLuint64 nanoseconds) {
    if (nanoseconds > 0 && fences.contains(fence)) {
        ++waited["glClientWaitSync"];
    }
    return Wait::forward(fence, flags, nanoseconds);
}

// Puts all counts in, or takes them out again.
void swap_all() {
#define COUNTED(function, into) counted<__COUNTER__>(function).swap(function, into, #function + 6)
    COUNTED(epoxy_glFinish, waited);
    COUNTED(epoxy_glReadPixels, waited);
    COUNTED(epoxy_glGetTexImage, waited);
    COUNTED(epoxy_glGetTextureImage, waited);
    COUNTED(epoxy_glGetTextureSubImage, waited);
    COUNTED(epoxy_glGetBufferSubData, waited);
    COUNTED(epoxy_glGetNamedBufferSubData, waited);
    COUNTED(epoxy_glMapBuffer, waited);
    COUNTED(epoxy_glMapNamedBuffer, waited);
    COUNTED(epoxy_glGetQueryObjectiv, waited);
    COUNTED(epoxy_glGetQueryObjectuiv, waited);
    COUNTED(epoxy_glGetQueryObjecti64v, waited);
    COUNTED(epoxy_glGetQueryObjectui64v, waited);
    COUNTED(epoxy_glCreateBuffers, allocated);
    COUNTED(epoxy_glNamedBufferStorage, allocated);
    COUNTED(epoxy_glNamedBufferData, allocated);
    COUNTED(epoxy_glMapBufferRange, allocated);  // for good, where it is mapped persistently
    COUNTED(epoxy_glMapNamedBufferRange, allocated);
    COUNTED(epoxy_glCreateTextures, allocated);
    COUNTED(epoxy_glGenTextures, allocated);
    COUNTED(epoxy_glTextureStorage1D, allocated);
    COUNTED(epoxy_glTextureStorage2D, allocated);
    COUNTED(epoxy_glTextureStorage3D, allocated);
    COUNTED(epoxy_glTextureView, allocated);
    COUNTED(epoxy_glCreateVertexArrays, allocated);
    COUNTED(epoxy_glCreateFramebuffers, allocated);
    COUNTED(epoxy_glCreateSamplers, allocated);
    COUNTED(epoxy_glCreateQueries, allocated);
    COUNTED(epoxy_glCreateProgram, allocated);
    COUNTED(epoxy_glCreateShader, allocated);
#undef COUNTED
    Fence::swap(epoxy_glFenceSync, set_fence);
    Wait::swap(epoxy_glClientWaitSync, wait_for_fence);
}

}  // namespace

GlCalls::GlCalls() {
    next_frame();
    swap_all();
}

GlCalls::~GlCalls() {
    swap_all();
}

const GlCalls::Counts& GlCalls::waits() const {
    return waited;
}

const GlCalls::Counts& GlCalls::allocations() const {
    return allocated;
}

void GlCalls::next_frame() {
    waited.clear();
    allocated.clear();
    fences.clear();
}

}  // namespace lanthorn::gi::test
