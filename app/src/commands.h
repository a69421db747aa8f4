// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <vector>

/// @file
/// The sub-commands. Each takes what follows its name and returns the exit code: see exit_code.h.
/// Errors are thrown; main prints them.

namespace glisson::app {

int run_atlas(const QStringList& arguments);
int run_demo(const QStringList& arguments);
int run_import(const QStringList& arguments);
int run_segment(const QStringList& arguments);
int run_edit(const QStringList& arguments);
int run_model(const QStringList& arguments);
int run_calibrate(const QStringList& arguments);
int run_check(const QStringList& arguments);
int run_reconstruct(const QStringList& arguments);
int run_register(const QStringList& arguments);
int run_track(const QStringList& arguments);
int run_render(const QStringList& arguments);
int run_overlay(const QStringList& arguments);
int run_moments(const QStringList& arguments);
int run_doctor(const QStringList& arguments);
int run_soak(const QStringList& arguments);
int run_prove(const QStringList& arguments);
int run_figure(const QStringList& arguments);
int run_simulate(const QStringList& arguments);
/// Opens the window, with what the program's own first argument names, if anything. @throws UsageError no
/// display.
int run_window(int argc, char** argv);

struct SubCommand {
  const char* name;
  int (*run)(const QStringList&);
  bool draws;               ///< needs fonts
  const char* description;  ///< to be translated
};
const std::vector<SubCommand>& sub_commands();

}  // namespace glisson::app
