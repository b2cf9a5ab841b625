#include "render/gl/gl_program.hpp"

#include <epoxy/gl.h>

namespace plumb {
namespace {

constexpr GLsizei kMessageBytes = 1024;

Result<GLuint> compileShader(GLenum kind, const std::string& source) {
    const GLuint shader = glCreateShader(kind);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled != 0) return shader;
    std::string message(kMessageBytes, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, kMessageBytes, &length, message.data());
    message.resize(static_cast<std::size_t>(length));
    glDeleteShader(shader);
    return Error{"shader", message, "update the graphics driver; Plumb needs OpenGL 3.3"};
}

}  // namespace

Result<GlProgram> buildProgram(const std::string& vertexSource, const std::string& fragmentSource) {
    const Result<GLuint> vertex = compileShader(GL_VERTEX_SHADER, vertexSource);
    if (!vertex) return vertex.error();
    const Result<GLuint> fragment = compileShader(GL_FRAGMENT_SHADER, fragmentSource);
    if (!fragment) return fragment.error();

    GlProgram program;
    program.name = glCreateProgram();
    glAttachShader(program.name, *vertex);
    glAttachShader(program.name, *fragment);
    glLinkProgram(program.name);
    glDeleteShader(*vertex);
    glDeleteShader(*fragment);
    GLint linked = 0;
    glGetProgramiv(program.name, GL_LINK_STATUS, &linked);
    if (linked == 0)
        return Error{"shader", "the driver could not link the program", "update the graphics driver"};

    program.viewX = glGetUniformLocation(program.name, "viewX");
    program.viewY = glGetUniformLocation(program.name, "viewY");
    program.viewOffset = glGetUniformLocation(program.name, "viewOffset");
    program.tint = glGetUniformLocation(program.name, "batchTint");
    program.texelScale = glGetUniformLocation(program.name, "texelScale");
    program.up = glGetUniformLocation(program.name, "up");
    return program;
}

}  // namespace plumb
