#pragma once

#include <GL/glcorearb.h>

#include <nacre/result.hpp>
#include <nacre/uniforms.hpp>

namespace nacre::demo {

// The OpenGL functions that the demo and the tests call, looked up through the context's own
// GetProcAddress: X(type, name).
#define NACRE_GL_FUNCTIONS(X)                                           \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                            \
    X(PFNGLATTACHSHADERPROC, AttachShader)                              \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                  \
    X(PFNGLBINDBUFFERBASEPROC, BindBufferBase)                          \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                        \
    X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                      \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                        \
    X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                        \
    X(PFNGLBUFFERDATAPROC, BufferData)                                  \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)          \
    X(PFNGLCLEARPROC, Clear)                                            \
    X(PFNGLCLEARCOLORPROC, ClearColor)                                  \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                            \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                            \
    X(PFNGLCREATESHADERPROC, CreateShader)                              \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                            \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                  \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                            \
    X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                \
    X(PFNGLDELETESHADERPROC, DeleteShader)                              \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                          \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                  \
    X(PFNGLDISABLEPROC, Disable)                                        \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                  \
    X(PFNGLDRAWBUFFERSPROC, DrawBuffers)                                \
    X(PFNGLDRAWELEMENTSPROC, DrawElements)                              \
    X(PFNGLENABLEPROC, Enable)                                          \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)        \
    X(PFNGLFINISHPROC, Finish)                                          \
    X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)        \
    X(PFNGLFRAMEBUFFERTEXTURE2DPROC, FramebufferTexture2D)              \
    X(PFNGLFRONTFACEPROC, FrontFace)                                    \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                                  \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                        \
    X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                      \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                        \
    X(PFNGLGETACTIVEUNIFORMPROC, GetActiveUniform)                      \
    X(PFNGLGETACTIVEUNIFORMBLOCKIVPROC, GetActiveUniformBlockiv)        \
    X(PFNGLGETACTIVEUNIFORMSIVPROC, GetActiveUniformsiv)                \
    X(PFNGLGETERRORPROC, GetError)                                      \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                    \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                              \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                      \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                                \
    X(PFNGLGETSTRINGPROC, GetString)                                    \
    X(PFNGLGETUNIFORMBLOCKINDEXPROC, GetUniformBlockIndex)              \
    X(PFNGLGETUNIFORMINDICESPROC, GetUniformIndices)                    \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                  \
    X(PFNGLGETUNIFORMFVPROC, GetUniformfv)                              \
    X(PFNGLGETUNIFORMIVPROC, GetUniformiv)                              \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                \
    X(PFNGLREADBUFFERPROC, ReadBuffer)                                  \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                  \
    X(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample) \
    X(PFNGLSCISSORPROC, Scissor)                                        \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                              \
    X(PFNGLTEXIMAGE1DPROC, TexImage1D)                                  \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                  \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                            \
    X(PFNGLTEXSUBIMAGE2DPROC, TexSubImage2D)                            \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                                    \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                                    \
    X(PFNGLUNIFORM3FVPROC, Uniform3fv)                                  \
    X(PFNGLUNIFORMBLOCKBINDINGPROC, UniformBlockBinding)                \
    X(PFNGLUNIFORMMATRIX3FVPROC, UniformMatrix3fv)                      \
    X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                      \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                  \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                \
    X(PFNGLVIEWPORTPROC, Viewport)

struct GlFunctions {
#define NACRE_GL_MEMBER(type, name) type name = nullptr;
    NACRE_GL_FUNCTIONS(NACRE_GL_MEMBER)
#undef NACRE_GL_MEMBER

    /// Looks all of them up; the error names the one that is missing.
    static Result<GlFunctions> load(GetProcAddress getProcAddress);
};

}  // namespace nacre::demo
