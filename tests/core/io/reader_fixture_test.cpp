// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/io/reader_fixture.h"

#include <unistd.h>

#include <atomic>
#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "core/io/read.h"

namespace confidel::test {

TemporaryFolder::TemporaryFolder() {
  static std::atomic<int> next = 0;
  folder_ = (std::filesystem::temp_directory_path() /
             ("confidel-io-" + std::to_string(getpid()) + "-" + std::to_string(next++)))
                .string();
  std::filesystem::create_directories(folder_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

std::string TemporaryFolder::write(const std::string& name, const std::string& text) const {
  std::ofstream(path(name), std::ios::binary) << text;
  return path(name);
}

Input read_text(const std::string& suffix, const std::string& text) {
  static const TemporaryFolder folder;
  return read_input(folder.write("input" + suffix, text));
}

std::vector<Problem> problems_of(const std::string& suffix, const std::string& text) {
  try {
    read_text(suffix, text);
  } catch (const InputError& error) {
    return error.problems;
  }
  return {};
}

void check_malformed(const std::string& suffix, const std::vector<Malformed>& table) {
  for (const Malformed& bad : table) {
    BOOST_TEST_CONTEXT(suffix << ": " << bad.why) {
      const std::vector<Problem> problems = problems_of(suffix, bad.text);
      BOOST_REQUIRE_MESSAGE(!problems.empty(), "accepted, but must be refused");
      const Problem& first = problems.front();
      BOOST_TEST_CONTEXT(first.message) {
        BOOST_TEST(first.code == bad.code);
        BOOST_TEST(first.place.line == bad.line);
        BOOST_TEST(first.place.column == bad.column);
        BOOST_TEST(first.place.file.ends_with(suffix));
        BOOST_TEST(!first.message.empty());
      }
    }
  }
}

std::string with(std::string text, const std::string& part, const std::string& replacement) {
  const std::size_t position = text.find(part);
  BOOST_REQUIRE_MESSAGE(position != std::string::npos && text.find(part, position + 1) == std::string::npos,
                        "'" << part << "' must occur once");
  return text.replace(position, part.size(), replacement);
}

}  // namespace confidel::test

BOOST_AUTO_TEST_SUITE(io_read)

using namespace confidel;

BOOST_AUTO_TEST_CASE(unknown_suffix_names_the_known_ones) {
  const std::vector<Problem> problems = test::problems_of(".step", "ISO-10303-21;");
  BOOST_REQUIRE_EQUAL(problems.size(), 1);
  BOOST_TEST(problems[0].code == "E-FORMAT");
  BOOST_TEST(problems[0].place.line == 0);
  for (const char* known : {".poly", ".smesh", ".off", ".obj", ".edg", ".stl", ".ply", ".mesh"}) {
    BOOST_TEST(problems[0].message.find(known) != std::string::npos, known);
  }
  BOOST_TEST(test::problems_of("", "OFF 0 0").front().code == "E-FORMAT");
}

BOOST_AUTO_TEST_CASE(suffix_may_be_in_capitals) {
  BOOST_TEST(test::read_text(".OFF", "OFF\n1 0 0\n1 2 3\n").vertices.size() == 1);
}

BOOST_AUTO_TEST_CASE(unreadable_files_are_no_input_errors) {
  const test::TemporaryFolder folder;
  BOOST_CHECK_THROW(read_input(folder.path("absent.off")), FileError);
  BOOST_CHECK_THROW(read_input(folder.path("absent.xyz")), FileError);
  std::filesystem::create_directory(folder.path("folder.off"));
  BOOST_CHECK_THROW(read_input(folder.path("folder.off")), FileError);
}

BOOST_AUTO_TEST_CASE(the_list_of_problems_is_bounded) {
  std::string text = "OFF\n100000 0 0\n";
  for (int i = 0; i < 100000; ++i) text += "x y z\n";
  BOOST_TEST(test::problems_of(".off", text).size() == 1000);
}

BOOST_AUTO_TEST_SUITE_END()
