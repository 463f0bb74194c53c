// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/lexer.h"

#include <boost/test/unit_test.hpp>
#include <string>

using namespace confidel::io;

namespace {

/// All records as "line:column=text ..." separated by '|'.
std::string dump(std::string_view text, Dialect dialect = {}) {
  Lexer lexer(text, dialect);
  std::string result;
  while (lexer.next()) {
    if (!result.empty()) result += "|";
    for (const Field& field : lexer.fields()) {
      if (&field != &lexer.fields().front()) result += " ";
      result += std::to_string(field.line) + ":" + std::to_string(field.column) + "=" + std::string(field.text);
    }
  }
  return result;
}

}  // namespace

BOOST_AUTO_TEST_SUITE(io_lexer)

BOOST_AUTO_TEST_CASE(records_and_places) {
  BOOST_TEST(dump("") == "");
  BOOST_TEST(dump("\n\n# only\n   \t ,\n") == "");
  BOOST_TEST(dump("a b\n c,d\t e") == "1:1=a 1:3=b|2:2=c 2:4=d 2:7=e");
  BOOST_TEST(dump("1#2\n  # 3\n4 #5 6\n") == "1:1=1|3:1=4");
  BOOST_TEST(dump("a\r\nb\rc\n\rd") == "1:1=a|2:1=b|3:1=c|5:1=d");
  BOOST_TEST(dump("\xEF\xBB\xBFOFF") == "1:1=OFF");
}

BOOST_AUTO_TEST_CASE(dialects) {
  BOOST_TEST(dump("1,2 3", {.comma_separates = false}) == "1:1=1,2 1:5=3");
  static constexpr std::string_view names[] = {"g"};
  const Dialect obj{.comma_separates = false, .name_records = names, .continuation = true};
  BOOST_TEST(dump("g a#1 #2\nf 1#2", obj) == "1:1=g 1:3=a#1|2:1=f 2:3=1");
  BOOST_TEST(dump("f 1 2 \\\n 3\\\r\n4\nf", obj) == "1:1=f 1:3=1 1:5=2 2:2=3 3:1=4|4:1=f");
  BOOST_TEST(dump("f 1 \\", obj) == "1:1=f 1:3=1");
  BOOST_TEST(dump("\\\n\\\nf 1 # \\\n2", obj) == "3:1=f 3:3=1|4:1=2");
  BOOST_TEST(dump("f 1 \\\n2") == "1:1=f 1:3=1 1:5=\\|2:1=2");
}

BOOST_AUTO_TEST_CASE(end_of_text) {
  const struct {
    const char* text;
    int line, column;
  } table[] = {{"", 1, 1},       {"ab", 1, 3},    {"ab\n", 1, 3},  {"ab\r\n", 1, 3},
               {"ab\n\n", 2, 1}, {"a\nbc", 2, 3}, {"a\rb\r", 2, 2}};
  for (const auto& entry : table) {
    const Lexer::End end = Lexer(entry.text, {}).end_of_text();
    BOOST_TEST(end.line == entry.line, entry.text);
    BOOST_TEST(end.column == entry.column, entry.text);
  }
}

BOOST_AUTO_TEST_SUITE_END()
