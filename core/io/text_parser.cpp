// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/text_parser.h"

#include <fmt/format.h>

#include <limits>

#include "core/io/number.h"

namespace confidel::io {

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  if (text.size() > longest) result += "...";
  return result + "'";
}

TextParser::TextParser(std::string file, std::string_view text, Problems& problems, Dialect dialect, int first_line)
    : file_(std::move(file)), problems_(&problems), lexer_(text, dialect, first_line) {}

Place TextParser::place(std::size_t field) const {
  const std::vector<Field>& fields = lexer_.fields();
  if (field < fields.size()) return {file_, fields[field].line, fields[field].column};
  const Field& last = fields.back();
  return {file_, last.line, last.column + static_cast<int>(last.text.size())};
}

Place TextParser::end_of_text() const {
  const Lexer::End end = lexer_.end_of_text();
  return {file_, end.line, end.column};
}

void TextParser::need(const std::string& expected) {
  if (next()) return;
  problems_->stop("E-TRUNCATED", end_of_text(),
                  fmt::format("the file ends where {} is expected: restore the rest, or correct the counts", expected));
}

void TextParser::need_row(const char* section, int done, int total) {
  if (next()) return;
  problems_->stop(
      "E-TRUNCATED", end_of_text(),
      fmt::format("the file ends after {} of {} {}: restore the rest, or correct the count", done, total, section));
}

void TextParser::expect_end(const std::string& why) {
  if (!next()) return;
  problems_->stop("E-TRAILING", place(0),
                  fmt::format("{} after the end, {}: remove it, or correct the counts", quoted(text(0)), why));
}

bool TextParser::has_fields(std::size_t least, std::size_t most, std::string_view layout) {
  if (size() >= least && size() <= most) return true;
  const std::string wanted = least == most       ? fmt::format("{}", least)
                             : most == unlimited ? fmt::format("at least {}", least)
                                                 : fmt::format("{} to {}", least, most);
  problems_->add("E-FIELDS", place(size() < least ? size() : most),
                 fmt::format("{} field{} where {} {} expected: {}", size(), size() == 1 ? "" : "s", wanted,
                             wanted == "1" ? "is" : "are", layout));
  return false;
}

void TextParser::need_fields(std::size_t least, std::size_t most, std::string_view layout) {
  if (!has_fields(least, most, layout)) problems_->throw_if_any();
}

double TextParser::real(std::size_t field, const char* name) {
  double value = 0;
  const NumberStatus status = parse_real(text(field), value);
  if (status == NumberStatus::ok) return value;
  std::string reason;
  switch (status) {
    case NumberStatus::not_finite:
      reason = "is not finite: every number must be a point of the real line";
      break;
    case NumberStatus::overflow:
      reason = "is beyond the largest double: scale the input";
      break;
    case NumberStatus::underflow:
      reason = "is not zero but rounds to zero as a double: write 0, or scale the input";
      break;
    default:
      reason = "is not a decimal number";
  }
  problems_->add("E-NUMBER", place(field), fmt::format("{} {} {}", name, quoted(text(field)), reason));
  return 0;
}

std::array<double, 3> TextParser::point(std::size_t field, int dimension) {
  std::array<double, 3> result{real(field, "coordinate x"), real(field + 1, "coordinate y"), 0};
  if (dimension == 3) result[2] = real(field + 2, "coordinate z");
  return result;
}

int TextParser::integer(std::size_t field, const char* name) {
  int value = 0;
  const NumberStatus status = parse_integer(text(field), value);
  if (status == NumberStatus::ok) return value;
  problems_->add(
      "E-NUMBER", place(field),
      fmt::format("{} {} {}", name, quoted(text(field)),
                  status == NumberStatus::overflow ? "does not fit in 32 bits" : "is not a decimal integer"));
  return 0;
}

int TextParser::count(std::size_t field, const char* name) {
  int value = 0;
  const NumberStatus status = parse_integer(text(field), value);
  if (status == NumberStatus::overflow || (status == NumberStatus::ok && value < 0)) {
    problems_->stop(
        "E-COUNT", place(field),
        fmt::format("{} {} is not between 0 and {}", name, quoted(text(field)), std::numeric_limits<int>::max()));
  }
  if (status == NumberStatus::ok) return value;
  problems_->stop("E-NUMBER", place(field), fmt::format("{} {} is not a decimal integer", name, quoted(text(field))));
}

int TextParser::choice(std::size_t field, const char* name, int least, int most) {
  int value = 0;
  const NumberStatus status = parse_integer(text(field), value);
  if (status == NumberStatus::malformed) {
    problems_->stop("E-NUMBER", place(field), fmt::format("{} {} is not a decimal integer", name, quoted(text(field))));
  }
  if (status == NumberStatus::ok && value >= least && value <= most) return value;
  problems_->stop("E-VALUE", place(field),
                  least == most
                      ? fmt::format("{} must be {}, not {}", name, least, quoted(text(field)))
                      : fmt::format("{} must be from {} to {}, not {}", name, least, most, quoted(text(field))));
}

long long TextParser::row_index(std::size_t field, const char* row, long long expected) {
  int value = 0;
  const NumberStatus status = parse_integer(text(field), value);
  if (status == NumberStatus::ok && value == expected) return expected + 1;
  if (status == NumberStatus::ok) {
    problems_->add("E-INDEX", place(field),
                   fmt::format("{} {} where {} is next: rows are numbered one by one from the first vertex's number",
                               row, quoted(text(field)), expected));
    // Go on from here, so that one missing row is one problem.
    return static_cast<long long>(value) + 1;
  }
  problems_->add("E-NUMBER", place(field), fmt::format("{} {} is not a decimal integer", row, quoted(text(field))));
  return expected + 1;
}

int TextParser::vertex(std::size_t field, int first_index, std::size_t vertex_count) {
  int value = 0;
  const NumberStatus status = parse_integer(text(field), value);
  if (status == NumberStatus::malformed) {
    problems_->add("E-NUMBER", place(field), fmt::format("vertex {} is not a decimal integer", quoted(text(field))));
    return 0;
  }
  const long long index = static_cast<long long>(value) - first_index;
  if (status == NumberStatus::ok && index >= 0 && index < static_cast<long long>(vertex_count)) {
    return static_cast<int>(index);
  }
  problems_->add("E-INDEX", place(field),
                 vertex_count == 0
                     ? fmt::format("vertex {} does not exist: there are none", quoted(text(field)))
                     : fmt::format("vertex {} does not exist: they are numbered from {} to {}", quoted(text(field)),
                                   first_index, first_index + static_cast<long long>(vertex_count) - 1));
  return 0;
}

}  // namespace confidel::io
