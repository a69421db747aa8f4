// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/atlas/transfer.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "fissure.h"
#include "glisson/atlas/review.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/patient/label_map.h"
#include "mirrored.h"
#include "note.h"
#include "statistics.h"

namespace glisson::atlas {
namespace {

constexpr double kImageDeviation = 0.002;  // metres, of what the image shows
constexpr double kHandDeviation = 0.003;   // metres, of what a person has placed
constexpr Eigen::Index kLeastMarks = 3;    // points of a contact
constexpr double kRidgeDeviation = 0.002;  // metres, of the ridge across its course
constexpr double kReach = 0.02;            // metres, of a point's surroundings
constexpr double kGoodFit = 0.0015;        // metres, mean distance between the surfaces
constexpr double kMuchTurned = 45.0;       // degrees
/// Over the deviations, where the liver may be another than it is taken for: a place on its other side, or on
/// a part that is not there, lies about twice as far as the statistics reach.
constexpr double kPerhapsElsewhere = 2.0;
constexpr double kMostLacking = 0.75;    // share of the surface up to which it counts
constexpr double kManyFolded = 0.02;     // share of the triangles
constexpr double kContradiction = 30.0;  // squared Mahalanobis distance: once in a million

/// The atlas on one liver.
class Placed {
 public:
  /// @param lacking share of the liver's surface that is not there
  Placed(const Atlas& atlas, const Correspondence& found, Handedness side, double lacking, Transfer& out)
      : atlas_(atlas),
        there_{found.vertices, atlas.triangles},
        mean_(atlas.mean()),
        size_(size_of(mean_.vertices)),
        upright_(found.from_start.rotation.transpose()),
        out_(out) {
    const Similarity onto = fit_similarity(mean_.vertices, there_.vertices);
    overall_ = onto.scale * onto.rotation;
    overall_scale_ = onto.scale;
    const Points shape = onto.inverse().apply(there_.vertices);
    out.surface = found.vertices;
    out.mean_distance = found.mean_distance;
    out.max_distance = found.max_distance;
    out.modes = atlas.shape.coefficients(shape).cwiseQuotient(atlas.shape.variances.cwiseSqrt());
    out.unusual = unusual(atlas.shape, shape) / std::max(1e-9, atlas.usual);
    doubt(found, side, lacking);
  }

  Proposal propose(const StructureStatistics& statistics) const {
    Proposal proposal;
    proposal.structure = statistics.structure;
    proposal.members = statistics.livers();
    proposal.origin = statistics.origin;
    const Eigen::VectorXd modes = out_.modes.cwiseMin(3.0).cwiseMax(-3.0);
    const Points on_mean = predicted(statistics, modes);
    proposal.points = points_at(places_of(mean_, on_mean, size_), there_, size_of(there_.vertices));
    for (Eigen::Index k = 0; k < on_mean.rows(); ++k) {
      const Eigen::Matrix3d map = unsqueezed(
          local_map(mean_.vertices, there_.vertices, on_mean.row(k).transpose(), kReach, overall_));
      const Eigen::Matrix3d spread = covariance(statistics, static_cast<int>(k), -1, growth_);
      proposal.covariances.push_back(fit_growth_ * fit_growth_ * map * spread * map.transpose());
      proposal.sources.push_back(Source::statistics);
    }
    if (statistics.share.size() == there_.vertices.rows()) {
      const std::vector<int> area = area_vertices(statistics.share);
      proposal.area.resize(static_cast<Eigen::Index>(area.size()), 3);
      for (std::size_t i = 0; i < area.size(); ++i)
        proposal.area.row(static_cast<Eigen::Index>(i)) = there_.vertices.row(area[i]);
    }
    if (is_area(statistics.structure) && proposal.area.rows() == 0) proposal.area = proposal.points;
    return proposal;
  }

  const Eigen::Matrix3d& upright() const { return upright_; }

