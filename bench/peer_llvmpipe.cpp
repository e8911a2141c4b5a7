#include "bench/peer_llvmpipe.h"

#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>

#include <chrono>
#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>

#include "raster/base/error.h"

namespace kinescope::bench {
namespace {

constexpr const char* kHead = R"(#version 330 core
uniform vec3 eye, base, specular, ambient;
uniform float shininess, opacity;
uniform int lights;
uniform vec3 light_position[8], light_colour[8];
void light(vec3 p, vec3 n, out vec3 body, out vec3 highlight) {
  vec3 v = normalize(eye - p);
  body = ambient;
  highlight = vec3(0);
  for (int i = 0; i < lights; ++i) {
    vec3 l = normalize(light_position[i] - p);
    float n_l = dot(n, l);
    if (n_l > 0.0) {
      body += n_l * light_colour[i];
      float r_v = max(dot(2.0 * n_l * n - l, v), 0.0);
      highlight += pow(r_v, shininess) * light_colour[i];
    }
  }
  body *= base;
  highlight *= specular;
}
)";

constexpr const char* kVertexPhong = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texcoord;
uniform mat4 clip_from_world;
out vec3 p, n;
out vec2 uv;
void main() {
  gl_Position = clip_from_world * vec4(position, 1);
  p = position; n = normal; uv = texcoord;
}
)";

constexpr const char* kFragmentPhong = R"(
in vec3 p, n;
in vec2 uv;
out vec4 colour;
uniform sampler2D image;
void main() {
  vec3 body, highlight;
  light(p, normalize(n), body, highlight);
#ifdef TEXTURED
  body *= texture(image, uv).rgb;
#endif
  colour = vec4(body + highlight, opacity);
}
)";

constexpr const char* kVertexGouraud = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 clip_from_world;
out vec3 lit;
void main() {
  gl_Position = clip_from_world * vec4(position, 1);
  vec3 body, highlight;
  light(position, normalize(normal), body, highlight);
  lit = body + highlight;
}
)";

constexpr const char* kFragmentGouraud = R"(
in vec3 lit;
out vec4 colour;
void main() { colour = vec4(lit, opacity); }
)";

constexpr const char* kVertexUnlit = R"(
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 texcoord;
layout(location = 3) in vec3 vertex_colour;
uniform mat4 clip_from_world;
out vec3 tint;
out vec2 uv;
void main() {
  gl_Position = clip_from_world * vec4(position, 1);
  tint = vertex_colour; uv = texcoord;
}
)";

constexpr const char* kFragmentUnlit = R"(
in vec3 tint;
in vec2 uv;
out vec4 colour;
uniform sampler2D image;
void main() {
#ifdef TEXTURED
  colour = vec4(base * texture(image, uv).rgb, opacity);
#else
  colour = vec4(base * tint, opacity);
#endif
}
)";

constexpr const char* kFragmentNumber = R"(
out vec4 colour;
void main() {
  uint number = uint(gl_PrimitiveID) + 1u;
  colour = vec4(number & 255u, number >> 8 & 255u, number >> 16 & 255u, 255u) / 255.0;
}
)";

constexpr const char* kFragmentMixed = R"(
out vec4 colour;
void main() {
  uint mixed = (uint(gl_PrimitiveID) + 1u) * 2654435761u;
  mixed = (mixed ^ mixed >> 16) * 0x85ebca6bu;
  colour = vec4(255u, mixed >> 24, mixed >> 16 & 255u, 255u) / 255.0;
}
)";

struct Sources {
  const char* vertex;
  const char* fragment;
};
Sources sources_of(ShadingModel shading, std::optional<TriangleColours> triangles) {
  if (triangles == TriangleColours::kNumber) return {kVertexPhong, kFragmentNumber};
  if (triangles == TriangleColours::kMixed) return {kVertexPhong, kFragmentMixed};
  if (shading == ShadingModel::kGouraud) return {kVertexGouraud, kFragmentGouraud};
  if (shading == ShadingModel::kUnlit) return {kVertexUnlit, kFragmentUnlit};
  return {kVertexPhong, kFragmentPhong};
}

[[noreturn]] void fail(const std::string& what) {
  throw Error(ErrorKind::kBadInput, what, "llvmpipe");
}

