/* The GL functions that the runtime calls: F(NAME, Name) stands for glName of type PFNGLNAMEPROC.
 * A row is all that a further function needs; gl_open refuses a driver that lacks one of them. All are in OpenGL 3.0. */
#ifndef MATC_GL_FUNCTIONS_H
#define MATC_GL_FUNCTIONS_H
#define GL_FUNCTIONS(F)                                                                                                \
    F(ACTIVETEXTURE, ActiveTexture)                                                                                    \
    F(ATTACHSHADER, AttachShader)                                                                                      \
    F(BEGINQUERY, BeginQuery)                                                                                          \
    F(BINDATTRIBLOCATION, BindAttribLocation)                                                                          \
    F(BINDBUFFER, BindBuffer)                                                                                          \
    F(BINDFRAGDATALOCATION, BindFragDataLocation)                                                                      \
    F(BINDFRAMEBUFFER, BindFramebuffer)                                                                                \
    F(BINDTEXTURE, BindTexture)                                                                                        \
    F(BINDVERTEXARRAY, BindVertexArray)                                                                                \
    F(BLENDFUNC, BlendFunc)                                                                                            \
    F(BUFFERDATA, BufferData)                                                                                          \
    F(BUFFERSUBDATA, BufferSubData)                                                                                    \
    F(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)                                                                  \
    F(CLEAR, Clear)                                                                                                    \
    F(CLEARBUFFERFV, ClearBufferfv)                                                                                    \
    F(CLEARBUFFERUIV, ClearBufferuiv)                                                                                  \
    F(CLEARCOLOR, ClearColor)                                                                                          \
    F(CLEARDEPTH, ClearDepth)                                                                                          \
    F(COMPILESHADER, CompileShader)                                                                                    \
    F(CREATEPROGRAM, CreateProgram)                                                                                    \
    F(CREATESHADER, CreateShader)                                                                                      \
    F(DELETEBUFFERS, DeleteBuffers)                                                                                    \
    F(DELETEFRAMEBUFFERS, DeleteFramebuffers)                                                                          \
    F(DELETEPROGRAM, DeleteProgram)                                                                                    \
    F(DELETEQUERIES, DeleteQueries)                                                                                    \
    F(DELETESHADER, DeleteShader)                                                                                      \
    F(DELETETEXTURES, DeleteTextures)                                                                                  \
    F(DELETEVERTEXARRAYS, DeleteVertexArrays)                                                                          \
    F(DEPTHFUNC, DepthFunc)                                                                                            \
    F(DEPTHRANGE, DepthRange)                                                                                          \
    F(DISABLE, Disable)                                                                                                \
    F(DRAWARRAYS, DrawArrays)                                                                                          \
    F(DRAWBUFFERS, DrawBuffers)                                                                                        \
    F(DRAWELEMENTS, DrawElements)                                                                                      \
    F(ENABLE, Enable)                                                                                                  \
    F(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)                                                                \
    F(ENDQUERY, EndQuery)                                                                                              \
    F(FINISH, Finish)                                                                                                  \
    F(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)                                                                      \
    F(FRONTFACE, FrontFace)                                                                                            \
    F(GENBUFFERS, GenBuffers)                                                                                          \
    F(GENFRAMEBUFFERS, GenFramebuffers)                                                                                \
    F(GENQUERIES, GenQueries)                                                                                          \
    F(GENERATEMIPMAP, GenerateMipmap)                                                                                  \
    F(GENTEXTURES, GenTextures)                                                                                        \
    F(GENVERTEXARRAYS, GenVertexArrays)                                                                                \
    F(GETACTIVEUNIFORM, GetActiveUniform)                                                                              \
    F(GETERROR, GetError)                                                                                              \
    F(GETINTEGERV, GetIntegerv)                                                                                        \
    F(GETPROGRAMINFOLOG, GetProgramInfoLog)                                                                            \
    F(GETPROGRAMIV, GetProgramiv)                                                                                      \
    F(GETSHADERINFOLOG, GetShaderInfoLog)                                                                              \
    F(GETSHADERIV, GetShaderiv)                                                                                        \
    F(GETSTRING, GetString)                                                                                            \
    F(GETUNIFORMLOCATION, GetUniformLocation)                                                                          \
    F(LINKPROGRAM, LinkProgram)                                                                                        \
    F(PIXELSTOREI, PixelStorei)                                                                                        \
    F(READBUFFER, ReadBuffer)                                                                                          \
    F(READPIXELS, ReadPixels)                                                                                          \
    F(SHADERSOURCE, ShaderSource)                                                                                      \
    F(TEXIMAGE2D, TexImage2D)                                                                                          \
    F(TEXPARAMETERI, TexParameteri)                                                                                    \
    F(UNIFORM1FV, Uniform1fv)                                                                                          \
    F(UNIFORM1IV, Uniform1iv)                                                                                          \
    F(UNIFORM2FV, Uniform2fv)                                                                                          \
    F(UNIFORM2IV, Uniform2iv)                                                                                          \
    F(UNIFORM3FV, Uniform3fv)                                                                                          \
    F(UNIFORM3IV, Uniform3iv)                                                                                          \
    F(UNIFORM4FV, Uniform4fv)                                                                                          \
    F(UNIFORM4IV, Uniform4iv)                                                                                          \
    F(UNIFORM1UIV, Uniform1uiv)                                                                                        \
    F(UNIFORMMATRIX3FV, UniformMatrix3fv)                                                                              \
    F(UNIFORMMATRIX4FV, UniformMatrix4fv)                                                                              \
    F(USEPROGRAM, UseProgram)                                                                                          \
    F(VERTEXATTRIBPOINTER, VertexAttribPointer)                                                                        \
    F(VIEWPORT, Viewport)

/* What a driver may lack: of OpenGL 3.1, 3.3, 4.2, 4.3 and 4.5. */
#define GL_OPTIONAL_FUNCTIONS(F)                                                                                       \
    F(BINDBUFFERBASE, BindBufferBase)                                                                                  \
    F(BINDIMAGETEXTURE, BindImageTexture)                                                                              \
    F(CLIPCONTROL, ClipControl)                                                                                        \
    F(DISPATCHCOMPUTE, DispatchCompute)                                                                                \
    F(DRAWELEMENTSINSTANCEDBASEINSTANCE, DrawElementsInstancedBaseInstance)                                            \
    F(MEMORYBARRIER, MemoryBarrier)                                                                                    \
    F(GETACTIVEUNIFORMBLOCKIV, GetActiveUniformBlockiv)                                                                \
    F(GETACTIVEUNIFORMSIV, GetActiveUniformsiv)                                                                        \
    F(GETQUERYOBJECTUI64V, GetQueryObjectui64v)                                                                        \
    F(GETUNIFORMBLOCKINDEX, GetUniformBlockIndex)                                                                      \
    F(UNIFORMBLOCKBINDING, UniformBlockBinding)                                                                        \
    F(VERTEXATTRIBDIVISOR, VertexAttribDivisor)                                                                        \
    F(VERTEXATTRIBIPOINTER, VertexAttribIPointer)
#endif
