// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: one reader, chosen by CONFIDEL_FUZZ_FORMAT, and the exact validity test behind it. Any answer is good that is an Input or an
// InputError; what was read can be written and read again.
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "campaigns/instance.h"
#include "core/complex/build.h"
#include "core/io/source.h"

namespace {

using namespace confidel;

Input read(const std::string& suffix, const std::string& text) {
  const io::Source source{"fuzz" + suffix, text};
  if (suffix == ".poly") return io::read_poly(source);
  if (suffix == ".smesh") return io::read_smesh(source);
  if (suffix == ".off") return io::read_off(source);
  if (suffix == ".obj") return io::read_obj(source);
  if (suffix == ".edg") return io::read_edg(source);
  if (suffix == ".stl") return io::read_stl(source);
  if (suffix == ".ply") return io::read_ply(source);
  if (suffix == ".mesh") return io::read_medit(source);
  std::abort();
}

const std::string& suffix() {
  static const std::string value = [] {
    const char* format = std::getenv("CONFIDEL_FUZZ_FORMAT");
    return "." + std::string(format == nullptr ? "poly" : format);
  }();
  return value;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most_entities = 60;  // the readers are meant, not the exact test's patience
  try {
    const Input input = read(suffix(), std::string(reinterpret_cast<const char*>(data), size));
    if (input.vertices.size() + input.facets.size() + input.segments.size() > most_entities) return 0;
    BuildOptions options;
    options.merge_identical_vertices = true;
    const BuiltComplex built = build_complex(input, options);
    canonical_text(built.complex);
    Input plain = input;
    plain.regions.clear();
    const Input again = read(campaigns::suffix_for(plain), campaigns::input_text(plain));
    if (again.vertices.size() != input.vertices.size() || again.facets.size() != input.facets.size()) std::abort();
  } catch (const InputError& error) {
    if (error.problems.empty()) std::abort();
  } catch (const FileError&) {  // the companion of a .poly
  } catch (const std::invalid_argument&) {  // volume holes together with hanging segments: no format says that
  }
  return 0;
}