GLuint compile(GLenum kind, const std::string& source) {
  const GLuint shader = glCreateShader(kind);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (!good) {
    char log[1024];
    glGetShaderInfoLog(shader, sizeof log, nullptr, log);
    fail(log);
  }
  return shader;
}

GLuint link(const Sources& sources, bool textured) {
  std::string head = kHead;
  if (textured) head.insert(head.find('\n') + 1, "#define TEXTURED\n");
  const GLuint program = glCreateProgram();
  glAttachShader(program, compile(GL_VERTEX_SHADER, head + sources.vertex));
  glAttachShader(program, compile(GL_FRAGMENT_SHADER, head + sources.fragment));
  glLinkProgram(program);
  GLint good = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if (!good) fail("the shaders do not link");
  return program;
}

/// A context of its own, current on this thread.
struct Context {
  Context() {
    const auto platform_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
        eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!platform_display) fail("EGL has no platforms");
    display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (!eglInitialize(display, nullptr, nullptr)) fail("EGL does not start");
    eglBindAPI(EGL_OPENGL_API);
    const EGLint wanted[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
    context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, wanted);
    if (context == EGL_NO_CONTEXT) fail("EGL gives no OpenGL 3.3 context");
    make_current();
    const std::string name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    if (name.find("llvmpipe") == std::string::npos) fail("OpenGL is drawn by " + name);
  }
  ~Context() {
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
  }
  void make_current() const { eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context); }

  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

struct MeshBuffers {
  GLuint vertex_array = 0;
  GLsizei indices = 0;
};

template <typename T>
void attribute(GLuint location, GLint components, const std::vector<T>& values) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(),
               GL_STATIC_DRAW);
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
}

MeshBuffers upload(const Mesh& mesh) {
  MeshBuffers buffers;
  glGenVertexArrays(1, &buffers.vertex_array);
  glBindVertexArray(buffers.vertex_array);
  attribute(0, 3, mesh.positions);
  attribute(1, 3, mesh.normals);
  if (!mesh.texcoords.empty()) attribute(2, 2, mesh.texcoords);
  if (!mesh.colours.empty()) attribute(3, 3, mesh.colours);
  GLuint indices = 0;
  glGenBuffers(1, &indices);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * 4),
               mesh.indices.data(), GL_STATIC_DRAW);
  buffers.indices = static_cast<GLsizei>(mesh.indices.size());
  return buffers;
}

void upload(const Texture& texture) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  // The same mipmaps as ours, so that only the filtering is compared.
  for (int i = 0; i < texture.levels(); ++i) {
    const Image<Texel>& level = texture.level(i);
    std::vector<Linear8> texels;
    for (const Texel t : level.pixels()) {
      const auto narrow = [](int v) { return static_cast<std::uint8_t>((v + 128) / 257); };
      texels.push_back({narrow(t.r), narrow(t.g), narrow(t.b), narrow(t.a)});
    }
    glTexImage2D(GL_TEXTURE_2D, i, GL_RGBA8, level.width(), level.height(), 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, texels.data());
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, texture.levels() - 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

GLuint make_frame_buffer(int width, int height, int samples, bool depth) {
  const auto renderbuffer = [&](GLenum format, GLenum attachment) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format, width,
                                     height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  };
  GLuint frame_buffer = 0;
  glGenFramebuffers(1, &frame_buffer);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_buffer);
  renderbuffer(GL_RGBA8, GL_COLOR_ATTACHMENT0);
  if (depth) renderbuffer(GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    fail("no frame buffer of " + std::to_string(samples) + " samples");
  }
  return frame_buffer;
}

}  // namespace

struct LlvmpipePeer::State {
  Context context;
  int width = 0, height = 0, samples = 1;
  GLuint target = 0, resolved = 0, program = 0;
  std::vector<MeshBuffers> meshes;
  bool blends = false;

  GLint uniform(const char* name) const { return glGetUniformLocation(program, name); }
  void set_lights(const Scene& scene) const;
};

