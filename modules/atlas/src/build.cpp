// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <mutex>
#include <set>

#include "glisson/atlas/atlas.h"
#include "glisson/atlas/correspond.h"
#include "glisson/core/error.h"
#include "glisson/core/note_value.h"
#include "glisson/core/random.h"
#include "glisson/core/share_out.h"
#include "glisson/core/statistics.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/distance.h"
#include "mirrored.h"
#include "note.h"
#include "statistics.h"

namespace glisson::atlas {
namespace {

constexpr std::size_t kLeastMembers = 5;
constexpr double kOutlierDeviations = 3.0;  // robust, from the median, at which a member's weight falls
constexpr double kTouching = 0.004;         // metres, between a vertex and an area's points
constexpr int kDrawn = 60;                  // instances for the specificity

/// What is known of one member on the way.
struct Work {
  Member member;
  TriangleMesh liver;  ///< prepared
  std::vector<std::string> doubts;
  Correspondence first, honest;  ///< by the template; by the others' mean and modes
  double weight = 1.0;
  double generality = 0.0, unusual = 0.0;
  std::map<Structure, Points> truth;   ///< ordered points on the member's own liver
  std::map<Structure, Places> places;  ///< the same on the template
};

class Builder {
 public:
  Builder(std::vector<Member> members, const Atlas& base, const BuildOptions& options,
          const RunContext& context)
      : base_(base), options_(options), context_(context), added_unusual_(options.added_unusual) {
    std::sort(members.begin(), members.end(),
              [](const Member& a, const Member& b) { return a.name < b.name; });
    for (Member& member : members) works_.emplace_back().member = std::move(member);
  }

  Cancellable<BuildResult> run() {
    check();
    if (options_.keep_shape ? !lay_on_base() : !make_shape()) return {};
    find_places();
    for (const Structure structure : kStructures) add(structure);
    depend();
    judge();
    if (options_.summed) forget_single_livers();
    return std::move(result_);
  }

 private:
  bool make_shape() {
    if (!correspond_all()) return false;
    weigh();
    if (!leave_out_each()) return false;
    finish_shape();
    return true;
  }

  void forget_single_livers() {
    for (StructureStatistics& one : result_.atlas.structures)
      if (result_.spreads.contains(one.structure)) sum_up(one);
    if (options_.keep_shape) return;  // the members are the base's
    int number = 0;
    for (AtlasMember& member : result_.atlas.members) member.name = "liver " + std::to_string(++number);
  }

  std::size_t count() const { return works_.size(); }
  void check() {
    if (count() < kLeastMembers)
      throw InputError("atlas", "members", "are " + std::to_string(count()),
                       "Give " + std::to_string(kLeastMembers) + " livers at least");
    std::set<std::string> names;
    for (Work& work : works_) {
      if (!names.insert(work.member.name).second)
        throw InputError("atlas", "members", "has two of the name " + work.member.name,
                         "Give each liver once");
      PreparedLiver prepared = prepare(work.member.liver, work.member.name);
      work.liver = std::move(prepared.mesh);
      work.doubts = std::move(prepared.doubts);
    }
  }

  /// Work on every member, counted as progress. False: cancelled.
  bool each(double from, double to, const char* stage, const std::function<bool(std::size_t)>& work) {
    std::mutex guard;
    int done = 0;
    bool whole = true;
    const RunContext span = context_.part(from, to);
    share_out(count(), options_.threads, [&](std::size_t i, bool here) {
      const bool finished = !context_.cancelled() && work(i);
      const std::lock_guard lock(guard);
      whole = whole && finished;
      ++done;
      if (here) span.progress(static_cast<double>(done) / static_cast<double>(count()), stage);
    });
    if (!whole || context_.cancelled()) return false;
    span.progress(1.0, stage);  // the last member may have been another thread's
    return true;
  }

  bool correspond_all() {
    const ShapeModel still{base_.shape.mean, {}, {}, 0.0};
    return each(0.0, 0.45, "atlas.correspond", [&](std::size_t i) {
      auto found = correspond(still, base_.triangles, works_[i].liver, context_.quiet());
      if (!found) return false;
      works_[i].first = std::move(*found);
      return true;
    });
  }

