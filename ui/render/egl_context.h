#pragma once

#include "core/base/result.h"

#include <memory>

namespace knittsim::render {

/// An OpenGL 3.3 core context without window, surface or display server. Current on the thread that made it.
class EglContext {
public:
    /// Errors: KS0401.
    static Result<std::unique_ptr<EglContext>> create();

    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

private:
    EglContext(void* display, void* context) : m_display(display), m_context(context) {}

    void* m_display;
    void* m_context;
};

} // namespace knittsim::render
