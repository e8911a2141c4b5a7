// OFF, the Geomview format: [ST][C][N][4]OFF, as text and BINARY.
// Source: Geomview 1.9 manual, "OFF Files".
#include <bit>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "engine/io/byte_reader.h"
#include "engine/io/colours.h"
#include "engine/io/polygon.h"
#include "engine/io/text.h"

namespace kinescope {
namespace {

/// What the letters before "OFF" promise of each vertex.
struct OffKind {
  bool has_texcoords = false;
  bool has_colours = false;
  bool has_normals = false;
  bool is_homogeneous = false;
};

std::optional<OffKind> kind_named(std::string_view word) {
  OffKind kind;
  const auto take = [&](std::string_view prefix) {
    const bool found = word.starts_with(prefix);
    if (found) word.remove_prefix(prefix.size());
    return found;
  };
  kind.has_texcoords = take("ST");
  kind.has_colours = take("C");
  kind.has_normals = take("N");
  kind.is_homogeneous = take("4");
  if (word != "OFF") return {};
  return kind;
}

/// Three or four components, of 255 if all are whole numbers, else of 1.
std::optional<glm::vec3> colour_of(const std::vector<double>& components, bool whole) {
  if (components.size() < 3) return {};
  const double scale = whole ? 1.0 / 255.0 : 1.0;
  return linear_from_srgb(components[0] * scale, components[1] * scale, components[2] * scale);
}

/// Collects vertices and faces. A face's own colour goes to vertices of its own.
class OffMesh {
 public:
  OffMesh(const ModelFile& file, OffKind kind) : kind_(kind), sink_(mesh_, file, "face") {}

  std::size_t numbers_per_vertex() const {
    return 3u + kind_.is_homogeneous + (kind_.has_normals ? 3u : 0u);
  }

  /// @param n  position, then normal if there is one
  void add_vertex(const std::vector<double>& n, const std::vector<double>& colour, bool whole,
                  std::pair<double, double> texcoord) {
    const double w = kind_.is_homogeneous ? n[3] : 1.0;
    const std::size_t at = kind_.is_homogeneous ? 4 : 3;
    mesh_.positions.emplace_back(to_float(n[0] / w), to_float(n[1] / w), to_float(n[2] / w));
    if (kind_.has_normals) {
      mesh_.normals.emplace_back(to_float(n[at]), to_float(n[at + 1]), to_float(n[at + 2]));
    }
    if (kind_.has_colours) {
      mesh_.colours.push_back(colour_of(colour, whole).value_or(glm::vec3(1.0f)));
    }
    if (kind_.has_texcoords) {
      // v runs up from the bottom row.
      mesh_.texcoords.emplace_back(to_float(texcoord.first), 1.0f - to_float(texcoord.second));
    }
  }

  void add_face(std::vector<std::uint32_t>& corners, std::optional<glm::vec3> colour) {
    if (colour) {
      for (std::uint32_t& corner : corners) corner = coloured(corner, *colour);
    }
    sink_.add(corners, faces_++);
  }

  Mesh take() {
    sink_.warn_of_lost();
    return std::move(mesh_);
  }

 private:
  /// The vertex that shows `vertex` in a face's colour.
  std::uint32_t coloured(std::uint32_t vertex, glm::vec3 colour) {
    if (vertex >= mesh_.positions.size()) return vertex;
    mesh_.colours.resize(mesh_.positions.size(), glm::vec3(1.0f));
    const auto next = static_cast<std::uint32_t>(mesh_.positions.size());
    const std::array<float, 3> rgb{colour.r, colour.g, colour.b};
    const auto [entry, is_new] = coloured_.try_emplace({vertex, rgb}, next);
    if (is_new) {
      mesh_.positions.push_back(glm::vec3(mesh_.positions[vertex]));
      mesh_.colours.push_back(colour);
      if (kind_.has_normals) mesh_.normals.push_back(glm::vec3(mesh_.normals[vertex]));
      if (kind_.has_texcoords) mesh_.texcoords.push_back(glm::vec2(mesh_.texcoords[vertex]));
    }
    return entry->second;
  }

