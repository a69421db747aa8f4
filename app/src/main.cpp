// SPDX-License-Identifier: GPL-3.0-or-later
#include <vtkLogger.h>

#include <QCoreApplication>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "cli.h"
#include "commands.h"
#include "crash_report.h"
#include "exit_code.h"
#include "glisson/core/claim.h"
#include "glisson/core/failure_sentence.h"
#include "glisson/core/files.h"
#include "glisson/core/log_file.h"
#include "glisson/core/printable.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/scene/headless_gui.h"
#include "glisson/ui/shell/language.h"

namespace glisson::app {

namespace {

void print_usage() {
  say(Cli::tr(
      "Glisson: planning and guidance of minimally invasive liver surgery. Research software: not for "
      "clinical use."));
  say(QString());
  say(Cli::tr("Usage: glisson [CASE]              open the window"));
  say(Cli::tr(
      "       glisson COMMAND [OPTIONS]   work without a display; 'glisson COMMAND --help' tells more"));
  say(QString());
  for (const SubCommand& command : sub_commands())
    say(QString("  %1 %2").arg(command.name, -12).arg(Cli::tr(command.description)));
}

int tell(const std::string& sentence, int code) {
  const std::string shown = printable(ui::error_text(sentence).toStdString());
  std::fprintf(stderr, "glisson: %s\n", QString::fromStdString(shown).toLocal8Bit().constData());
  return code;
}

/// Does something; what is said on an error is told in the person's language, while there is one.
int run_told(const char* name, const std::function<int()>& work) {
  try {
    return work();
  } catch (const UsageError& failure) {
    return tell(failure.what(), kUsage);
  } catch (const Interrupted&) {
    throw;
  } catch (const std::exception& failure) {
    return tell(sentence_of(failure, name), kFailed);
  }
}

int open_window(int argc, char** argv) {
  try {
    if (argc > 1 && argv[1][0] == '-')
      throw UsageError(std::string(argv[1]) + ": unknown option. See 'glisson --help'.");
    report_crashes(crash_folder(), "");
    return run_window(argc, argv);
  } catch (const std::exception&) {
    // Without a window there was no language as yet.
    QCoreApplication application(argc, argv);
    ui::set_up_language(application);
    return run_told("window", []() -> int { throw; });
  }
}

int run(int argc, char** argv) {
  const char* first = argc > 1 ? argv[1] : "";
  for (const SubCommand& command : sub_commands()) {
    if (std::strcmp(first, command.name) != 0) continue;
    // Text in pictures needs Qt's fonts, which need no display.
    std::optional<scene::HeadlessGui> gui;
    std::optional<QCoreApplication> application;
    if (command.draws)
      gui.emplace();
    else
      application.emplace(argc, argv);
    ui::set_up_language(*QCoreApplication::instance());
    catch_interrupts();
    report_crashes(crash_folder(), command.name);
    sweep_leftovers(work_folder());
    QStringList arguments;
    for (int i = 2; i < argc; ++i) arguments << QString::fromLocal8Bit(argv[i]);
    return run_told(command.name, [&] { return command.run(arguments); });
  }
  if (std::strcmp(first, "--help") == 0 || std::strcmp(first, "-h") == 0 || std::strcmp(first, "help") == 0) {
    QCoreApplication application(argc, argv);
    ui::set_up_language(application);
    print_usage();
    return 0;
  }
  if (std::strcmp(first, "--version") == 0) {
    std::puts("glisson " GLISSON_VERSION);
    return 0;
  }
  return open_window(argc, argv);
}

}  // namespace
}  // namespace glisson::app

int main(int argc, char** argv) {
  // FFmpeg's own words on a broken video, and VTK's on a broken mesh; ours name the file and the remedy.
  ::setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  glisson::app::provide_runtime_folder();
  try {
    return glisson::app::run(argc, argv);
  } catch (const glisson::app::UsageError& failure) {
    std::fprintf(stderr, "glisson: %s\n", failure.what());
    return glisson::app::kUsage;
  } catch (const glisson::app::Interrupted& stopped) {
    std::fprintf(stderr, "\nglisson: %s\n", stopped.what());
    return glisson::app::kCancelled;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "glisson: %s\n", glisson::sentence_of(failure, "start").c_str());
    return glisson::app::kFailed;
  }
}
