// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "apps/command.h"
#include "apps/interrupt.h"
#include "apps/style.h"

namespace {

using namespace confidel;

constexpr const char* footer = R"(Examples:
  confidel info examples/w3.smesh
  confidel conform examples/w3.smesh -o w3.cert
  confidel explain E-NONCOPLANAR

Exit codes: 0 success, 1 refuted, 2 bad usage or input, 3 undecided, 4 a file cannot be read or written,
5 a certificate is rejected, 70 internal error, 130 interrupted.)";

/// The message of an error that ends the program.
void print_error(const char* code, const std::string& message) {
  fmt::print(stderr, "confidel: {}: {}\n", styled(Style::error, fmt::format("error[{}]", code), stderr), message);
}

int run_command_line(int argc, char** argv, Selection& selection) {
  CLI::App app("Conforming Delaunay tetrahedralizations of piecewise-linear complexes, with certificates", "confidel");
  app.set_version_flag("--version", "confidel " CONFIDEL_VERSION, "Print the version and exit");
  app.require_subcommand(1);
  app.fallthrough();
  app.footer(footer);
  add_color_option(app);
  add_info(app, selection);
  add_canonical(app, selection);
  add_conform(app, selection);
  add_draw(app, selection);
  add_lemma(app, selection);
  add_paper(app, selection);
  add_generate(app, selection);
  add_campaign(app, selection);
  add_shrink(app, selection);
  add_falsify(app, selection);
  add_audit(app, selection);
  add_convert(app, selection);
  add_explain(app, selection);
  add_report(app, selection);
  add_manual(app, selection);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help, --version
  } catch (const CLI::ParseError& error) {
    print_error("E-USAGE", fmt::format("{}\nRun `confidel --help` or `confidel COMMAND --help`.", error.what()));
    return exit_bad_input;
  }
  return selection.run();
}

}  // namespace

int main(int argc, char** argv) {
  handle_interrupts();
  Selection selection;
  try {
    return run_command_line(argc, argv, selection);
  } catch (const InputError& error) {
    print_problems(error, selection.json);
    return exit_bad_input;
  } catch (const FileError& error) {
    print_error("E-FILE", error.what());
    return exit_unreadable;
  } catch (const std::bad_alloc&) {
    print_error("E-INTERNAL", "out of memory");
    return exit_internal;
  } catch (const std::exception& error) {
    print_error("E-INTERNAL", fmt::format("{}; please report this with the input", error.what()));
    return exit_internal;
  }
}
