// SPDX-License-Identifier: GPL-3.0-or-later
#include "demo_progress.h"

#include "demo_input.h"

namespace glisson::experiments {
namespace {

using Plan = std::vector<std::pair<std::string, double>>;

/// Seconds that the stages took on two cores at 3 GHz; only their ratios matter.
Plan plan_of(const DemoOptions& options) {
  Plan plan;
  switch (input_of(options)) {
    case DemoInput::synthetic:
      plan = {{"synthetic_patient", 12.0}, {"segment", 20.0}, {"build_model", 5.0}};
      break;
    case DemoInput::open_case:
      plan = {{"open_case", 4.0}};
      break;
    case DemoInput::labels:
      plan = {{"import_labels", 2.0}, {"build_model", 5.0}};
      break;
    case DemoInput::surfaces:
      plan = {{"import_surfaces", 4.0}};
      break;
  }
  const double frames = options.theatre.frames;
  const Plan rest = {{"theatre", 8.0},   {"film", 0.2 * frames},   {"register", 12.0}, {"reconstruct", 0.6},
                     {"register", 12.0}, {"track", 0.05 * frames}, {"save_case", 1.5}};
  plan.insert(plan.end(), rest.begin(), rest.end());
  return plan;
}

}  // namespace

DemoProgress::DemoProgress(const DemoOptions& options, const RunContext& context)
    : context_(context), plan_(plan_of(options)) {
  for (const auto& [stage, seconds] : plan_) total_ += seconds;
}

RunContext DemoProgress::begin(const std::string& stage) {
  double begin = done_;
  for (std::size_t i = next_; i < plan_.size(); ++i) {
    const double end = begin + plan_[i].second;
    if (plan_[i].first == stage) {
      next_ = i + 1;
      done_ = end;
      return context_.part(begin / total_, end / total_);
    }
    begin = end;
  }
  return context_.part(done_ / total_, done_ / total_);
}

}  // namespace glisson::experiments
