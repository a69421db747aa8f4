// SPDX-License-Identifier: GPL-3.0-or-later
// stopwatch_run --ct FOLDER: somebody who has not seen the program before takes a CT from its folder to an
// approved segmentation in the window; then the command line does the same. See README.md.
#include <QApplication>
#include <QCommandLineParser>
#include <QTemporaryDir>
#include <QTest>
#include <cstdio>
#include <cstdlib>

#include "command_line.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/ui/shell/run_window.h"
#include "sitting.h"

namespace {

using namespace glisson;
using namespace glisson::stopwatch;

constexpr double kMost = 480.0;  ///< s, of person and program together
constexpr double kDice = 0.95;   ///< of the liver
constexpr double kStill = 3.0;   ///< s, that a person waits without a sign before doubting
constexpr QSize kScreen(1280, 800);

struct Arguments {
  SittingOptions sitting;
  bool compares = true;
};

Arguments read_arguments(const QApplication& application) {
  QCommandLineParser parser;
  const auto option = [&](const char* name, const char* what, const char* value = "", const char* by = "") {
    parser.addOption({QLatin1String(name), QLatin1String(what), QLatin1String(value), QLatin1String(by)});
  };
  parser.addHelpOption();
  option("ct", "a folder of DICOM slices", "FOLDER");
  option("truth", "an expert's labels of it", "FILE");
  option("codes", "what their numbers mean", "FILE");
  option("out", "where photographs, figures and the case are put", "FOLDER");
  option("seed", "of the clicks", "N", "1001");
  option("corrections", "at most", "N", "3");
  option("lesions", "a click on each lesion, too");
  option("propose", "no clicks: Propose the liver");
  option("window-only", "leave the command line out");
  parser.process(application);
  Arguments arguments;
  SittingOptions& sitting = arguments.sitting;
  const auto path = [&](const char* name) { return parser.value(QLatin1String(name)).toStdString(); };
  sitting.ct = path("ct");
  sitting.truth = path("truth");
  sitting.codes = path("codes");
  sitting.out = path("out");
  sitting.seed = parser.value(QStringLiteral("seed")).toULongLong();
  sitting.corrections = parser.value(QStringLiteral("corrections")).toInt();
  sitting.lesions = parser.isSet(QStringLiteral("lesions"));
  sitting.proposes = parser.isSet(QStringLiteral("propose")) || sitting.truth.empty();
  arguments.compares = !parser.isSet(QStringLiteral("window-only"));
  if (sitting.ct.empty() || sitting.out.empty()) parser.showHelp(2);
  std::filesystem::create_directories(sitting.out);
  return arguments;
}

void print(const Sitting& sitting) {
  std::printf("%s\n", sitting.ledger.table().c_str());
  for (const auto& [sentence, count] : sitting.ledger.findings())
    std::printf("finding (%d times): %s\n", count, sentence.c_str());
  for (const Step& step : sitting.ledger.steps())
    if (step.longest_still > kStill)
      std::printf("finding: %.1f s without a sign of progress (%s)\n", step.longest_still,
                  step.still_at.c_str());
  std::printf("clicks lie up to %.1f mm from where they were meant\n", sitting.placed_off_mm);
  for (std::size_t n = 0; n < sitting.dice.size(); ++n)
    std::printf("Dice of the liver after %zu corrections: %.4f\n", n, sitting.dice[n]);
}

Figures figures_of(const Sitting& sitting) {
  Figures figures;
  const Step total = sitting.ledger.total();
  figures["human_s"] = total.human;
  figures["program_s"] = total.program;
  figures["both_s"] = total.human + total.program;
  figures["clicks"] = total.clicks;
  figures["keys"] = total.keys;
  figures["notches"] = total.notches;
  figures["longest_still_s"] = total.longest_still;
  figures["longest_deaf_s"] = total.longest_deaf;
  figures["placed_off_mm"] = sitting.placed_off_mm;
  for (std::size_t n = 0; n < sitting.dice.size(); ++n)
    figures["dice_liver_" + std::to_string(n)] = sitting.dice[n];
  return figures;
}

/// 0: in time, good enough, and the command line did the same.
int work(const Arguments& arguments) {
  ui::MainWindow window;
  window.resize(kScreen);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return 2;
  QApplication::setActiveWindow(&window);  // keys go to it though no window manager says so
  const Sitting sitting = sit(arguments.sitting, window);
  if (window.size() != kScreen)
    std::printf("finding: the window is %d x %d\n", window.width(), window.height());
  print(sitting);
  Figures figures = figures_of(sitting);
  bool good = figures["both_s"] <= kMost && (sitting.dice.empty() || sitting.dice.back() >= kDice);
  std::printf("%.0f s of %.0f\n", figures["both_s"], kMost);
  if (arguments.compares) {
    const TemporaryFolder folder;
    const Comparison comparison = do_the_same(arguments.sitting.ct, sitting, folder.path());
    for (std::size_t n = 0; n < comparison.voxels_apart.size(); ++n) {
      std::printf("the command line after %zu corrections: %ld voxels apart\n", n,
                  comparison.voxels_apart[n]);
      figures["voxels_apart_" + std::to_string(n)] = static_cast<double>(comparison.voxels_apart[n]);
      good = good && comparison.voxels_apart[n] == 0;
    }
    std::printf("saved and shown: %ld voxels apart; the command line took %.1f s\n", comparison.saved_apart,
                comparison.seconds);
    good = good && comparison.saved_apart == 0;
    figures["command_line_s"] = comparison.seconds;
  }
  double load = 0.0;
  if (getloadavg(&load, 1) == 1) std::printf("load of the machine at the end: %.1f\n", load);
  write_figures(arguments.sitting.out / "stopwatch.json", figures);
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("LC_ALL", "C.UTF-8");
  qunsetenv("LANGUAGE");
  const QTemporaryDir settings, state;  // not the user's own
  qputenv("GLISSON_SETTINGS", settings.path().toUtf8());
  qputenv("XDG_STATE_HOME", state.path().toUtf8());
  ui::prepare_application();
  QApplication application(argc, argv);
  ui::dress_application(application);
  try {
    return work(read_arguments(application));
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "the person could not go on: %s\n", problem.what());
    return 2;
  }
}
