#include "demos/film.h"

#include <gtest/gtest.h>

#include "raster/base/error.h"

namespace kinescope {
namespace {

TEST(Film, FormatByEndingByOptionAndByCount) {
  EXPECT_EQ(film_format("a.png", "", false), FilmFormat::kPng);
  EXPECT_EQ(film_format("a_#.png", "", true), FilmFormat::kPng);
  EXPECT_EQ(film_format("a.y4m", "", false), FilmFormat::kY4m);
  EXPECT_EQ(film_format("-", "", false), FilmFormat::kPng);
  EXPECT_EQ(film_format("-", "", true), FilmFormat::kY4m);
  EXPECT_EQ(film_format("/dev/full", "", true), FilmFormat::kY4m);
  EXPECT_EQ(film_format("a.png", "raw", true), FilmFormat::kRaw);
  EXPECT_EQ(film_format("folder.d/film", "", false), FilmFormat::kPng);
  EXPECT_THROW(film_format("a.mp4", "", false), Error);
  EXPECT_THROW(film_format("a.png", "", true), Error);
  EXPECT_THROW(film_format("-", "png", true), Error);
}

}  // namespace
}  // namespace kinescope
