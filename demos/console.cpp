#include "demos/console.h"

#include <cstdio>

#include "raster/base/output_file.h"

namespace kinescope {
namespace {

void print_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  text = "kinescope: " + text + "\n";
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace

void print_result(const std::string& text) {
  OutputFile out("-");
  out.write(text);
  out.commit();
}

void print_fault(const std::string& text) { print_line(text); }

void print_warnings(const Warnings& warnings, bool quiet) {
  if (quiet) return;
  for (const std::string& warning : warnings) print_line("warning: " + warning);
}

void print_remark(const std::string& text, bool quiet) {
  if (!quiet) print_line(text);
}

}  // namespace kinescope
