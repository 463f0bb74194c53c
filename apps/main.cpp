// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "apps/command.h"
#include "apps/interrupt.h"

namespace {

using namespace confidel;

int run_command_line(int argc, char** argv) {
  CLI::App app("Conforming Delaunay tetrahedralizations of piecewise-linear complexes, with certificates", "confidel");
  app.set_version_flag("--version", "confidel " CONFIDEL_VERSION);
  app.require_subcommand(1);
  Selection selection;
  add_info(app, selection);
  add_canonical(app, selection);
  add_conform(app, selection);
  add_draw(app, selection);
  add_lemma(app, selection);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);  // --help, --version
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "confidel: error[E-USAGE]: {}\nRun `confidel --help` or `confidel COMMAND --help`.\n",
               error.what());
    return exit_bad_input;
  }
  return selection.run();
}

}  // namespace

int main(int argc, char** argv) {
  handle_interrupts();
  try {
    return run_command_line(argc, argv);
  } catch (const InputError& error) {
    print_problems(error);
    return exit_bad_input;
  } catch (const FileError& error) {
    fmt::print(stderr, "confidel: error[E-FILE]: {}\n", error.what());
    return exit_unreadable;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "confidel: error[E-INTERNAL]: out of memory\n");
    return exit_internal;
  } catch (const std::exception& error) {
    fmt::print(stderr, "confidel: error[E-INTERNAL]: {}; please report this with the input\n", error.what());
    return exit_internal;
  }
}
