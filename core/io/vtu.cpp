// SPDX-License-Identifier: GPL-3.0-or-later
// .vtu of VTK: XML by Boost; numbers as text, or as base64 within the file. Appended and compressed data are not read.
#include <fmt/format.h>
#include <openssl/evp.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <sstream>

#include "core/io/bytes.h"
#include "core/io/mesh.h"
#include "core/io/text_parser.h"

namespace confidel::io {
namespace {

using Tree = boost::property_tree::ptree;

struct Type {
  std::size_t size;
  char kind;  ///< f, i, u
};
const std::map<std::string, Type> types{{"Float32", {4, 'f'}}, {"Float64", {8, 'f'}}, {"Int8", {1, 'i'}},   {"UInt8", {1, 'u'}},  {"Int16", {2, 'i'}},
                                        {"UInt16", {2, 'u'}},  {"Int32", {4, 'i'}},   {"UInt32", {4, 'u'}}, {"Int64", {8, 'i'}}, {"UInt64", {8, 'u'}}};

class VtuReader {
 public:
  explicit VtuReader(const Source& source) : file_(source.file) {
    std::istringstream stream(source.text);
    try {
      boost::property_tree::read_xml(stream, root_);
    } catch (const boost::property_tree::xml_parser_error& error) {
      problems_.stop("E-SYNTAX", {file_, static_cast<int>(error.line()), 0}, "no XML: " + error.message());
    }
  }

  Mesh read() {
    const Tree& file = child(root_, "VTKFile");
    if (attribute(file, "type") != "UnstructuredGrid") fail("E-FORMAT", "the file holds no UnstructuredGrid");
    if (!attribute(file, "compressor").empty()) fail("E-FORMAT", "compressed data are not read: write them uncompressed");
    big_endian_ = attribute(file, "byte_order") == "BigEndian";
    header_size_ = attribute(file, "header_type") == "UInt64" ? 8 : 4;
    const Tree& grid = child(file, "UnstructuredGrid");
    if (grid.count("Piece") != 1) fail("E-FORMAT", "the grid must be one Piece");
    const Tree& piece = child(grid, "Piece");
    Mesh mesh;
    mesh.file = file_;
    read_points(array(child(piece, "Points"), ""), mesh);
    read_cells(child(piece, "Cells"), mesh);
    problems_.throw_if_any();
    return mesh;
  }

 private:
  [[noreturn]] void fail(const char* code, const std::string& message) { problems_.stop(code, {file_, 0, 0}, message); }

  const Tree& child(const Tree& tree, const char* name) {
    const auto found = tree.get_child_optional(name);
    if (!found) fail("E-SYNTAX", fmt::format("there is no element {}", name));
    return *found;
  }
  static std::string attribute(const Tree& tree, const char* name) { return tree.get<std::string>(std::string("<xmlattr>.") + name, ""); }

  /// The DataArray of this name; any if the name is empty.
  const Tree& array(const Tree& tree, const std::string& name) {
    for (const auto& [tag, each] : tree)
      if (tag == "DataArray" && (name.empty() || attribute(each, "Name") == name)) return each;
    fail("E-SYNTAX", fmt::format("there is no DataArray {}", name));
  }

  std::string decoded(const std::string& text) {
    std::string digits, bytes;
    for (const char c : text)
      if (std::isspace(static_cast<unsigned char>(c)) == 0) digits += c;
    if (digits.size() % 4 != 0) fail("E-TRUNCATED", "base64 data end within a group");
    // Group by group: writers that encode the length by itself put padding into the middle.
    for (std::size_t at = 0; at < digits.size(); at += 4) {
      unsigned char group[3];
      if (EVP_DecodeBlock(group, reinterpret_cast<const unsigned char*>(digits.data()) + at, 4) != 3) fail("E-SYNTAX", "this is no base64");
      const std::size_t padding = digits[at + 3] != '=' ? 0 : digits[at + 2] != '=' ? 1 : 2;
      bytes.append(reinterpret_cast<const char*>(group), 3 - padding);
    }
    return bytes;
  }

  template <class Number>
  std::vector<Number> numbers(const Tree& data) {
    const auto type = types.find(attribute(data, "type"));
    if (type == types.end()) fail("E-FORMAT", fmt::format("numbers of type '{}'", attribute(data, "type")));
    const std::string format = attribute(data, "format"), text = data.get_value<std::string>();
    std::vector<Number> result;
    if (format == "ascii") {
      TextParser parser(file_, text, problems_);
      while (parser.next())
        for (std::size_t field = 0; field < parser.size(); ++field) {
          if constexpr (std::is_floating_point_v<Number>) result.push_back(parser.real(field, "number"));
          else result.push_back(parser.integer(field, "number"));
        }
      return result;
    }
    if (format != "binary") fail("E-FORMAT", fmt::format("data of format '{}': only ascii and binary (inline) are read", format));
    const std::string bytes = decoded(text);
    if (bytes.size() < header_size_) fail("E-TRUNCATED", "base64 data without their length");
    ByteCursor cursor(bytes, 0, big_endian_);
    const std::uint64_t length = cursor.integer(header_size_);
    if (length > bytes.size() - header_size_ || length % type->second.size != 0) fail("E-TRUNCATED", "base64 data are shorter than they say");
    for (std::uint64_t i = 0; i < length / type->second.size; ++i) result.push_back(static_cast<Number>(value(cursor, type->second)));
    return result;
  }

