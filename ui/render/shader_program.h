#pragma once

#include "core/base/result.h"

#include <Eigen/Core>

#include <memory>
#include <span>

namespace knittsim::render {

/// A linked pair of shaders from resources/shaders. Setting a uniform that the shaders do not use is no
/// error.
class ShaderProgram {
public:
    /// Files in resources/shaders; the parts of a shader are put one after the other. Errors: KS0001, KS0403.
    static Result<std::unique_ptr<ShaderProgram>> load(std::span<const char* const> vertexParts,
                                                       std::span<const char* const> fragmentParts);

    ~ShaderProgram();
    ShaderProgram(const ShaderProgram&) = delete;
    ShaderProgram& operator=(const ShaderProgram&) = delete;

    void use() const;

    // Set uniforms of the program in use.
    void set(const char* name, int value) const;
    void set(const char* name, float value) const;
    void set(const char* name, const Eigen::Vector2f& value) const;
    void set(const char* name, const Eigen::Vector3f& value) const;
    void set(const char* name, const Eigen::Vector4f& value) const;
    void set(const char* name, const Eigen::Matrix4f& value) const;

private:
    explicit ShaderProgram(unsigned program) : m_program(program) {}
    int location(const char* name) const;

    unsigned m_program;
};

} // namespace knittsim::render
