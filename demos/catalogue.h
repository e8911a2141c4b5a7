// The gallery on paper: a page in Markdown of every demo's picture, topics and keys.
#pragma once

#include <string>

#include "demos/demo.h"

namespace kinescope {

/// @param pictures folder of the pictures (NAME.png), as seen from the page
std::string gallery_page_markdown(const std::string& pictures);

/// Draws a demo as the page shows it, after some seconds of its own time.
Image<Srgb8> catalogue_picture(const DemoInfo& info, const std::shared_ptr<Studio>& studio);

}  // namespace kinescope
