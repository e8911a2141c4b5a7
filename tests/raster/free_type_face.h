// FreeType's own view of the built-in sans font, as an oracle.
#pragma once

#include <ft2build.h>
#include FT_FREETYPE_H

#include <gtest/gtest.h>

#include <string_view>

#include "dejavu_sans.h"

namespace kinescope {

class FreeTypeFace {
 public:
  FreeTypeFace() {
    EXPECT_EQ(FT_Init_FreeType(&library_), 0);
    const std::string_view bytes = embedded::dejavu_sans();
    EXPECT_EQ(FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(bytes.data()),
                                 static_cast<FT_Long>(bytes.size()), 0, &face_),
              0);
  }
  ~FreeTypeFace() { FT_Done_FreeType(library_); }
  FreeTypeFace(const FreeTypeFace&) = delete;
  FreeTypeFace& operator=(const FreeTypeFace&) = delete;

  FT_Library library() const { return library_; }
  FT_Face face() const { return face_; }

 private:
  FT_Library library_ = nullptr;
  FT_Face face_ = nullptr;
};

}  // namespace kinescope
