#include "paint/gl.h"

#include <assert.h>
#include <stdio.h>

#include "base/memory.h"

#define GL_LOAD(name_) gl->name_ = (__typeof__(gl->name_))get("gl" #name_);
#define GL_MISSES(name_) || !gl->name_

bool gl_load(Gl *gl, GlGetFunction get) {
    GL_FUNCTIONS(GL_LOAD)
    if (false GL_FUNCTIONS(GL_MISSES))
        return false;
    /* a library gives an address for any name: only the version tells whether the function exists */
    GLint major = 0, minor = 0;
    gl->GetIntegerv(GL_MAJOR_VERSION, &major);
    gl->GetIntegerv(GL_MINOR_VERSION, &minor);
    return major > 3 || (major == 3 && minor >= 3);
}

void gl_check(const Gl *gl) {
    GLenum error = gl->GetError();
    if (error == GL_OUT_OF_MEMORY)
        memory_end();
    assert(error == GL_NO_ERROR);
}

static GLuint compiled(const Gl *gl, GLenum kind, const char *source) {
    GLuint shader = gl->CreateShader(kind);
    gl->ShaderSource(shader, 1, &source, NULL);
    gl->CompileShader(shader);
    GLint good = 0;
    gl->GetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        char log[2000];
        gl->GetShaderInfoLog(shader, sizeof log, NULL, log);
        fprintf(stderr, "%s\n", log);
        assert(!"a shader compiles");
    }
    return shader;
}

GLuint gl_program(const Gl *gl, const char *vertex, const char *fragment, const char *const *attributes) {
    GLuint program = gl->CreateProgram();
    GLuint shaders[] = {compiled(gl, GL_VERTEX_SHADER, vertex), compiled(gl, GL_FRAGMENT_SHADER, fragment)};
    for (int i = 0; i < 2; i++)
        gl->AttachShader(program, shaders[i]);
    for (GLuint location = 0; attributes[location]; location++)
        gl->BindAttribLocation(program, location, attributes[location]);
    gl->LinkProgram(program);
    for (int i = 0; i < 2; i++)
        gl->DeleteShader(shaders[i]);
    GLint good = 0;
    gl->GetProgramiv(program, GL_LINK_STATUS, &good);
    if (!good) {
        char log[2000];
        gl->GetProgramInfoLog(program, sizeof log, NULL, log);
        fprintf(stderr, "%s\n", log);
        assert(!"a program links");
    }
    return program;
}
