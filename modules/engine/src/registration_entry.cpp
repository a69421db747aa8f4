// SPDX-License-Identifier: GPL-3.0-or-later
#include "registration_entry.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "case_files.h"
#include "case_manifest.h"
#include "glisson/core/error.h"
#include "glisson/engine/case_io.h"

namespace glisson::engine {
namespace {
using nlohmann::json;

constexpr LengthUnit kUnit = LengthUnit::millimetre;

/// Cases of before hold its number.
Termination termination_of(const json& said, const CaseFolder& folder) {
  for (const auto& [termination, code] : kTerminations)
    if (said == code || (said.is_number_integer() && said == static_cast<int>(termination)))
      return termination;
  throw InputError((folder.path / kCaseFile).string(), "termination", "is " + said.dump(),
                   "Restore the case from a copy");
}

}  // namespace

json write_registration_entry(const CaseFolder& folder, const char* file, const model::BuiltModel& built,
                              const Registration& registration) {
  write_registration(folder.path / file, built.model, registration, kUnit);
  return {{"termination", termination_code(registration.termination)},
          {"plateaus", registration.plateaus},
          {"steps", registration.steps},
          {"residual_mm", 1e3 * registration.residual},
          {"seen_share", registration.seen_share},
          {"doubts", registration.doubts},
          {"notes", registration.notes}};
}

std::shared_ptr<const Registration> read_registration_entry(const CaseFolder& folder, const char* file,
                                                            const json& entry,
                                                            const model::BuiltModel* built) {
  if (built == nullptr)
    throw InputError((folder.path / kCaseFile).string(), "registration",
                     "there is no model that it belongs to", "Restore the case from a copy");
  Registration registration = read_registration(folder.path / file, built->model, kUnit);
  registration.termination = termination_of(entry.at("termination"), folder);
  registration.plateaus = entry.at("plateaus");
  registration.steps = entry.at("steps");
  registration.residual = 1e-3 * entry.at("residual_mm").get<double>();
  registration.seen_share = entry.value("seen_share", 0.0);  // cases of before have none
  registration.doubts = entry.at("doubts").get<std::vector<std::string>>();
  registration.notes = entry.value("notes", std::vector<std::string>());  // cases of before have none
  return std::make_shared<const Registration>(std::move(registration));
}

bool same_registration(const Registration& written, const Registration& read) {
  static constexpr double kClose = 1e-6;  // of numbers in files of their own unit, relative
  const auto close = [](const auto& a, const auto& b) {
    return a.rows() == b.rows() && (a.size() == 0 || a.isApprox(b, kClose) || (a - b).isZero(0.0));
  };
  const auto has_lesion = [&](const LesionSpread& a) {  // files hold them in another order
    return std::any_of(read.lesions.begin(), read.lesions.end(), [&](const LesionSpread& b) {
      return a.lesion == b.lesion && close(a.covariance, b.covariance);
    });
  };
  const auto same_fork = [&](const ForkSpread& a, const ForkSpread& b) {
    return a.tree == b.tree && a.order == b.order && close(a.centre, b.centre) &&
           close(a.covariance, b.covariance);
  };
  return same_points(written.nodes_in_camera, read.nodes_in_camera) &&
         written.termination == read.termination && written.doubts == read.doubts &&
         written.notes == read.notes && written.lesions.size() == read.lesions.size() &&
         std::all_of(written.lesions.begin(), written.lesions.end(), has_lesion) &&
         std::equal(written.forks.begin(), written.forks.end(), read.forks.begin(), read.forks.end(),
                    same_fork) &&
         close(written.expected, read.expected) && close(written.covariances, read.covariances) &&
         written.rivals.size() == read.rivals.size() && written.looks.size() == read.looks.size();
}

}  // namespace glisson::engine
