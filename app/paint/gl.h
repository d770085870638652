/* The functions of OpenGL 3.3 core, looked up one by one in the library that made the context, so that the program is
 * linked with no GL library and the same painter works with and without a window. */
#pragma once

#include <stdbool.h>

#define GL_GLEXT_PROTOTYPES /* the table below takes the types of its entries from these declarations; none is linked  \
                             */
#include <GL/glcorearb.h>

#define GL_FUNCTIONS(X)                                                                                                \
    X(ActiveTexture)                                                                                                   \
    X(AttachShader)                                                                                                    \
    X(BindAttribLocation)                                                                                              \
    X(BindBuffer)                                                                                                      \
    X(BindFramebuffer)                                                                                                 \
    X(BindRenderbuffer)                                                                                                \
    X(BindTexture)                                                                                                     \
    X(BindVertexArray)                                                                                                 \
    X(BlendFunc)                                                                                                       \
    X(BlitFramebuffer)                                                                                                 \
    X(BufferData)                                                                                                      \
    X(CheckFramebufferStatus)                                                                                          \
    X(Clear)                                                                                                           \
    X(ClearColor)                                                                                                      \
    X(CompileShader)                                                                                                   \
    X(CreateProgram)                                                                                                   \
    X(CreateShader)                                                                                                    \
    X(DeleteBuffers)                                                                                                   \
    X(DeleteFramebuffers)                                                                                              \
    X(DeleteProgram)                                                                                                   \
    X(DeleteRenderbuffers)                                                                                             \
    X(DeleteShader)                                                                                                    \
    X(DeleteTextures)                                                                                                  \
    X(DeleteVertexArrays)                                                                                              \
    X(DepthFunc)                                                                                                       \
    X(DepthMask)                                                                                                       \
    X(Disable)                                                                                                         \
    X(DrawElements)                                                                                                    \
    X(Enable)                                                                                                          \
    X(EnableVertexAttribArray)                                                                                         \
    X(Finish)                                                                                                          \
    X(FramebufferRenderbuffer)                                                                                         \
    X(FramebufferTexture2D)                                                                                            \
    X(GenBuffers)                                                                                                      \
    X(GenFramebuffers)                                                                                                 \
    X(GenRenderbuffers)                                                                                                \
    X(GenTextures)                                                                                                     \
    X(GenVertexArrays)                                                                                                 \
    X(GetError)                                                                                                        \
    X(GetIntegerv)                                                                                                     \
    X(GetProgramInfoLog)                                                                                               \
    X(GetProgramiv)                                                                                                    \
    X(GetShaderInfoLog)                                                                                                \
    X(GetShaderiv)                                                                                                     \
    X(GetUniformLocation)                                                                                              \
    X(LinkProgram)                                                                                                     \
    X(PixelStorei)                                                                                                     \
    X(ReadPixels)                                                                                                      \
    X(RenderbufferStorage)                                                                                             \
    X(RenderbufferStorageMultisample)                                                                                  \
    X(Scissor)                                                                                                         \
    X(ShaderSource)                                                                                                    \
    X(StencilFunc)                                                                                                     \
    X(StencilOp)                                                                                                       \
    X(TexImage2D)                                                                                                      \
    X(TexParameteri)                                                                                                   \
    X(TexSubImage2D)                                                                                                   \
    X(Uniform2f)                                                                                                       \
    X(Uniform3f)                                                                                                       \
    X(Uniform4fv)                                                                                                      \
    X(UseProgram)                                                                                                      \
    X(VertexAttribIPointer)                                                                                            \
    X(VertexAttribPointer)                                                                                             \
    X(Viewport)

#define GL_MEMBER(name_) __typeof__(gl##name_) *name_;

/* One context's functions. */
typedef struct Gl {
    GL_FUNCTIONS(GL_MEMBER)
} Gl;

typedef void (*GlFunction)(void);
typedef GlFunction (*GlGetFunction)(const char *name);

/* Looks up all functions of the current context; false if it is older than OpenGL 3.3. */
bool gl_load(Gl *gl, GlGetFunction get);

/* Asserts that no call since the last check was wrong. Ends the program as memory_end does if memory was exhausted. */
void gl_check(const Gl *gl);

/* Links a program of two shaders of this project; an error in a shader is a bug. Attributes get locations in the order
 * of their names; NULL ends the list. */
GLuint gl_program(const Gl *gl, const char *vertex, const char *fragment, const char *const *attributes);
