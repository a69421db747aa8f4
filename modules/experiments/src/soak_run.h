// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "glisson/core/json_file.h"

/// @file
/// What a process uses must not grow with its work.

namespace glisson::experiments {

/// What a process uses at one moment.
struct Usage {
  double memory_mb = 0.0;  ///< resident
  double descriptors = 0.0, threads = 0.0;
};
/// Of this process now (Linux: /proc/self).
Usage usage_now();

/// One kind of work, over and over, with samples of what the process uses.
class SoakRun {
 public:
  /// @param a_day how often it is done on a day of much work. @param measure what is used now.
  /// @pre times >= 0, a_day > 0
  SoakRun(std::string name, int times, double a_day, std::function<Usage()> measure = usage_now);

  /// Does it, numbered from 0. @return false: `once` said so, since it was cancelled; what was done before
  /// is kept.
  bool work(const std::function<bool(int)>& once);

  bool is_empty() const { return samples_.empty(); }
  /// The first quarter fills what is kept for later use: the second is compared with the last. Memory may
  /// grow by 24 MB or 3 %, descriptors and threads not at all.
  bool is_flat() const;
  /// A run that would not have shown a leak which fills 2 GB in a day says nothing.
  bool is_long_enough() const { return shows_kb() <= bearable_kb(); }
  /// `soak_NAME` and `soak_NAME_...`.
  Figures figures() const;
  static std::string table_head();
  /// The same as a row of Markdown.
  std::string row() const;

 private:
  double mean(double Usage::*kind, std::size_t quarter) const;
  double early(double Usage::*kind) const { return mean(kind, 1); }
  double late(double Usage::*kind) const { return mean(kind, 3); }
  double most(double Usage::*kind) const;
  double allowed_mb() const;
  double shows_kb() const;
  double bearable_kb() const;

  std::string name_;
  int times_, done_ = 0;
  double a_day_;
  std::function<Usage()> measure_;
  double seconds_ = 0.0;
  std::vector<Usage> samples_;
};

}  // namespace glisson::experiments
