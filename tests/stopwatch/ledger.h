// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace glisson::stopwatch {

/// What a step of the work took.
struct Step {
  std::string name;
  double human = 0.0;    ///< s, by the model of human_times.h
  double program = 0.0;  ///< s, measured: from an act until the window has done it
  int clicks = 0;        ///< of the mouse
  int keys = 0;
  int notches = 0;             ///< of the wheel
  double longest_still = 0.0;  ///< s, in which the work went on and no sign of it moved
  std::string still_at = {};   ///< what the window then said
  double longest_deaf = 0.0;   ///< s, in which the window did not answer
};

/// Times and clicks, step by step, and what was awkward on the way.
class Ledger {
 public:
  /// All that follows belongs to it.
  void begin(const std::string& name);
  Step& now() { return steps_.back(); }
  const std::vector<Step>& steps() const { return steps_; }
  Step total() const;
  /// Something that a person stumbles over; told once, with how often it came.
  void finding(const std::string& sentence) { ++findings_[sentence]; }
  const std::map<std::string, int>& findings() const { return findings_; }
  /// A table in lines.
  std::string table() const;

 private:
  std::vector<Step> steps_;
  std::map<std::string, int> findings_;
};

}  // namespace glisson::stopwatch
