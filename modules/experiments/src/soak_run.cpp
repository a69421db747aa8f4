// SPDX-License-Identifier: GPL-3.0-or-later
#include "soak_run.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <utility>

#include "glisson/core/error.h"
#include "glisson/core/stopwatch.h"

namespace glisson::experiments {
namespace {

constexpr int kSamples = 60;
/// Memory that the allocator keeps from one moment to the next is no leak; what grows by more is one.
constexpr double kGrowthMb = 24.0, kGrowthShare = 0.03;
/// What a day's work may take before a computer is short of memory.
constexpr double kDayMb = 2000.0;

std::string number(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

}  // namespace

Usage usage_now() {
  Usage usage;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double value = 0.0;
    if (word == "VmRSS:" && status >> value) usage.memory_mb = value / 1024.0;
    if (word == "Threads:" && status >> value) usage.threads = value;
  }
  std::error_code ignored;
  for (auto entry = std::filesystem::directory_iterator("/proc/self/fd", ignored);
       entry != std::filesystem::directory_iterator(); entry.increment(ignored))
    usage.descriptors += 1.0;
  return usage;
}

SoakRun::SoakRun(std::string name, int times, double a_day, std::function<Usage()> measure)
    : name_(std::move(name)), times_(times), a_day_(a_day), measure_(std::move(measure)) {
  require(times >= 0 && a_day > 0.0, "work is done some times, and on some days");
}

bool SoakRun::work(const std::function<bool(int)>& once) {
  const int every = std::max(1, times_ / kSamples);
  const Stopwatch watch;
  bool goes_on = true;
  for (done_ = 0; done_ < times_ && (goes_on = once(done_));)
    if (++done_ % every == 0) samples_.push_back(measure_());
  seconds_ = watch.seconds();
  return goes_on;
}

double SoakRun::mean(double Usage::*kind, std::size_t quarter) const {
  const std::size_t from = samples_.size() * quarter / 4, to = samples_.size() * (quarter + 1) / 4;
  double sum = 0.0;
  for (std::size_t n = from; n < to; ++n) sum += samples_[n].*kind;
  return sum / static_cast<double>(std::max<std::size_t>(1, to - from));
}

double SoakRun::most(double Usage::*kind) const {
  double most = 0.0;
  for (const Usage& sample : samples_) most = std::max(most, sample.*kind);
  return most;
}

double SoakRun::allowed_mb() const { return std::max(kGrowthMb, kGrowthShare * early(&Usage::memory_mb)); }
/// The smallest leak that this run shows, kB each time: half of it lies between the two quarters.
double SoakRun::shows_kb() const { return 1e3 * allowed_mb() / (0.5 * std::max(1, done_)); }
/// What one more time may cost if a day's work is to fit.
double SoakRun::bearable_kb() const { return 1e3 * kDayMb / a_day_; }

bool SoakRun::is_flat() const {
  return is_long_enough() && late(&Usage::memory_mb) - early(&Usage::memory_mb) < allowed_mb() &&
         late(&Usage::descriptors) < early(&Usage::descriptors) + 1.0 &&
         late(&Usage::threads) < early(&Usage::threads) + 1.0;
}

Figures SoakRun::figures() const {
  const std::string key = "soak_" + name_;
  return {{key, done_},
          {key + "_seconds", seconds_},
          {key + "_growth_mb", late(&Usage::memory_mb) - early(&Usage::memory_mb)},
          {key + "_shows_kb", shows_kb()},
          {key + "_long_enough", is_long_enough() ? 1.0 : 0.0},
          {key + "_flat", is_flat() ? 1.0 : 0.0}};
}

std::string SoakRun::table_head() {
  return "| work | times | s | memory early, MB | late, MB | most, MB | descriptors | threads | hides, kB | "
         "flat |\n|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string SoakRun::row() const {
  std::string row = "| " + name_ + " | " + std::to_string(done_) +
                    (done_ == times_ ? "" : " of " + std::to_string(times_)) + " | " + number(seconds_, 0) +
                    " | ";
  row += number(early(&Usage::memory_mb), 0) + " | " + number(late(&Usage::memory_mb), 0) + " | " +
         number(most(&Usage::memory_mb), 0) + " | ";
  row += number(early(&Usage::descriptors), 1) + " -> " + number(late(&Usage::descriptors), 1) + " | ";
  row += number(early(&Usage::threads), 1) + " -> " + number(late(&Usage::threads), 1) + " | ";
  row += number(shows_kb(), 1) + " of " + number(bearable_kb(), 1) + " | ";
  return row + (!is_long_enough() ? "too short to say" : is_flat() ? "yes" : "**no**") + " |\n";
}

}  // namespace glisson::experiments
