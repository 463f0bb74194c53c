// SPDX-License-Identifier: GPL-3.0-or-later
// The text of docs/certificate-format.md section 2, and its SHA-256.
#include <openssl/evp.h>

#include <memory>
#include <stdexcept>

#include "core/complex/complex.h"

namespace confidel {

namespace {

/// value * 2^power for power >= 0.
mpz_class shifted(const mpz_class& value, int power) {
  mpz_class result;
  mpz_mul_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(power));
  return result;
}

void append_indices(std::string& text, std::initializer_list<int> indices) {
  bool first = true;
  for (const int index : indices) {
    if (!first) text += ' ';
    text += std::to_string(index);
    first = false;
  }
  text += '\n';
}

void append_edges(std::string& text, char letter, const std::vector<std::array<VertexId, 2>>& edges) {
  text += letter;
  text += ' ';
  append_indices(text, {static_cast<int>(edges.size())});
  for (const auto& [a, c] : edges) append_indices(text, {a, c});
}

void append_facet(std::string& text, const Facet& facet) {
  text += "f ";
  append_indices(text, {facet.frame[0], facet.frame[1], facet.frame[2]});
  append_edges(text, 'b', facet.boundary);
  append_edges(text, 'c', facet.constraints);
  text += "p ";
  append_indices(text, {static_cast<int>(facet.isolated.size())});
  for (const VertexId vertex : facet.isolated) append_indices(text, {vertex});
}

}  // namespace

std::string canonical_point(const Point& input_position, int dimension) {
  // The representation is normalised (point.h): with a positive exponent one numerator is odd, so the gcd with W =
  // 2^exponent is 1; otherwise the coordinates are integers and W = 1.
  const int exponent = input_position.exponent();
  const mpz_class weight = exponent > 0 ? shifted(1, exponent) : mpz_class(1);
  std::string text;
  for (int axis = 0; axis < dimension; ++axis) {
    const mpz_class& numerator = input_position.numerator(axis);
    text += (exponent < 0 ? shifted(numerator, -exponent) : numerator).get_str(16);
    text += ' ';
  }
  return text + weight.get_str(16);
}

std::string canonical_text(const Complex& complex) {
  std::string text = "plc 1\ndim " + std::to_string(complex.dimension) + "\nvertices ";
  append_indices(text, {static_cast<int>(complex.vertices.size())});
  for (VertexId vertex = 0; vertex < static_cast<VertexId>(complex.vertices.size()); ++vertex)
    text += "v " + canonical_point(complex.input_position(vertex), complex.dimension) + "\n";
  text += "segments ";
  append_indices(text, {static_cast<int>(complex.segments.size())});
  for (const auto& [a, b] : complex.segments) {
    text += "s ";
    append_indices(text, {a, b});
  }
  text += "facets ";
  append_indices(text, {static_cast<int>(complex.facets.size())});
  for (const Facet& facet : complex.facets) append_facet(text, facet);
  return text + "end\n";
}

std::string sha256(const std::string& bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available from libcrypto");
  static constexpr char digits[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < length; ++i) {
    text += digits[digest[i] >> 4];
    text += digits[digest[i] & 15];
  }
  return text;
}

}  // namespace confidel