 private:
  void doubt(const Correspondence& found, Handedness side, double lacking) {
    std::vector<std::string>& doubts = out_.doubts;
    growth_ = std::max(1.0, out_.unusual);
    if (out_.unusual > 1.0) doubts.push_back(note("atlas.unusual_shape", out_.unusual, 2));
    const double size = (std::log(size_of(there_.vertices)) - atlas_.log_size) / atlas_.log_size_deviation;
    if (std::abs(size) > 3.0) {
      doubts.push_back(note("atlas.unusual_size", size, 1));
      growth_ = std::max(growth_, std::abs(size) / 3.0);
    }
    if (found.mean_distance > kGoodFit) {
      doubts.push_back(note("atlas.poor_fit", 1e3 * found.mean_distance, 1));
      fit_growth_ *= found.mean_distance / kGoodFit;
    }
    const double folded = static_cast<double>(found.folded) / static_cast<double>(atlas_.triangles.rows());
    if (folded > kManyFolded) {
      doubts.push_back(note("atlas.folded", 100.0 * folded, 0));
      fit_growth_ *= std::sqrt(folded / kManyFolded);
    }
    if (side == Handedness::uncertain) doubts.emplace_back("atlas.perhaps_mirrored");
    if (side == Handedness::no_liver) doubts.emplace_back("atlas.no_whole_liver");
    if (side != Handedness::right) fit_growth_ *= kPerhapsElsewhere;
    if (found.turned_deg > kMuchTurned) {
      doubts.push_back(note("atlas.turned", found.turned_deg, 0));
      fit_growth_ *= found.turned_deg / kMuchTurned;
    }
    fit_growth_ /= 1.0 - std::min(kMostLacking, lacking);
  }

  /// What disease or a surgeon has squeezed is no better known for it: of a shape that is more unusual than
  /// the members' no direction is narrower than on the mean liver.
  Eigen::Matrix3d unsqueezed(const Eigen::Matrix3d& map) const {
    if (growth_ <= 1.0) return map;
    const double least = std::max(1.0, overall_scale_);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return svd.matrixU() * svd.singularValues().cwiseMax(least).asDiagonal() * svd.matrixV().transpose();
  }

  const Atlas& atlas_;
  TriangleMesh there_, mean_;
  double size_;
  double growth_ = 1.0;  ///< of deviations, by what is unusual of the shape
  double overall_scale_ = 1.0;
  double fit_growth_ = 1.0;  ///< of all, by what is wrong with the correspondence
  Eigen::Matrix3d upright_, overall_;
  Transfer& out_;
};

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

/// Draws the points of the margin onto the ridge where it passes within their ellipsoids: across its course
/// the ridge is right, along it the statistics are.
void draw_to_ridge(Proposal& margin, const Points& ridge) {
  if (ridge.rows() < 3) return;
  const Points fine = resampled(ridge, static_cast<int>(std::max<Eigen::Index>(200, 2 * ridge.rows())));
  for (Eigen::Index k = 0; k < margin.points.rows(); ++k) {
    Eigen::Matrix3d& spread = margin.covariances[static_cast<std::size_t>(k)];
    const Eigen::Matrix3d precision = spread.inverse();
    const Eigen::Vector3d p = margin.points.row(k);
    double least = kEllipsoid95;
    Eigen::Index at = -1;
    for (Eigen::Index i = 1; i + 1 < fine.rows(); ++i) {
      const Eigen::Vector3d off = fine.row(i).transpose() - p;
      const double squared = off.dot(precision * off);
      if (squared >= least) continue;
      least = squared;
      at = i;
    }
    if (at <= 1 || at + 2 >= fine.rows()) continue;  // none, or beyond the ridge's ends
    const Eigen::Vector3d along = (fine.row(at + 1) - fine.row(at - 1)).transpose().normalized();
    const Eigen::Matrix3d across =
        (Eigen::Matrix3d::Identity() - along * along.transpose()) / (kRidgeDeviation * kRidgeDeviation);
    const Eigen::Matrix3d fused = (precision + across).inverse();
    margin.points.row(k) = (fused * (precision * p + across * fine.row(at).transpose())).transpose();
    spread = fused;
    margin.sources[static_cast<std::size_t>(k)] = Source::both;
  }
}

/// What is known of this patient: by a person, else by the image, else by the ridge.
void know(Proposal& proposal, const Evidence& evidence, const Eigen::Matrix3d& upright,
          std::vector<std::string>& doubts) {
  if (take_marks(proposal, evidence, upright)) return;
  const auto raw = evidence.found.find(proposal.structure);
  const Points seen = raw == evidence.found.end()
                          ? Points(0, 3)
                          : ordered_points(proposal.structure, raw->second, upright, Points(0, 3));
  if (seen.rows() > 0)
    show(proposal, seen, raw->second, doubts);
  else if (proposal.structure == Structure::anterior_margin)
    draw_to_ridge(proposal, evidence.ridge);
}

void onto_liver(Proposal& proposal, const ClosestPointTree& tree) {
  for (Eigen::Index k = 0; k < proposal.points.rows(); ++k)
    proposal.points.row(k) = tree.closest(proposal.points.row(k).transpose()).point.transpose();
}

}  // namespace

const char* source_code(Source source) {
  constexpr std::array kCodes = {"statistics", "image", "both", "person"};
  return kCodes[static_cast<std::size_t>(source)];
}

const char* decision_code(Decision decision) {
  constexpr std::array kCodes = {"proposed", "accepted", "moved", "not_visible"};
  return kCodes[static_cast<std::size_t>(decision)];
}

double Proposal::deviation() const {
  double sum = 0.0;
  for (const Eigen::Matrix3d& spread : covariances) sum += spread.trace();
  return covariances.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(covariances.size()));
}

