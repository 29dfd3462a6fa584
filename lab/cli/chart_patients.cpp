#include "lab/cli/chart_patients.h"

#include <iostream>
#include <memory>

#include "clients/cli/progress_bar.h"
#include "core/metrics/mean_and_sd.h"
#include "lab/cli/chart_parts.h"
#include "lab/diseases/barlow_study.h"
#include "lab/diseases/durable_anchors.h"
#include "lab/twins/rupture_table.h"
#include "lab/twins/twin_table.h"
#include "lab/verdicts/chordae_study.h"

namespace coapt {
namespace {

void print(std::ostream& out, const std::vector<DrawnAnatomy>& all) {
  for (const ChordaeAgreement& of : chordae_agreements(all))
    out << to_string(of.known) << ", " << of.anatomies << " anatomies: tau " << of.tau
        << ", regret " << of.regret_mm2 << " mm2 (at most " << of.most_regret_mm2
        << "), error of the median leak " << of.error_mm2 << ", sd over draws " << of.sd_mm2
        << " mm2, " << of.refused << " refused or not trusted\n";
}

/// Mean, sd and number of those that have one.
void print_share(std::ostream& out, const char* what, const std::vector<double>& shares) {
  const auto [mean, sd] = mean_and_sd(shares);
  out << what << 100.0 * mean << " ± " << 100.0 * sd << " % (" << shares.size() << " valves)\n";
}

void print(std::ostream& out, const std::vector<BarlowState>& states) {
  std::vector<double> for_index, to_close;
  for (const BarlowAnswer& of : barlow_answers(states)) {
    out << "valve " << of.valve << ": index " << of.index_as_is << ", leak " << of.leak_mm2
        << " mm2, with a healthy law " << of.healthy_leak_mm2 << " mm2\n";
    if (of.reduction_for_index) for_index.push_back(*of.reduction_for_index);
    if (of.reduction_to_close) to_close.push_back(*of.reduction_to_close);
  }
  print_share(out, "annular area less for a coaptation area index of 20 %: ", for_index);
  print_share(out, "annular area less for a leak below 1 mm2: ", to_close);
  out << "Aguilera 2023: 31 ± 6 % less for 20 % without resection; 58 ± 7 % were done\n";
}

void print(std::ostream& out, const std::vector<DurableAnchor>& repairs) {
  for (const DurableAnchorAnswer& of : durable_anchor_answers(repairs))
    out << to_string(of.displaced) << (of.ring ? " displaced, with a ring" : " displaced")
        << ", tied until " << of.limit_mm2 << " mm2, " << (of.odd ? "odd" : "even")
        << " anatomies (" << of.anatomies << "): trigone lasts longer in " << of.trigone_longer
        << ", saddle peak in " << of.peak_longer << "; trigone less peak " << of.mean_mm << " ± "
        << of.sd_mm << " mm, with " << of.movement_mm << " mm more movement\n";
}

}  // namespace

void add_durable_anchors(Command chart, int& status) {
  const auto options = std::make_shared<DurableAnchorOptions>();
  Command command = chart.add_command(
      "durable-anchors", "Ask which anchor of papillary sutures lasts longer as disease goes on");
  const auto directory = add_output(command);
  command.add_option("--anatomies", options->anatomies, "Random ones")
      .check(number_from(1, 10000))
      .show_default();
  command.add_option("--seed", options->seed, "Of the anatomies").show_default();
  add_threads_option(command, options->threads, "anatomies");
  command.footer(
      "Sutures to the ipsilateral trigone or to the saddle peak, each just short enough for a "
      "leak\n"
      "of 5 or of 1 mm2, then closed along eight courses of further disease.\n\n"
      "Example:\n"
      "  coapt-lab chart durable-anchors -o charts");
  command.on_run([=, &status] {
    std::vector<DurableAnchor> repairs;
    status = run_chart(*directory, "durable-anchors.csv", [&] {
      const ProgressBar bar;
      repairs = study_durable_anchors(
          *options, [&](int done, int planned) { bar.show(done, planned, "anatomies"); });
      return durable_anchors_csv(repairs);
    });
    print(std::cout, repairs);
  });
}

void add_barlow(Command chart, int& status) {
  const auto options = std::make_shared<BarlowStudyOptions>();
  Command command = chart.add_command(
      "barlow", "Make the annulus of valves with Barlow's disease smaller until they coapt");
  const auto directory = add_output(command);
  command.add_option("--valves", options->valves, "Random ones")
      .check(number_from(1, 1000))
      .show_default();
  command.add_option("--seed", options->seed, "Of their dimensions").show_default();
  add_threads_option(command, options->threads, "closures");
  command.footer("Example:\n  coapt-lab chart barlow -o charts");
  command.on_run([=, &status] {
    std::vector<BarlowState> states;
    status = run_chart(*directory, "barlow.csv", [&] {
      const ProgressBar bar;
      states =
          study_barlow(*options, [&](int done, int planned) { bar.show(done, planned, "valves"); });
      return barlow_csv(states);
    });
    print(std::cout, states);
  });
}

void add_drawn_chordae(Command chart, int& status) {
  const auto options = std::make_shared<ChordaeStudyOptions>();
  Command command = chart.add_command(
      "chordae", "Judge plans on anatomies with their own chordae and with drawn ones");
  const auto directory = add_output(command);
  command.add_option("--anatomies", options->anatomies, "Random ones")
      .check(number_from(1, 1000))
      .show_default();
  command.add_option("--draws", options->draws, "For each, tips seen and tips drawn")
      .check(number_from(1, 1000))
      .show_default();
  command.add_option("--plans", options->plans, "Random plans for each anatomy")
      .check(number_from(1, 50))
      .show_default();
  command.add_option("--seed", options->seed, "Of anatomies, disease and plans").show_default();
  add_threads_option(command, options->threads, "leaks");
  command.footer(
      "Says what is lost where images show no chordae: how far the order of plans and the best "
      "one\n"
      "by the median over the draws are those of the anatomy's own chordae.\n\n"
      "Example:\n"
      "  coapt-lab chart chordae -o charts");
  command.on_run([=, &status] {
    std::vector<DrawnAnatomy> all;
    status = run_chart(*directory, "chordae.csv", [&] {
      const ProgressBar bar;
      all = study_chordae(*options,
                          [&](int done, int planned) { bar.show(done, planned, "anatomies"); });
      return chordae_csv(all);
    });
    print(std::cout, all);
  });
}

void add_twins(Command chart, int& status) {
  const auto options = std::make_shared<TwinStudyOptions>();
  const auto unknown_leak = std::make_shared<bool>(false);
  Command command = chart.add_command(
      "twins",
      "Fit valves whose chordae, tips and tissue are known to a view of their closed state");
  const auto directory = add_output(command);
  command.add_option("--twins", options->twins, "Random anatomies")
      .check(number_from(1, 1000))
      .show_default();
  command.add_option("--seed", options->seed, "Of anatomies, draws and noise").show_default();
  command.add_option("--noise", options->echo.noise_mm, "Standard deviation of a point, mm")
      .check(number_from(0.0, 5.0))
      .show_default();
  command
      .add_option("--refinements", options->refinements,
                  "How often the mesh is refined that twins are closed on")
      .check(number_from(0, 2))
      .show_default();
  command.add_flag("--leak-unknown", *unknown_leak, "The fit is not told the leak");
  add_threads_option(command, options->fit.threads, "twins");
  command.footer(
      "Each twin is drawn from the priors of the fit, closed on a finer mesh, and seen from "
      "the\n"
      "atrium with noise, holes and smoothing.\n\n"
      "Example:\n"
      "  coapt-lab chart twins --twins 40 -o charts");
  command.on_run([=, &status] {
    options->leak_known = !*unknown_leak;
    std::vector<Twin> twins;
    status = run_chart(*directory, "twins.csv", [&] {
      const ProgressBar bar;
      twins =
          study_twins(*options, [&](int done, int planned) { bar.show(done, planned, "twins"); });
      return twins_csv(twins);
    });
    print_twins(std::cout, twins);
  });
}

void add_ruptures(Command chart, int& status) {
  const auto options = std::make_shared<TwinStudyOptions>();
  options->twins = 20;
  options->fit.ruptures = true;
  Command command = chart.add_command(
      "ruptures", "Fit valves, of which half have ruptured chordae that the fit gets whole");
  const auto directory = add_output(command);
  command.add_option("--twins", options->twins, "Random anatomies")
      .check(number_from(1, 1000))
      .show_default();
  command.add_option("--seed", options->seed, "Of anatomies, lesions, draws and noise")
      .show_default();
  add_threads_option(command, options->fit.threads, "twins");
  command.footer(
      "Twins as those of coapt-lab chart twins; every second pair has the marginal chordae of a\n"
      "random scallop ruptured. Says how many coapt fit --ruptured finds.\n\n"
      "Example:\n"
      "  coapt-lab chart ruptures --twins 40 -o charts");
  command.on_run([=, &status] {
    std::vector<Twin> twins;
    status = run_chart(*directory, "ruptures.csv", [&] {
      const ProgressBar bar;
      twins =
          study_twins(*options, [&](int done, int planned) { bar.show(done, planned, "twins"); });
      return ruptures_csv(twins);
    });
    print_ruptures(std::cout, twins);
  });
}

}  // namespace coapt
