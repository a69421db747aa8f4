// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/atlas/transfer.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "mirrored.h"
#include "note.h"
#include "statistics.h"

namespace glisson::atlas {
namespace {

constexpr double kReach = 0.02;       // metres, of a point's surroundings
constexpr double kGoodFit = 0.0015;   // metres, mean distance between the surfaces
constexpr double kMuchTurned = 45.0;  // degrees
/// Over the deviations, where the liver may be another than it is taken for: a place on its other side, or on
/// a part that is not there, lies about twice as far as the statistics reach.
constexpr double kPerhapsElsewhere = 2.0;
constexpr double kMostLacking = 0.75;  // share of the surface up to which it counts
constexpr double kManyFolded = 0.02;   // share of the triangles

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
    out.basis.upright = upright_;
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

  /// Where it lies by statistics alone, and what others tell of it.
  void foretell(const StructureStatistics& statistics, TransferBasis& basis) const {
    Proposal proposal;
    proposal.structure = statistics.structure;
    proposal.members = statistics.livers();
    proposal.origin = statistics.origin;
    const Eigen::VectorXd modes = out_.modes.cwiseMin(3.0).cwiseMax(-3.0);
    const Points on_mean = predicted(statistics, modes);
    proposal.points = points_at(places_of(mean_, on_mean, size_), there_, size_of(there_.vertices));
    std::vector<CarriedDependence> depends;
    for (const Dependence& one : statistics.depends)
      depends.push_back({statistics.structure, one.on, one.point, {}, {}});
    for (Eigen::Index k = 0; k < on_mean.rows(); ++k) {
      const Eigen::Matrix3d map = unsqueezed(
          local_map(mean_.vertices, there_.vertices, on_mean.row(k).transpose(), kReach, overall_));
      const auto carried = [&](const Eigen::Matrix3d& spread) -> Eigen::Matrix3d {
        return fit_growth_ * fit_growth_ * map * spread * map.transpose();
      };
      const int point = static_cast<int>(k);
      proposal.covariances.push_back(carried(covariance(statistics, point, -1, growth_)));
      proposal.sources.push_back(Source::statistics);
      for (std::size_t i = 0; i < depends.size(); ++i) {
        const Dependence& one = statistics.depends[i];
        // What is near each other is carried alike: sizes and bends cancel.
        depends[i].gains.push_back(upright_.transpose() * one.gains[static_cast<std::size_t>(k)] * upright_);
        depends[i].covariances.push_back(carried(covariance(statistics, one, point, growth_)));
      }
    }
    if (statistics.share.size() == there_.vertices.rows()) {
      const std::vector<int> area = area_vertices(statistics.share);
      proposal.area.resize(static_cast<Eigen::Index>(area.size()), 3);
      for (std::size_t i = 0; i < area.size(); ++i)
        proposal.area.row(static_cast<Eigen::Index>(i)) = there_.vertices.row(area[i]);
    }
    if (is_area(statistics.structure) && proposal.area.rows() == 0) proposal.area = proposal.points;
    basis.foretold.push_back(std::move(proposal));
    std::ranges::move(depends, std::back_inserter(basis.dependences));
  }

 private:
  void doubt(const Correspondence& found, Handedness side, double lacking) {
    std::vector<std::string>& doubts = out_.basis.doubts;
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

Cancellable<Transfer> transfer(const Atlas& atlas, const TriangleMesh& liver, const Evidence& evidence,
                               const RunContext& context) {
  const PreparedLiver prepared = prepare(liver, "model");
  const auto found = correspond(atlas.shape, atlas.triangles, prepared.mesh, context.part(0.0, 0.95));
  if (!found) return {};
  const auto side = handedness(atlas.shape, atlas.triangles, prepared.mesh, *found, context.quiet());
  if (!side) return {};
  if (*side == Handedness::mirrored) refuse_mirrored("model");
  Transfer bare;
  bare.atlas = atlas.name;
  bare.basis.doubts = prepared.doubts;
  // In a liver that may be mirrored, or is not whole, nothing says which branch is the left one.
  bare.basis.sides_known = *side == Handedness::right;
  const Placed placed(atlas, *found, *side, prepared.lacking, bare);
  for (const StructureStatistics& statistics : atlas.structures) placed.foretell(statistics, bare.basis);
  Transfer result = told(bare, liver, evidence);
  context.progress(1.0, "atlas.fit");
  return result;
}

}  // namespace glisson::atlas
