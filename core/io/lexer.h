// SPDX-License-Identifier: GPL-3.0-or-later
// A text as records: the fields of a line, each with its place. Blank lines and comments vanish here.
#pragma once

#include <span>
#include <string_view>
#include <vector>

namespace confidel::io {

struct Field {
  std::string_view text;
  int line = 0;
  int column = 0;
};

struct Dialect {
  bool comma_separates = true;
  /// '#' starts a comment anywhere, except that records with such a first field carry names, which may contain it.
  std::span<const std::string_view> name_records = {};
  /// A field that is a backslash at the end of a line joins it with the next.
  bool continuation = false;
};

class Lexer {
 public:
  /// The text must outlive the lexer. Lines end with LF, CRLF or CR; a UTF-8 byte order mark is skipped.
  Lexer(std::string_view text, Dialect dialect, int first_line = 1);

  /// Goes to the next line that has fields; false at the end of the text.
  bool next();
  const std::vector<Field>& fields() const { return fields_; }

  /// Just behind the last character of the text.
  struct End {
    int line;
    int column;
  };
  End end_of_text() const;

 private:
  /// Splits the line at position_, and moves there; true if the next line belongs to the same record.
  bool split_line();
  bool carries_names() const;

  std::string_view text_;
  Dialect dialect_;
  std::size_t position_ = 0;
  int first_line_;
  int line_;
  std::vector<Field> fields_;
};

}  // namespace confidel::io