  /// Members that lie far from the others count less.
  void weigh() {
    const auto aligned = aligned_shapes(-1, true);
    const Points& mean = gauge_;
    std::vector<double> distances;
    distances.reserve(aligned.size());
    for (const Points& shape : aligned) distances.push_back((shape - mean).norm());
    const double middle = upper_median(distances);
    const double limit =
        middle + kOutlierDeviations * kDeviationPerMad * median_absolute_deviation(distances, middle);
    for (std::size_t i = 0; i < count(); ++i) {
      if (distances[i] <= limit) continue;
      works_[i].weight = (limit / distances[i]) * (limit / distances[i]);
      result_.notes.push_back(
          note("atlas.outlier " + note_value(works_[i].member.name), distances[i] / middle, 2));
    }
  }

  /// All shapes but one in the frame of their mean, which becomes the gauge.
  std::vector<Points> aligned_shapes(int left_out, bool first) {
    std::vector<Points> shapes;
    std::vector<double> weights;
    for (std::size_t i = 0; i < count(); ++i)
      if (static_cast<int>(i) != left_out) {
        shapes.push_back(first ? works_[i].first.vertices : works_[i].honest.vertices);
        weights.push_back(works_[i].weight);
      }
    const Procrustes procrustes = align(shapes, weights, base_.shape.mean);
    for (std::size_t i = 0; i < shapes.size(); ++i)
      shapes[i] = procrustes.mean_from_member[i].apply(shapes[i]);
    if (left_out < 0) gauge_ = procrustes.mean;
    return shapes;
  }

  ShapeModel model_of(int left_out, bool first, double share) {
    std::vector<double> weights;
    for (std::size_t i = 0; i < count(); ++i)
      if (static_cast<int>(i) != left_out) weights.push_back(works_[i].weight);
    return shape_model(aligned_shapes(left_out, first), weights, share);
  }

  bool leave_out_each() {
    return each(0.45, 0.95, "atlas.leave_one_out", [&](std::size_t i) {
      return lay_on(model_of(static_cast<int>(i), true, options_.share), works_[i]);
    });
  }

  /// A member as a patient is met, by livers without it. False: cancelled.
  bool lay_on(const ShapeModel& others, Work& work) {
    auto found = correspond(others, base_.triangles, work.liver, context_.quiet());
    if (!found) return false;
    work.honest = std::move(*found);
    const auto side = handedness(others, base_.triangles, work.liver, work.honest, context_.quiet());
    if (!side) return false;
    if (*side == Handedness::mirrored) refuse_mirrored(work.member.name);
    const Similarity back = fit_similarity(work.honest.vertices, others.mean);
    const Points shape = back.apply(work.honest.vertices);
    work.unusual = unusual(others, shape);
    work.generality =
        (shape - others.instance(others.coefficients(shape))).rowwise().norm().mean() / back.scale;
    return true;
  }

  /// The base's shape stays as it is, and with it whatever its members show.
  bool lay_on_base() {
    if (base_.shape.mode_count() == 0 || !(base_.usual > 0.0))
      throw InputError("atlas", "base", "has no shape that could be kept", "Build on another atlas");
    const bool done =
        each(0.0, 0.95, "atlas.correspond", [&](std::size_t i) { return lay_on(base_.shape, works_[i]); });
    if (!done) return false;
    result_.atlas = base_;
    result_.atlas.name = base_.name + ", " + options_.name;
    result_.atlas.structures.clear();
    std::vector<double> ratios;
    for (const Work& work : works_) {
      ratios.push_back(work.unusual / base_.usual);
      modes_.push_back(modes_of(work));
    }
    added_unusual_ = std::max(options_.added_unusual, upper_percentile(ratios, 0.95));
    return true;
  }

  void finish_shape() {
    Atlas& atlas = result_.atlas;
    atlas.name = options_.name;
    atlas.triangles = base_.triangles;
    atlas.shape = model_of(-1, false, options_.share);
    std::vector<double> ratios, sizes;
    double weights = 0.0, sum = 0.0, squares = 0.0;
    for (const Work& work : works_) {
      ratios.push_back(work.unusual);
      const double size = size_of(work.honest.vertices);
      atlas.members.push_back({work.member.name, work.weight, size, work.unusual, work.honest.mean_distance});
      weights += work.weight;
      sum += work.weight * std::log(size);
      squares += work.weight * std::log(size) * std::log(size);
    }
    atlas.usual = upper_percentile(ratios, 0.95);
    atlas.log_size = sum / weights;
    atlas.log_size_deviation = std::sqrt(std::max(1e-6, squares / weights - atlas.log_size * atlas.log_size));
    for (const Work& work : works_) modes_.push_back(modes_of(work));
  }

