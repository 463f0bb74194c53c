// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as files spell them. Independent of the locale.
#pragma once

#include <string_view>

namespace confidel::io {

enum class NumberStatus {
  ok,
  malformed,   ///< not a number in this grammar
  not_finite,  ///< nan, inf and their relatives
  overflow,    ///< beyond the largest double (or integer)
  underflow,   ///< not zero, but its nearest double is
};

/// [+|-] digits [. digits] [e|E|d|D [+|-] digits], a digit on at least one side of the point: the nearest double.
/// A negative zero becomes zero: they are the same point.
NumberStatus parse_real(std::string_view text, double& value);

/// [+|-] digits, always decimal: 010 is ten.
NumberStatus parse_integer(std::string_view text, int& value);

}  // namespace confidel::io
