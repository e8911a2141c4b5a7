#include "bench/workloads.h"

#include "bench/workload_kinds.h"
#include "raster/base/error.h"

namespace kinescope::bench {
namespace {

struct Entry {
  const char* name;
  Workload (*make)();
};

constexpr Entry kEntries[] = {
    {"knot-gouraud",
     [] {
       return knot_workload({4096, 128, ShadingModel::kGouraud, false});
     }},
    {"knot-phong",
     [] {
       return knot_workload({1280, 40, ShadingModel::kPhong, false});
     }},
    {"knot-phong-texture",
     [] {
       return knot_workload({1280, 40, ShadingModel::kPhong, true});
     }},
    {"knot-coarse",
     [] {
       return knot_workload({400, 13, ShadingModel::kGouraud, false});
     }},
    {"knot-micro",
     [] {
       return knot_workload({8192, 256, ShadingModel::kGouraud, false});
     }},
    {"layers-far-first", [] { return layers_workload(32, false, false); }},
    {"layers-near-first", [] { return layers_workload(32, true, false); }},
    {"layers-texture", [] { return layers_workload(8, false, true); }},
    {"layers-glass", [] { return layers_workload(32, false, false, 0.5f); }},
    {"city", [] { return city_workload(); }},
    {"sweep-1", [] { return sweep_workload(1); }},
    {"sweep-2", [] { return sweep_workload(2); }},
    {"sweep-5", [] { return sweep_workload(5); }},
    {"sweep-10", [] { return sweep_workload(10); }},
    {"sweep-50", [] { return sweep_workload(50); }},
    {"sweep-100", [] { return sweep_workload(100); }},
    {"sweep-500", [] { return sweep_workload(500); }},
};

}  // namespace

Material bench_material() {
  Material material;
  material.base_colour = {0.8f, 0.5f, 0.3f};
  material.specular = glm::vec3(0.4f);
  material.shininess = 32;
  return material;
}

void add_bench_lights(Scene& scene) {
  const auto add = [&scene](glm::vec3 position, glm::vec3 colour) {
    Light light;
    light.position = position;
    light.colour = colour;
    scene.lights.push_back({-1, light});
  };
  add({4, 5, 3}, {0.9f, 0.9f, 0.8f});
  add({-4, 2, 1}, {0.3f, 0.4f, 0.6f});
  scene.ambient = glm::vec3(0.1f);
}

std::vector<std::string> workload_names() {
  std::vector<std::string> names;
  for (const Entry& entry : kEntries) names.emplace_back(entry.name);
  return names;
}

Workload make_workload(const std::string& name) {
  std::string known;
  for (const Entry& entry : kEntries) {
    if (name == entry.name) {
      Workload workload = entry.make();
      workload.name = name;
      return workload;
    }
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw Error(ErrorKind::kUsage, "no workload \"" + name + "\"; there are " + known);
}

}  // namespace kinescope::bench