  Eigen::VectorXd modes_of(const Work& work) const {
    const ShapeModel& shape = result_.atlas.shape;
    const Points aligned = fit_similarity(work.honest.vertices, shape.mean).apply(work.honest.vertices);
    return shape.coefficients(aligned).cwiseQuotient(shape.variances.cwiseSqrt());
  }

  void find_places() {
    for (Work& work : works_) {
      const Eigen::Matrix3d upright = work.honest.from_start.rotation.transpose();
      const TriangleMesh surface{work.honest.vertices, base_.triangles};
      const auto notch = work.member.structures.find(Structure::umbilical_notch);
      for (const auto& [structure, raw] : work.member.structures) {
        const Points points = ordered_points(
            structure, raw, upright, notch == work.member.structures.end() ? Points(0, 3) : notch->second);
        if (points.rows() == 0) continue;
        work.truth[structure] = points;
        work.places[structure] = places_of(surface, points, size_of(surface.vertices));
      }
    }
  }

  std::vector<Observation> observations_of(Structure structure) const {
    std::vector<Observation> observed;
    const TriangleMesh mean = result_.atlas.mean();
    const double size = size_of(mean.vertices);
    for (std::size_t i = 0; i < count(); ++i)
      if (const auto at = works_[i].places.find(structure); at != works_[i].places.end())
        observed.push_back(
            {works_[i].member.name, works_[i].weight, points_at(at->second, mean, size), modes_[i]});
    return observed;
  }

  /// Falciform line and margin meet the notch: the shape must not take one of them along and leave another.
  int mode_count(Structure structure, const std::vector<Observation>& observed) const {
    static constexpr std::array kMeet = {Structure::umbilical_notch, Structure::falciform_line,
                                         Structure::anterior_margin};
    if (std::find(kMeet.begin(), kMeet.end(), structure) == kMeet.end()) return modes_for({observed});
    std::vector<std::vector<Observation>> all;
    all.reserve(kMeet.size());
    for (const Structure one : kMeet) all.push_back(observations_of(one));
    std::erase_if(all, [](const auto& one) { return one.size() < kLeastMembers; });
    return modes_for(all);
  }

  void add(Structure structure) {
    const std::vector<Observation> observed = observations_of(structure);
    if (observed.size() < kLeastMembers) {
      take_over(structure, observed.size());
      return;
    }
    result_.spreads[structure] = spread_of(observed);
    StructureStatistics statistics;
    statistics.structure = structure;
    statistics.origin = options_.name;
    statistics.added_deviation = options_.added_deviation;
    statistics.added_unusual = added_unusual_;
    observe(statistics, observed, mode_count(structure, observed));
    if (is_area(structure)) statistics.share = shares(structure);
    result_.atlas.structures.push_back(std::move(statistics));
  }

  /// What the members show of two structures together; of what was taken over from the base what that had.
  void depend() {
    std::vector<StructureStatistics*> own;
    for (StructureStatistics& one : result_.atlas.structures)
      if (result_.spreads.contains(one.structure))
        own.push_back(&one);
      else
        std::erase_if(one.depends,
                      [&](const Dependence& other) { return result_.spreads.contains(other.on); });
    learn_dependences(own);
  }

  /// What too few members show, from the base: the places are the same, for the triangles are.
  void take_over(Structure structure, std::size_t shown_by) {
    const StructureStatistics* known = base_.find(structure);
    if (known == nullptr) {
      if (shown_by > 0) result_.notes.push_back(std::string("atlas.too_few ") + structure_code(structure));
      return;
    }
    StructureStatistics taken = *known;
    result_.notes.push_back(std::string("atlas.taken_over ") + structure_code(structure) + " " +
                            note_value(known->origin));
    if (options_.keep_shape) {
      result_.atlas.structures.push_back(std::move(taken));
      return;
    }
    const TriangleMesh mean = base_.mean();
    taken.mean = points_at(places_of(mean, known->mean, size_of(mean.vertices)), result_.atlas.mean(),
                           size_of(result_.atlas.shape.mean));
    // The slopes belong to the other one's modes: without them the residuals are a little larger.
    if (taken.slopes.cols() > 0) taken.added_deviation = std::hypot(taken.added_deviation, slope_size(taken));
    taken.slopes.resize(taken.mean.size(), 0);
    result_.atlas.structures.push_back(std::move(taken));
  }

