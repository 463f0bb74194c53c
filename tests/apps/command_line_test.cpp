// SPDX-License-Identifier: GPL-3.0-or-later
// The command as its users meet it: outputs, messages, exit codes (docs/certificate-format.md, section 6).
#include <sys/wait.h>
#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace {

namespace fs = std::filesystem;

struct Result {
  int code = -1;
  std::string out, err;
};

std::string contents(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / ("confidel-command-line-" + std::to_string(getpid()))) {
    fs::remove_all(path_);
    fs::create_directories(path_);
    write("square.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    write("bent.off", "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n4 0 1 2 3\n");
    write("twice.off", "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 3 5 4\n");
  }
  ~Folder() { fs::remove_all(path_); }

  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
  fs::path operator/(const std::string& name) const { return path_ / name; }

  Result run(const std::string& arguments) const {
    const std::string command = "cd '" + path_.string() + "' && '" CONFIDEL_BINARY_DIR "/confidel' " + arguments +
                                " > stdout.txt 2> stderr.txt < /dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(path_ / "stdout.txt"),
            contents(path_ / "stderr.txt")};
  }

 private:
  fs::path path_;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

BOOST_AUTO_TEST_SUITE(apps_command_line)

BOOST_FIXTURE_TEST_CASE(usage_errors_exit_with_2, Folder) {
  for (const std::string arguments :
       {"", "info", "canonical", "frobnicate", "info square.off --frobnicate", "info a b"}) {
    const Result result = run(arguments);
    BOOST_TEST_CONTEXT(arguments) {
      BOOST_TEST(result.code == 2);
      BOOST_TEST(has(result.err, "confidel: error[E-USAGE]: "));
      BOOST_TEST(result.out.empty());
    }
  }
}

BOOST_FIXTURE_TEST_CASE(help_and_version_exit_with_0, Folder) {
  BOOST_TEST(run("--help").code == 0);
  BOOST_TEST(has(run("info --help").out, "--json"));
  BOOST_TEST(has(run("--version").out, "confidel "));
}

BOOST_FIXTURE_TEST_CASE(files_that_cannot_be_read_or_written_exit_with_4, Folder) {
  BOOST_TEST(run("info missing.off").code == 4);
  BOOST_TEST(has(run("info missing.off").err, "missing.off"));
  BOOST_TEST(run("canonical square.off -o no/such/folder/out.plc").code == 4);
  BOOST_TEST(run("canonical square.off -o /dev/full/x").code == 4);
}

BOOST_FIXTURE_TEST_CASE(bad_input_exits_with_2_and_names_the_place, Folder) {
  const Result bent = run("info bent.off");
  BOOST_TEST(bent.code == 2);
  BOOST_TEST(bent.out.empty());
  BOOST_TEST(bent.err.rfind("bent.off:7:1: error[E-NONCOPLANAR]: facet 0 (line 7) is not flat: vertex 3 (line 6)", 0) ==
             0U);
  const Result canonical = run("canonical bent.off -o bent.plc");
  BOOST_TEST(canonical.code == 2);
  BOOST_TEST(!fs::exists(*this / "bent.plc"));
}

BOOST_FIXTURE_TEST_CASE(twenty_problems_then_a_count, Folder) {
  std::string text = "OFF\n75 25 0\n";
  for (int i = 0; i < 25; ++i)
    for (int corner = 0; corner < 3; ++corner) text += std::to_string(3 * i + corner) + " 0 0\n";
  for (int i = 0; i < 25; ++i)
    text += "3 " + std::to_string(3 * i) + " " + std::to_string(3 * i + 1) + " " + std::to_string(3 * i + 2) + "\n";
  write("lines.off", text);
  const Result result = run("info lines.off");
  BOOST_TEST(result.code == 2);
  BOOST_TEST(std::count(result.err.begin(), result.err.end(), '\n') == 21);
  BOOST_TEST(has(result.err, "lines.off: 25 errors in all (20 shown): 25 E-DEGENERATE-FACET\n"));
}

BOOST_FIXTURE_TEST_CASE(canonical_writes_the_same_to_file_and_standard_output, Folder) {
  const Result shown = run("canonical square.off");
  BOOST_TEST(shown.code == 0);
  BOOST_TEST(shown.out.rfind("plc 1\ndim 3\nvertices 4\n", 0) == 0U);
  write("square.plc", "old");
  BOOST_TEST(run("canonical square.off --output square.plc").code == 0);
  BOOST_TEST(contents(*this / "square.plc") == shown.out);
  // Nothing but the output stays behind.
  for (const auto& entry : fs::directory_iterator(fs::path(*this / "").parent_path()))
    BOOST_TEST(!has(entry.path().filename().string(), ".partial-"));
}

BOOST_FIXTURE_TEST_CASE(identical_vertices_are_merged_only_on_request, Folder) {
  BOOST_TEST(run("info twice.off").code == 2);
  BOOST_TEST(has(run("info twice.off").err,
                 "twice.off:6:1: error[E-DUPLICATE-VERTEX]: vertex 3 (line 6) and vertex 1 (line 4)"));
  const Result merged = run("info twice.off --merge-identical --merge-coplanar off --json");
  BOOST_TEST(merged.code == 0);
  const auto document = nlohmann::json::parse(merged.out);
  BOOST_TEST(document["vertices"] == 4);
  BOOST_TEST(document["segments"] == 5);
}

BOOST_FIXTURE_TEST_CASE(info_in_json, Folder) {
  const Result result = run("info square.off --json");
  BOOST_TEST(result.code == 0);
  const auto document = nlohmann::json::parse(result.out);
  BOOST_TEST(document["dimension"] == 3);
  BOOST_TEST(document["valid"] == true);
  BOOST_TEST(document["triangles"] == 2);
  BOOST_TEST(document["smallest_angle_between_segments"]["degrees"].get<double>() > 89.99);
  BOOST_TEST(document["smallest_angle_between_segments"]["degrees"].get<double>() <= 90);
  BOOST_TEST(document["smallest_dihedral_angle"].is_null());
  BOOST_TEST(document["vertex_feature_size"]["min"].get<double>() > 0.999);
  BOOST_TEST(document["sha256"].get<std::string>().size() == 64U);
}

BOOST_FIXTURE_TEST_CASE(info_in_words, Folder) {
  const Result result = run("info square.off");
  BOOST_TEST(result.code == 0);
  BOOST_TEST(has(result.out, "square.off: valid, exactly"));
  BOOST_TEST(has(result.out, "1: 2 triangles, 4 boundary edges, 0 inner constraints, 0 isolated vertices"));
  BOOST_TEST(has(result.out, "90 degrees, at vertex 0"));
}

BOOST_AUTO_TEST_SUITE_END()
