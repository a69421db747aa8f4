// SPDX-License-Identifier: GPL-3.0-or-later
// What nobody has placed follows what is known of the others, by the joint covariance of the two.
#include "follow.h"

#include <Eigen/LU>
#include <algorithm>
#include <functional>
#include <optional>

#include "fissure.h"

namespace glisson::atlas {
namespace {

constexpr double kRidgeDeviation = 0.002;  // metres, of the ridge across its course

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

bool is_from(const Proposal& proposal, Source source) {
  return std::ranges::find(proposal.sources, source) != proposal.sources.end();
}

bool is_by_a_person(const Proposal& proposal) {
  return std::ranges::all_of(proposal.sources, [](Source one) { return one == Source::person; });
}

/// Nobody has said where it lies, and the image does not show it.
bool is_open(const Proposal& proposal) {
  const bool is_decided = proposal.decision == Decision::accepted || proposal.decision == Decision::moved;
  return !is_decided && !is_from(proposal, Source::person) && !is_from(proposal, Source::image);
}

template <class Proposals>
auto find(Proposals& proposals, Structure structure) {
  const auto at = std::ranges::find(proposals, structure, &Proposal::structure);
  return at == proposals.end() ? nullptr : &*at;
}

/// Where a point of another structure is known to lie, beside what statistics say of it.
struct KnownPoint {
  const CarriedDependence* depends = nullptr;
  Source source = Source::person;
  Eigen::Vector3d off;     ///< from where it was foretold
  Eigen::Matrix3d spread;  ///< of where it is known
};

class Again {
 public:
  Again(Transfer& transfer, const ClosestPointTree& liver, const Evidence& evidence)
      : transfer_(transfer), basis_(transfer.basis), liver_(liver), evidence_(evidence) {}

  void run() {
    for (Proposal& one : transfer_.proposals)
      if (is_open(one)) begin_again(one);
    see_notch();
    for (Proposal* one : open_) {
      if (one->structure == Structure::umbilical_notch) continue;
      const bool is_in_fissure = one->structure == Structure::falciform_line && part_;
      // A notch that the vein has drawn and the vein's plane are one evidence: the better one is taken.
      if (is_in_fissure && is_notch_by_vein()) draw_line(*one, *part_, basis_.upright);
      follow(*one);
      if (one->structure == Structure::anterior_margin) draw_to_ridge(*one, evidence_.ridge);
      if (is_in_fissure && !is_notch_by_vein()) draw_line(*one, *part_, basis_.upright);
      onto_liver(*one, liver_);
    }
  }

 private:
  bool is_notch_by_vein() {
    const Proposal* notch = find(transfer_.proposals, Structure::umbilical_notch);
    return notch != nullptr && notch->sources[0] == Source::both;
  }

  void begin_again(Proposal& one) {
    const Proposal* foretold = find(basis_.foretold, one.structure);
    if (foretold == nullptr) return;
    const Decision decision = one.decision;
    one = *foretold;
    one.decision = decision;
    open_.push_back(&one);
  }

  /// The notch by what tells of it, the portal vein at last; then what the vein shows of the fissure.
  void see_notch() {
    Proposal* notch = find(transfer_.proposals, Structure::umbilical_notch);
    if (notch == nullptr) return;
    const bool is_again = std::ranges::find(open_, notch) != open_.end();
    if (is_again) follow(*notch);
    see_fissure(*notch, is_again);
    if (is_again) onto_liver(*notch, liver_);
  }

  void see_fissure(Proposal& notch, bool is_again) {
    if (!basis_.sides_known || evidence_.portal_vein.empty()) return;
    std::vector<std::string> doubts;
    part_ = fissure_part(transfer_.proposals, basis_.foretold, evidence_.portal_vein, basis_.upright, doubts);
    // Where a person has placed the notch nothing is missed.
    if (!is_by_a_person(notch)) append(doubts);
    if (!part_) return;
    if (!agrees(notch, *part_, basis_.upright, transfer_.doubts)) return part_.reset();
    if (is_again) draw_notch(notch, *part_, basis_.upright);
  }

  void append(const std::vector<std::string>& doubts) {
    transfer_.doubts.insert(transfer_.doubts.end(), doubts.begin(), doubts.end());
  }