  /// Which vertices of the template touch the area of a member.
  Eigen::VectorXd touching(const Work& work, Structure structure) const {
    const Points& raw = work.member.structures.at(structure);
    const Points& vertices = work.honest.vertices;
    Eigen::VectorXd inside = Eigen::VectorXd::Zero(vertices.rows());
    for (Eigen::Index v = 0; v < vertices.rows(); ++v)
      if ((raw.rowwise() - vertices.row(v)).rowwise().squaredNorm().minCoeff() <= kTouching * kTouching)
        inside[v] = 1.0;
    return inside;
  }
  Eigen::VectorXd shares(Structure structure) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(base_.shape.mean.rows());
    double n = 0.0;
    for (const Work& work : works_)
      if (work.truth.count(structure) > 0) {
        touching_[{work.member.name, structure}] = touching(work, structure);
        sum += touching_[{work.member.name, structure}];
        n += 1.0;
      }
    return sum / n;
  }

  void judge() {
    for (const Work& work : works_) {
      LeftOut left{work.member.name,
                   work.honest.mean_distance,
                   work.honest.max_distance,
                   work.honest.turned_deg,
                   work.first.misfit,
                   work.first.mirrored_misfit,
                   work.honest.folded,
                   work.unusual,
                   work.doubts,
                   {},
                   {}};
      for (const StructureStatistics& statistics : result_.atlas.structures)
        // Of what was taken over the residuals are others', whatever their livers are called.
        if (result_.spreads.contains(statistics.structure)) judge(left, work, statistics);
      result_.left_out.push_back(std::move(left));
    }
    result_.quality.compactness_modes = result_.atlas.shape.mode_count();
    for (const Work& work : works_)
      result_.quality.generality += work.generality / static_cast<double>(count());
    if (!options_.keep_shape) result_.quality.specificity = specificity();
  }

  void judge(LeftOut& left, const Work& work, const StructureStatistics& statistics) const {
    const int index = number_of(work, statistics);
    if (index < 0) return;
    const Points& residual = statistics.residuals[static_cast<std::size_t>(index)];
    LeftOutStructure found =
        judged(work, statistics.structure, residual, [&](int k) { return covariance(statistics, k, index); });
    if (is_area(statistics.structure)) {
      const SetDistance apart = area_distance(work, statistics);
      found.area_distance = apart.mean;
      found.area_largest = apart.largest;
    }
    left.structures[statistics.structure] = found;
    judge_with_notch(left, work, statistics, residual);
  }

  /// The same by one who knows where the notch lies on this liver, and what the others tell of the two.
  void judge_with_notch(LeftOut& left, const Work& work, const StructureStatistics& statistics,
                        const Points& residual) const {
    const StructureStatistics* notch = result_.atlas.find(Structure::umbilical_notch);
    if (notch == nullptr || notch == &statistics || !result_.spreads.contains(notch->structure)) return;
    const int index = number_of(work, *notch);
    const auto told = index < 0 || statistics.depends.empty()
                          ? std::nullopt
                          : dependence(statistics, *notch, 0, work.member.name);
    if (!told) return;
    const Eigen::Vector3d off = notch->residuals[static_cast<std::size_t>(index)].row(0);
    Points rest = residual;
    for (Eigen::Index k = 0; k < rest.rows(); ++k)
      rest.row(k) -= (told->gains[static_cast<std::size_t>(k)] * off).transpose();
    left.with_notch[statistics.structure] =
        judged(work, statistics.structure, rest, [&](int k) { return covariance(statistics, *told, k); });
  }

  /// Which of the structure's residuals is this member's; -1: none.
  static int number_of(const Work& work, const StructureStatistics& statistics) {
    const auto number = std::find(statistics.members.begin(), statistics.members.end(), work.member.name);
    const bool is_shown = work.truth.contains(statistics.structure) && number != statistics.members.end();
    return is_shown ? static_cast<int>(number - statistics.members.begin()) : -1;
  }

