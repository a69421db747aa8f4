// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <type_traits>

#include "case_manifest.h"
#include "glisson/core/error.h"

namespace glisson::engine {

/// Revisions are numbers of case.json, and those are read as doubles, which count so far.
inline constexpr double kMostRevisions = 9007199254740992.0;

/// A number of case.json between its bounds: a larger one would wrap, and mean something else.
/// @throws InputError it is missing, no number, not whole where it must be, or out of range.
template <class Number>
Number ranged(const std::filesystem::path& folder, const nlohmann::json& entry, const char* field,
              double least, double most) {
  const std::string file = (folder / kCaseFile).string();
  const auto found = entry.find(field);
  if (found == entry.end() || !found->is_number())
    throw InputError(file, field, "is no number", "Restore the case from a copy");
  const auto value = found->template get<double>();
  const bool is_whole = !std::is_integral_v<Number> || found->is_number_integer();
  if (is_whole && value >= least && value <= most) return found->template get<Number>();
  std::ostringstream problem;
  problem << "is " << found->dump() << ", not between " << least << " and " << most;
  throw InputError(file, field, problem.str(), "Restore the case from a copy");
}

}  // namespace glisson::engine
