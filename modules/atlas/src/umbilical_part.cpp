// SPDX-License-Identifier: GPL-3.0-or-later
#include "umbilical_part.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glisson::atlas {
namespace {

constexpr double kRun = 0.02;     // metres of vein by which its direction is told: about the part's length
constexpr double kBefore = 0.06;  // metres of vein before it: the left branch's transverse part and the fork
constexpr double kForward = 0.5;  // of a way's length is gained forwards: within 60 degrees of forwards
constexpr double kLeft = 0.012;   // metres to the left before it: a little over the branch's own diameter
constexpr double kRise = 0.01;    // metres upwards before it: the branch climbs out of the hilum
constexpr double kThick = 0.5;    // of the thickest radius: three forks into equals leave it (Murray's law)
/// Metres forwards from the top of its arch, to which the branch climbs: what ends before is a transverse
/// part cut short (10 mm and more on twelve real livers; of the same, cut short, 7 and less).
constexpr double kBeyondTop = 0.0085;
constexpr double kTop = 0.002;  // metres below the highest node, that still are the top
/// Metres: where a vein about as thick lies farther to the left than that, the stretch is a branch of the
/// right lobe, seen from which trunk and left branch are there (at most 15 mm on twelve real livers).
constexpr double kBeside = 0.025;
constexpr double kAsThick = 0.9;  // of its radius
constexpr double kTapered = 0.5;  // of its own radius: what is thinner is a branch to a segment

/// A portal vein, seen from its end that lies farthest to the patient's right: from there the way to the left
/// lobe passes the fork and the left branch, wherever the root was put. Nodes in the atlas' axes.
class Way {
 public:
  Way(const VesselTree& tree, const Eigen::Matrix3d& upright)
      : at_(tree.nodes * upright.transpose()),
        radii_(tree.radii),
        next_(static_cast<std::size_t>(tree.nodes.rows())),
        from_(next_.size(), -1) {
    for (const auto& [a, b] : tree.beams) {
      next_[static_cast<std::size_t>(a)].push_back(b);
      next_[static_cast<std::size_t>(b)].push_back(a);
    }
    walk();
  }

  const std::vector<int>& order() const { return order_; }

  /// The last two centimetres before a node: how they run, and how the vein ran before them.
  struct Stretch {
    double forward = 0.0;           ///< share of its length that is gained forwards
    double radius = 0.0;            ///< mean, metres
    double left = 0.0, rise = 0.0;  ///< metres, from where the vein came
    int base = -1;                  ///< its first node; none: there is too little vein
  };
  Stretch stretch_before(int end) const {
    Stretch run;
    double length = 0.0, top = at_(end, 2);
    int node = end;
    for (; from(node) >= 0 && length < kRun; node = from(node)) {
      top = std::max(top, at_(from(node), 2));
      const double beam = beam_to(node), used = std::min(beam, kRun - length);
      if (beam <= 0.0) continue;
      run.forward += used / beam * gained(node) / kRun;
      run.radius += used * 0.5 * (radius(node) + radius(from(node))) / kRun;
      length += used;
    }
    if (length < kRun) return {};
    run.base = node;
    double right = at_(node, 0), low = at_(node, 2);
    for (length = 0.0; from(node) >= 0 && length < kBefore; node = from(node)) {
      length += beam_to(node);
      right = std::min(right, at_(from(node), 0));
      low = std::min(low, at_(from(node), 2));
    }
    run.left = at_(run.base, 0) - right;
    run.rise = top - low;
    return run;
  }

  /// How far forwards a node lies from where the vein first reached its top on the way there, metres.
  double beyond_top(int end) const {
    double top = at_(end, 2), start = at_(end, 1), length = 0.0;
    const auto each = [&](const auto& look) {
      length = 0.0;
      for (int node = end; from(node) >= 0 && length < kRun + kBefore; node = from(node)) {
        length += beam_to(node);
        look(from(node));
      }
    };
    each([&](int node) { top = std::max(top, at_(node, 2)); });
    each([&](int node) {
      if (at_(node, 2) >= top - kTop) start = at_(node, 1);
    });
    return start - at_(end, 1);
  }

