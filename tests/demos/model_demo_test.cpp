#include "demos/model_demo.h"

#include <gtest/gtest.h>

#include <set>

#include "demos/player.h"
#include "engine/teapot.h"
#include "tests/demos/demo_testing.h"

namespace kinescope {
namespace {

DemoInfo teapot_as_a_model() {
  Scene scene;
  scene.meshes.push_back(teapot_mesh(3));
  scene.meshes[0].material = 0;
  scene.materials.emplace_back().specular = glm::vec3(0.5f);
  Node node;
  node.meshes = {0};
  scene.nodes.push_back(node);
  Options options;
  options.render.models = {"teapot"};
  return model_demo(std::move(scene), options.render, plan_model_film(options));
}

std::uint64_t picture_after(const std::vector<InputEvent>& events) {
  const DemoInfo info = teapot_as_a_model();
  Player player(info, small_setup(), 0);
  const Seconds length = player.demo().refresh().period();
  player.forward(length);
  player.forward(length, events);
  for (int i = 0; i < 3; ++i) player.forward(length);
  return hash_picture(player.picture());
}

TEST(ModelDemo, ShowsTheModelOnItsTube) {
  const DemoInfo info = teapot_as_a_model();
  Player player(info, small_setup(), 0);
  for (int i = 0; i < 4; ++i) player.forward(player.demo().refresh().period());
  const Image<Srgb8>& picture = player.picture();
  EXPECT_GT(picture.at(80, 60).g, 60);
  EXPECT_LT(picture.at(2, 2).g, 20);
}

TEST(ModelDemo, EveryKeyChangesThePicture) {
  std::set<std::uint64_t> hashes;
  const std::vector<std::string> keys{"", "f", "g", "b", "u", "w", "1", "8", "d", "Left", "Up"};
  for (const std::string& key : keys) {
    hashes.insert(picture_after(key.empty() ? std::vector<InputEvent>{}
                                            : std::vector<InputEvent>{key_down(key)}));
  }
  EXPECT_EQ(hashes.size(), keys.size());
}

TEST(ModelDemo, DraggingTurnsItAndTheWheelBringsItNear) {
  const std::uint64_t still = picture_after({});
  const std::uint64_t turned =
      picture_after({mouse_event(InputKind::kMouseDown, 50, 50, MouseButton::kLeft),
                     mouse_event(InputKind::kMouseMove, 90, 60),
                     mouse_event(InputKind::kMouseUp, 90, 60, MouseButton::kLeft)});
  const std::uint64_t nearer =
      picture_after({mouse_event(InputKind::kWheel, 80, 60, MouseButton::kNone, 2)});
  EXPECT_NE(still, turned);
  EXPECT_NE(still, nearer);
  EXPECT_NE(turned, nearer);
}

TEST(ModelDemo, ACopyIsASnapshot) {
  const DemoInfo info = teapot_as_a_model();
  const auto demo = info.create(small_setup());
  const Seconds T = demo->refresh().period();
  Image<Srgb8> picture, again;
  demo->step({{Seconds(0), T}, {}}, picture);
  const auto copy = demo->clone();
  demo->step({{T, 2 * T}, {key_down("Left")}}, picture);
  copy->step({{T, 2 * T}, {key_down("Left")}}, again);
  EXPECT_EQ(hash_picture(picture), hash_picture(again));
}

}  // namespace
}  // namespace kinescope
