#pragma once
#include <GLES3/gl32.h>

namespace telar::gl {

// Every GL entry point that telar calls: OpenGL ES 3.0, loaded by name at run time on each backend.
#define TELAR_GL_FUNCTIONS(F)                                       \
  F(ACTIVETEXTURE, ActiveTexture)                                   \
  F(ATTACHSHADER, AttachShader)                                     \
  F(BEGINTRANSFORMFEEDBACK, BeginTransformFeedback)                 \
  F(BINDATTRIBLOCATION, BindAttribLocation)                         \
  F(BINDBUFFER, BindBuffer)                                         \
  F(BINDBUFFERBASE, BindBufferBase)                                 \
  F(BINDFRAMEBUFFER, BindFramebuffer)                               \
  F(BINDRENDERBUFFER, BindRenderbuffer)                             \
  F(BINDSAMPLER, BindSampler)                                       \
  F(BINDTEXTURE, BindTexture)                                       \
  F(BINDVERTEXARRAY, BindVertexArray)                               \
  F(BLENDEQUATION, BlendEquation)                                   \
  F(BLENDFUNCSEPARATE, BlendFuncSeparate)                           \
  F(BLITFRAMEBUFFER, BlitFramebuffer)                               \
  F(BUFFERDATA, BufferData)                                         \
  F(BUFFERSUBDATA, BufferSubData)                                   \
  F(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)                 \
  F(CLEAR, Clear)                                                   \
  F(CLEARCOLOR, ClearColor)                                         \
  F(CLEARDEPTHF, ClearDepthf)                                       \
  F(COLORMASK, ColorMask)                                           \
  F(COMPILESHADER, CompileShader)                                   \
  F(COMPRESSEDTEXSUBIMAGE2D, CompressedTexSubImage2D)               \
  F(CREATEPROGRAM, CreateProgram)                                   \
  F(CREATESHADER, CreateShader)                                     \
  F(CULLFACE, CullFace)                                             \
  F(DELETEBUFFERS, DeleteBuffers)                                   \
  F(DELETEFRAMEBUFFERS, DeleteFramebuffers)                         \
  F(DELETEPROGRAM, DeleteProgram)                                   \
  F(DELETERENDERBUFFERS, DeleteRenderbuffers)                       \
  F(DELETESAMPLERS, DeleteSamplers)                                 \
  F(DELETESHADER, DeleteShader)                                     \
  F(DELETETEXTURES, DeleteTextures)                                 \
  F(DELETEVERTEXARRAYS, DeleteVertexArrays)                         \
  F(DEPTHFUNC, DepthFunc)                                           \
  F(DEPTHMASK, DepthMask)                                           \
  F(DISABLE, Disable)                                               \
  F(DRAWARRAYS, DrawArrays)                                         \
  F(DRAWARRAYSINSTANCED, DrawArraysInstanced)                       \
  F(DRAWBUFFERS, DrawBuffers)                                       \
  F(DRAWELEMENTS, DrawElements)                                     \
  F(DRAWELEMENTSINSTANCED, DrawElementsInstanced)                   \
  F(ENABLE, Enable)                                                 \
  F(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)               \
  F(ENDTRANSFORMFEEDBACK, EndTransformFeedback)                     \
  F(FINISH, Finish)                                                 \
  F(FLUSH, Flush)                                                   \
  F(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer)               \
  F(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)                     \
  F(FRONTFACE, FrontFace)                                           \
  F(GENBUFFERS, GenBuffers)                                         \
  F(GENERATEMIPMAP, GenerateMipmap)                                 \
  F(GENFRAMEBUFFERS, GenFramebuffers)                               \
  F(GENRENDERBUFFERS, GenRenderbuffers)                             \
  F(GENSAMPLERS, GenSamplers)                                       \
  F(GENTEXTURES, GenTextures)                                       \
  F(GENVERTEXARRAYS, GenVertexArrays)                               \
  F(GETERROR, GetError)                                             \
  F(GETINTEGERV, GetIntegerv)                                       \
  F(GETPROGRAMINFOLOG, GetProgramInfoLog)                           \
  F(GETPROGRAMIV, GetProgramiv)                                     \
  F(GETSHADERINFOLOG, GetShaderInfoLog)                             \
  F(GETSHADERIV, GetShaderiv)                                       \
  F(GETSTRING, GetString)                                           \
  F(GETSTRINGI, GetStringi)                                         \
  F(GETUNIFORMBLOCKINDEX, GetUniformBlockIndex)                     \
  F(GETUNIFORMLOCATION, GetUniformLocation)                         \
  F(LINKPROGRAM, LinkProgram)                                       \
  F(MAPBUFFERRANGE, MapBufferRange)                                 \
  F(PIXELSTOREI, PixelStorei)                                       \
  F(READPIXELS, ReadPixels)                                         \
  F(RENDERBUFFERSTORAGEMULTISAMPLE, RenderbufferStorageMultisample) \
  F(SAMPLERPARAMETERI, SamplerParameteri)                           \
  F(SCISSOR, Scissor)                                               \
  F(SHADERSOURCE, ShaderSource)                                     \
  F(TEXPARAMETERI, TexParameteri)                                   \
  F(TEXSTORAGE2D, TexStorage2D)                                     \
  F(TEXSUBIMAGE2D, TexSubImage2D)                                   \
  F(TRANSFORMFEEDBACKVARYINGS, TransformFeedbackVaryings)           \
  F(UNIFORM1F, Uniform1f)                                           \
  F(UNIFORM1I, Uniform1i)                                           \
  F(UNIFORM2FV, Uniform2fv)                                         \
  F(UNIFORM3FV, Uniform3fv)                                         \
  F(UNIFORM4FV, Uniform4fv)                                         \
  F(UNIFORM1FV, Uniform1fv)                                         \
  F(UNIFORMBLOCKBINDING, UniformBlockBinding)                       \
  F(UNIFORMMATRIX3FV, UniformMatrix3fv)                             \
  F(UNIFORMMATRIX4FV, UniformMatrix4fv)                             \
  F(UNMAPBUFFER, UnmapBuffer)                                       \
  F(USEPROGRAM, UseProgram)                                         \
  F(VERTEXATTRIB4F, VertexAttrib4f)                                 \
  F(VERTEXATTRIBDIVISOR, VertexAttribDivisor)                       \
  F(VERTEXATTRIBPOINTER, VertexAttribPointer)                       \
  F(VIEWPORT, Viewport)

// Entry points of extensions and of OpenGL ES 3.1 and 3.2; null where the backend lacks them.
#define TELAR_GL_OPTIONAL_FUNCTIONS(F)              \
  F(DEBUGMESSAGECALLBACK, DebugMessageCallback)     \
  F(DEBUGMESSAGECONTROL, DebugMessageControl)       \
  F(GETGRAPHICSRESETSTATUS, GetGraphicsResetStatus) \
  F(GETMULTISAMPLEFV, GetMultisamplefv)             \
  F(OBJECTLABEL, ObjectLabel)                       \
  F(PUSHDEBUGGROUP, PushDebugGroup)                 \
  F(POPDEBUGGROUP, PopDebugGroup)                   \
  F(TEXBUFFER, TexBuffer)

/// One table for EGL and OSMesa.
struct Functions {
#define TELAR_GL_MEMBER(upper, name) PFNGL##upper##PROC name = nullptr;
  TELAR_GL_FUNCTIONS(TELAR_GL_MEMBER)
  TELAR_GL_OPTIONAL_FUNCTIONS(TELAR_GL_MEMBER)
#undef TELAR_GL_MEMBER
  mutable int liveObjects = 0;  ///< GL names alive, kept by gl_object.h
};

using ProcLoader = void (*(*)(const char* name))();

/// @throws Error{X_GL} naming the first missing entry point.
Functions loadFunctions(ProcLoader loader);

}  // namespace telar::gl