  /// @param residual on the mean liver, metres @param spread_of a point's covariance there
  LeftOutStructure judged(const Work& work, Structure structure, const Points& residual,
                          const std::function<Eigen::Matrix3d(int)>& spread_of) const {
    const TriangleMesh mean = result_.atlas.mean();
    const double size = size_of(mean.vertices);
    const Points on_mean = points_at(work.places.at(structure), mean, size) - residual;
    const TriangleMesh there{work.honest.vertices, base_.triangles};
    const Points placed = points_at(places_of(mean, on_mean, size), there, size_of(there.vertices));
    const Eigen::VectorXd errors = (placed - work.truth.at(structure)).rowwise().norm();
    LeftOutStructure found{errors.mean(), errors.maxCoeff(), 0.0, 0, static_cast<int>(errors.size()), 0.0};
    double traces = 0.0;
    for (int k = 0; k < found.points; ++k) {
      const Eigen::Matrix3d spread = spread_of(k);
      const Eigen::Vector3d r = residual.row(k);
      if (r.dot(spread.ldlt().solve(r)) <= kEllipsoid95) ++found.inside;
      traces += spread.trace();
    }
    found.deviation = std::sqrt(traces / found.points);
    return found;
  }

  /// Between the contact as the others foretell it and as it is.
  SetDistance area_distance(const Work& work, const StructureStatistics& statistics) const {
    const Eigen::VectorXd& own = touching_.at({work.member.name, statistics.structure});
    const auto n = static_cast<double>(statistics.members.size());
    const std::vector<int> foretold = area_vertices((n * statistics.share - own) / (n - 1.0));
    const Points& truth = work.member.structures.at(statistics.structure);
    Points there(static_cast<Eigen::Index>(foretold.size()), 3);
    for (std::size_t i = 0; i < foretold.size(); ++i)
      there.row(static_cast<Eigen::Index>(i)) = work.honest.vertices.row(foretold[i]);
    return set_distance(there, truth);
  }

  double specificity() {
    auto random = context_.random("atlas.specificity");
    const ShapeModel& shape = result_.atlas.shape;
    const auto members = aligned_shapes(-1, false);
    double sum = 0.0;
    for (int drawn = 0; drawn < kDrawn; ++drawn) {
      Eigen::VectorXd b(shape.mode_count());
      for (Eigen::Index k = 0; k < b.size(); ++k)
        b[k] = standard_normal(random) * std::sqrt(shape.variances[k]);
      const Points instance = shape.instance(b);
      double closest = std::numeric_limits<double>::infinity();
      for (const Points& member : members)
        closest = std::min(closest, (instance - member).rowwise().norm().mean());
      sum += closest;
    }
    return sum / kDrawn;
  }

  const Atlas& base_;
  const BuildOptions& options_;
  const RunContext& context_;
  double added_unusual_;
  std::vector<Work> works_;
  Points gauge_;
  std::vector<Eigen::VectorXd> modes_;
  std::map<std::pair<std::string, Structure>, Eigen::VectorXd> touching_;
  BuildResult result_;
};

}  // namespace

void BuildOptions::validate() const {
  const OptionCheck check("atlas options");
  check(share > 0.0 && share <= 1.0, "share", share, "Give a share above 0, at most 1");
  check(added_deviation >= 0.0 && added_deviation < 0.1, "added_deviation", added_deviation,
        "Give a number from 0 to 0.1 m");
  check(added_unusual >= 1.0 && added_unusual < 100.0, "added_unusual", added_unusual,
        "Choose 1 and more: over what is usual");
  check(threads == 1 || threads == 2, "threads", threads, "Give 1 or 2");
}

Cancellable<BuildResult> build(std::vector<Member> members, const Atlas& base, const BuildOptions& options,
                               const RunContext& context) {
  options.validate();
  require(base.shape.mean.rows() >= 4, "the base has a mean");
  return Builder(std::move(members), base, options, context).run();
}

Atlas bare_atlas(const TriangleMesh& mean) {
  Atlas atlas;
  atlas.name = "template";
  atlas.triangles = mean.triangles;
  atlas.shape.mean = mean.vertices;
  return atlas;
}

}  // namespace glisson::atlas
