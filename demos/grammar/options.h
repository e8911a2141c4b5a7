// Options that several commands share, as CLI11 takes them.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "demos/options.h"

namespace kinescope::grammar {

using Parse = std::function<void(const std::string& text, const std::string& option)>;

/// An option whose text a parser of our own takes; `names` as CLI11 has them ("-o,--output").
CLI::Option* add(CLI::App& app, const std::string& names, const std::string& value_name,
                 const std::string& help, const Parse& parse);
/// One of a few words; `set` gets its index.
void add_choice(CLI::App& app, const std::string& names, std::vector<std::string> words,
                const std::string& help, const std::function<void(std::size_t)>& set);

// Values land in the options while CLI11 parses; both must outlive the App.
void add_common(CLI::App& app, CommonOptions& common);
void add_size(CLI::App& app, PictureOptions& picture);
/// @param formats that --format takes; svg only where strokes are at hand
void add_picture(CLI::App& app, PictureOptions& picture,
                 const std::vector<std::string>& formats = {"png", "y4m", "raw"});
/// @param or_bare whether the picture may also be left as it is
void add_display(CLI::App& app, PictureOptions& picture, bool or_bare);
void add_depth(CLI::App& app, PictureOptions& picture);
/// How a model is looked at.
void add_camera(CLI::App& app, RenderOptions& render);

}  // namespace kinescope::grammar
