#include "float_target.hpp"

namespace nacre::demo {

FloatTarget::FloatTarget(const GlFunctions& gl, int width, int height) : gl_(gl), width_(width), height_(height)
{
    gl.GenFramebuffers(1, &framebuffer_);
    gl.GenTextures(1, &colour_);
    gl.GenTextures(1, &depth_);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl.BindTexture(GL_TEXTURE_2D, colour_);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    // Without mipmaps the default filter would leave the texture incomplete to whoever samples it.
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_, 0);
    gl.BindTexture(GL_TEXTURE_2D, depth_);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
}

FloatTarget::~FloatTarget()
{
    gl_.DeleteFramebuffers(1, &framebuffer_);
    gl_.DeleteTextures(1, &colour_);
    gl_.DeleteTextures(1, &depth_);
}

void FloatTarget::use() const
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.Viewport(0, 0, width_, height_);
}

bool FloatTarget::isComplete() const
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    return gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

}  // namespace nacre::demo
