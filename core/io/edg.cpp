// SPDX-License-Identifier: GPL-3.0-or-later
// .edg of CGAL: a list of segments by the coordinates of their ends.
#include <fmt/format.h>

#include "core/io/source.h"
#include "core/io/surface.h"
#include "core/io/text_parser.h"

namespace confidel::io {

Input read_edg(const Source& source) {
  Problems problems;
  TextParser parser(source.file, source.text, problems);
  Input input;
  input.file = source.file;
  input.vertex_file = source.file;
  input.dimension = 2;
  parser.need("the number of segments");
  parser.need_fields(1, 1, "number of segments");
  const int count = parser.count(0, "number of segments");
  CornerMerger merger(input);
  std::vector<int> points;
  for (int i = 0; i < count; ++i) {
    parser.need_row("segments", i, count);
    if (!parser.has_fields(4, 4, "a segment row is: x1 y1 x2 y2")) continue;
    InputSegment segment;
    segment.line = parser.line();
    for (std::size_t end = 0; end < 2; ++end) {
      segment.ends[end] = merger.vertex(parser.point(2 * end, 2), segment.line);
    }
    if (segment.ends[0] == segment.ends[1]) {
      points.push_back(segment.line);
    } else {
      input.segments.push_back(segment);
    }
  }
  parser.expect_end(fmt::format("{} segments were announced", count));
  problems.throw_if_any();
  merger.finish();
  if (!points.empty()) {
    input.remarks.push_back(fmt::format("{} segments have equal ends and are read as vertices, the first at line {}",
                                        points.size(), points.front()));
  }
  return input;
}

}  // namespace confidel::io
