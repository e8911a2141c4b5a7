#include "engine/io/gltf/container.h"

#include <algorithm>
#include <string_view>

#include "engine/io/byte_reader.h"
#include "engine/io/text.h"

namespace kinescope {
namespace {

constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinaryChunk = 0x004e4942;
constexpr int kDeepest = 128;
constexpr std::uint64_t kMostBufferBytes = std::uint64_t{1} << 31;

/// Walks JSON text without understanding more of it than strings and brackets.
class JsonShape {
 public:
  explicit JsonShape(std::string_view text) : text_(text) {}

  void scan() {
    for (at_ = 0; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"') {
        string();
      } else if (c == '{' || c == '[') {
        open(c);
      } else if (c == '}' || c == ']') {
        --depth_;
      }
    }
  }

  int deepest() const { return deepest_; }
  std::uint64_t buffers() const { return buffers_; }

 private:
  void string() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    if (depth_ == 1) last_key_ = text_.substr(begin, std::min(at_, text_.size()) - begin);
  }

  void open(char bracket) {
    if (depth_ == 2 && bracket == '{' && last_key_ == "buffers") ++buffers_;
    deepest_ = std::max(deepest_, ++depth_);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  int deepest_ = 0;
  std::uint64_t buffers_ = 0;
  std::string_view last_key_;
};

struct Chunks {
  std::string_view json;
  std::uint64_t binary_bytes = 0;
};

Chunks split_glb(const ModelFile& file) {
  ByteReader bytes(file, 4);
  const auto version = bytes.read<std::uint32_t>();
  if (version != 2) {
    file.fail("this is glTF version " + std::to_string(version) + "; only version 2 is read");
  }
  const auto length = bytes.read<std::uint32_t>();
  if (length > file.bytes.size()) {
    file.fail("the file ends too early: it promises " + std::to_string(length) + " bytes and has " +
              std::to_string(file.bytes.size()));
  }
  const auto json_bytes = bytes.read<std::uint32_t>();
  const auto kind = bytes.read<std::uint32_t>();
  if (kind != kJsonChunk) file.fail("the first chunk is not JSON", "byte 16");
  bytes.skip(json_bytes);
  Chunks chunks{as_text(file.bytes).substr(20, json_bytes), 0};
  if (std::uint64_t{20} + json_bytes == length) return chunks;
  chunks.binary_bytes = bytes.read<std::uint32_t>();
  if (bytes.read<std::uint32_t>() != kBinaryChunk)
    bytes.fail("the second chunk is not binary data");
  bytes.skip(chunks.binary_bytes);
  return chunks;
}

}  // namespace

bool is_glb(const ModelFile& file) { return as_text(file.bytes).starts_with("glTF"); }

void check_gltf_container(const ModelFile& file) {
  const Chunks chunks = is_glb(file) ? split_glb(file) : Chunks{as_text(file.bytes), 0};
  JsonShape shape(chunks.json);
  shape.scan();
  if (shape.deepest() > kDeepest) file.fail("the JSON is nested too deeply");
  if (shape.buffers() * chunks.binary_bytes > kMostBufferBytes) file.fail("too many buffers");
}

}  // namespace kinescope
