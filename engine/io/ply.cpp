// PLY, ASCII and binary of both byte orders.
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/io/byte_reader.h"
#include "engine/io/colours.h"
#include "engine/io/picture_finder.h"
#include "engine/io/ply_header.h"
#include "engine/io/polygon.h"
#include "engine/io/text.h"

namespace kinescope {
namespace {

/// Where a property of a vertex goes.
enum Slot { kX, kY, kZ, kNx, kNy, kNz, kRed, kGreen, kBlue, kU, kV, kSlots, kNowhere = kSlots };

Slot slot_named(const std::string& name) {
  static constexpr std::array<std::pair<const char*, Slot>, 25> kNames{{{"x", kX},
                                                                        {"y", kY},
                                                                        {"z", kZ},
                                                                        {"nx", kNx},
                                                                        {"ny", kNy},
                                                                        {"nz", kNz},
                                                                        {"red", kRed},
                                                                        {"green", kGreen},
                                                                        {"blue", kBlue},
                                                                        {"r", kRed},
                                                                        {"g", kGreen},
                                                                        {"b", kBlue},
                                                                        {"diffuse_red", kRed},
                                                                        {"diffuse_green", kGreen},
                                                                        {"diffuse_blue", kBlue},
                                                                        {"u", kU},
                                                                        {"v", kV},
                                                                        {"s", kU},
                                                                        {"t", kV},
                                                                        {"texture_u", kU},
                                                                        {"texture_v", kV},
                                                                        {"texture_s", kU},
                                                                        {"texture_t", kV},
                                                                        {"tx", kU},
                                                                        {"ty", kV}}};
  for (const auto& [known, slot] : kNames) {
    if (name == known) return slot;
  }
  return kNowhere;
}

/// Reads values one after another, in whichever encoding.
class PlyValues {
 public:
  PlyValues(const ModelFile& file, const PlyHeader& header)
      : is_text_(header.encoding == PlyEncoding::kAscii),
        text_(file, header.data_offset),
        bytes_(
            file, header.data_offset,
            header.encoding == PlyEncoding::kBigEndian ? std::endian::big : std::endian::little) {}

  double read(PlyType type) {
    if (is_text_) return text_.number();
    switch (type) {
      case PlyType::kInt8:
        return bytes_.read<std::int8_t>();
      case PlyType::kUint8:
        return bytes_.read<std::uint8_t>();
      case PlyType::kInt16:
        return bytes_.read<std::int16_t>();
      case PlyType::kUint16:
        return bytes_.read<std::uint16_t>();
      case PlyType::kInt32:
        return bytes_.read<std::int32_t>();
      case PlyType::kUint32:
        return bytes_.read<std::uint32_t>();
      case PlyType::kFloat32:
        return static_cast<double>(bytes_.read<float>());
      case PlyType::kFloat64:
        return bytes_.read<double>();
    }
    return 0.0;
  }

  /// The length of a list, checked against what is left of the file.
  std::size_t read_length(const PlyProperty& list) {
    const double length = read(list.count_type);
    const double entry = is_text_ ? 2.0 : static_cast<double>(size_of(list.type));
    const double left = static_cast<double>(is_text_ ? text_.remaining() + 1 : bytes_.remaining());
    if (!(length >= 0.0) || length != std::floor(length)) fail("a list has no proper length");
    if (length * entry > left) fail("the file ends too early: within a list");
    return static_cast<std::size_t>(length);
  }

  void read_list(const PlyProperty& list, std::vector<double>& values) {
    values.resize(read_length(list));
    for (double& value : values) value = read(list.type);
  }

  void skip(const PlyProperty& property) {
    if (!property.is_list) {
      read(property.type);
    } else if (const std::size_t length = read_length(property); is_text_) {
      for (std::size_t i = 0; i < length; ++i) text_.word();
    } else {
      bytes_.skip(length * size_of(property.type));
    }
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    if (is_text_) text_.fail(what);
    bytes_.fail(what);
  }

  bool is_text_;
  TextReader text_;
  ByteReader bytes_;
};

std::uint32_t as_index(double value) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  return value >= 0.0 && value < kNone ? static_cast<std::uint32_t>(value) : kNone;
}

class PlyMesh {
 public:
  PlyMesh(const ModelFile& file, const PlyHeader& header)
      : file_(file), header_(header), values_(file, header) {}