  /// What is drawn to the ridge, or to the fissure's plane, is no better known for others: the notch alone
  /// is, whose place the vein tells.
  std::optional<KnownPoint> known(const CarriedDependence& depends) {
    const Proposal* now = find(transfer_.proposals, depends.on);
    const Proposal* foretold = find(basis_.foretold, depends.on);
    if (now == nullptr || foretold == nullptr || now->decision == Decision::not_visible) return {};
    const auto point = static_cast<std::size_t>(depends.point);
    const Source source = now->sources[point];
    const bool is_known = source == Source::person || source == Source::image ||
                          (source == Source::both && depends.on == Structure::umbilical_notch);
    if (!is_known) return {};
    return KnownPoint{&depends, source,
                      (now->points.row(depends.point) - foretold->points.row(depends.point)).transpose(),
                      now->covariances[point]};
  }

  /// Each point goes with the one known point that tells most of it, and more than is known of it: what
  /// several tell is not independent.
  void follow(Proposal& one) {
    std::vector<KnownPoint> all;
    for (const CarriedDependence& depends : basis_.dependences)
      if (depends.of == one.structure)
        if (const auto point = known(depends)) all.push_back(*point);
    if (all.empty()) return;
    const Proposal& foretold = *find(basis_.foretold, one.structure);
    Eigen::RowVector3d way = Eigen::RowVector3d::Zero();
    for (Eigen::Index k = 0; k < one.points.rows(); ++k) {
      const auto i = static_cast<std::size_t>(k);
      const KnownPoint* best = nullptr;
      Eigen::Matrix3d least = one.covariances[i];
      for (const KnownPoint& point : all) {
        const Eigen::Matrix3d& gain = point.depends->gains[i];
        const Eigen::Matrix3d spread = point.depends->covariances[i] + gain * point.spread * gain.transpose();
        if (spread.trace() >= least.trace()) continue;
        least = spread;
        best = &point;
      }
      if (best == nullptr) continue;
      const Eigen::RowVector3d by = (best->depends->gains[i] * best->off).transpose();
      one.points.row(k) = foretold.points.row(k) + by;
      one.covariances[i] = least;
      one.sources[i] = Source::statistics;
      way += by / static_cast<double>(one.points.rows());
      count(one, *best);
    }
    if (one.area.rows() > 0) one.area.rowwise() += way;
    std::ranges::stable_sort(one.follows, std::greater(), &Followed::points);
  }

  static void count(Proposal& one, const KnownPoint& point) {
    const auto at = std::ranges::find(one.follows, point.depends->on, &Followed::on);
    if (at == one.follows.end())
      one.follows.push_back({point.depends->on, point.source, 1});
    else
      ++at->points;
  }

  Transfer& transfer_;
  const TransferBasis& basis_;
  const ClosestPointTree& liver_;
  const Evidence& evidence_;
  std::vector<Proposal*> open_;
  std::optional<UmbilicalPart> part_;
};

/// What a person has placed tells nothing of the others, by this atlas, though some are open.
bool is_idle(const Transfer& transfer) {
  return transfer.basis.dependences.empty() && std::ranges::any_of(transfer.proposals, is_by_a_person) &&
         std::ranges::any_of(transfer.proposals, is_open);
}

}  // namespace

void onto_liver(Proposal& proposal, const ClosestPointTree& liver) {
  for (Eigen::Index k = 0; k < proposal.points.rows(); ++k)
    proposal.points.row(k) = liver.closest(proposal.points.row(k).transpose()).point.transpose();
}

void propose_again(Transfer& transfer, const ClosestPointTree& liver, const Evidence& evidence) {
  transfer.doubts = transfer.basis.doubts;
  Again(transfer, liver, evidence).run();
  if (is_idle(transfer)) transfer.doubts.emplace_back("atlas.nothing_follows");
}

void propose_again(Transfer& transfer, const TriangleMesh& liver, const Evidence& evidence) {
  if (transfer.basis.foretold.empty()) return;
  propose_again(transfer, ClosestPointTree(prepare(liver, "model").mesh), evidence);
}

}  // namespace glisson::atlas
