// SPDX-License-Identifier: GPL-3.0-or-later
#include "ledger.h"

#include <algorithm>
#include <cstdio>

namespace glisson::stopwatch {
namespace {

std::string line_of(const Step& step) {
  char text[200];
  std::snprintf(text, sizeof text, "%-26s %8.1f %9.1f %8.1f %7d %6d %8d %7.1f %6.1f\n", step.name.c_str(),
                step.human, step.program, step.human + step.program, step.clicks, step.keys, step.notches,
                step.longest_still, step.longest_deaf);
  return text;
}

}  // namespace

void Ledger::begin(const std::string& name) {
  steps_.emplace_back();
  steps_.back().name = name;
}

Step Ledger::total() const {
  Step total;
  total.name = "all";
  for (const Step& step : steps_) {
    total.human += step.human;
    total.program += step.program;
    total.clicks += step.clicks;
    total.keys += step.keys;
    total.notches += step.notches;
    total.longest_still = std::max(total.longest_still, step.longest_still);
    total.longest_deaf = std::max(total.longest_deaf, step.longest_deaf);
  }
  return total;
}

std::string Ledger::table() const {
  std::string text =
      "step                      person s  program s    both s  clicks   keys  notches   still   deaf\n";
  for (const Step& step : steps_) text += line_of(step);
  return text + line_of(total());
}

}  // namespace glisson::stopwatch
