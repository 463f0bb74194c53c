// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of this folder that are compiled into the program (apps/embed.cmake): what pictures carry with them.
#pragma once

#include <string_view>

namespace confidel {

extern const std::string_view embedded_svg_css;
extern const std::string_view embedded_svg_js;
extern const std::string_view embedded_viewer_html;
extern const std::string_view embedded_viewer_css;
extern const std::string_view embedded_viewer_data_js;
extern const std::string_view embedded_viewer_gl_js;
extern const std::string_view embedded_viewer_js;
extern const std::string_view embedded_viewer_panel_js;

}  // namespace confidel
