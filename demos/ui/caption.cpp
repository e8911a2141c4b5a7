#include "demos/ui/caption.h"

#include "demos/ui/theme.h"

namespace kinescope {

float caption_room(int height) {
  return (theme::kWindowLine + 1.6f * theme::kBody) * theme::scale_for(height);
}

void lay_caption(Image<Srgb8>& picture, const Font& font, std::string_view text) {
  const float scale = theme::scale_for(picture.height());
  const auto width = static_cast<float>(picture.width()),
             height = static_cast<float>(picture.height());
  Canvas(picture).text(font,
                       {width / 2, height - (theme::kWindowLine + 0.5f * theme::kBody) * scale},
                       text, theme::kBody * scale, theme::kText, Align::kCentre);
}

}  // namespace kinescope