Source Proposal::source() const {
  std::array<long, 4> counts{};
  for (const Source one : sources) ++counts[static_cast<std::size_t>(one)];
  return static_cast<Source>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

Evidence evidence_of(const PatientModel& model) {
  Evidence evidence;
  evidence.ridge = model.landmarks.anterior_margin;
  Landmarks shown;
  shown.vena_cava = model.landmarks.vena_cava;
  evidence.found = member_of("model", model, shown).structures;
  std::ranges::copy_if(model.vessels, std::back_inserter(evidence.portal_vein), [](const VesselTree& tree) {
    return tree.structure == glisson::structure::kPortalVein;
  });
  return evidence;
}

Cancellable<Transfer> transfer(const Atlas& atlas, const TriangleMesh& liver, const Evidence& evidence,
                               const RunContext& context) {
  const PreparedLiver prepared = prepare(liver, "model");
  const auto found = correspond(atlas.shape, atlas.triangles, prepared.mesh, context.part(0.0, 0.95));
  if (!found) return {};
  const auto side = handedness(atlas.shape, atlas.triangles, prepared.mesh, *found, context.quiet());
  if (!side) return {};
  if (*side == Handedness::mirrored) refuse_mirrored("model");
  Transfer result;
  result.atlas = atlas.name;
  result.doubts = prepared.doubts;
  const Placed placed(atlas, *found, *side, prepared.lacking, result);
  const ClosestPointTree tree(prepared.mesh);
  for (const StructureStatistics& statistics : atlas.structures)
    result.proposals.push_back(placed.propose(statistics));
  const std::vector<Proposal> foretold = result.proposals;
  for (Proposal& proposal : result.proposals) know(proposal, evidence, placed.upright(), result.doubts);
  // In a liver that may be mirrored, or is not whole, nothing says which branch is the left one.
  if (*side == Handedness::right)
    draw_to_fissure(result.proposals, foretold, evidence.portal_vein, placed.upright(), result.doubts);
  for (Proposal& proposal : result.proposals) onto_liver(proposal, tree);
  context.progress(1.0, "atlas.fit");
  return result;
}

}  // namespace glisson::atlas