  Mesh read() {
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else {
        read_lists(element);
      }
    }
    PolygonSink sink(mesh_, file_, "face");
    std::size_t begin = 0;
    for (std::size_t face = 0; face < face_ends_.size(); ++face) {
      sink.add(std::span(corners_).subspan(begin, face_ends_[face] - begin), face);
      begin = face_ends_[face];
    }
    sink.warn_of_lost();
    return std::move(mesh_);
  }

 private:
  void read_vertices(const PlyElement& element) {
    std::vector<Slot> slots;
    std::array<bool, kSlots + 1> has{};
    bool bytes_as_colour = false;
    for (const PlyProperty& property : element.properties) {
      slots.push_back(property.is_list ? kNowhere : slot_named(property.name));
      has[slots.back()] = true;
      if (slots.back() == kRed) bytes_as_colour = property.type == PlyType::kUint8;
    }
    if (!has[kX] || !has[kY] || !has[kZ]) file_.fail("the vertices lack x, y or z");
    std::array<double, kSlots + 1> value{};
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (std::size_t p = 0; p < slots.size(); ++p) {
        if (slots[p] == kNowhere) {
          values_.skip(element.properties[p]);
        } else {
          value[slots[p]] = values_.read(element.properties[p].type);
        }
      }
      add_vertex(value, has, bytes_as_colour ? 1.0 / 255.0 : 1.0);
    }
  }

  void add_vertex(const std::array<double, kSlots + 1>& value,
                  const std::array<bool, kSlots + 1>& has, double colour_scale) {
    const auto vec3 = [&](Slot first) {
      return glm::vec3(to_float(value[first]), to_float(value[first + 1]),
                       to_float(value[first + 2]));
    };
    mesh_.positions.push_back(vec3(kX));
    if (has[kNx] && has[kNy] && has[kNz]) mesh_.normals.push_back(vec3(kNx));
    // v runs up from the bottom row, as the tools that write PLY have it.
    if (has[kU] && has[kV])
      mesh_.texcoords.emplace_back(to_float(value[kU]), 1.0f - to_float(value[kV]));
    if (has[kRed] && has[kGreen] && has[kBlue]) {
      mesh_.colours.push_back(linear_from_srgb(
          value[kRed] * colour_scale, value[kGreen] * colour_scale, value[kBlue] * colour_scale));
    }
  }

  void read_lists(const PlyElement& element) {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) {
        const bool is_face = element.name == "face" &&
                             (property.name == "vertex_indices" || property.name == "vertex_index");
        const bool is_strip = element.name == "tristrips" && property.name == "vertex_indices";
        if (!property.is_list || !(is_face || is_strip)) {
          values_.skip(property);
          continue;
        }
        values_.read_list(property, list_);
        if (is_strip) {
          add_strips();
        } else {
          for (const double index : list_) corners_.push_back(as_index(index));
          face_ends_.push_back(corners_.size());
        }
      }
    }
  }

  /// Triangle strips one after another in list_, each ended by -1.
  void add_strips() {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < list_.size(); ++i) {
      if (list_[i] < 0.0) {
        begin = i + 1;
      } else if (i >= begin + 2) {
        const bool odd = (i - begin) % 2 == 1;
        corners_.push_back(as_index(list_[odd ? i - 1 : i - 2]));
        corners_.push_back(as_index(list_[odd ? i - 2 : i - 1]));
        corners_.push_back(as_index(list_[i]));
        face_ends_.push_back(corners_.size());
      }
    }
  }

  const ModelFile& file_;
  const PlyHeader& header_;
  PlyValues values_;
  Mesh mesh_;
  // Faces may come before the vertices, so they are kept until the end.
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> face_ends_;
  std::vector<double> list_;
};

}  // namespace

Scene read_ply(const ModelFile& file) {
  const PlyHeader header = read_ply_header(file);
  Mesh mesh = PlyMesh(file, header).read();
  if (mesh.texcoords.empty() || header.texture_file.empty()) return scene_of({std::move(mesh)});
  mesh.material = 0;
  Scene scene = scene_of({std::move(mesh)});
  Material material;
  material.base_colour = glm::vec3(1.0f);
  PictureFinder finder(file);
  if (auto picture = finder.find(header.texture_file)) {
    scene.textures.emplace_back(*picture);
    scene.textures.back().name = header.texture_file;
    material.base_texture = 0;
  }
  scene.materials.push_back(material);
  return scene;
}

}  // namespace kinescope
