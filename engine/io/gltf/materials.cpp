#include "engine/io/gltf/materials.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "engine/io/text.h"

namespace kinescope {
namespace {

using tinygltf::Value;

const Value* member(const Value* object, const char* name) {
  return object && object->IsObject() && object->Has(name) ? &object->Get(name) : nullptr;
}

const Value* extension(const tinygltf::ExtensionMap& extensions, const char* name) {
  const auto found = extensions.find(name);
  return found == extensions.end() ? nullptr : &found->second;
}

float number_or(const Value* value, float otherwise) {
  if (!value || !value->IsNumber()) return otherwise;
  return to_float(value->GetNumberAsDouble());
}

template <typename Vec>
Vec vector_or(const Value* value, Vec otherwise) {
  if (!value || value->ArrayLen() < static_cast<std::size_t>(Vec::length())) return otherwise;
  for (int i = 0; i < Vec::length(); ++i) otherwise[i] = number_or(&value->Get(i), otherwise[i]);
  return otherwise;
}

int index_or(const Value* value, int otherwise) {
  return value && value->IsInt() ? value->GetNumberAsInt() : otherwise;
}

float unit(float value) { return value > 0.0f ? std::min(value, 1.0f) : 0.0f; }
glm::vec3 unit(glm::vec3 v) { return {unit(v.x), unit(v.y), unit(v.z)}; }

glm::vec3 vec3_of(const std::vector<double>& numbers) {
  if (numbers.size() < 3) return glm::vec3(1.0f);
  return {to_float(numbers[0]), to_float(numbers[1]), to_float(numbers[2])};
}

GltfTexcoords texcoords_from(int set, const tinygltf::ExtensionMap& extensions) {
  GltfTexcoords texcoords;
  texcoords.set = set;
  const Value* transform = extension(extensions, "KHR_texture_transform");
  texcoords.offset = vector_or(member(transform, "offset"), texcoords.offset);
  texcoords.scale = vector_or(member(transform, "scale"), texcoords.scale);
  texcoords.rotation_rad = number_or(member(transform, "rotation"), 0.0f);
  texcoords.set = index_or(member(transform, "texCoord"), set);
  return texcoords;
}

Wrap wrap_of(int code) {
  if (code == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::kClamp;
  if (code == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::kMirror;
  return Wrap::kRepeat;
}

Filter filter_of(const tinygltf::Sampler& sampler) {
  if (sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST) return Filter::kNearest;
  if (sampler.minFilter == TINYGLTF_TEXTURE_FILTER_LINEAR) return Filter::kBilinear;
  return Filter::kTrilinear;
}

/// Alpha as the material's mode reads it: all there, all or nothing, or as it is.
void apply_alpha_mode(Image<Srgb8>& picture, const tinygltf::Material& source) {
  if (source.alphaMode == "BLEND") return;
  const bool mask = source.alphaMode == "MASK";
  for (Srgb8& pixel : picture.pixels()) {
    pixel.a = !mask || pixel.a >= source.alphaCutoff * 255.0 ? 255 : 0;
  }
}

}  // namespace

glm::vec2 GltfTexcoords::apply(glm::vec2 uv) const {
  const glm::vec2 scaled = uv * scale;
  const float c = std::cos(rotation_rad);
  const float s = std::sin(rotation_rad);
  // Counter-clockwise as seen, with v down.
  return glm::vec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x) + offset;
}

void set_phong(Material& material, const PhysicalSurface& surface) {
  constexpr float kMirrored = 0.3f;
  constexpr float kSharpest = 1024.0f;
  const float metal = surface.metalness;
  material.base_colour = surface.base_colour * (1.0f - (1.0f - kMirrored) * metal);
  const float alpha = std::max(surface.roughness * surface.roughness, 1e-3f);
  const float blinn = 2.0f / (alpha * alpha) - 2.0f;
  material.shininess = std::clamp(blinn * 0.25f, 1.0f, kSharpest);
  const glm::vec3 reflectance = glm::mix(surface.reflectance, surface.base_colour, metal);
  const float strongest = std::max({reflectance.r, reflectance.g, reflectance.b, 1e-6f});
  material.specular = reflectance * std::min((blinn + 8.0f) / 8.0f, 1.0f / strongest);
}

GltfMaterials::GltfMaterials(const tinygltf::Model& model, const GltfAccessors& accessors,
                             const ModelFile& file, Scene& scene)
    : model_(model), accessors_(accessors), file_(file), scene_(scene), finder_(file) {}

void GltfMaterials::read_all() {
  for (const tinygltf::Material& source : model_.materials) read(source);
}

GltfTexcoords GltfMaterials::texcoords_of(int material) const {
  const bool known = material >= 0 && static_cast<std::size_t>(material) < texcoords_.size();
  return known ? texcoords_[static_cast<std::size_t>(material)] : GltfTexcoords{};
}

void GltfMaterials::read(const tinygltf::Material& source) {
  Material material;
  material.name = source.name;
  material.double_sided = source.doubleSided;
  texcoords_.emplace_back();
  const Value* glossy = extension(source.extensions, "KHR_materials_pbrSpecularGlossiness");
  if (glossy) {
    read_specular_glossiness(source, *glossy, material);
  } else {
    read_base(source, material);
  }
  read_emission(source, material);
  if (extension(source.extensions, "KHR_materials_unlit")) {
    material.specular = glm::vec3(0.0f);
    // A texture cannot shine by itself here: an unlit one is lit, but without a highlight.
    if (material.base_texture < 0) {
      material.emission = material.base_colour;
      material.base_colour = glm::vec3(0.0f);
    }
  }
  scene_.materials.push_back(std::move(material));
}

void GltfMaterials::read_base(const tinygltf::Material& source, Material& material) {
  const tinygltf::PbrMetallicRoughness& pbr = source.pbrMetallicRoughness;
  PhysicalSurface surface;
  surface.base_colour = unit(vec3_of(pbr.baseColorFactor));
  surface.metalness = unit(to_float(pbr.metallicFactor));
  surface.roughness = unit(to_float(pbr.roughnessFactor));
  if (pbr.metallicRoughnessTexture.index >= 0) {
    // One value for the whole surface: green is roughness, blue is metalness.
    const glm::vec3 mean = mean_of(pbr.metallicRoughnessTexture.index, false);
    surface.roughness *= mean.g;
    surface.metalness *= mean.b;
  }
  if (extension(source.extensions, "KHR_materials_unlit")) surface.metalness = 0.0f;
  set_phong(material, surface);
  if (source.alphaMode == "BLEND" && pbr.baseColorFactor.size() == 4) {
    material.opacity = unit(to_float(pbr.baseColorFactor[3]));
  }
  const tinygltf::TextureInfo& info = pbr.baseColorTexture;
  lay_base(info.index, texcoords_from(info.texCoord, info.extensions), source, material);
}

void GltfMaterials::read_specular_glossiness(const tinygltf::Material& source, const Value& glossy,
                                             Material& material) {
  const glm::vec4 diffuse = vector_or(member(&glossy, "diffuseFactor"), glm::vec4(1.0f));
  PhysicalSurface surface;
  surface.base_colour = unit(glm::vec3(diffuse));
  surface.metalness = 0.0f;
  surface.reflectance = unit(vector_or(member(&glossy, "specularFactor"), glm::vec3(1.0f)));
  surface.roughness = 1.0f - unit(number_or(member(&glossy, "glossinessFactor"), 1.0f));
  set_phong(material, surface);
  if (source.alphaMode == "BLEND") material.opacity = unit(diffuse.a);
  const Value* info = member(&glossy, "diffuseTexture");
  tinygltf::ExtensionMap extensions;
  if (const Value* transform = member(member(info, "extensions"), "KHR_texture_transform")) {
    extensions["KHR_texture_transform"] = *transform;
  }
  lay_base(index_or(member(info, "index"), -1),
           texcoords_from(index_or(member(info, "texCoord"), 0), extensions), source, material);
}

void GltfMaterials::read_emission(const tinygltf::Material& source, Material& material) {
  const Value* strength = extension(source.extensions, "KHR_materials_emissive_strength");
  const float times =
      std::clamp(number_or(member(strength, "emissiveStrength"), 1.0f), 0.0f, 100.0f);
  material.emission = unit(vec3_of(source.emissiveFactor)) * times;
  if (source.emissiveTexture.index >= 0 && material.emission != glm::vec3(0.0f)) {
    material.emission *= mean_of(source.emissiveTexture.index, true);
  }
}

const Image<Srgb8>* GltfMaterials::picture_of(int texture) {
  if (texture < 0 || static_cast<std::size_t>(texture) >= model_.textures.size()) return nullptr;
  const int source = model_.textures[static_cast<std::size_t>(texture)].source;
  if (source < 0 || static_cast<std::size_t>(source) >= model_.images.size()) return nullptr;
  const auto [entry, is_new] = pictures_.try_emplace(source);
  if (is_new) {
    const tinygltf::Image& image = model_.images[static_cast<std::size_t>(source)];
    const std::span<const std::uint8_t> bytes =
        image.bufferView >= 0 ? accessors_.bytes_of_view(image.bufferView) : std::span(image.image);
    std::string name = "image " + std::to_string(source);
    if (!image.uri.empty()) name += " (" + image.uri.substr(0, 80) + ")";
    if (bytes.empty()) {
      file_.warn("the picture is missing; drawn without it", name);
    } else {
      entry->second = finder_.decode(bytes, name);
    }
  }
  return entry->second ? &*entry->second : nullptr;
}

glm::vec3 GltfMaterials::mean_of(int texture, bool is_colour) {
  const Image<Srgb8>* picture = picture_of(texture);
  if (!picture || picture->empty()) return glm::vec3(1.0f);
  glm::dvec3 sum(0.0);
  for (const Srgb8& pixel : picture->pixels()) {
    if (is_colour) {
      const LinearRgba linear = decode(pixel);
      sum += glm::dvec3(linear.r, linear.g, linear.b);
    } else {
      sum += glm::dvec3(pixel.r, pixel.g, pixel.b) / 255.0;
    }
  }
  return glm::vec3(sum / static_cast<double>(picture->pixels().size()));
}

void GltfMaterials::lay_base(int texture, const GltfTexcoords& texcoords,
                             const tinygltf::Material& source, Material& material) {
  const Image<Srgb8>* picture = picture_of(texture);
  if (!picture) return;
  texcoords_.back() = texcoords;
  const double cutoff = source.alphaMode == "MASK" ? source.alphaCutoff : 0.0;
  const auto next = static_cast<int>(scene_.textures.size());
  const auto [entry, is_new] = textures_.try_emplace({texture, source.alphaMode, cutoff}, next);
  material.base_texture = entry->second;
  if (!is_new) return;
  const tinygltf::Texture& found = model_.textures[static_cast<std::size_t>(texture)];
  tinygltf::Sampler sampler;
  if (found.sampler >= 0 && static_cast<std::size_t>(found.sampler) < model_.samplers.size()) {
    sampler = model_.samplers[static_cast<std::size_t>(found.sampler)];
  }
  Image<Srgb8> laid = *picture;
  apply_alpha_mode(laid, source);
  scene_.textures.emplace_back(laid, filter_of(sampler), wrap_of(sampler.wrapS),
                               wrap_of(sampler.wrapT));
  scene_.textures.back().name = found.name;
}

}  // namespace kinescope
