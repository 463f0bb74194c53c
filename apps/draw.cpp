// SPDX-License-Identifier: GPL-3.0-or-later
// confidel draw CERT -o OUT: pictures of certificates. What they say about the verdict is the checker's word.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <thread>

#include "apps/checker_process.h"
#include "apps/command.h"
#include "apps/draw/html.h"
#include "apps/draw/picture.h"
#include "apps/draw/svg.h"
#include "apps/draw/vtu.h"
#include "apps/meter.h"
#include "core/io/source.h"

namespace confidel {

namespace {

struct DrawOptions {
  std::string file, output;
  SvgOptions svg;
  std::vector<double> window;
  double time_limit = 0;
  std::size_t memory_limit = 0;
  bool no_check = false, no_panel = false, quiet = false, json = false;
};

struct Stopped {};

// About 100 MB of page; browsers hold no string much longer.
constexpr std::size_t most_cells_in_page = 2'000'000;

void check(Picture& picture, const DrawOptions& options, Meter& meter) {
  if (options.no_check) {
    picture.verdict = "not checked";
    return;
  }
  meter.at("checking", static_cast<long>(picture.certificate.points.size()));
  const CheckerRun run = run_checker(options.file, "", static_cast<int>(std::max(1U, std::thread::hardware_concurrency())), meter.time_left(), options.memory_limit);
  picture.check = nlohmann::ordered_json::parse(run.report, nullptr, false);
  if (picture.check.is_discarded()) picture.check = nullptr;
  picture.verdict = run.verdict.substr(0, run.verdict.find('\n'));
}

void measure(Picture& picture, Meter& meter) {
  const long points = static_cast<long>(picture.certificate.points.size());
  meter.at("measuring", points);
  picture.positions = approximate_positions(picture.certificate);
  std::atomic<bool> stopped{false};
  picture.clearances = clearances(picture.certificate, picture.positions, [&] {
    if (meter.stop_requested(points)) stopped = true;
    return stopped.load();
  });
  if (stopped) throw Stopped();
  picture.lemmas = lemma_slacks(picture.certificate);
  derive(picture);
}

InputError unusable(const std::string& file, const std::string& message) { return InputError({{"E-USAGE", {file, 0, 0}, message}}); }

int run_draw(const DrawOptions& options) {
  const std::string suffix = io::suffix(options.output);
  if (suffix != ".svg" && suffix != ".html" && suffix != ".vtu")
    throw unusable(options.output, "unknown kind of picture; the suffixes are .svg (dimension 2), .html and .vtu");
  Meter meter(options.time_limit, options.memory_limit, !options.quiet);
  Picture picture;
  meter.at("reading", 0);
  picture.certificate = read_certificate(options.file);
  const Certificate& certificate = picture.certificate;
  if (suffix == ".svg" && certificate.dimension != 2)
    throw unusable(options.output, "an SVG shows dimension 2, and this certificate is of dimension 3: write .html or .vtu");
  if (suffix == ".html" && certificate.cells.size() > most_cells_in_page)
    throw InputError({{"E-TOO-LARGE", {options.file, 0, 0}, fmt::format("{} cells are too many for a page (at most {}); write .vtu for ParaView", certificate.cells.size(), most_cells_in_page)}});
  try {
    check(picture, options, meter);
    measure(picture, meter);
  } catch (const Stopped&) {
    if (options.json) fmt::print("{}\n", nlohmann::ordered_json{{"file", options.file}, {"verdict", fmt::format("s UNDECIDED {}", meter.reason())}, {"exit", static_cast<int>(exit_undecided)}}.dump(2));
    fmt::print(options.json ? stderr : stdout, "stopped; nothing was written\ns UNDECIDED {}\n", meter.reason());
    return exit_undecided;
  }
  meter.at("drawing", static_cast<long>(certificate.points.size()));
  if (suffix == ".svg") {
    const SvgResult drawn = draw_svg(picture, options.svg);
    for (const std::string& remark : drawn.remarks) fmt::print(stderr, "confidel draw: {}\n", remark);
    write_output(options.output, drawn.text);
  } else {
    write_output(options.output, suffix == ".html" ? draw_html(picture) : draw_vtu(picture));
  }
  if (options.json) {
    const nlohmann::ordered_json report{{"file", options.file}, {"output", options.output}, {"points", certificate.points.size()}, {"cells", certificate.cells.size()},
                                        {"violated", picture.violated.size()}, {"verdict", picture.verdict}, {"exit", static_cast<int>(exit_success)}};
    fmt::print("{}\n", report.dump(2));
  } else if (!options.quiet) {
    fmt::print("{}: {} points, {} cells, {} violated\n", options.file, certificate.points.size(), certificate.cells.size(), picture.violated.size());
    fmt::print("checked by confidel-check: {}\n", picture.verdict);
    fmt::print("picture: {}\n", options.output);
  }
  return exit_success;
}

}  // namespace

void add_draw(CLI::App& app, Selection& selection) {
  auto options = std::make_shared<DrawOptions>();
  CLI::App* command = app.add_subcommand("draw", "Draw a certificate: .svg in dimension 2, .html to look at it in space, .vtu for ParaView");
  command->add_option("FILE", options->file, "The certificate: .cert or .cert.zst")->required();
  command->add_option("-o,--output", options->output, "The picture; its suffix says which kind")->required();
  command->add_option("--layers", options->svg.layers, "SVG: the layers shown at first, separated by commas (the panel switches them)")
      ->delimiter(',')->check(CLI::IsMember(svg_layers()));
  command->add_option("--window", options->window, "SVG: draw only this part of the plane")->expected(4)->option_text("XMIN YMIN XMAX YMAX");
  command->add_option("--max-elements", options->svg.most_elements, "SVG: objects with tooltips; above, the largest layers lose them")
      ->check(CLI::Range(std::size_t{100}, std::size_t{100'000'000}))->capture_default_str();
  command->add_flag("--no-panel", options->no_panel, "SVG: without legend and switches, as for a page of text");
  command->add_flag("--exact", options->svg.in_full, "SVG: exact numbers however long they are");
  command->add_flag("--no-check", options->no_check, "Do not run confidel-check; the picture then says that it was not checked");
  command->add_option("--time-limit", options->time_limit, "UNDECIDED after this time, such as 90, 90s or 5m")
      ->transform(CLI::AsNumberWithUnit(std::map<std::string, double>{{"s", 1}, {"m", 60}, {"h", 3600}}, CLI::AsNumberWithUnit::CASE_INSENSITIVE));
  command->add_option("--memory-limit", options->memory_limit, "UNDECIDED above this resident memory, such as 512M or 4G")->transform(CLI::AsSizeValue(false));
  command->add_flag("-q,--quiet", options->quiet, "Nothing but errors and remarks");
  add_json_option(*command, selection);
  command->footer(
      "Examples:\n  confidel conform examples/courtyard.poly -o map.cert && confidel draw map.cert -o map.svg\n"
      "  confidel conform examples/w3.smesh -o part.cert && confidel draw part.cert -o part.html\n\nExit codes: 0 drawn, 2 bad input, 3 a limit was reached, 4 unreadable file, 70 internal error, 130 interrupted.");
  command->callback([options, &selection] {
    options->json = selection.json;
    options->svg.panel = !options->no_panel;
    if (!options->window.empty()) {
      const auto& window = options->window;
      if (!(window[0] < window[2] && window[1] < window[3])) throw CLI::ValidationError("--window", "XMIN < XMAX and YMIN < YMAX must hold");
      options->svg.window = {window[0], window[1], window[2], window[3]};
    }
    selection.run = [options] { return run_draw(*options); };
  });
}

}  // namespace confidel
