// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/number.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <string>

using namespace confidel::io;

BOOST_TEST_DONT_PRINT_LOG_VALUE(NumberStatus)

BOOST_AUTO_TEST_SUITE(io_number)

BOOST_AUTO_TEST_CASE(nearest_doubles) {
  const struct {
    const char* text;
    double value;
  } table[] = {{"0", 0},
               {"1", 1},
               {"+1", 1},
               {"-1", -1},
               {"010", 10},
               {"1.", 1},
               {".5", 0.5},
               {"-.5e1", -5},
               {"+.5E+1", 5},
               {"1e-3", 1e-3},
               {"1D3", 1000},
               {"-1.5d-3", -1.5e-3},
               {"+1D+03", 1000},
               {"0.1", 0.1},
               {"2449266.260000000009", 2449266.260000000009},
               {"-.000000E+00", 0},
               {"0e999999999999999999999", 0},
               {"0.48254759356271648", 0.48254759356271648},
               {"9007199254740993", 9007199254740992.0},
               {"9007199254740993.00000000000000000000000000000000001", 9007199254740994.0},
               {"1.7976931348623157e308", std::numeric_limits<double>::max()},
               {"1e-310", 1e-310},
               {"5e-324", 5e-324},
               {"2.5e-324", 5e-324}};
  for (const auto& entry : table) {
    double value = -7;
    BOOST_CHECK_MESSAGE(parse_real(entry.text, value) == NumberStatus::ok, entry.text);
    BOOST_CHECK_MESSAGE(value == entry.value, entry.text);
    BOOST_CHECK_MESSAGE(!std::signbit(value) || value < 0, entry.text << " is a negative zero");
  }
  double value = 0;
  BOOST_CHECK(parse_real(std::string(100000, '0') + "1" + std::string(200, '0') + "." + std::string(100000, '0'),
                         value) == NumberStatus::ok);
  BOOST_CHECK_EQUAL(value, 1e200);
}

BOOST_AUTO_TEST_CASE(no_numbers) {
  for (const char* text : {"",    "+",   "-",     ".",      "-.",  "e5",   "1e",    "1e+",   "1d",  "++1",
                           "+-1", "--1", "0x10",  "1x",     "1,5", "1..2", "1.2.3", "1e5.0", "1 2", "1e5e5",
                           "1f",  "abc", "1'000", "\u00bd", "1_0", "0b1",  "1e--5", "1.0L"}) {
    double value = -7;
    BOOST_CHECK_MESSAGE(parse_real(text, value) == NumberStatus::malformed, text);
    BOOST_CHECK_EQUAL(value, -7);
  }
  for (const char* text : {"nan", "NaN", "-nan", "nan(0x1)", "-nan(ind)", "inf", "-Inf", "+INF", "infinity", "1.#QNAN",
                           "-1.#IND", "1.#INF"}) {
    double value = -7;
    BOOST_CHECK_MESSAGE(parse_real(text, value) == NumberStatus::not_finite, text);
  }
}

BOOST_AUTO_TEST_CASE(out_of_range) {
  for (const std::string& text :
       {std::string("1e400"), std::string("-1e309"), std::string("1.7976931348623159e308"), std::string("+1D400"),
        std::string("1e99999999999999999999"), "1" + std::string(400, '0'), "1" + std::string(400, '0') + "e-5"}) {
    double value = -7;
    BOOST_CHECK_MESSAGE(parse_real(text, value) == NumberStatus::overflow, text);
  }
  for (const std::string& text :
       {std::string("1e-400"), std::string("-2.4e-324"), std::string("+1d-400"), std::string("1e-99999999999999999999"),
        "0." + std::string(400, '0') + "1", "0." + std::string(400, '0') + "1e5"}) {
    double value = -7;
    BOOST_CHECK_MESSAGE(parse_real(text, value) == NumberStatus::underflow, text);
  }
}

BOOST_AUTO_TEST_CASE(integers_are_decimal) {
  const struct {
    const char* text;
    int value;
  } table[] = {{"0", 0},
               {"10", 10},
               {"010", 10},
               {"+3", 3},
               {"-3", -3},
               {"-0", 0},
               {"2147483647", 2147483647},
               {"-2147483648", -2147483647 - 1}};
  for (const auto& entry : table) {
    int value = -7;
    BOOST_CHECK_MESSAGE(parse_integer(entry.text, value) == NumberStatus::ok, entry.text);
    BOOST_CHECK_EQUAL(value, entry.value);
  }
  for (const char* text : {"", "+", "-", "0x10", "1.0", "1e3", "+-1", "--1", "1/2", "abc", " 1"}) {
    int value = -7;
    BOOST_CHECK_MESSAGE(parse_integer(text, value) == NumberStatus::malformed, text);
    BOOST_CHECK_EQUAL(value, -7);
  }
  for (const char* text : {"2147483648", "-2147483649", "99999999999999999999999999"}) {
    int value = -7;
    BOOST_CHECK_MESSAGE(parse_integer(text, value) == NumberStatus::overflow, text);
  }
}

BOOST_AUTO_TEST_SUITE_END()
