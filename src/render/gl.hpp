// OpenGL objects with owners. Only .cpp files of this folder see epoxy.
#pragma once
#include <epoxy/gl.h>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bozzetto::gl {

/// Owns one GL name. Dies with its context current.
template <void (*Release)(GLuint)>
class Name {
 public:
  Name() = default;
  explicit Name(GLuint id) : id_(id) {}
  Name(Name&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Name& operator=(Name&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Name() {
    if (id_ != 0) Release(id_);
  }
  GLuint get() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

inline void deleteBuffer(GLuint id) { glDeleteBuffers(1, &id); }
inline void deleteVertexArray(GLuint id) { glDeleteVertexArrays(1, &id); }
inline void deleteTexture(GLuint id) { glDeleteTextures(1, &id); }
inline void deleteFramebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void deleteRenderbuffer(GLuint id) { glDeleteRenderbuffers(1, &id); }
inline void deleteProgram(GLuint id) { glDeleteProgram(id); }
inline void deleteShader(GLuint id) { glDeleteShader(id); }

using Buffer = Name<deleteBuffer>;
using VertexArray = Name<deleteVertexArray>;
using Texture = Name<deleteTexture>;
using Framebuffer = Name<deleteFramebuffer>;
using Renderbuffer = Name<deleteRenderbuffer>;
using ProgramName = Name<deleteProgram>;
using Shader = Name<deleteShader>;

Buffer newBuffer();
VertexArray newVertexArray();
Framebuffer newFramebuffer();
Renderbuffer newRenderbuffer();

/// Throws Error naming `doing` when GL has recorded an error.
void check(std::string_view doing);

enum class Filter { nearest, linear, mipmaps };

/// A 2-D texture with edges clamped, made but not filled; bound to the unit `making`.
struct TextureFormat {
  GLenum internal = GL_RGBA8;
  int width = 1, height = 1;
  Filter filter = Filter::linear;
};
Texture newTexture(const TextureFormat& format);
void bindTexture(int unit, const Texture& texture);

/// The framebuffer and the viewport that are set now are set again at the end of the scope.
class KeepTarget {
 public:
  KeepTarget() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
  }
  KeepTarget(const KeepTarget&) = delete;
  KeepTarget& operator=(const KeepTarget&) = delete;
  ~KeepTarget() {
    glBindFramebuffer(GL_FRAMEBUFFER, GLuint(framebuffer_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  }

 private:
  GLint framebuffer_ = 0, viewport_[4] = {};
};

/// A shader program from .glsl files: the names of the parts, in order, without extension.
class Program {
 public:
  Program(const std::vector<std::string_view>& vertexParts,
          const std::vector<std::string_view>& fragmentParts);
  void use() const { glUseProgram(program_.get()); }
  /// Location, -1 where the compiler left the uniform out.
  GLint at(std::string_view uniform) const;
  void set(std::string_view uniform, int value) const { glUniform1i(at(uniform), value); }
  void set(std::string_view uniform, float value) const { glUniform1f(at(uniform), value); }
  void set(std::string_view uniform, const glm::vec4& v) const {
    glUniform4f(at(uniform), v.x, v.y, v.z, v.w);
  }
  void set(std::string_view uniform, const glm::mat4& m) const {
    glUniformMatrix4fv(at(uniform), 1, GL_FALSE, &m[0][0]);
  }

 private:
  ProgramName program_;
  mutable std::map<std::string, GLint, std::less<>> locations_;
};

/// Blocks of uniforms and units of textures, the same in every program; textures are made on the
/// last, so that making one takes nothing away from a program.
inline constexpr GLuint kFrameBlock = 0, kStudioBlock = 1;
enum TextureUnit {
  environmentMap,
  shadowMap,
  matcap,
  floorOcclusion,
  source,
  other,
  clayDepth,
  making
};

}  // namespace bozzetto::gl
