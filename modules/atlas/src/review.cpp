// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/atlas/review.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "glisson/core/error.h"

namespace glisson::atlas {
namespace {

constexpr double kHandDeviation = 0.003;  // metres, of a point that a person placed
constexpr double kMoved = 0.0005;         // metres, from which on a point was moved
/// What follows a dragged point by less than this share of its way is still what it was.
constexpr double kCarried = 0.6;

constexpr double kSpacing = 0.004;     // metres, of the cava's points, as the model has them
constexpr Eigen::Index kLeastRun = 5;  // points of a margin
constexpr double kCertain = 0.012;     // metres, deviation up to which statistics alone say where it runs
constexpr double kBridged = 0.045;     // metres of a margin between what is shown that may be statistics

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
  if (is_area(proposal.structure)) return thinned(proposal.area);
  return proposal.structure == Structure::anterior_margin ? shown_margin(proposal) : proposal.points;
}

void move(Proposal& proposal, const Points& to) {
  proposal.follows.clear();
  const Eigen::Matrix3d by_hand = kHandDeviation * kHandDeviation * Eigen::Matrix3d::Identity();
  if (is_area(proposal.structure)) {
    if (to.rows() < 3)
      throw InputError("review", "moved", "has fewer than 3 points", "Give the points of the contact");
    proposal.area = to;
    proposal.points =
        (proposal.points.rowwise() - proposal.points.colwise().mean()).rowwise() + to.colwise().mean();
    for (Eigen::Index k = 0; k < proposal.points.rows(); ++k) {  // its course lies on the contact
      Eigen::Index closest = 0;
      (to.rowwise() - proposal.points.row(k)).rowwise().squaredNorm().minCoeff(&closest);
      proposal.points.row(k) = to.row(closest);
    }
    std::fill(proposal.sources.begin(), proposal.sources.end(), Source::person);
    std::fill(proposal.covariances.begin(), proposal.covariances.end(), by_hand);
  } else {
    if (to.rows() != proposal.points.rows())
      throw InputError("review", "moved", "has " + std::to_string(to.rows()) + " points",
                       "Give as many as are proposed: " + std::to_string(proposal.points.rows()));
    const Eigen::VectorXd way = (to - proposal.points).rowwise().norm();
    const double least = std::max(kMoved, kCarried * way.maxCoeff());
    for (Eigen::Index k = 0; k < to.rows(); ++k) {
      if (way[k] < least) continue;
      proposal.sources[static_cast<std::size_t>(k)] = Source::person;
      proposal.covariances[static_cast<std::size_t>(k)] = by_hand;
    }
    proposal.points = to;
  }
}

/// Standard deviation of a point across its course (of a single point: in any direction), metres; 0 where a
/// person has placed it or the image shows it.
double deviation_of(const Proposal& proposal, Eigen::Index k) {
  const auto i = static_cast<std::size_t>(k);
  if (proposal.sources[i] == Source::person || proposal.sources[i] == Source::image) return 0.0;
  const Eigen::Matrix3d& spread = proposal.covariances[i];
  if (proposal.points.rows() == 1) return std::sqrt(spread.trace() / 3.0);
  const Eigen::Index last = proposal.points.rows() - 1;
  const Eigen::Vector3d along =
      (proposal.points.row(std::min(k + 1, last)) - proposal.points.row(std::max<Eigen::Index>(k - 1, 0)))
          .transpose()
          .normalized();
  return std::sqrt(0.5 * std::max(0.0, spread.trace() - along.dot(spread * along)));
}

}  // namespace

Proposal reviewed(const Proposal& proposal, Decision decision, const PointsIn<CtFrame>& moved) {
  Proposal after = proposal;
  if (decision == Decision::moved) move(after, moved);
  after.decision = decision;
  return after;
}

PointsIn<CtFrame> landmark_left_by(const Proposal& proposal) {
  const bool is_used = proposal.decision == Decision::accepted || proposal.decision == Decision::moved;
  return is_used ? landmark_points(proposal) : Points(0, 3);
}

std::vector<std::optional<Source>> landmark_sources(const Proposal& proposal,
                                                    const PointsIn<CtFrame>& landmark) {
  constexpr double kSame = 1e-6;  // metres: files round
  std::vector<std::optional<Source>> sources(static_cast<std::size_t>(landmark.rows()));
  const Points left = landmark_left_by(proposal);
  if (left.rows() == 0) return sources;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const Eigen::RowVector3d p = landmark.row(static_cast<Eigen::Index>(i));
    if ((left.rowwise() - p).rowwise().norm().minCoeff() > kSame) continue;
    Eigen::Index at = 0;  // of a contact: the place of its course beside it, of which all are alike
    (proposal.points.rowwise() - p).rowwise().norm().minCoeff(&at);
    sources[i] = proposal.sources[static_cast<std::size_t>(at)];
  }
  return sources;
}

Eigen::VectorXd landmark_deviations(const Proposal& proposal, const PointsIn<CtFrame>& landmark) {
  constexpr double kSame = 1e-9;
  Eigen::VectorXd deviations = Eigen::VectorXd::Zero(landmark.rows());
  for (Eigen::Index k = 0; k < landmark.rows(); ++k) {
    Eigen::Index at = 0;
    if ((proposal.points.rowwise() - landmark.row(k)).rowwise().norm().minCoeff(&at) < kSame)
      deviations[k] = deviation_of(proposal, at);
  }
  return deviations;
}

}  // namespace glisson::atlas
