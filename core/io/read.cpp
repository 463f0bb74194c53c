// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/read.h"

#include <fmt/format.h>

#include <string_view>

#include "core/io/source.h"

namespace confidel {

namespace {

struct Format {
  std::string_view suffix;
  Input (*read)(const io::Source&);
};

constexpr Format formats[] = {{".poly", io::read_poly}, {".smesh", io::read_smesh}, {".off", io::read_off},
                              {".obj", io::read_obj},   {".edg", io::read_edg},     {".stl", io::read_stl},
                              {".ply", io::read_ply},   {".mesh", io::read_medit}};

// Null if the suffix names no format.
const Format* format_of(const std::string& name) {
  const std::string suffix = io::suffix(name);
  for (const Format& format : formats)
    if (format.suffix == suffix) return &format;
  return nullptr;
}

[[noreturn]] void refuse(const std::string& name) {
  std::string known;
  for (const Format& format : formats) known += fmt::format("{}{}", known.empty() ? "" : ", ", format.suffix);
  throw InputError({{"E-FORMAT",
                     {name, 0, 0},
                     fmt::format("the suffix '{}' names no format that can be read: use one of {}", io::suffix(name), known)}});
}

}  // namespace

Input read_input(const std::string& path) {
  const Format* format = format_of(path);
  const io::Source source = io::load(path);  // A file that is not there at all is the more useful message.
  if (format == nullptr) refuse(path);
  return format->read(source);
}

Input read_input_text(const std::string& name, const std::string& text) {
  const Format* format = format_of(name);
  if (format == nullptr) refuse(name);
  return format->read({name, text});
}

}  // namespace confidel
