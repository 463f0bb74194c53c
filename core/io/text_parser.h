// SPDX-License-Identifier: GPL-3.0-or-later
// Typed access to the fields of records, with messages that say what was expected.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/complex/input.h"
#include "core/io/lexer.h"
#include "core/io/problems.h"

namespace confidel::io {

/// A field for a message: quoted, shortened, control characters replaced.
std::string quoted(std::string_view text);

class TextParser {
 public:
  /// For records without a largest number of fields.
  static constexpr std::size_t unlimited = static_cast<std::size_t>(-1);

  TextParser(std::string file, std::string_view text, Problems& problems, Dialect dialect = {}, int first_line = 1);

  /// Goes to the next record; false at the end of the text.
  bool next() { return lexer_.next(); }
  /// Goes to the next record; stops with E-TRUNCATED if there is none.
  void need(const std::string& expected);
  /// The same, for row done + 1 of a section.
  void need_row(const char* section, int done, int total);
  /// Stops with E-TRAILING if there is another record.
  void expect_end(const std::string& why);

  std::size_t size() const { return lexer_.fields().size(); }
  std::string_view text(std::size_t field) const { return lexer_.fields()[field].text; }
  int line() const { return lexer_.fields().front().line; }
  Place place() const { return {file_, line(), 0}; }
  Place place(std::size_t field) const;
  Place end_of_text() const;
  const std::string& file() const { return file_; }
  Problems& problems() { return *problems_; }

  /// Checks the number of fields; reports E-FIELDS where the first is missing or superfluous.
  bool has_fields(std::size_t least, std::size_t most, std::string_view layout);
  /// The same, but stops: the number of fields of a header decides how the rest is read.
  void need_fields(std::size_t least, std::size_t most, std::string_view layout);

  /// A coordinate or attribute; reports E-NUMBER and yields 0.
  double real(std::size_t field, const char* name);
  /// Coordinates from the given field on; z = 0 if the dimension is 2.
  std::array<double, 3> point(std::size_t field, int dimension);
  /// A marker or the like; reports E-NUMBER and yields 0.
  int integer(std::size_t field, const char* name);
  /// A number of records; stops with E-NUMBER, or with E-COUNT if it is negative or too large to be true.
  int count(std::size_t field, const char* name);
  /// A small number from the header; stops with E-NUMBER, or with E-VALUE if it is outside.
  int choice(std::size_t field, const char* name, int least, int most);
  /// The number at the beginning of a row, which must be the expected one (E-INDEX). Returns the next to expect.
  long long row_index(std::size_t field, const char* row, long long expected);
  /// A vertex by the file's numbering, made 0-based; reports E-INDEX and yields 0.
  int vertex(std::size_t field, int first_index, std::size_t vertex_count);

 private:
  std::string file_;
  Problems* problems_;
  Lexer lexer_;
};

}  // namespace confidel::io
