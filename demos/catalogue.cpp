#include "demos/catalogue.h"

#include <fmt/format.h>

#include <string_view>

#include "demos/gallery_page.h"
#include "demos/lesson/lesson.h"
#include "demos/portrait.h"
#include "demos/registry.h"
#include "demos/ui/widgets.h"

namespace kinescope {
namespace {

constexpr int kPictureWidth = 240, kPictureHeight = 180;
// The storage tube's plot takes so many.
constexpr int kPictureSteps = 150;

/// Nothing is drawn with it.
DemoSetup smallest() { return {std::make_shared<Studio>(1), 64, 48, 1}; }

std::string keys_of(const Knob& knob) {
  std::string keys;
  for (const std::string& key : knob.keys) {
    keys += (keys.empty() ? "`" : " `") + (key == "`" ? "grave" : key_label(key)) + "`";
  }
  return keys;
}

std::string meaning_of(const Knob& knob) {
  std::string text = knob.help;
  for (std::size_t i = 0; i < knob.choices.size(); ++i) {
    text += (i == 0 ? ": " : ", ") + knob.choices[i];
  }
  return text;
}

constexpr const char* kTableHead = "| keys | | |\n|---|---|---|\n";

std::string row(const std::string& keys, const std::string& name, const std::string& meaning) {
  return fmt::format("| {} | {} | {} |\n", keys, name, meaning);
}

std::string knob_rows(std::span<const Knob> knobs) {
  std::string rows;
  for (const Knob& knob : knobs) rows += row(keys_of(knob), knob.name, meaning_of(knob));
  return rows;
}

std::string entry(const DemoInfo& info, const std::string& pictures) {
  std::string text =
      fmt::format("### {0}\n\n![{0}]({1}/{0}.png)\n\n{2}.\n", info.name, pictures, info.summary);
  for (std::size_t i = 0; i < info.topics.size(); ++i) {
    text += fmt::format("{}{}", i == 0 ? "\nShows: " : "; ", info.topics[i]);
  }
  if (!info.topics.empty()) text += ".\n";
  const std::unique_ptr<Demo> demo = info.create(smallest());
  std::span<const Knob> knobs = demo->knobs();
  const bool lesson = dynamic_cast<const Lesson*>(demo.get()) != nullptr;
  if (lesson) knobs = knobs.first(knobs.size() - Lesson::kSharedKnobs);
  std::string rows = info.mouse.empty() ? "" : row("mouse", "", std::string(info.mouse));
  rows += knob_rows(knobs);
  if (!rows.empty()) text += "\n" + (kTableHead + rows);
  return text + "\n";
}

/// Of the first lesson: they have them in common.
std::string lesson_keys() {
  for (const DemoInfo& info : all_demos()) {
    const std::unique_ptr<Demo> demo = info.create(smallest());
    if (dynamic_cast<const Lesson*>(demo.get()) == nullptr) continue;
    return knob_rows(demo->knobs().last(Lesson::kSharedKnobs));
  }
  return {};
}

}  // namespace

std::string gallery_page_markdown(const std::string& pictures) {
  std::string text =
      "# The gallery\n\n"
      "Every demo, by chapter of the course; `kinescope demo NAME` opens one, `kinescope` the\n"
      "gallery. `kinescope list --markdown` writes this page, `scripts/make-gallery` its pictures "
      "too.\n"
      "\n"
      "In every demo `?` shows the keys, Space pauses, `.` and `,` step, `[` and `]` slow time "
      "down\n"
      "and up, Tab shows the knobs. [Lessons](lessons.md) step through an algorithm, and also "
      "have\n"
      "these:\n\n" +
      std::string(kTableHead) +
      row("`n` `b`", "step", "one step of the algorithm forward, one back") +
      row("`Home` `End`", "", "to its beginning, to its end") + lesson_keys() + "\n";
  std::string_view chapter;
  for (const std::size_t i : in_order_of_chapters(all_demos())) {
    const DemoInfo& info = all_demos()[i];
    if (info.chapter != chapter) text += fmt::format("## {}\n\n", info.chapter);
    chapter = info.chapter;
    text += entry(info, pictures);
  }
  text.pop_back();
  return text;
}

Image<Srgb8> catalogue_picture(const DemoInfo& info, const std::shared_ptr<Studio>& studio) {
  Portrait portrait(info, {studio, kPictureWidth, kPictureHeight, 1});
  for (int i = 0; i < kPictureSteps; ++i) portrait.step();
  return portrait.picture();
}

}  // namespace kinescope
