// STL, binary and ASCII. Equal corners are joined, so that finish() can smooth what was curved; the
// facet normals that the file repeats, and colours in its attribute bytes, are not used.
// Source: 3D Systems, "StereoLithography Interface Specification", 1988.
#include <utility>
#include <vector>

#include "engine/io/byte_reader.h"
#include "engine/io/polygon.h"
#include "engine/io/text.h"
#include "engine/io/vertex_pool.h"

namespace kinescope {
namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kTriangleBytes = 50;

/// Corners that share a vertex where they have the same position.
class JoinedCorners {
 public:
  explicit JoinedCorners(Mesh& mesh) : mesh_(mesh) {}

  std::uint32_t index_of(const glm::vec3& position) {
    const std::uint32_t index = pool_.index_of(position);
    if (index == mesh_.positions.size()) mesh_.positions.push_back(position);
    return index;
  }

 private:
  Mesh& mesh_;
  VertexPool pool_;
};

Mesh read_binary(const ModelFile& file, std::uint64_t count) {
  ByteReader bytes(file, kHeaderBytes + sizeof(std::uint32_t));
  Mesh mesh;
  JoinedCorners joined(mesh);
  mesh.indices.reserve(count * 3);
  for (std::uint64_t i = 0; i < count; ++i) {
    bytes.skip(3 * sizeof(float));
    for (int corner = 0; corner < 3; ++corner) {
      const float x = bytes.read<float>();
      const float y = bytes.read<float>();
      const float z = bytes.read<float>();
      mesh.indices.push_back(joined.index_of({x, y, z}));
    }
    bytes.skip(sizeof(std::uint16_t));
  }
  return mesh;
}

/// Words, whatever lines they stand on. A facet may have more than three corners.
Mesh read_ascii(const ModelFile& file) {
  TextReader text(file, 0);
  Mesh mesh;
  JoinedCorners joined(mesh);
  PolygonSink sink(mesh, file, "facet");
  std::vector<std::uint32_t> corners;
  std::size_t facets = 0;
  bool in_facet = false;
  for (std::string_view raw = text.word(); !raw.empty(); raw = text.word()) {
    const std::string word = lower_case(raw);
    if (word == "facet") {
      in_facet = true;
      corners.clear();
    } else if (word == "vertex" && in_facet) {
      const float x = to_float(text.number());
      const float y = to_float(text.number());
      const float z = to_float(text.number());
      corners.push_back(joined.index_of({x, y, z}));
    } else if (word == "endfacet" && in_facet) {
      sink.add(corners, facets++);
      in_facet = false;
    }
  }
  if (in_facet) text.fail("the file ends within a facet");
  return mesh;
}

/// How many triangles the file promises if it is binary.
std::uint64_t promised_triangles(const ModelFile& file) {
  return ByteReader(file, kHeaderBytes).read<std::uint32_t>();
}

}  // namespace

bool is_binary_stl(const ModelFile& file) {
  const std::size_t size = file.bytes.size();
  if (size < kHeaderBytes + sizeof(std::uint32_t)) return false;
  return size == kHeaderBytes + sizeof(std::uint32_t) + promised_triangles(file) * kTriangleBytes;
}

bool is_ascii_stl(const ModelFile& file) {
  std::string_view text = as_text(file.bytes);
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  if (lower_case(text.substr(0, 5)) != "solid") return false;
  // A damaged binary file may begin so as well, but then holds zeros before long.
  return text.substr(0, 1024).find('\0') == std::string_view::npos;
}

Scene read_stl(const ModelFile& file) {
  // Binary files may begin with "solid" too: their size tells them apart.
  if (is_binary_stl(file)) return scene_of({read_binary(file, promised_triangles(file))});
  if (is_ascii_stl(file)) return scene_of({read_ascii(file)});
  const std::size_t size = file.bytes.size();
  if (size < kHeaderBytes + sizeof(std::uint32_t)) file.fail("the file ends too early");
  const std::uint64_t promised = promised_triangles(file);
  const std::uint64_t held = (size - kHeaderBytes - sizeof(std::uint32_t)) / kTriangleBytes;
  if (promised > held) {
    file.fail("the file ends too early: it promises " + std::to_string(promised) +
              " triangles and holds " + std::to_string(held));
  }
  return scene_of({read_binary(file, promised)});
}

}  // namespace kinescope
