// SPDX-License-Identifier: GPL-3.0-or-later
#include "proposal_landmark.h"

#include <algorithm>
#include <vector>

namespace glisson::engine {
namespace {
using atlas::Decision;
using atlas::Proposal;
using atlas::Source;
using atlas::Structure;

constexpr double kSpacing = 0.004;     // metres, of the cava's points, as the model has them
constexpr Eigen::Index kLeastRun = 5;  // points of a margin
constexpr double kCertain = 0.012;     // metres, deviation up to which statistics alone say where it runs
constexpr double kBridged =
    0.045;  // metres of a margin's course that may be statistics between what is shown

/// Points of an area, none closer to another than kSpacing.
Points thinned(const Points& area) {
  std::vector<Eigen::RowVector3d> kept;
  for (Eigen::Index i = 0; i < area.rows(); ++i) {
    const Eigen::RowVector3d p = area.row(i);
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Eigen::RowVector3d& q) { return (p - q).norm() < kSpacing; }))
      kept.push_back(p);
  }
  Points points(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = kept[i];
  return points;
}

double length_of(const Points& line, Eigen::Index first, Eigen::Index last) {
  double length = 0.0;
  for (Eigen::Index k = first; k < last; ++k) length += (line.row(k + 1) - line.row(k)).norm();
  return length;
}

/// Which points of a margin are used: those that the CT or a person shows, those that the atlas is sure of,
/// and what lies between or beside these over a short way.
std::vector<char> used_points(const Proposal& margin) {
  const auto count = margin.points.rows();
  std::vector<char> used(static_cast<std::size_t>(count), 0);
  for (std::size_t k = 0; k < used.size(); ++k)
    used[k] = margin.sources[k] != Source::statistics || margin.covariances[k].trace() <= kCertain * kCertain;
  const std::vector<char> shown = used;
  for (Eigen::Index begin = 0; begin < count;) {
    Eigen::Index end = begin;
    while (end < count && shown[static_cast<std::size_t>(end)] == shown[static_cast<std::size_t>(begin)])
      ++end;
    const Eigen::Index first = std::max<Eigen::Index>(0, begin - 1), last = std::min(count - 1, end);
    const bool is_whole = begin == 0 && end == count;
    if (!is_whole && length_of(margin.points, first, last) <= kBridged)
      std::fill(used.begin() + begin, used.begin() + end, char{1});
    begin = end;
  }
  return used;
}

/// What registration may take for the margin: the longest piece that is used. None: too little is shown.
Points shown_margin(const Proposal& margin) {
  const std::vector<char> used = used_points(margin);
  Eigen::Index best = 0, count = 0, begin = 0;
  double longest = -1.0;
  for (Eigen::Index k = 0; k < margin.points.rows(); ++k) {
    if (used[static_cast<std::size_t>(k)] == 0) {
      begin = k + 1;
      continue;
    }
    const double length = length_of(margin.points, begin, k);
    if (length <= longest) continue;
    longest = length;
    count = k + 1 - begin;
    best = begin;
  }
  return count < kLeastRun ? Points(0, 3) : Points(margin.points.middleRows(best, count));
}

/// Of one that is used.
Points landmark_points(const Proposal& proposal) {
  if (atlas::is_area(proposal.structure)) return thinned(proposal.area);
  return proposal.structure == Structure::anterior_margin ? shown_margin(proposal) : proposal.points;
}

}  // namespace

Points landmark_left_by(const Proposal& proposal) {
  const bool is_used = proposal.decision == Decision::accepted || proposal.decision == Decision::moved;
  return is_used ? landmark_points(proposal) : Points(0, 3);
}

}  // namespace glisson::engine
