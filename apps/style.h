// SPDX-License-Identifier: GPL-3.0-or-later
// Colour on terminals: of errors and verdicts, and nothing that is not said in words too.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

namespace confidel {

enum class Style { plain, error, good, doubtful };

/// --color auto|always|never: auto colours on a terminal, unless NO_COLOR is set (https://no-color.org) or TERM is dumb.
void add_color_option(CLI::App& app);

/// The text in its style if the stream has colour, the text otherwise.
std::string styled(Style style, const std::string& text, std::FILE* stream);

/// A line `s ...`: VERIFIED is good, UNDECIDED doubtful, the rest an error.
std::string styled_verdict(const std::string& line, std::FILE* stream);

}  // namespace confidel
