// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/lexer.h"

#include <algorithm>

namespace confidel::io {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

Lexer::Lexer(std::string_view text, Dialect dialect, int first_line)
    : text_(text), dialect_(dialect), first_line_(first_line), line_(first_line - 1) {
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

bool Lexer::next() {
  fields_.clear();
  while (position_ < text_.size()) {
    const bool goes_on = split_line();
    if (!fields_.empty() && !goes_on) return true;
  }
  return !fields_.empty();
}

bool Lexer::carries_names() const {
  if (fields_.empty()) return false;
  return std::find(dialect_.name_records.begin(), dialect_.name_records.end(), fields_.front().text) !=
         dialect_.name_records.end();
}

bool Lexer::split_line() {
  ++line_;
  std::size_t end = text_.find_first_of("\r\n", position_);
  if (end == std::string_view::npos) end = text_.size();
  const std::string_view line = text_.substr(position_, end - position_);
  position_ = end;
  if (position_ < text_.size()) position_ += text_.substr(position_, 2) == "\r\n" ? 2 : 1;

  const auto separates = [&](char c) { return c == ' ' || c == '\t' || (c == ',' && dialect_.comma_separates); };
  std::size_t i = 0;
  while (i < line.size()) {
    if (separates(line[i])) {
      ++i;
      continue;
    }
    if (line[i] == '#') return false;
    const std::size_t begin = i;
    while (i < line.size() && !separates(line[i]) && !(line[i] == '#' && !carries_names())) ++i;
    fields_.push_back({line.substr(begin, i - begin), line_, static_cast<int>(begin) + 1});
  }
  if (!dialect_.continuation || line.empty() || line.back() != '\\' || fields_.empty()) return false;
  fields_.back().text.remove_suffix(1);
  if (fields_.back().text.empty()) fields_.pop_back();
  return true;
}

Lexer::End Lexer::end_of_text() const {
  End end{first_line_, 1};
  std::size_t begin = 0;
  std::size_t i = 0;
  while (i < text_.size()) {
    const bool breaks = text_[i] == '\n' || text_[i] == '\r';
    const std::size_t length = text_.substr(i, 2) == "\r\n" ? 2 : 1;
    if (breaks && i + length == text_.size()) break;
    i += length;
    if (breaks) {
      ++end.line;
      begin = i;
    }
  }
  end.column = static_cast<int>(i - begin) + 1;
  return end;
}

}  // namespace confidel::io
