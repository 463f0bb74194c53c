// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/number.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string>

namespace confidel::io {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// True for nan, nan(...), -nan(ind), inf, infinity, 1.#QNAN, 1.#INF: values, but no points.
bool names_no_finite_number(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return std::tolower(c); });
  std::string_view rest = lower;
  if (!rest.empty() && (rest.front() == '+' || rest.front() == '-')) rest.remove_prefix(1);
  return rest.starts_with("nan") || rest.starts_with("inf") || rest.starts_with("1.#");
}

struct Spelling {
  bool well_formed = false;
  bool nonzero = false;
  std::size_t exponent_mark = std::string_view::npos;
};

Spelling examine(std::string_view text) {
  Spelling result;
  std::size_t i = 0;
  bool digits = false;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  const auto skip_digits = [&] {
    const std::size_t begin = i;
    for (; i < text.size() && is_digit(text[i]); ++i) result.nonzero = result.nonzero || text[i] != '0';
    return i > begin;
  };
  digits = skip_digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    digits = skip_digits() || digits;
  }
  if (!digits) return result;
  if (i < text.size() && std::string_view("eEdD").find(text[i]) != std::string_view::npos) {
    result.exponent_mark = i++;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    const bool mantissa_nonzero = result.nonzero;
    if (!skip_digits()) return result;
    result.nonzero = mantissa_nonzero;
  }
  result.well_formed = i == text.size();
  return result;
}

/// For a number that no double can hold: is it too large rather than too small?
bool is_large(std::string_view text, std::size_t exponent_mark) {
  const std::string_view mantissa = text.substr(0, exponent_mark);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_of("123456789");
  const double leading = first < point ? static_cast<double>(point - first) : -static_cast<double>(first - point);
  double exponent = 0;
  bool negative = false;
  if (exponent_mark != std::string_view::npos) {
    for (const char c : text.substr(exponent_mark + 1)) {
      if (c == '-') negative = true;
      if (is_digit(c)) exponent = std::min(exponent * 10 + (c - '0'), 1e18);
    }
  }
  return (negative ? -exponent : exponent) + leading > 0;
}

}  // namespace

NumberStatus parse_real(std::string_view text, double& value) {
  const Spelling spelling = examine(text);
  if (!spelling.well_formed) return names_no_finite_number(text) ? NumberStatus::not_finite : NumberStatus::malformed;
  if (!spelling.nonzero) {
    value = 0;
    return NumberStatus::ok;
  }
  if (text.front() == '+') {
    double unsigned_value = 0;
    const NumberStatus status = parse_real(text.substr(1), unsigned_value);
    if (status == NumberStatus::ok) value = unsigned_value;
    return status;
  }
  std::string fortran;
  std::string_view plain = text;
  if (spelling.exponent_mark != std::string_view::npos && std::tolower(text[spelling.exponent_mark]) == 'd') {
    fortran = text;
    fortran[spelling.exponent_mark] = 'e';
    plain = fortran;
  }
  double result = 0;
  const auto [end, error] = std::from_chars(plain.data(), plain.data() + plain.size(), result);
  if (error == std::errc::result_out_of_range || result == 0) {
    return is_large(text, spelling.exponent_mark) ? NumberStatus::overflow : NumberStatus::underflow;
  }
  if (error != std::errc() || end != plain.data() + plain.size()) return NumberStatus::malformed;
  value = result;
  return NumberStatus::ok;
}

NumberStatus parse_integer(std::string_view text, int& value) {
  std::string_view digits = text;
  if (!digits.empty() && (digits.front() == '+' || digits.front() == '-')) digits.remove_prefix(1);
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), is_digit)) return NumberStatus::malformed;
  if (text.front() == '+') text.remove_prefix(1);
  int result = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result, 10);
  if (error == std::errc::result_out_of_range) return NumberStatus::overflow;
  if (error != std::errc() || end != text.data() + text.size()) return NumberStatus::malformed;
  value = result;
  return NumberStatus::ok;
}

}  // namespace confidel::io