  OffKind kind_;
  Mesh mesh_;
  PolygonSink sink_;
  std::size_t faces_ = 0;
  std::map<std::pair<std::uint32_t, std::array<float, 3>>, std::uint32_t> coloured_;
};

/// The numbers on the rest of a line.
std::vector<double>& rest_of_line(TextReader& text, std::vector<double>& numbers, bool& whole) {
  numbers.clear();
  whole = true;
  for (std::string_view word = text.word_on_line(); !word.empty(); word = text.word_on_line()) {
    numbers.push_back(text.number(word));
    whole = whole && word.find_first_of(".eE") == std::string_view::npos;
  }
  return numbers;
}

void read_text_vertices(TextReader& text, const OffKind& kind, std::uint64_t count, OffMesh& mesh) {
  std::vector<double> numbers(mesh.numbers_per_vertex());
  std::vector<double> rest;
  for (std::uint64_t i = 0; i < count; ++i) {
    for (double& number : numbers) number = text.number();
    bool whole = false;
    rest_of_line(text, rest, whole);
    std::pair<double, double> texcoord{0.0, 0.0};
    if (kind.has_texcoords && rest.size() >= 2) {
      texcoord = {rest[rest.size() - 2], rest.back()};
      rest.resize(rest.size() - 2);
    }
    mesh.add_vertex(numbers, rest, whole, texcoord);
  }
}

void read_text_faces(TextReader& text, std::uint64_t count, OffMesh& mesh) {
  std::vector<std::uint32_t> corners;
  std::vector<double> rest;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t size = text.count("a number of corners");
    if (size > (text.remaining() + 1) / 2) text.fail("the file ends within this face");
    corners.clear();
    for (std::uint64_t k = 0; k < size; ++k) {
      const std::uint64_t index = text.count("a vertex number");
      corners.push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(index, 0xffffffffu)));
    }
    bool whole = false;
    rest_of_line(text, rest, whole);
    mesh.add_face(corners, colour_of(rest, whole));
  }
}

Mesh read_text(const ModelFile& file, TextReader& text, OffKind kind, std::string_view first) {
  const std::uint64_t vertices = text.count(first, "the number of vertices");
  const std::uint64_t faces = text.count("the number of faces");
  text.word_on_line();  // the number of edges: not needed, and often left out
  OffMesh mesh(file, kind);
  const std::uint64_t left = text.remaining() + 1;
  if (vertices > left / (2 * mesh.numbers_per_vertex()) || faces > left / 2) {
    text.fail("the file ends too early: it promises " + std::to_string(vertices) +
              " vertices and " + std::to_string(faces) + " faces");
  }
  read_text_vertices(text, kind, vertices, mesh);
  read_text_faces(text, faces, mesh);
  return mesh.take();
}

std::uint32_t read_count(ByteReader& bytes, std::uint64_t least_size) {
  const auto count = bytes.read<std::int32_t>();
  if (count < 0 || static_cast<std::uint64_t>(count) * least_size > bytes.remaining()) {
    bytes.fail("the file ends too early: it promises " + std::to_string(count) + " more entries");
  }
  return static_cast<std::uint32_t>(count);
}

void read_floats(ByteReader& bytes, std::vector<double>& numbers) {
  for (double& number : numbers) number = static_cast<double>(bytes.read<float>());
}

Mesh read_binary(const ModelFile& file, std::size_t offset, OffKind kind) {
  ByteReader bytes(file, offset, std::endian::big);
  OffMesh mesh(file, kind);
  std::vector<double> numbers(mesh.numbers_per_vertex());
  std::vector<double> colour(kind.has_colours ? 4 : 0);
  const std::uint32_t vertices = read_count(bytes, 4 * numbers.size());
  const std::uint32_t faces = read_count(bytes, 8);
  bytes.read<std::int32_t>();  // edges
  for (std::uint32_t i = 0; i < vertices; ++i) {
    read_floats(bytes, numbers);
    read_floats(bytes, colour);
    std::vector<double> texcoord(kind.has_texcoords ? 2 : 0);
    read_floats(bytes, texcoord);
    texcoord.resize(2, 0.0);
    mesh.add_vertex(numbers, colour, false, {texcoord[0], texcoord[1]});
  }
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < faces; ++i) {
    corners.resize(read_count(bytes, 4));
    for (std::uint32_t& corner : corners) corner = bytes.read<std::uint32_t>();
    std::vector<double> face_colour(read_count(bytes, 4));
    read_floats(bytes, face_colour);
    mesh.add_face(corners, colour_of(face_colour, false));
  }
  return mesh.take();
}

}  // namespace

Scene read_off(const ModelFile& file) {
  TextReader text(file, 0, '#');
  std::string_view word = text.word();
  OffKind kind;
  if (const auto named = kind_named(word)) {
    kind = *named;
    word = text.word();
    if (word == "BINARY") {
      text.next_line();
      return scene_of({read_binary(file, text.offset(), kind)});
    }
  }
  return scene_of({read_text(file, text, kind, word)});
}

}  // namespace kinescope
