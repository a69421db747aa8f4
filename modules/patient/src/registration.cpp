// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/patient/registration.h"

#include <charconv>

#include "glisson/patient/label_map.h"

namespace glisson {
namespace {

const std::string kFork = "_fork_";

}  // namespace

Eigen::Matrix<double, 1, 6> symmetric_row(const Eigen::Matrix3d& m) {
  Eigen::Matrix<double, 1, 6> row;
  row << m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(0, 2);
  return row;
}

Eigen::Matrix3d symmetric_matrix(const Eigen::Matrix<double, 1, 6>& row) {
  Eigen::Matrix3d m;
  m << row[0], row[3], row[5], row[3], row[1], row[4], row[5], row[4], row[2];
  return m;
}

std::string fork_name(const ForkSpread& fork) {
  return structure_name(fork.tree) + kFork + std::to_string(fork.order);
}

std::optional<std::pair<Label, int>> fork_named(const std::string& name) {
  const std::size_t at = name.find(kFork);
  if (at == std::string::npos) return {};
  const auto tree = structure_named(name.substr(0, at));
  const std::string number = name.substr(at + kFork.size());
  int order = 0;
  const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), order);
  if (!tree || failure != std::errc() || end != number.data() + number.size() || order < 1) return {};
  return std::pair(*tree, order);
}

const char* validity_code(Validity validity) {
  switch (validity) {
    case Validity::valid:
      return "valid";
    case Validity::not_started:
      return "not_started";
    case Validity::too_few_points:
      return "too_few_points";
    case Validity::inconsistent_motion:
      return "inconsistent_motion";
    case Validity::residual_too_large:
      return "residual_too_large";
    case Validity::mechanics_failed:
      return "mechanics_failed";
    case Validity::stale:
      return "stale";
    case Validity::surface_apart:
      return "surface_apart";
    case Validity::picture_stands:
      return "picture_stands";
    case Validity::views_apart:
      return "views_apart";
    case Validity::partly_covered:
      return "partly_covered";
    case Validity::poor_picture:
      return "poor_picture";
    case Validity::picture_still:
      return "picture_still";
    case Validity::proposed:
      return "proposed";
    case Validity::mostly_masked:
      return "mostly_masked";
    case Validity::masked_out:
      return "masked_out";
    case Validity::view_lost:
      return "view_lost";
    case Validity::views_swapped:
      return "views_swapped";
    case Validity::picture_lost:
      return "picture_lost";
  }
  return "unknown";
}

Level level_of(Validity validity) {
  if (validity == Validity::valid) return Level::valid;
  const bool is_degraded = validity == Validity::partly_covered || validity == Validity::poor_picture ||
                           validity == Validity::picture_still || validity == Validity::proposed ||
                           validity == Validity::mostly_masked;
  return is_degraded ? Level::degraded : Level::withdrawn;
}

bool is_followed(Validity validity) {
  switch (validity) {
    case Validity::not_started:
    case Validity::too_few_points:
    case Validity::masked_out:
    case Validity::view_lost:
    case Validity::views_swapped:
    case Validity::picture_lost:
    case Validity::inconsistent_motion:
    case Validity::mechanics_failed:
      return false;
    default:
      return true;
  }
}

}  // namespace glisson
