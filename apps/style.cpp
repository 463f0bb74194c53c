// SPDX-License-Identifier: GPL-3.0-or-later
#include "apps/style.h"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace confidel {
namespace {

std::string when = "auto";

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

bool has_colour(std::FILE* stream) {
  if (when != "auto") return when == "always";
  const char* terminal = std::getenv("TERM");
  return ::isatty(::fileno(stream)) != 0 && !is_set("NO_COLOR") && terminal != nullptr && std::string_view(terminal) != "dumb";
}

}  // namespace

void add_color_option(CLI::App& app) {
  app.add_option("--color", when, "Colour of errors and verdicts: auto (on terminals, unless NO_COLOR is set), always, never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->option_text("auto|always|never");
}

std::string styled(Style style, const std::string& text, std::FILE* stream) {
  if (style == Style::plain || !has_colour(stream)) return text;
  const char* const code = style == Style::error ? "1;31" : style == Style::good ? "1;32" : "1;33";
  return std::string("\x1b[") + code + "m" + text + "\x1b[0m";
}

std::string styled_verdict(const std::string& line, std::FILE* stream) {
  const std::string_view text = line;
  const Style style = text.substr(0, 10) == "s VERIFIED" ? Style::good : text.substr(0, 11) == "s UNDECIDED" ? Style::doubtful : Style::error;
  return styled(style, line, stream);
}

}  // namespace confidel
