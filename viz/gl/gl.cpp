#include "viz/gl/gl.h"

#include <algorithm>

namespace isect::viz::gl {
namespace {

unsigned compile(GLenum kind, const char* source) {
  const unsigned shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  int done = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
  if (done) return shader;
  char log[1024] = {};
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  glDeleteShader(shader);
  throw failure(std::string("a shader does not compile: ") + log);
}

void set_sampling(GLint filter) {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void check_complete(int width, int height) {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return;
  throw failure("no framebuffer of " + std::to_string(width) + " x " + std::to_string(height) +
                " pixels with four samples");
}

}  // namespace

std::runtime_error failure(const std::string& what) { return std::runtime_error("OpenGL: " + what); }

void load(GetProc get_proc) {
  const auto find = [](void* user, const char* name) {
    return reinterpret_cast<GLADapiproc>((*static_cast<GetProc*>(user))(name));
  };
  const int version = gladLoadGLUserPtr(find, &get_proc);
  if (version < GLAD_MAKE_VERSION(3, 3)) throw failure("version 3.3 is needed and was not found");
}

Program::Program(const char* vertex_shader, const char* fragment_shader) {
  const unsigned vertex = compile(GL_VERTEX_SHADER, vertex_shader);
  const unsigned fragment = compile(GL_FRAGMENT_SHADER, fragment_shader);
  glAttachShader(id_, vertex);
  glAttachShader(id_, fragment);
  glLinkProgram(id_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  int done = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &done);
  if (!done) throw failure("a program does not link");
}

Target::Target(int samples) : samples_(samples) {
  glGenFramebuffers(2, framebuffers_);
  glGenRenderbuffers(2, buffers_);
  glGenTextures(1, &texture_);
}

Target::~Target() {
  glDeleteFramebuffers(2, framebuffers_);
  glDeleteRenderbuffers(2, buffers_);
  glDeleteTextures(1, &texture_);
}

void Target::bind(int width, int height) {
  if (width != width_ || height != height_) resize(width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
  glViewport(0, 0, width, height);
}

void Target::resize(int width, int height) {
  int most = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
  if (width < 1 || height < 1 || width > most || height > most)
    throw failure("a picture may be 1 to " + std::to_string(most) + " pixels wide and high, not " +
                  std::to_string(width) + " x " + std::to_string(height));
  width_ = height_ = 0;  // stays so if an exception is thrown

  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[0]);
  const auto attach = [&](int i, GLenum format, GLenum where) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffers_[i]);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples_, format, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffers_[i]);
  };
  attach(0, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  attach(1, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
  check_complete(width, height);

  glBindFramebuffer(GL_FRAMEBUFFER, framebuffers_[1]);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  set_sampling(GL_LINEAR);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  check_complete(width, height);
  width_ = width, height_ = height;
}

void Target::resolve() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[0]);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers_[1]);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Picture Target::read() const {
  const std::size_t row = static_cast<std::size_t>(width_) * 4;
  Picture picture{width_, height_, std::vector<std::uint8_t>(row * static_cast<std::size_t>(height_))};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers_[1]);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);

  std::uint8_t* const data = picture.rgba.data();
  for (int y = 0; y < height_ / 2; ++y)
    std::swap_ranges(data + y * row, data + (y + 1) * row, data + (height_ - 1 - y) * row);
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  return picture;
}

unsigned make_texture(const Picture& picture) {
  unsigned texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               picture.rgba.data());
  set_sampling(GL_NEAREST);
  return texture;
}

}  // namespace isect::viz::gl
