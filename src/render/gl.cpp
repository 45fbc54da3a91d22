#include "render/gl.hpp"

#include <array>

#include "bozzetto/base/error.hpp"
#include "render/shader_files.hpp"

namespace bozzetto::gl {
namespace {

std::string textOf(std::string_view part) {
  for (const ShaderFile& file : shaderFiles()) {
    if (file.name == part) return "#line 1\n" + std::string(file.text);
  }
  throw Error("shader part " + std::string(part) + " is missing from the program");
}

using GetValue = decltype(&glGetShaderiv);
using GetLog = decltype(&glGetShaderInfoLog);

template <class Get, class Log>
void requireSuccess(GLuint object, GLenum what, Get get, Log log) {
  GLint done = GL_FALSE;
  get(object, what, &done);
  if (done == GL_TRUE) return;
  std::array<char, 2048> text{};
  log(object, GLsizei(text.size()), nullptr, text.data());
  throw Error("OpenGL: shader does not compile: " + std::string(text.data()));
}

Shader compiled(GLenum stage, const std::vector<std::string_view>& parts) {
  std::string text = "#version 330 core\n";
  for (const std::string_view part : parts) text += textOf(part);
  Shader shader(glCreateShader(stage));
  const char* start = text.c_str();
  glShaderSource(shader.get(), 1, &start, nullptr);
  glCompileShader(shader.get());
  requireSuccess(shader.get(), GL_COMPILE_STATUS, glGetShaderiv, glGetShaderInfoLog);
  return shader;
}

void bindBlock(GLuint program, const char* name, GLuint binding) {
  const GLuint block = glGetUniformBlockIndex(program, name);
  if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, binding);
}

}  // namespace

Buffer newBuffer() {
  GLuint id = 0;
  glGenBuffers(1, &id);
  return Buffer(id);
}

VertexArray newVertexArray() {
  GLuint id = 0;
  glGenVertexArrays(1, &id);
  return VertexArray(id);
}

Framebuffer newFramebuffer() {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  return Framebuffer(id);
}

Renderbuffer newRenderbuffer() {
  GLuint id = 0;
  glGenRenderbuffers(1, &id);
  return Renderbuffer(id);
}

void check(std::string_view doing) {
  const GLenum code = glGetError();
  if (code == GL_NO_ERROR) return;
  while (glGetError() != GL_NO_ERROR) {
  }
  throw Error("OpenGL: " + std::string(doing) + " failed with code " + std::to_string(code) +
              (code == GL_OUT_OF_MEMORY ? " (out of memory)" : ""));
}

Texture newTexture(const TextureFormat& format) {
  GLuint id = 0;
  glGenTextures(1, &id);
  Texture texture(id);
  bindTexture(making, texture);
  const bool depth = format.internal == GL_DEPTH_COMPONENT24;
  glTexImage2D(GL_TEXTURE_2D, 0, GLint(format.internal), format.width, format.height, 0,
               depth ? GL_DEPTH_COMPONENT : GL_RGBA, depth ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE,
               nullptr);
  const GLint magnify = format.filter == Filter::nearest ? GL_NEAREST : GL_LINEAR;
  const GLint minify = format.filter == Filter::mipmaps ? GL_LINEAR_MIPMAP_LINEAR : magnify;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, magnify);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, minify);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

void bindTexture(int unit, const Texture& texture) {
  glActiveTexture(GL_TEXTURE0 + GLenum(unit));
  glBindTexture(GL_TEXTURE_2D, texture.get());
}

Program::Program(const std::vector<std::string_view>& vertexParts,
                 const std::vector<std::string_view>& fragmentParts)
    : program_(glCreateProgram()) {
  const Shader vertex = compiled(GL_VERTEX_SHADER, vertexParts);
  const Shader fragment = compiled(GL_FRAGMENT_SHADER, fragmentParts);
  glAttachShader(program_.get(), vertex.get());
  glAttachShader(program_.get(), fragment.get());
  glLinkProgram(program_.get());
  requireSuccess(program_.get(), GL_LINK_STATUS, glGetProgramiv, glGetProgramInfoLog);
  bindBlock(program_.get(), "Frame", kFrameBlock);
  bindBlock(program_.get(), "Studio", kStudioBlock);
  use();
  set("environmentMap", environmentMap);
  set("shadowMap", shadowMap);
  set("matcap", matcap);
  set("floorOcclusion", floorOcclusion);
  set("source", source);
  set("other", other);
  set("clayDepth", clayDepth);
}

GLint Program::at(std::string_view uniform) const {
  const auto known = locations_.find(uniform);
  if (known != locations_.end()) return known->second;
  const std::string name(uniform);
  return locations_[name] = glGetUniformLocation(program_.get(), name.c_str());
}

}  // namespace bozzetto::gl