void LlvmpipePeer::State::set_lights(const Scene& scene) const {
  const Material& material = scene.materials.at(0);
  glUniform3fv(uniform("base"), 1, glm::value_ptr(material.base_colour));
  glUniform3fv(uniform("specular"), 1, glm::value_ptr(material.specular));
  glUniform1f(uniform("shininess"), material.shininess);
  glUniform1f(uniform("opacity"), material.opacity);
  glUniform3fv(uniform("ambient"), 1, glm::value_ptr(scene.ambient));
  glUniform1i(uniform("lights"), static_cast<GLint>(scene.lights.size()));
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    const Light& light = scene.lights[i].item;
    glUniform3fv(uniform(("light_position" + at).c_str()), 1, glm::value_ptr(light.position));
    glUniform3fv(uniform(("light_colour" + at).c_str()), 1, glm::value_ptr(light.colour));
  }
}

void LlvmpipePeer::set_threads(int threads) {
  setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  setenv("GALLIUM_DRIVER", "llvmpipe", 1);
}

LlvmpipePeer::LlvmpipePeer(const Workload& workload, int width, int height, int samples,
                           std::optional<TriangleColours> triangles)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.width = width;
  s.height = height;
  s.samples = samples;
  s.resolved = make_frame_buffer(width, height, 1, samples == 1);
  s.target = samples > 1 ? make_frame_buffer(width, height, samples, true) : s.resolved;
  const bool textured = workload.scene.materials.at(0).base_texture >= 0;
  s.program = link(sources_of(workload.shading, triangles), textured);
  glUseProgram(s.program);
  s.set_lights(workload.scene);
  if (textured) upload(workload.scene.textures.at(0));
  for (const Mesh& mesh : workload.scene.meshes) s.meshes.push_back(upload(mesh));
  glViewport(0, 0, width, height);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glFrontFace(GL_CW);  // the picture is drawn upside down
  s.blends = workload.scene.materials.at(0).opacity < 1.0f;
  if (s.blends) {
    // In the order of submission: the workload's meshes run from far to near.
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  }
}

LlvmpipePeer::~LlvmpipePeer() { state_->context.make_current(); }

std::string LlvmpipePeer::version() const {
  state_->context.make_current();
  const auto text = [](GLenum name) {
    return std::string(reinterpret_cast<const char*>(glGetString(name)));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

double LlvmpipePeer::draw(const Camera& camera) {
  State& s = *state_;
  s.context.make_current();
  // Ours maps depth to 0..w; OpenGL's clip space wants -w..w. Turned upside down, its rows come
  // from the top too, and its sample pattern and fill rule lie as ours do.
  glm::mat4 gl_from_clip(1.0f);
  gl_from_clip[1][1] = -1;
  gl_from_clip[2][2] = 2;
  gl_from_clip[3][2] = -1;
  const glm::mat4 clip_from_world = gl_from_clip * camera.clip_from_world();
  const auto start = std::chrono::steady_clock::now();
  glBindFramebuffer(GL_FRAMEBUFFER, s.target);
  glClearColor(0, 0, 0, 1);
  glDepthMask(GL_TRUE);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDepthMask(s.blends ? GL_FALSE : GL_TRUE);
  glUniformMatrix4fv(s.uniform("clip_from_world"), 1, GL_FALSE, glm::value_ptr(clip_from_world));
  glUniform3fv(s.uniform("eye"), 1, glm::value_ptr(camera.eye));
  for (const MeshBuffers& mesh : s.meshes) {
    glBindVertexArray(mesh.vertex_array);
    glDrawElements(GL_TRIANGLES, mesh.indices, GL_UNSIGNED_INT, nullptr);
  }
  if (s.samples > 1) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, s.target);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, s.resolved);
    glBlitFramebuffer(0, 0, s.width, s.height, 0, 0, s.width, s.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  }
  glFinish();
  const std::chrono::duration<double, std::milli> elapsed =
      std::chrono::steady_clock::now() - start;
  return elapsed.count();
}

Image<Linear8> LlvmpipePeer::picture() const {
  const State& s = *state_;
  s.context.make_current();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, s.resolved);
  Image<Linear8> picture(s.width, s.height);
  glReadPixels(0, 0, s.width, s.height, GL_RGBA, GL_UNSIGNED_BYTE, picture.pixels().data());
  return picture;
}

}  // namespace kinescope::bench
