// SPDX-License-Identifier: GPL-3.0-or-later
#include "proofs/certificate/reader.h"

#include <fmt/format.h>
#include <mpfr.h>
#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>

#include "core/complex/complex.h"
#include "core/io/problems.h"
#include "core/io/source.h"
#include "core/io/text_parser.h"

namespace confidel {
namespace {

constexpr std::size_t longest_line = std::size_t{1} << 20;
constexpr std::size_t most_digits = 65536;
constexpr std::size_t most_text = std::size_t{1} << 33;
constexpr int greatest_window = 27;  // 128 MiB

bool is_index(std::string_view text) {
  if (text.empty() || text.size() > 10 || (text.size() > 1 && text[0] == '0')) return false;
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool is_integer(std::string_view text) {
  if (!text.empty() && text[0] == '-') {
    text.remove_prefix(1);
    if (text == "0") return false;
  }
  if (text.empty() || text.size() > most_digits || (text.size() > 1 && text[0] == '0')) return false;
  return std::all_of(text.begin(), text.end(), [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

class Parser {
 public:
  Parser(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  Certificate read() {
    Certificate result;
    result.file = file_;
    need("the line confidel-certificate 1", 2, "confidel-certificate");
    if (fields_[1] != "1") stop("E-SYNTAX", 1, fmt::format("version {}; this program reads version 1", io::quoted(fields_[1])));
    const std::size_t begin = position_;
    read_complex(result);
    result.complex_sha256 = sha256(std::string(text_.substr(begin, position_ - begin)));
    read_lines("claims", result.claims);
    const int notes = announced("notes");
    for (int i = 0; i < notes; ++i) {
      need("a note", 3, "n", true);
      const std::size_t key = fields_[1].size();
      result.notes.emplace_back(std::string(fields_[1]), std::string(line_.substr(3 + key)));
    }
    read_lines("parameters", result.parameters);
    read_points(result);
    read_cells(result);
    read_rows(result);
    const int hanging = announced("hanging");
    for (int i = 0; i < hanging; ++i) {
      need("a subsegment `h SEGMENT a b`", 4, "h");
      result.hanging.push_back({index(1, result.segments.size(), "segment"), index(2, result.points.size(), "point"),
                                index(3, result.points.size(), "point")});
    }
    read_lines("evidence", result.evidence);
    const std::size_t before_end = position_;
    need("the line `end` with the counts", 9, "end");
    const std::size_t counts[] = {static_cast<std::size_t>(result.vertex_count), result.segments.size(), result.facets.size(),
                                  result.points.size() - result.vertex_count, result.cells.size(), result.rows.size(), result.hanging.size()};
    for (std::size_t i = 0; i < std::size(counts); ++i)
      if (fields_[i + 1] != std::to_string(counts[i]))
        stop("E-COUNT", i + 1, fmt::format("{} is said here, but there are {}", io::quoted(fields_[i + 1]), counts[i]));
    result.digest_matches = fields_[8] == sha256(std::string(text_.substr(0, before_end)));
    if (position_ != text_.size()) {
      ++line_number_;
      problems_.stop("E-TRAILING", {file_, line_number_, 1}, "text after the end of the certificate");
    }
    return result;
  }

 private:
  [[noreturn]] void stop(const char* code, std::size_t field, const std::string& message) {
    const int column = field < fields_.size() ? static_cast<int>(fields_[field].data() - line_.data()) + 1 : static_cast<int>(line_.size()) + 1;
    problems_.stop(code, {file_, line_number_, column}, message);
  }

  /// Goes to the next line and splits it into fields; they keep pointing into the text.
  void next(const std::string& expected) {
    ++line_number_;
    const std::size_t end = text_.find('\n', position_);
    fields_.clear();
    if (end == std::string_view::npos) {
      line_ = text_.substr(position_);
      problems_.stop("E-TRUNCATED", {file_, line_number_, static_cast<int>(line_.size()) + 1}, "the text ends before " + expected);
    }
    line_ = text_.substr(position_, end - position_);
    position_ = end + 1;
    if (line_.size() > longest_line) problems_.stop("E-SYNTAX", {file_, line_number_, 1}, "a line of more than 1048576 bytes");
    std::size_t at = 0;
    for (;;) {
      const std::size_t space = std::min(line_.find(' ', at), line_.size());
      if (space == at) problems_.stop("E-SYNTAX", {file_, line_number_, static_cast<int>(at) + 1}, "an empty field: fields are separated by one space, lines are not empty");
      fields_.push_back(line_.substr(at, space - at));
      if (space == line_.size()) break;
      at = space + 1;
    }
  }

  /// The next line has this word first and this number of fields (or more, if so said).
  void need(const std::string& expected, std::size_t count, std::string_view word, bool or_more = false) {
    next(expected);
    if (!word.empty() && fields_[0] != word) stop("E-SYNTAX", 0, fmt::format("{}, but {} was expected", io::quoted(fields_[0]), expected));
    need_count(expected, count, or_more ? static_cast<std::size_t>(-1) : count);
  }

  void need_count(const std::string& expected, std::size_t least, std::size_t most) {
    if (fields_.size() < least || fields_.size() > most)
      stop("E-SYNTAX", std::min(fields_.size(), most), fmt::format("{} fields, but {} has {}", fields_.size(), expected, least));
  }

  int announced(const char* section) {
    need(fmt::format("the line `{} COUNT`", section), 2, section);
    return number(1, "count");
  }

  int number(std::size_t field, const char* what) {
    const std::string_view text = fields_[field];
    if (!is_index(text)) stop("E-SYNTAX", field, fmt::format("{} is no {}", io::quoted(text), what));
    const std::uint64_t value = std::stoull(std::string(text));
    if (value > INT32_MAX) stop("E-RANGE", field, fmt::format("{} {} is too large", what, text));
    return static_cast<int>(value);
  }

  int index(std::size_t field, std::size_t count, const char* what) {
    const int value = number(field, what);
    if (static_cast<std::size_t>(value) >= count) stop("E-RANGE", field, fmt::format("there is no {} {}; there are {}", what, value, count));
    return value;
  }

  mpz_class integer(std::size_t field) {
    const std::string_view text = fields_[field];
    if (!is_integer(text)) stop("E-SYNTAX", field, io::quoted(text) + " is no hexadecimal integer");
    return mpz_class(std::string(text), 16);
  }

  HomogeneousPoint point(std::size_t field, int dimension) {
    HomogeneousPoint result;
    for (int axis = 0; axis < dimension; ++axis) result.numerator[axis] = integer(field + axis);
    result.denominator = integer(field + dimension);
    if (result.denominator <= 0) stop("E-VALUE", field + dimension, "the denominator W of a point is not positive");
    for (int axis = 0; axis < dimension; ++axis)
      if (!std::isfinite(result.approximate(axis))) stop("E-VALUE", field + axis, "the coordinate is beyond the range of doubles, and cannot be drawn");
    return result;
  }

  std::vector<std::array<int, 2>> pairs(const char* section, int vertices) {
    const int count = announced(section);
    std::vector<std::array<int, 2>> result;
    for (int i = 0; i < count; ++i) {
      next("an edge of two vertices");
      need_count("an edge", 2, 2);
      result.push_back({index(0, vertices, "vertex"), index(1, vertices, "vertex")});
    }
    return result;
  }

  void read_lines(const char* section, std::vector<CertificateLine>& lines) {
    const int count = announced(section);
    for (int i = 0; i < count; ++i) {
      next(fmt::format("line {} of {} of the section {}", i + 1, count, section));
      lines.push_back({line_number_, std::string(line_)});
    }
  }

  void read_complex(Certificate& result) {
    need("the line `plc 1`", 2, "plc");
    if (fields_[1] != "1") stop("E-SYNTAX", 1, fmt::format("complex of version {}; this program reads version 1", io::quoted(fields_[1])));
    result.dimension = announced("dim");
    if (result.dimension != 2 && result.dimension != 3) stop("E-VALUE", 1, "the dimension is neither 2 nor 3");
    const int vertices = announced("vertices");
    for (int i = 0; i < vertices; ++i) {
      need("a vertex", result.dimension + 2, "v");
      result.points.push_back(point(1, result.dimension));
      result.point_lines.push_back(line_number_);
    }
    result.vertex_count = vertices;
    result.kinds.assign(vertices, PointKind::vertex);
    result.carriers.assign(vertices, -1);
    const int segments = announced("segments");
    for (int i = 0; i < segments; ++i) {
      need("a segment `s a b`", 3, "s");
      result.segments.push_back({index(1, vertices, "vertex"), index(2, vertices, "vertex")});
    }
    const int facets = announced("facets");
    for (int i = 0; i < facets; ++i) {
      need("a facet `f i j k`", 4, "f");
      CertificateFacet facet;
      for (int k = 0; k < 3; ++k) facet.frame[k] = index(k + 1, vertices, "vertex");
      facet.boundary = pairs("b", vertices);
      facet.constraints = pairs("c", vertices);
      const int isolated = announced("p");
      for (int k = 0; k < isolated; ++k) {
        next("an isolated vertex");
        need_count("an isolated vertex", 1, 1);
        facet.isolated.push_back(index(0, vertices, "vertex"));
      }
      result.facets.push_back(std::move(facet));
    }
    need("the line `end` of the complex", 1, "end");
  }

  void read_points(Certificate& result) {
    const int count = announced("points");
    for (int i = 0; i < count; ++i) {
      need("a point `q KIND CARRIER ...`", result.dimension + 4, "q");
      PointKind kind = PointKind::vertex;
      for (PointKind candidate : {PointKind::projection, PointKind::edge, PointKind::offset, PointKind::arc, PointKind::interior})
        if (fields_[1] == name_of(candidate)) kind = candidate;
      if (kind == PointKind::vertex) stop("E-SYNTAX", 1, io::quoted(fields_[1]) + " is no kind of points");
      const bool on_segment = kind == PointKind::projection || kind == PointKind::edge;
      result.carriers.push_back(on_segment ? index(2, result.segments.size(), "segment") : index(2, result.facets.size(), "facet"));
      result.kinds.push_back(kind);
      result.points.push_back(point(3, result.dimension));
      result.point_lines.push_back(line_number_);
    }
  }

  void read_cells(Certificate& result) {
    const int count = announced("cells");
    for (int i = 0; i < count; ++i) {
      next("a cell `t FACET a b c KIND`");
      if (fields_[0] != "t") stop("E-SYNTAX", 0, fmt::format("{}, but cell {} of {} was expected", io::quoted(fields_[0]), i + 1, count));
      need_count("a cell `t FACET a b c KIND [BOX] [OFFSET]`", 6, 8);
      CertificateCell cell;
      cell.line = line_number_;
      cell.facet = index(1, result.facets.size(), "facet");
      for (int k = 0; k < 3; ++k) cell.corners[k] = index(k + 2, result.points.size(), "point");
      const std::size_t kind = fields_[5].size() == 1 ? std::string_view("TSRC").find(fields_[5][0]) : std::string_view::npos;
      if (kind == std::string_view::npos) stop("E-SYNTAX", 5, io::quoted(fields_[5]) + " is no kind of cells: T, S, R or C");
      cell.kind = static_cast<CellKind>(kind);
      std::size_t field = 6;
      if (cell.kind == CellKind::R) {
        need_count("a cell of a box", 7, 8);
        cell.box = number(field++, "box");
      }
      if (field < fields_.size()) cell.offset = rational(field++);
      if (field != fields_.size()) stop("E-SYNTAX", field, "a superfluous field");
      result.cells.push_back(std::move(cell));
    }
  }

  mpq_class rational(std::size_t field) {
    const std::string_view text = fields_[field];
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos || !is_integer(text.substr(0, slash)) || !is_integer(text.substr(slash + 1)))
      stop("E-SYNTAX", field, io::quoted(text) + " is no rational NUM/DEN");
    mpq_class result(mpz_class(std::string(text.substr(0, slash)), 16), mpz_class(std::string(text.substr(slash + 1)), 16));
    if (result.get_den() <= 0) stop("E-VALUE", field, "the denominator is not positive");
    result.canonicalize();
    return result;
  }

  void read_rows(Certificate& result) {
    const int count = announced("rows");
    for (int i = 0; i < count; ++i) {
      need("a row `r SEGMENT M [FACET SIDE]`", 3, "r", true);
      if (fields_.size() != 3) need_count("a protector's row", 5, 5);
      CertificateRow row;
      row.segment = index(1, result.segments.size(), "segment");
      const int points = number(2, "count");
      if (fields_.size() == 5) {
        row.facet = index(3, result.facets.size(), "facet");
        if (fields_[4] != "+" && fields_[4] != "-") stop("E-SYNTAX", 4, "a side is + or -");
        row.left = fields_[4] == "+";
      }
      for (int k = 0; k < points; ++k) {
        next("a point of a row");
        need_count("a point of a row", 1, 1);
        row.points.push_back(index(0, result.points.size(), "point"));
      }
      result.rows.push_back(std::move(row));
    }
  }

  const std::string& file_;
  std::string_view text_, line_;
  std::vector<std::string_view> fields_;
  std::size_t position_ = 0;
  int line_number_ = 0;
  io::Problems problems_;
};

std::string decompressed(const io::Source& source) {
  io::Problems problems;
  const auto fail = [&](const std::string& message) { problems.stop("E-ZSTD", {source.file, 0, 0}, message); };
  struct Free {
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
  };
  const std::unique_ptr<ZSTD_DCtx, Free> context(ZSTD_createDCtx());
  ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, greatest_window);
  std::string text;
  std::vector<char> buffer(ZSTD_DStreamOutSize());
  ZSTD_inBuffer input{source.text.data(), source.text.size(), 0};
  std::size_t line_begin = 0;
  for (;;) {
    ZSTD_outBuffer output{buffer.data(), buffer.size(), 0};
    const std::size_t rest = ZSTD_decompressStream(context.get(), &output, &input);
    if (ZSTD_isError(rest)) fail(fmt::format("the zstd frame is damaged: {}", ZSTD_getErrorName(rest)));
    text.append(buffer.data(), output.pos);
    if (text.size() > most_text) fail("more than 8 GiB of text: too large for this program");
    if (const void* line_feed = memrchr(buffer.data(), '\n', output.pos); line_feed != nullptr)
      line_begin = text.size() - output.pos + static_cast<std::size_t>(static_cast<const char*>(line_feed) - buffer.data()) + 1;
    if (text.size() - line_begin > longest_line + 1) fail("the zstd frame holds a line of more than 1048576 bytes");
    // A frame whose text does not begin as a certificate does is not worth unpacking: it may be a bomb.
    if (text.size() >= 8 && text.compare(0, 8, "confidel") != 0) fail("the zstd frame does not hold a certificate");
    if (rest == 0) break;
    if (output.pos == 0 && input.pos == input.size) fail("the zstd frame ends early");
  }
  if (input.pos != input.size) fail("there are bytes after the zstd frame");
  return text;
}

}  // namespace

double HomogeneousPoint::approximate(int axis) const {
  // mpq_get_d truncates; mpfr rounds, and needs no gcd.
  mpfr_t value;
  mpfr_init2(value, 128);
  mpfr_set_z(value, numerator[axis].get_mpz_t(), MPFR_RNDN);
  mpfr_t divisor;
  mpfr_init2(divisor, 128);
  mpfr_set_z(divisor, denominator.get_mpz_t(), MPFR_RNDN);
  mpfr_div(value, value, divisor, MPFR_RNDN);
  const double result = mpfr_get_d(value, MPFR_RNDN);
  mpfr_clear(value);
  mpfr_clear(divisor);
  return result;
}

mpq_class HomogeneousPoint::coordinate(int axis) const {
  mpq_class result(numerator[axis], denominator);
  result.canonicalize();
  return result;
}

std::string Certificate::note(const std::string& key) const {
  for (const auto& [name, text] : notes)
    if (name == key) return text;
  return "";
}

Certificate parse_certificate(const std::string& file, const std::string& text) { return Parser(file, text).read(); }

Certificate read_certificate(const std::string& path) {
  io::Source source = io::load(path);
  if (source.text.compare(0, 4, "\x28\xb5\x2f\xfd") == 0) source.text = decompressed(source);
  return parse_certificate(source.file, source.text);
}

}  // namespace confidel
