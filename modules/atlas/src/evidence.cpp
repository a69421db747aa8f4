// SPDX-License-Identifier: GPL-3.0-or-later
// What a person has placed and what the image shows take the place of the statistics.
#include <Eigen/LU>
#include <algorithm>
#include <iterator>

#include "follow.h"
#include "glisson/atlas/review.h"
#include "glisson/atlas/transfer.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/patient/label_map.h"
#include "note.h"

namespace glisson::atlas {
namespace {

constexpr double kImageDeviation = 0.002;  // metres, of what the image shows
constexpr double kHandDeviation = 0.003;   // metres, of what a person has placed
constexpr Eigen::Index kLeastMarks = 3;    // points of a contact
constexpr double kContradiction = 30.0;    // squared Mahalanobis distance: once in a million

/// What is known of this patient stands in place of the statistics.
void put(Proposal& proposal, const Points& course, const Points& raw, Source source, double deviation) {
  proposal.points = course;
  std::fill(proposal.covariances.begin(), proposal.covariances.end(),
            Eigen::Matrix3d(deviation * deviation * Eigen::Matrix3d::Identity()));
  std::fill(proposal.sources.begin(), proposal.sources.end(), source);
  if (is_area(proposal.structure)) proposal.area = raw;
}

/// What a person has placed. Of a contact of which too little is known for its course, the course that was
/// foretold goes along. False: it says nothing.
bool take_marks(Proposal& proposal, const Evidence& evidence, const Eigen::Matrix3d& upright) {
  const auto marks = evidence.placed.find(proposal.structure);
  if (marks == evidence.placed.end() || marks->second.rows() == 0) return false;
  const Points course = ordered_points(proposal.structure, marks->second, upright, Points(0, 3));
  if (course.rows() > 0) {
    put(proposal, course, marks->second, Source::person, kHandDeviation);
  } else {
    if (!is_area(proposal.structure) || marks->second.rows() < kLeastMarks) return false;
    proposal = reviewed(proposal, Decision::moved, marks->second);
    proposal.decision = Decision::proposed;
  }
  return true;
}

/// What the image shows; a contradiction between it and the statistics is said.
void show(Proposal& proposal, const Points& seen, const Points& raw, std::vector<std::string>& doubts) {
  double worst = 0.0, apart = 0.0;
  for (Eigen::Index k = 0; k < seen.rows(); ++k) {
    const Eigen::Vector3d off = (seen.row(k) - proposal.points.row(k)).transpose();
    const double squared = off.dot(proposal.covariances[static_cast<std::size_t>(k)].inverse() * off);
    if (squared <= worst) continue;
    worst = squared;
    apart = off.norm();
  }
  if (worst > kContradiction)
    doubts.push_back(
        note(std::string("atlas.contradiction ") + structure_code(proposal.structure), 1e3 * apart, 0));
  put(proposal, seen, raw, Source::image, kImageDeviation);
}

/// What is known of this patient: by a person, else by the image.
void know(Proposal& proposal, const Evidence& evidence, const Eigen::Matrix3d& upright,
          std::vector<std::string>& doubts) {
  if (take_marks(proposal, evidence, upright)) return;
  const auto raw = evidence.found.find(proposal.structure);
  if (raw == evidence.found.end()) return;
  const Points seen = ordered_points(proposal.structure, raw->second, upright, Points(0, 3));
  if (seen.rows() > 0) show(proposal, seen, raw->second, doubts);
}

}  // namespace

Evidence courses_of(const PatientModel& model) {
  Evidence evidence;
  evidence.ridge = model.landmarks.anterior_margin;
  std::ranges::copy_if(model.vessels, std::back_inserter(evidence.portal_vein), [](const VesselTree& tree) {
    return tree.structure == glisson::structure::kPortalVein;
  });
  return evidence;
}

Evidence evidence_of(const PatientModel& model) {
  Evidence evidence = courses_of(model);
  Landmarks shown;
  shown.vena_cava = model.landmarks.vena_cava;
  evidence.found = member_of("model", model, shown).structures;
  return evidence;
}

Transfer told(const Transfer& bare, const TriangleMesh& liver, const Evidence& evidence) {
  Transfer made = bare;
  made.proposals = made.basis.foretold;
  const ClosestPointTree tree(prepare(liver, "model").mesh);
  for (Proposal& proposal : made.proposals) {
    know(proposal, evidence, made.basis.upright, made.basis.doubts);
    onto_liver(proposal, tree);
  }
  propose_again(made, tree, evidence);
  return made;
}

}  // namespace glisson::atlas
