// SPDX-License-Identifier: GPL-3.0-or-later
#include "demo_progress.h"

#include "demo_input.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/segment.h"

namespace glisson::experiments {
namespace {

using Plan = std::vector<std::pair<std::string, double>>;

/// A stage that is a command goes by the command's own code.
template <class C>
std::pair<std::string, double> stage(double seconds) {
  return {std::string(C().traits().code), seconds};
}

/// Seconds that the stages took on two cores at 3 GHz; only their ratios matter.
Plan plan_of(const DemoOptions& options) {
  Plan plan;
  switch (input_of(options)) {
    case DemoInput::synthetic:
      plan = {{"synthetic_patient", 12.0}, stage<engine::Segment>(20.0), stage<engine::BuildModel>(5.0)};
      break;
    case DemoInput::open_case:
      plan = {stage<engine::OpenCase>(4.0)};
      break;
    case DemoInput::labels:
      plan = {stage<engine::ImportLabels>(2.0), stage<engine::BuildModel>(5.0)};
      break;
    case DemoInput::surfaces:
      plan = {stage<engine::ImportSurfaces>(4.0)};
      break;
  }
  const double frames = options.theatre.frames;
  const Plan rest = {{"theatre", 8.0},
                     {"film", 0.2 * frames},
                     stage<engine::Register>(12.0),
                     stage<engine::Reconstruct>(0.6),
                     stage<engine::Register>(12.0),
                     {"track", 0.05 * frames},
                     stage<engine::SaveCase>(1.5)};
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