  /// Where what runs forwards ends: the node beyond this one, over vein that is thick enough, up to which
  /// most is gained forwards against half of the way.
  int end_beyond(int start, double least_radius) const {
    constexpr double kUnreached = -std::numeric_limits<double>::infinity();
    std::vector<double> gain(from_.size(), kUnreached);
    gain[static_cast<std::size_t>(start)] = 0.0;
    int best = start;
    for (const int node : order_) {  // parents come first
      const double before = from(node) < 0 ? kUnreached : gain[static_cast<std::size_t>(from(node))];
      if (before == kUnreached || radius(node) < least_radius) continue;
      const double now = before + gained(node) - kForward * beam_to(node);
      gain[static_cast<std::size_t>(node)] = now;
      if (now > gain[static_cast<std::size_t>(best)]) best = node;
    }
    return best;
  }

  double left_of(int node) const { return at_(node, 0); }
  /// How far to the left what is at least as thick as this reaches, metres.
  double leftmost(double least_radius) const {
    double most = -std::numeric_limits<double>::infinity();
    for (const int node : order_)
      if (radius(node) >= least_radius) most = std::max(most, at_(node, 0));
    return most;
  }
  double thickest() const { return radii_.empty() ? 0.0 : *std::max_element(radii_.begin(), radii_.end()); }

 private:
  /// From the end on the right; what does not hang together with it is not reached.
  void walk() {
    int start = -1;
    for (std::size_t i = 0; i < next_.size(); ++i)
      if (const auto node = static_cast<int>(i);
          next_[i].size() == 1 && (start < 0 || at_(node, 0) < at_(start, 0)))
        start = node;
    if (start < 0) return;
    order_ = {start};
    for (std::size_t i = 0; i < order_.size(); ++i)
      for (const int node : next_[static_cast<std::size_t>(order_[i])]) {
        if (node == start || from(node) >= 0) continue;
        from_[static_cast<std::size_t>(node)] = order_[i];
        order_.push_back(node);
      }
  }

  int from(int node) const { return from_[static_cast<std::size_t>(node)]; }
  double radius(int node) const { return radii_[static_cast<std::size_t>(node)]; }
  double beam_to(int node) const { return (at_.row(node) - at_.row(from(node))).norm(); }
  double gained(int node) const { return at_(from(node), 1) - at_(node, 1); }

  Points at_;
  std::vector<double> radii_;
  std::vector<std::vector<int>> next_;
  std::vector<int> from_, order_;
};

bool looks_umbilical(const Way& way, const Way::Stretch& run, int end) {
  if (run.base < 0 || run.forward < kForward || run.left < kLeft || run.rise < kRise ||
      run.radius < kThick * way.thickest())
    return false;
  const double left = std::max(way.left_of(run.base), way.left_of(end));
  return way.leftmost(kAsThick * run.radius) - left <= kBeside;
}

}  // namespace

std::optional<UmbilicalPart> umbilical_part(const std::vector<VesselTree>& trees,
                                            const Eigen::Matrix3d& upright) {
  std::optional<UmbilicalPart> found;
  double most = 0.0;
  for (const VesselTree& tree : trees) {
    const Way way(tree, upright);
    for (const int node : way.order()) {
      const Way::Stretch run = way.stretch_before(node);
      if (!looks_umbilical(way, run, node)) continue;
      const double flow = run.radius * run.radius * run.forward;  // the cross-section that faces forwards
      const int tip = way.end_beyond(node, kTapered * run.radius);
      if (flow <= most || way.beyond_top(tip) < kBeyondTop) continue;
      most = flow;
      found = UmbilicalPart{Point<CtFrame>(tree.nodes.row(run.base).transpose()),
                            Point<CtFrame>(tree.nodes.row(tip).transpose()), run.radius};
    }
  }
  return found;
}

}  // namespace glisson::atlas
