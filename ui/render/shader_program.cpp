#include "ui/render/shader_program.h"

#include "core/base/file.h"
#include "core/base/resources.h"

#include <epoxy/gl.h>

#include <string>

namespace knittsim::render {

namespace {

Result<std::string> readShader(std::span<const char* const> parts) {
    std::string text = "#version 330 core\n";
    for (const char* part : parts) {
        Result<std::string> read = readFile(resourceFolder() / "shaders" / part);
        if (!read) {
            return read;
        }
        // Compilers count lines from here, so that their messages fit the file.
        text += "#line 1\n" + read.value();
    }
    return text;
}

Diagnostic buildError(const std::string& file, std::string log) {
    return {.id = "KS0403", .place = {.file = file}, .arguments = {std::move(log)}};
}

/// 0 and a filled `log` when it does not compile.
GLuint compile(GLenum kind, const std::string& text, std::string& log) {
    const GLuint shader = glCreateShader(kind);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    GLint ok = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    if (ok == GL_TRUE) {
        return shader;
    }
    log.resize(2000);
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    return 0;
}

} // namespace

Result<std::unique_ptr<ShaderProgram>> ShaderProgram::load(std::span<const char* const> vertexParts,
                                                           std::span<const char* const> fragmentParts) {
    std::unique_ptr<ShaderProgram> result(new ShaderProgram(glCreateProgram()));
    for (const auto& [kind, parts] :
         {std::pair{GLenum{GL_VERTEX_SHADER}, vertexParts}, {GLenum{GL_FRAGMENT_SHADER}, fragmentParts}}) {
        const Result<std::string> text = readShader(parts);
        if (!text) {
            return Result<std::unique_ptr<ShaderProgram>>::failure(text.diagnostics());
        }
        std::string log;
        const GLuint shader = compile(kind, text.value(), log);
        if (shader == 0) {
            return buildError(parts.back(), log);
        }
        glAttachShader(result->m_program, shader);
        glDeleteShader(shader);
    }
    glLinkProgram(result->m_program);
    GLint ok = GL_FALSE;
    glGetProgramiv(result->m_program, GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE) {
        return buildError(fragmentParts.back(), "the shaders do not fit together");
    }
    return result;
}

ShaderProgram::~ShaderProgram() {
    glDeleteProgram(m_program);
}

void ShaderProgram::use() const {
    glUseProgram(m_program);
}

int ShaderProgram::location(const char* name) const {
    return glGetUniformLocation(m_program, name);
}

void ShaderProgram::set(const char* name, int value) const {
    glUniform1i(location(name), value);
}
void ShaderProgram::set(const char* name, float value) const {
    glUniform1f(location(name), value);
}

void ShaderProgram::set(const char* name, const Eigen::Vector2f& value) const {
    glUniform2fv(location(name), 1, value.data());
}

void ShaderProgram::set(const char* name, const Eigen::Vector3f& value) const {
    glUniform3fv(location(name), 1, value.data());
}

void ShaderProgram::set(const char* name, const Eigen::Vector4f& value) const {
    glUniform4fv(location(name), 1, value.data());
}

void ShaderProgram::set(const char* name, const Eigen::Matrix4f& value) const {
    glUniformMatrix4fv(location(name), 1, GL_FALSE, value.data());
}

} // namespace knittsim::render
