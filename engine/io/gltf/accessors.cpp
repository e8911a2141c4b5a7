#include "engine/io/gltf/accessors.h"

#include <algorithm>
#include <cstring>

namespace kinescope {
namespace {

/// Bytes of a component; 0 for those that glTF does not have.
std::size_t component_size(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

/// Components of an element; 0 for matrices, which no attribute of a mesh is.
int component_count(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    default:
      return 0;
  }
}

template <typename T>
T load(const std::uint8_t* from) {
  T value;
  std::memcpy(&value, from, sizeof(T));
  return value;
}

/// Source: glTF 2.0 specification, 3.6.2.2, the conversion of normalized integers.
float load_float(const std::uint8_t* from, int type, bool normalized) {
  const auto scaled = [&](float value, float largest) {
    return normalized ? std::max(value / largest, -1.0f) : value;
  };
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return scaled(load<std::int8_t>(from), 127.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return scaled(*from, 255.0f);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return scaled(load<std::int16_t>(from), 32767.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return scaled(load<std::uint16_t>(from), 65535.0f);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return scaled(static_cast<float>(load<std::uint32_t>(from)), 4294967295.0f);
    default:
      return load<float>(from);
  }
}

std::uint32_t load_index(const std::uint8_t* from, int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return *from;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return load<std::uint16_t>(from);
    default:
      return load<std::uint32_t>(from);
  }
}

bool is_index_type(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// Elements at even distances within a view.
struct Elements {
  std::span<const std::uint8_t> bytes;
  std::size_t stride = 0;

  const std::uint8_t* at(std::size_t i) const { return bytes.data() + i * stride; }
};

/// @throws Error if the last element ends outside
Elements elements_of(std::span<const std::uint8_t> view, std::size_t offset, std::size_t stride,
                     std::size_t size, std::size_t count, const ModelFile& file,
                     const std::string& where) {
  if (count == 0) return {};
  if (offset > view.size() || size > view.size() - offset ||
      count - 1 > (view.size() - offset - size) / stride) {
    file.fail("reaches past the end of its buffer view", where);
  }
  return {view.subspan(offset), stride};
}

}  // namespace

GltfAccessors::GltfAccessors(const tinygltf::Model& model, const ModelFile& file)
    : model_(model), file_(file), total_bytes_(file.bytes.size()) {
  for (const tinygltf::Buffer& buffer : model.buffers) total_bytes_ += buffer.data.size();
}

std::span<const std::uint8_t> GltfAccessors::bytes_of_view(int view) const {
  if (view < 0 || static_cast<std::size_t>(view) >= model_.bufferViews.size()) return {};
  const tinygltf::BufferView& found = model_.bufferViews[static_cast<std::size_t>(view)];
  if (found.buffer < 0 || static_cast<std::size_t>(found.buffer) >= model_.buffers.size())
    return {};
  const std::span<const std::uint8_t> all(
      model_.buffers[static_cast<std::size_t>(found.buffer)].data);
  if (found.byteOffset > all.size() || found.byteLength > all.size() - found.byteOffset) return {};
  return all.subspan(found.byteOffset, found.byteLength);
}

const tinygltf::Accessor& GltfAccessors::checked(int accessor) const {
  const std::string where = "accessor " + std::to_string(accessor);
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size()) {
    file_.fail("is not there", where);
  }
  const tinygltf::Accessor& found = model_.accessors[static_cast<std::size_t>(accessor)];
  if (component_size(found.componentType) == 0 || component_count(found.type) == 0) {
    file_.fail("has a type that no mesh can have", where);
  }
  if (found.count > total_bytes_) file_.fail("promises more elements than the file holds", where);
  return found;
}

/// Calls sink(i, bytes of element i), first for all elements, then for those that are replaced.
template <typename Sink>
void GltfAccessors::visit(int index, const Sink& sink) const {
  const tinygltf::Accessor& accessor = checked(index);
  const std::string where = "accessor " + std::to_string(index);
  // Without a view all elements are zero.
  if (accessor.bufferView >= 0) {
    const std::size_t size = component_size(accessor.componentType) *
                             static_cast<std::size_t>(component_count(accessor.type));
    const std::span<const std::uint8_t> view = bytes_of_view(accessor.bufferView);
    // An empty span may mean that there is no such view.
    const std::size_t stride =
        view.empty() ? 0
                     : model_.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
    const Elements elements = elements_of(view, accessor.byteOffset, stride ? stride : size, size,
                                          accessor.count, file_, where);
    for (std::size_t i = 0; i < accessor.count; ++i) sink(i, elements.at(i));
  }
  if (accessor.sparse.isSparse) visit_sparse(accessor, where, sink);
}

template <typename Sink>
void GltfAccessors::visit_sparse(const tinygltf::Accessor& accessor, const std::string& where,
                                 const Sink& sink) const {
  const auto& sparse = accessor.sparse;
  const int index_type = sparse.indices.componentType;
  if (sparse.count < 0 || sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0 ||
      !is_index_type(index_type)) {
    file_.fail("its sparse part is not as it should be", where);
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::size_t index_size = component_size(index_type);
  const std::size_t size = component_size(accessor.componentType) *
                           static_cast<std::size_t>(component_count(accessor.type));
  const Elements indices = elements_of(bytes_of_view(sparse.indices.bufferView),
                                       static_cast<std::size_t>(sparse.indices.byteOffset),
                                       index_size, index_size, count, file_, where);
  const Elements values = elements_of(bytes_of_view(sparse.values.bufferView),
                                      static_cast<std::size_t>(sparse.values.byteOffset), size,
                                      size, count, file_, where);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t target = load_index(indices.at(i), index_type);
    if (target >= accessor.count)
      file_.fail("its sparse part replaces an element that is not there", where);
    sink(target, values.at(i));
  }
}

const GltfNumbers& GltfAccessors::floats(int index) {
  const auto known = floats_.find(index);
  if (known != floats_.end()) return known->second;
  const tinygltf::Accessor& accessor = checked(index);
  GltfNumbers numbers;
  numbers.components = component_count(accessor.type);
  numbers.count = accessor.count;
  const auto width = static_cast<std::size_t>(numbers.components);
  const std::size_t size = component_size(accessor.componentType);
  // Every number takes a byte at least; accessors that overlap must not multiply them.
  decoded_ += accessor.count * width;
  if (decoded_ > 4 * total_bytes_) file_.fail("too many accessors show the same bytes");
  numbers.values.assign(accessor.count * width, 0.0f);
  visit(index, [&](std::size_t i, const std::uint8_t* element) {
    for (std::size_t c = 0; c < width; ++c) {
      numbers.values[i * width + c] =
          load_float(element + c * size, accessor.componentType, accessor.normalized);
    }
  });
  return floats_.emplace(index, std::move(numbers)).first->second;
}

std::vector<std::uint32_t> GltfAccessors::indices(int index) const {
  const tinygltf::Accessor& accessor = checked(index);
  if (!is_index_type(accessor.componentType) || accessor.type != TINYGLTF_TYPE_SCALAR) {
    file_.fail("cannot serve as indices", "accessor " + std::to_string(index));
  }
  std::vector<std::uint32_t> indices(accessor.count, 0);
  visit(index, [&](std::size_t i, const std::uint8_t* element) {
    indices[i] = load_index(element, accessor.componentType);
  });
  return indices;
}

}  // namespace kinescope
