#include <fmt/format.h>

#include <algorithm>

#include "demos/catalogue.h"
#include "demos/commands/commands.h"
#include "demos/console.h"
#include "demos/json.h"
#include "demos/progress.h"
#include "demos/registry.h"
#include "raster/image/codecs.h"

namespace kinescope {
namespace {

std::string as_json() {
  JsonWriter json;
  json.begin_array();
  for (const DemoInfo& demo : all_demos()) {
    json.begin_object().member("name", demo.name).member("chapter", demo.chapter);
    json.member("summary", demo.summary).key("topics").begin_array();
    for (const std::string_view topic : demo.topics) json.value(topic);
    json.end_array().end_object();
  }
  return json.end_array().text();
}

std::string as_table() {
  std::size_t name_width = 0, chapter_width = 0;
  for (const DemoInfo& demo : all_demos()) {
    name_width = std::max(name_width, demo.name.size());
    chapter_width = std::max(chapter_width, demo.chapter.size());
  }
  std::string table;
  for (const DemoInfo& demo : all_demos()) {
    table += fmt::format("{:{}}  {:{}}  {}\n", demo.name, name_width, demo.chapter, chapter_width,
                         demo.summary);
  }
  return table;
}

void draw_pictures(const std::string& folder, const CommonOptions& common) {
  const auto studio = std::make_shared<Studio>(common.threads);
  Progress progress("drawing", static_cast<int>(all_demos().size()), !common.quiet);
  int drawn = 0;
  for (const DemoInfo& demo : all_demos()) {
    write_png(fmt::format("{}/{}.png", folder, demo.name), catalogue_picture(demo, studio));
    progress.done(++drawn);
  }
}

}  // namespace

int run_list(const Options& options) {
  if (!options.list.pictures.empty()) draw_pictures(options.list.pictures, options.common);
  if (options.list.markdown) {
    print_result(gallery_page_markdown("pictures/gallery"));
    return 0;
  }
  if (!options.list.pictures.empty()) return 0;
  print_result(options.common.json ? as_json() : as_table());
  return 0;
}

}  // namespace kinescope
