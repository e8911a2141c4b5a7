#include "demos/gallery.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <glm/vec2.hpp>
#include <iterator>
#include <set>
#include <vector>

#include "demo_testing.h"
#include "demos/catalogue.h"

namespace kinescope {
namespace {

Gallery make_gallery(int width = 640, int height = 480) {
  return Gallery(test_studio(), width, height, 1);
}

void run(Screen& screen, int ticks) {
  for (int i = 0; i < ticks; ++i) screen.tick(60);
}

InputEvent text(const std::string& words) {
  InputEvent event;
  event.kind = InputKind::kText;
  event.key = words;
  return event;
}

void type(Gallery& gallery, const std::string& words) {
  for (const char c : words) gallery.handle(text(std::string(1, c)));
}

TEST(Gallery, ShowsAPictureOfEachDemoInView) {
  Gallery gallery = make_gallery();
  const GalleryPage& page = gallery.page();
  std::size_t seen = 0;
  for (const std::string chapter : {"2 Scan", "9 Curves"}) {
    type(gallery, chapter);
    run(gallery, 40);
    for (std::size_t i = 0; i < page.shown().size(); ++i) {
      const Rect rect = page.thumbnail(i);
      if (rect.bottom() > 480) continue;
      const int x = static_cast<int>(rect.x), y = static_cast<int>(rect.y);
      EXPECT_GT(distinct_colours(gallery.frame(), x, y, static_cast<int>(rect.right()),
                                 static_cast<int>(rect.bottom())),
                20u)
          << all_demos()[page.shown()[i]].name;
      ++seen;
    }
    gallery.handle(key_down("Escape"));
  }
  EXPECT_GE(seen, 4u);
}

TEST(Gallery, ChaptersStandInTheirOrderUnderOneHeadingEach) {
  const GalleryPage page(all_demos(), 1280, 720);
  EXPECT_EQ(page.shown().size(), all_demos().size());
  const std::set<std::size_t> each(page.shown().begin(), page.shown().end());
  EXPECT_EQ(each.size(), all_demos().size());
  std::set<std::string_view> names;
  std::size_t next = 0;
  for (const GalleryPage::Chapter& chapter : page.chapters()) {
    EXPECT_TRUE(names.insert(chapter.name).second) << chapter.name;
    EXPECT_EQ(chapter.first, next);
    for (std::size_t i = 0; i < chapter.count; ++i) {
      EXPECT_EQ(all_demos()[page.shown()[next++]].chapter, chapter.name);
    }
  }
  EXPECT_EQ(page.chapters().front().name, "1 Displays and coordinates");
  EXPECT_EQ(page.chapters().back().name, "Practicals");
  const auto before = [&](const char* a, const char* b) {
    return names.contains(a) && names.contains(b) &&
           std::find_if(
               page.chapters().begin(), page.chapters().end(),
               [&](const auto& c) {
                 return c.name == a;
               })->first <
               std::find_if(
                   page.chapters().begin(), page.chapters().end(),
                   [&](const auto& c) { return c.name == b; })
                   ->first;
  };
  EXPECT_TRUE(before("2 Scan conversion", "11 Rendering")) << "by number, not by letters";
}

TEST(Gallery, CellsNeitherOverlapNorLeaveThePage) {
  for (const auto& [width, height] : {std::pair{1280, 720}, {3840, 2160}, {640, 480}, {300, 900}}) {
    const GalleryPage page(all_demos(), width, height);
    const Rect room = page.room();
    for (std::size_t i = 0; i < page.shown().size(); ++i) {
      const Rect cell = page.cell(i);
      EXPECT_GE(cell.x, room.x);
      EXPECT_LE(cell.right(), room.right());
      EXPECT_LE(page.thumbnail(i).height, cell.height);
      for (std::size_t j = 0; j < i; ++j) {
        const Rect other = page.cell(j);
        EXPECT_TRUE(other.right() <= cell.x || cell.right() <= other.x ||
                    other.bottom() <= cell.y || cell.bottom() <= other.y)
            << i << " and " << j << " at " << width << "x" << height;
      }
    }
  }
}

TEST(Gallery, WordsFindNamesChaptersAndTopics) {
  const DemoInfo info{"seed-fill", "8 Filling",   "Runs need a short stack", {}, 1,
                      {},          {"Flood fill"}};
  for (const char* words : {"", " ", "seed", "SEED", "8 fill", "flood stack", "  runs "}) {
    EXPECT_TRUE(found_by(info, words)) << words;
  }
  for (const char* words : {"seeds", "flood pen", "9"})
    EXPECT_FALSE(found_by(info, words)) << words;
}

TEST(Gallery, TypingSearchesEnterStartsAndEscapeShowsAll) {
  Gallery gallery = make_gallery();
  gallery.handle(text(" "));
  EXPECT_FALSE(gallery.typing()) << "a space alone is no search";
  type(gallery, "bezier");
  EXPECT_TRUE(gallery.typing());
  ASSERT_TRUE(gallery.selected());
  for (const std::size_t demo : gallery.page().shown()) {
    EXPECT_TRUE(found_by(all_demos()[demo], "bezier"));
  }
  EXPECT_LT(gallery.page().shown().size(), all_demos().size() / 2);
  type(gallery, "zzz");
  EXPECT_FALSE(gallery.selected());
  for (const char* key : {"Return", "Down", "Tab", "PageUp", "End"}) gallery.handle(key_down(key));
  EXPECT_FALSE(gallery.done()) << "nothing was found";
  run(gallery, 2);
  for (int i = 0; i < 3; ++i) gallery.handle(key_down("Backspace"));
  ASSERT_TRUE(gallery.selected());
  const std::size_t found = *gallery.selected();
  gallery.handle(key_down("Return"));
  EXPECT_EQ(gallery.take_choice(), found);
  EXPECT_EQ(gallery.selected(), found) << "it is still found and marked";
  gallery.handle(key_down("Escape"));
  EXPECT_FALSE(gallery.typing());
  EXPECT_EQ(gallery.page().shown().size(), all_demos().size());
}

TEST(Gallery, KeysMoveTheMarkAndKeepItInView) {
  Gallery gallery = make_gallery();
  const GalleryPage& page = gallery.page();
  const auto order = page.shown();
  const auto place = [&] {
    return static_cast<std::size_t>(std::find(order.begin(), order.end(), *gallery.selected()) -
                                    order.begin());
  };
  const auto press = [&](const char* key) {
    gallery.handle(key_down(key));
    const Rect rect = page.thumbnail(place());
    EXPECT_GE(rect.y, page.room().y) << key;
    EXPECT_LE(rect.bottom(), 480) << key;
    return place();
  };
  const std::size_t last = order.size() - 1;
  EXPECT_EQ(press("Left"), 0u);
  EXPECT_EQ(press("Right"), 1u);
  const std::size_t below = press("Down");
  EXPECT_GT(below, 2u) << "a row holds two or more";
  EXPECT_EQ(page.cell(below).x, page.cell(1).x);
  EXPECT_EQ(press("Up"), 1u);
  EXPECT_EQ(press("Left"), 0u);
  EXPECT_EQ(press("Down"), below - 1);
  EXPECT_EQ(press("End"), last);
  EXPECT_EQ(press("Right"), last);
  EXPECT_EQ(press("Down"), last);
  EXPECT_EQ(press("Home"), 0u);
  EXPECT_GT(press("PageDown"), 0u);
  EXPECT_EQ(press("PageUp"), 0u);
  // Down from row to row visits each row once and ends in the last.
  std::set<float> rows;
  for (std::size_t at = 0;; at = place()) {
    rows.insert(page.cell(at).y - page.cell(0).y);
    if (press("Down") == at) break;
  }
  EXPECT_EQ(page.cell(place()).y, page.cell(last).y);
  press("Home");
  for (const GalleryPage::Chapter& chapter : page.chapters()) {
    EXPECT_EQ(place(), chapter.first);
    press("Tab");
  }
  EXPECT_EQ(place(), 0u);
  EXPECT_FALSE(gallery.done());
  gallery.handle(key_down("Return"));
  EXPECT_TRUE(gallery.done());
  EXPECT_EQ(gallery.take_choice(), order[0]);
  EXPECT_FALSE(gallery.done()) << "it can be shown again";
}

TEST(Gallery, TheMouseMarksStartsAndScrolls) {
  Gallery gallery = make_gallery(1280, 720);
  const GalleryPage& page = gallery.page();
  run(gallery, 1);
  const auto over = [](const Rect& rect) {
    return glm::ivec2(rect.x + rect.width / 2, rect.y + rect.height / 2);
  };
  for (const std::size_t i : {2u, 0u, 3u}) {
    const glm::ivec2 at = over(page.thumbnail(i));
    gallery.handle(mouse_event(InputKind::kMouseMove, at.x, at.y));
    EXPECT_EQ(gallery.selected(), page.shown()[i]);
  }
  gallery.handle(mouse_event(InputKind::kMouseDown, 5, 5, MouseButton::kLeft));
  EXPECT_FALSE(gallery.done()) << "a click beside the demos";
  const float before = page.cell(0).y;
  gallery.handle(mouse_event(InputKind::kWheel, 640, 400, MouseButton::kNone, 5));
  EXPECT_EQ(page.cell(0).y, before) << "there is nothing above";
  gallery.handle(mouse_event(InputKind::kWheel, 640, 400, MouseButton::kNone, -1));
  EXPECT_LT(page.cell(0).y, before);
  gallery.handle(mouse_event(InputKind::kWheel, 640, 400, MouseButton::kNone, -500));
  EXPECT_LE(page.cell(all_demos().size() - 1).bottom(), 720) << "the page's end, and no farther";
  EXPECT_GT(page.cell(all_demos().size() - 1).bottom(), 600);
  const glm::ivec2 second = over(page.rail_entry(1));
  gallery.handle(mouse_event(InputKind::kMouseDown, second.x, second.y, MouseButton::kLeft));
  EXPECT_FALSE(gallery.done());
  EXPECT_NEAR(page.heading(1).y, page.room().y, 1);
  const std::size_t wanted = page.chapters()[1].first + 1;
  const glm::ivec2 at = over(page.thumbnail(wanted));
  gallery.handle(mouse_event(InputKind::kMouseDown, at.x, at.y, MouseButton::kLeft));
  EXPECT_EQ(gallery.take_choice(), page.shown()[wanted]);
}

TEST(Gallery, MovingTheMarkChangesThePicture) {
  Gallery gallery = make_gallery();
  type(gallery, "scan conversion");  // cheap ones
  run(gallery, 12);
  const auto before = gallery.frame();
  gallery.handle(key_down("Right"));
  run(gallery, 1);
  EXPECT_NE(before, gallery.frame());
}

// docs/gallery.md is the program's own page; scripts/make-gallery writes it anew.
TEST(GalleryPageOnPaper, IsWhatTheProgramSaysAndNamesEveryDemo) {
  const std::string docs = KINESCOPE_SOURCE_DIR "/docs/";
  std::ifstream file(docs + "gallery.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(page == gallery_page_markdown("pictures/gallery")) << "run scripts/make-gallery";
  std::uintmax_t bytes = 0;
  for (const DemoInfo& info : all_demos()) {
    const std::string name(info.name), picture = "pictures/gallery/" + name + ".png";
    EXPECT_NE(page.find("### " + name + "\n"), std::string::npos);
    EXPECT_NE(page.find("## " + std::string(info.chapter) + "\n"), std::string::npos);
    EXPECT_NE(page.find("(" + picture + ")"), std::string::npos);
    ASSERT_TRUE(std::filesystem::exists(docs + picture)) << "run scripts/make-gallery";
    bytes += std::filesystem::file_size(docs + picture);
    const std::unique_ptr<Demo> demo = info.create(small_setup(64, 48));
    for (const Knob& knob : demo->knobs()) {
      EXPECT_NE(page.find(knob.help), std::string::npos) << knob.name << " of " << name;
    }
  }
  EXPECT_LT(bytes, 3u << 20) << "small pictures";
}

TEST(Gallery, FitsWindowsOfAnyShape) {
  for (const auto& [width, height] : {std::pair{1, 1}, {100, 900}, {1600, 200}, {1920, 1080}}) {
    Gallery gallery = make_gallery();
    type(gallery, "scan conversion");
    run(gallery, 1);
    gallery.handle(mouse_event(InputKind::kResize, width, height));
    gallery.handle(key_down("End"));
    run(gallery, 3);
    EXPECT_EQ(gallery.frame().width(), std::max(64, width));
    EXPECT_EQ(gallery.frame().height(), std::max(48, height));
  }
}

}  // namespace
}  // namespace kinescope
