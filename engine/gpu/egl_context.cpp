#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/gpu/display_order.h"
#include "lanthorn/core/error.h"
#include "lanthorn/gpu/context.h"

namespace lanthorn::gpu {

namespace {

class EglContext final : public Context {
  public:
    EglContext() {
        std::string last;
        for (const DisplayAttempt<EGLDisplay>& attempt : displays()) {
            try {
                if (open(attempt.display) && (attempt.software || !info().software)) {
                    return;
                }
            } catch (const Error& error) {  // this one lacks something: the next may not
                last = std::string("; ") + error.what();
            }
            close();
        }
        throw Error(ExitCode::no_gl,
                    "EGL: no display offers OpenGL 4.5 core (tried surfaceless and every device)" + last);
    }

    ~EglContext() override { close(); }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

  private:
    void bind() override { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_); }

    void close() {
        if (context_ != EGL_NO_CONTEXT) {
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            eglDestroyContext(display_, std::exchange(context_, EGL_NO_CONTEXT));
        }
    }

    // Where Mesa stands beside a vendor's driver, surfaceless alone would be llvmpipe.
    static std::vector<DisplayAttempt<EGLDisplay>> displays() {
        std::vector<EGLDisplay> hardware, surfaceless, software;
        if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration") &&
            epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
            std::array<EGLDeviceEXT, 16> devices{};
            EGLint count = 0;
            if (eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
                for (EGLint i = 0; i < count; ++i) {
                    (is_software(devices[i]) ? software : hardware)
                        .push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
                }
            }
        }
        if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
            surfaceless.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr));
        }
        // Mesa's own switch, which its surfaceless platform follows.
        const char* always = std::getenv("LIBGL_ALWAYS_SOFTWARE");
        return display_order(hardware, surfaceless, software,
                             always != nullptr && *always != '\0' && std::string_view(always) != "0" &&
                                 std::string_view(always) != "false");
    }

    static bool is_software(EGLDeviceEXT device) {
        const char* extensions = epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_query")
                                     ? eglQueryDeviceStringEXT(device, EGL_EXTENSIONS)
                                     : nullptr;
        return extensions != nullptr &&
               std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
    }

    bool open(EGLDisplay display) {
        if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
            return false;
        }
        if (!eglBindAPI(EGL_OPENGL_API)) {
            return false;
        }
        constexpr std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                                   4,
                                                   EGL_CONTEXT_MINOR_VERSION,
                                                   5,
                                                   EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                   EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                   EGL_NONE};
        EGLConfig config = EGL_NO_CONFIG_KHR;
        if (!epoxy_has_egl_extension(display, "EGL_KHR_no_config_context")) {
            constexpr std::array<EGLint, 3> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
            EGLint found = 0;
            if (!eglChooseConfig(display, wanted.data(), &config, 1, &found) || found == 0) {
                return false;
            }
        }
        EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
        if (context == EGL_NO_CONTEXT) {
            return false;
        }
        if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
            eglDestroyContext(display, context);
            return false;
        }
        display_ = display;
        context_ = context;
        adopt_current();
        return true;
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> create_headless_context() {
    return std::make_unique<EglContext>();
}

}  // namespace lanthorn::gpu
