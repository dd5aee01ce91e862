#include "ui/render/egl_context.h"

#include <epoxy/egl.h>

#include <array>
#include <dlfcn.h>
#include <vector>

namespace knittsim::render {

namespace {

Diagnostic noContext(std::string reason) {
    return {.id = "KS0401", .place = {}, .arguments = {std::move(reason)}};
}

bool libraryExists(const char* name) {
    // epoxy ends the program when a library is missing, so look first.
    void* library = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    if (library != nullptr) {
        dlclose(library);
    }
    return library != nullptr;
}

EGLDisplay openDisplay() {
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        return eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    }
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

EGLContext makeContext(EGLDisplay display) {
    constexpr std::array<EGLint, 3> kConfig{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    std::vector<EGLint> wanted{EGL_CONTEXT_MAJOR_VERSION,
                               3,
                               EGL_CONTEXT_MINOR_VERSION,
                               3,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                               EGL_LOSE_CONTEXT_ON_RESET,
                               EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API)) {
        return EGL_NO_CONTEXT;
    }
    if (!eglChooseConfig(display, kConfig.data(), &config, 1, &count) || count < 1) {
        config = nullptr; // EGL_NO_CONFIG_KHR
    }
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
    if (context != EGL_NO_CONTEXT) {
        return context;
    }
    wanted.resize(wanted.size() - 3); // older drivers do not tell of resets
    wanted.push_back(EGL_NONE);
    return eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
}

} // namespace

Result<std::unique_ptr<EglContext>> EglContext::create() {
    if (!libraryExists("libEGL.so.1") || !libraryExists("libGL.so.1")) {
        return noContext("libEGL.so.1 or libGL.so.1 is missing");
    }
    const EGLDisplay display = openDisplay();
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
        return noContext("EGL finds no device");
    }
    const EGLContext context = makeContext(display);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
        if (context != EGL_NO_CONTEXT) {
            eglDestroyContext(display, context);
        }
        eglTerminate(display);
        return noContext("EGL gives no OpenGL 3.3 core context");
    }
    return std::unique_ptr<EglContext>(new EglContext(display, context));
}

EglContext::~EglContext() {
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
    eglTerminate(m_display);
}

} // namespace knittsim::render