  double value(ByteCursor& cursor, const Type& type) {
    if (type.kind == 'f') return type.size == 4 ? cursor.real32() : cursor.real64();
    const std::uint64_t bits = cursor.integer(type.size);
    if (type.kind == 'u' || type.size == 8) return static_cast<double>(bits);
    const std::uint64_t sign = std::uint64_t{1} << (8 * type.size - 1);
    return static_cast<double>(static_cast<std::int64_t>((bits ^ sign)) - static_cast<std::int64_t>(sign));
  }

  void read_points(const Tree& data, Mesh& mesh) {
    const std::vector<double> coordinates = numbers<double>(data);
    if (coordinates.size() % 3 != 0) fail("E-COUNT", "points have three coordinates each");
    for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) mesh.points.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    for (const auto& point : mesh.points)
      for (const double coordinate : point)
        if (!std::isfinite(coordinate)) fail("E-NUMBER", fmt::format("point {} has a coordinate that is not finite", &point - mesh.points.data()));
  }

  template <std::size_t Corners>
  void add(const std::vector<std::int64_t>& connectivity, std::int64_t begin, const Mesh& mesh, std::vector<std::array<int, Corners>>& rows) {
    std::array<int, Corners> corners{};
    for (std::size_t i = 0; i < Corners; ++i) {
      const std::int64_t corner = connectivity[static_cast<std::size_t>(begin) + i];
      if (corner < 0 || corner >= static_cast<std::int64_t>(mesh.points.size())) fail("E-INDEX", fmt::format("point {} does not exist", corner));
      corners[i] = static_cast<int>(corner);
    }
    rows.push_back(corners);
  }

  void read_cells(const Tree& cells, Mesh& mesh) {
    const auto connectivity = numbers<std::int64_t>(array(cells, "connectivity"));
    const auto offsets = numbers<std::int64_t>(array(cells, "offsets")), kinds = numbers<std::int64_t>(array(cells, "types"));
    if (offsets.size() != kinds.size()) fail("E-COUNT", "there are not as many offsets as types");
    std::int64_t begin = 0;
    for (std::size_t i = 0; i < offsets.size(); begin = offsets[i++]) {
      if (offsets[i] < begin || offsets[i] > static_cast<std::int64_t>(connectivity.size())) fail("E-COUNT", fmt::format("the offset of cell {} is wrong", i));
      const std::int64_t corners = offsets[i] - begin;
      if (kinds[i] == 1 && corners == 1) continue;
      if (kinds[i] == 3 && corners == 2) add(connectivity, begin, mesh, mesh.edges);
      else if (kinds[i] == 5 && corners == 3) add(connectivity, begin, mesh, mesh.faces);
      else if (kinds[i] == 10 && corners == 4) add(connectivity, begin, mesh, mesh.tetrahedra);
      else fail("E-FORMAT", fmt::format("cell {} is of type {}: only vertices, lines, triangles and tetrahedra are read", i, kinds[i]));
    }
  }

  std::string file_;
  Tree root_;
  Problems problems_;
  bool big_endian_ = false;
  std::size_t header_size_ = 4;
};

template <class Number>
std::string data_array(const char* type, const std::string& attributes, const std::vector<Number>& numbers) {
  const std::uint64_t length = numbers.size() * sizeof(Number);
  std::string bytes(sizeof length + length, '\0');
  std::memcpy(bytes.data(), &length, sizeof length);
  if (length > 0) std::memcpy(bytes.data() + sizeof length, numbers.data(), length);
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');
  text.resize(static_cast<std::size_t>(EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()))));
  return fmt::format("        <DataArray type=\"{}\" {} format=\"binary\">\n{}\n        </DataArray>\n", type, attributes, text);
}

}  // namespace

Mesh read_vtu(const Source& source) { return VtuReader(source).read(); }

std::string vtu_text(const Mesh& mesh) {
  std::vector<double> points, region;
  std::vector<std::int64_t> connectivity, offsets, marker;
  std::vector<std::uint8_t> kinds;
  for (const auto& point : mesh.points) points.insert(points.end(), point.begin(), point.end());
  const auto add = [&](const auto& cells, std::uint8_t kind, const std::vector<int>& labels) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      connectivity.insert(connectivity.end(), cells[i].begin(), cells[i].end());
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
      kinds.push_back(kind);
      marker.push_back(labels.empty() ? 0 : labels[i]);
      region.push_back(kind == 10 && !mesh.tetrahedron_labels.empty() ? mesh.tetrahedron_labels[i] : 0);
    }
  };
  add(mesh.tetrahedra, 10, {});
  add(mesh.faces, 5, mesh.face_labels);
  add(mesh.edges, 3, mesh.edge_labels);
  return fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
                     "  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n      <CellData>\n",
                     mesh.points.size(), kinds.size()) +
         data_array("Int64", "Name=\"marker\"", marker) + data_array("Float64", "Name=\"region\"", region) + "      </CellData>\n      <Points>\n" +
         data_array("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", points) + "      </Points>\n      <Cells>\n" +
         data_array("Int64", "Name=\"connectivity\"", connectivity) + data_array("Int64", "Name=\"offsets\"", offsets) +
         data_array("UInt8", "Name=\"types\"", kinds) + "      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace confidel::io
