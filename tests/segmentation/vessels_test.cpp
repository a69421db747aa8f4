// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>
#include <random>

#include "glisson/core/error.h"
#include "glisson/segmentation/segment.h"
#include "min_cut.h"
#include "phantom_field.h"
#include "tree_split.h"

using namespace glisson;
using namespace glisson::segmentation;
using namespace glisson::test;

namespace {

struct Tube {
  Eigen::Vector3d from, to;  // mm
  double radius;
};

double depth_in(const std::vector<Tube>& tubes, const Eigen::Vector3d& p) {
  double deepest = -1e9;
  for (const Tube& tube : tubes) {
    const Eigen::Vector3d axis = tube.to - tube.from;
    const double t = std::clamp((p - tube.from).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    deepest = std::max(deepest, tube.radius - (p - tube.from - t * axis).norm());
  }
  return deepest;
}

/// Two Y-trees in a block of liver. The portal one comes from below, the hepatic one from above; their left
/// branches cross, and touch each other's walls over several voxels there.
struct Phantom {
  Image image;
  LabelMap liver;  // of parenchyma alone
  std::vector<Tube> portal, hepatic;
  /// A kidney that the liver lies against; a branch of the hepatic veins ends beside it.
  static constexpr double kKidney = 13.0, kCortex = 5.0;  // mm: radius and thickness
  Eigen::Vector3d kidney{100, 30, 38};

  /// What else may lie there.
  struct Setting {
    double portal_hu = 190.0, hepatic_hu = 190.0;
    bool with_kidney = false;
    double liver_from = 8.0;  ///< mm: below it the portal trunk runs outside
    double heart_from = 1e9;  ///< mm: what lies above is a heart that shines in
  };

  explicit Phantom(unsigned seed, double vessel_hu = 190.0, bool with_kidney = false)
      : Phantom(seed, Setting{vessel_hu, vessel_hu, with_kidney, 8.0, 1e9}) {}
  Phantom(unsigned seed, const Setting& setting) {
    portal = {{{54, 48, 2}, {54, 48, 40}, 5.0},
              {{54, 48, 40}, {25, 48, 62}, 4.0},
              {{54, 48, 40}, {85, 48, 60}, 3.0}};
    hepatic = {{{54, 30, 94}, {54, 30, 70}, 5.0},
               {{54, 30, 70}, {30, 48.7, 30}, 4.0},
               {{54, 30, 70}, {88, 30, 40}, 3.0}};
    VolumeGrid& grid = image.grid;
    grid.size = {76, 66, 81};
    grid.spacing_mm = {1.4, 1.4, 1.2};
    grid.origin_mm = {-40, 10, 5};
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 10.0);
    std::vector<std::int16_t> voxels;
    std::vector<Label> labels;
    for (int k = 0; k < grid.size.z(); ++k)
      for (int j = 0; j < grid.size.y(); ++j)
        for (int i = 0; i < grid.size.x(); ++i) {
          const Eigen::Vector3d p = Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm);
          const double inside_kidney = setting.with_kidney ? kKidney - (p - kidney).norm() : -1e9;
          const bool in = (p.array() > 8.0).all() && p.z() > setting.liver_from && p.x() < 98 && p.y() < 84 &&
                          p.z() < 88 && inside_kidney < 0.0;
          const double in_portal = depth_in(portal, p), in_hepatic = depth_in(hepatic, p);
          const double depth = std::max(in_portal, in_hepatic);
          const double vessel = 1.0 / (1.0 + std::exp(-depth / 0.4));
          const double cortex =
              1.0 / (1.0 + std::exp(-std::min(inside_kidney, kCortex - inside_kidney) / 0.8));
          const bool in_heart = p.z() > setting.heart_from && p.x() < 98 && p.y() < 84;
          const double organ = (in || in_heart        ? (p.z() > setting.heart_from ? 150.0 : 110.0)
                                : inside_kidney > 0.0 ? 120.0
                                                      : -90.0) *
                                   (1.0 - vessel) +
                               (in_portal > in_hepatic ? setting.portal_hu : setting.hepatic_hu) * vessel;
          const double hu = organ * (1.0 - cortex) + 270.0 * cortex + noise(random);
          voxels.push_back(static_cast<std::int16_t>(std::lround(hu)));
          labels.push_back(in ? structure::kParenchyma : structure::kBackground);
        }
    image.voxels = std::make_shared<const std::vector<std::int16_t>>(std::move(voxels));
    liver = {LabelVolume(grid, labels), {structure_info(structure::kParenchyma)}};
  }

  Points at(std::initializer_list<Eigen::Vector3d> places_mm) const {
    Points points(static_cast<Eigen::Index>(places_mm.size()), 3);
    Eigen::Index n = 0;
    for (const Eigen::Vector3d& place : places_mm)
      points.row(n++) = (1e-3 * (image.grid.origin_mm + place)).transpose();
    return points;
  }
  /// A click at the entrance of each tree.
  Seeds roots() const {
    Seeds seeds;
    seeds.portal_vein = at({{54, 49, 14}});
    seeds.hepatic_veins = at({{55, 30, 84}});
    return seeds;
  }
  /// The portal trunk 30 mm before a liver from 38 mm on, and the hepatic veins in three places.
  Seeds trunk_and_branches() const {
    Seeds seeds;
    seeds.portal_vein = at({{54, 48, 8}});
    seeds.hepatic_veins = at({{55, 30, 84}, {54, 30, 76}, {70, 30, 56}});
    return seeds;
  }
  Segmented found(const Seeds& seeds, const LabelMap& kept, bool with_hepatic = true) const {
    SegmentationOptions options;
    options.structures = {false, true, with_hepatic, false, false, false};
    return segment(image, seeds, options, RunContext(), &kept).value();
  }
};

bool tells(const Segmented& found, const std::string& code) {
  const std::vector<std::string>& notes = found.report.notes;
  return std::find(notes.begin(), notes.end(), code) != notes.end();
}

struct Counts {
  long right = 0, wrong = 0, missed = 0, extra = 0;
  long far = 0;  ///< of the extra ones, more than 2 mm from either tree
  double dice() const {
    return 2.0 * static_cast<double>(right) / static_cast<double>(2 * right + wrong + missed + extra);
  }
};

/// Of the truth's voxels in the liver of one tree, how many carry its label, the other's, or none.
Counts compare(const Phantom& p, const LabelMap& found, const std::vector<Tube>& own,
               const std::vector<Tube>& other, Label label, Label wrong) {
  Counts counts;
  const VolumeGrid& grid = p.image.grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        if (p.liver.voxels.at({i, j, k}) == 0) continue;
        const Eigen::Vector3d x = Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm);
        const double depth = depth_in(own, x), elsewhere = depth_in(other, x);
        const Label l = found.voxels.at({i, j, k});
        if (depth > 0.0 && depth > elsewhere) {
          if (l == label)
            ++counts.right;
          else if (l == wrong)
            ++counts.wrong;
          else
            ++counts.missed;
        } else if (elsewhere <= 0.0 && l == label) {
          ++counts.extra;
          counts.far += depth < -2.0 && elsewhere < -2.0;
        }
      }
  return counts;
}

/// Of the portal tree, and of the hepatic one.
std::pair<Counts, Counts> compare(const Phantom& p, const LabelMap& found) {
  return {compare(p, found, p.portal, p.hepatic, structure::kPortalVein, structure::kHepaticVeins),
          compare(p, found, p.hepatic, p.portal, structure::kHepaticVeins, structure::kPortalVein)};
}

/// Cost of a parting of a small graph in two.
struct SmallGraph {
  struct Edge {
    std::size_t a, b;
    int direction;
    float capacity;
  };
  std::vector<float> leaning;
  std::vector<Edge> edges;

  double cost(unsigned first) const {
    double sum = 0.0;
    for (std::size_t n = 0; n < leaning.size(); ++n) {
      const bool in = (first >> n & 1U) != 0;
      if (leaning[n] > 0.0F && !in) sum += leaning[n];
      if (leaning[n] < 0.0F && in) sum -= leaning[n];
    }
    for (const Edge& e : edges)
      if ((first >> e.a & 1U) != (first >> e.b & 1U)) sum += e.capacity;
    return sum;
  }
};

}  // namespace

class VesselsTest : public QObject {
  Q_OBJECT
 private slots:
  void CutIsAsCheapAsTheCheapestOfAll();
  void CutRunsThroughTheNarrowPlace();
  void CancelledCutGivesNothing();
  void TreesThatTouchAreKeptApart();
  void AKeptTreeIsNotEntered();
  void DimVesselsLetNoNoiseIn();
  void VesselsThatHardlyEnhanceAreTold();
  void TheRimOfAKidneyIsNoVein();
  void ATreeTapersFromItsRoot();
  void ATrunkIsClickedWhereItIsWidest();
  void ATreeThatIsNotSeenIsNotInvented();
  void ATreeTwiceAsBrightIsFound();
  void AHeartThatShinesInIsNoVein();
  void AClickBesideEveryBranchIsTold();
  void AClickAgainstTheLiverOnAVesselIsTold();
};

void VesselsTest::CutIsAsCheapAsTheCheapestOfAll() {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  for (int trial = 0; trial < 200; ++trial) {
    const std::size_t count = 4 + random() % 8;
    SmallGraph graph;
    MinCut cut(count);
    for (std::size_t n = 0; n < count; ++n) {
      graph.leaning.push_back(random() % 3 == 0 ? 0.0F : 4.0F * unit(random) - 2.0F);
      cut.lean(n, graph.leaning.back());
    }
    // Every node has 26 places for neighbours, an edge takes opposite ones.
    std::vector<unsigned> taken(count, 0);
    for (int n = 0; n < 30; ++n) {
      const std::size_t a = random() % count, b = random() % count;
      const int d = static_cast<int>(random() % 26);
      bool joined = a == b || (taken[a] >> d & 1U) != 0 || (taken[b] >> (25 - d) & 1U) != 0;
      for (const auto& e : graph.edges) joined = joined || (e.a == a && e.b == b) || (e.a == b && e.b == a);
      if (joined) continue;
      taken[a] |= 1U << d;
      taken[b] |= 1U << (25 - d);
      graph.edges.push_back({a, b, d, unit(random)});
      cut.join(a, b, d, graph.edges.back().capacity);
    }
    const std::vector<std::uint8_t> side = cut.first_side(RunContext()).value();
    unsigned found = 0;
    for (std::size_t n = 0; n < count; ++n) found |= static_cast<unsigned>(side[n]) << n;
    double least = 1e30;
    for (unsigned first = 0; first < 1U << count; ++first) least = std::min(least, graph.cost(first));
    QVERIFY2(std::abs(graph.cost(found) - least) < 1e-4, qPrintable(QString::number(trial)));
  }
}

void VesselsTest::CutRunsThroughTheNarrowPlace() {
  // A chain whose fourth link is the weakest.
  MinCut cut(8);
  const std::array<float, 7> links = {3.0F, 2.0F, 5.0F, 0.5F, 1.0F, 4.0F, 2.0F};
  for (std::size_t n = 0; n < links.size(); ++n) cut.join(n, n + 1, 13, links[n]);
  cut.lean(0, MinCut::kBound);
  cut.lean(7, -MinCut::kBound);
  const std::vector<std::uint8_t> wanted = {1, 1, 1, 1, 0, 0, 0, 0};
  QCOMPARE(cut.first_side(RunContext()).value(), wanted);
  MinCut bad(2);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, bad.join(0, 1, 26, 1.0F));
  QVERIFY_THROWS_EXCEPTION(PreconditionError, bad.join(0, 1, 3, -1.0F));
}

void VesselsTest::CancelledCutGivesNothing() {
  MinCut cut(2);
  cut.join(0, 1, 13, 1.0F);
  cut.lean(0, 1.0F);
  cut.lean(1, -1.0F);
  const auto flag = std::make_shared<CancelFlag>();
  flag->request();
  QVERIFY(!cut.first_side(RunContext({}, flag, 1)).has_value());
}

void VesselsTest::TreesThatTouchAreKeptApart() {
  for (const unsigned seed : {1U, 2U}) {
    const Phantom p(seed);
    const LabelMap labels = p.found(p.roots(), p.liver).labels;
    const auto [portal, hepatic] = compare(p, labels);
    // A hundredth of each tree: the few voxels of the contact itself.
    qInfo("portal %ld wrong, %ld right; hepatic %ld wrong, %ld right", portal.wrong, portal.right,
          hepatic.wrong, hepatic.right);
    QVERIFY2(100 * portal.wrong <= portal.right, qPrintable(QString::number(portal.wrong)));
    QVERIFY2(100 * hepatic.wrong <= hepatic.right, qPrintable(QString::number(hepatic.wrong)));
    QVERIFY2(portal.dice() > 0.85, qPrintable(QString::number(portal.dice())));
    QVERIFY2(hepatic.dice() > 0.85, qPrintable(QString::number(hepatic.dice())));
  }
}

void VesselsTest::AKeptTreeIsNotEntered() {
  const Phantom p(1);
  // The hepatic veins by hand; the portal vein is grown beside them.
  LabelMap edited = p.liver;
  const VolumeGrid& grid = p.image.grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3d x = Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm);
        if (depth_in(p.hepatic, x) > std::max(0.0, depth_in(p.portal, x)))
          edited.voxels.set({i, j, k}, structure::kHepaticVeins);
      }
  const LabelMap labels =
      p.found(p.roots(), edited, false).labels;  // the hepatic root is not asked for: without effect
  const auto hepatic = [](Label label) { return label == structure::kHepaticVeins; };
  QVERIFY(labels.voxels.mask(hepatic) == edited.voxels.mask(hepatic));
  const Counts portal = compare(p, labels).first;
  QVERIFY2(portal.dice() > 0.8, qPrintable(QString::number(portal.dice())));
}

void VesselsTest::DimVesselsLetNoNoiseIn() {
  // Twice the noise of what is left of it at 1 mm: a third of the contrast is within it.
  const Phantom p(1, 124.0);
  const LabelMap labels = p.found(p.roots(), p.liver).labels;
  const auto [portal, hepatic] = compare(p, labels);
  qInfo("portal %ld right, %ld extra; hepatic %ld right, %ld extra", portal.right, portal.extra,
        hepatic.right, hepatic.extra);
  QVERIFY(portal.right > 1000 && hepatic.right > 1000);
  QVERIFY2(5 * portal.extra < portal.right, qPrintable(QString::number(portal.extra)));
  QVERIFY2(5 * hepatic.extra < hepatic.right, qPrintable(QString::number(hepatic.extra)));
}

void VesselsTest::VesselsThatHardlyEnhanceAreTold() {
  const Phantom sound(5), faint(5, 118.0);
  const Segmented bright = sound.found(sound.roots(), sound.liver),
                  dim = faint.found(faint.roots(), faint.liver);
  for (const char* code : {"portal_vein.faint", "hepatic_veins.faint"}) {
    QVERIFY(!tells(bright, code));
    QVERIFY(tells(dim, code));
  }
}

void VesselsTest::TheRimOfAKidneyIsNoVein() {
  const Phantom p(1, 190.0, true);
  const LabelMap labels = p.found(p.roots(), p.liver).labels;
  long rim = 0;
  const VolumeGrid& grid = p.image.grid;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        const Eigen::Vector3d x = Eigen::Vector3d(i, j, k).cwiseProduct(grid.spacing_mm);
        const bool beside = std::abs((x - p.kidney).norm() - Phantom::kKidney) < 3.0;
        const Label l = labels.voxels.at({i, j, k});
        const bool is_vessel = l == structure::kHepaticVeins || l == structure::kPortalVein;
        if (beside && depth_in(p.hepatic, x) < -2.0 && is_vessel) ++rim;
      }
  qInfo("%ld voxels of the kidney's rim", rim);
  QVERIFY2(rim < 20, qPrintable(QString::number(rim)));
  const Counts hepatic = compare(p, labels).second;
  QVERIFY2(hepatic.dice() > 0.8, qPrintable(QString::number(hepatic.dice())));
}

void VesselsTest::ATreeTapersFromItsRoot() {
  // A branch whose origin is narrower and dim, as in a fissure's fat, and a thin bright vessel of the other
  // tree that ends in it: the thin one cannot feed it.
  Field grid = field_of({80, 40, 40}, 1.0);
  Mask candidates = grid.empty_mask();
  std::vector<float> brightness(grid.values.size(), 0.0F);
  const std::vector<std::pair<Tube, float>> tubes = {{{{6, 20, 20}, {24, 20, 20}, 5.0}, 1.0F},
                                                     {{{24, 20, 20}, {34, 20, 20}, 3.0}, 0.6F},
                                                     {{{34, 20, 20}, {72, 20, 20}, 4.0}, 1.0F},
                                                     {{{60, 20, 20}, {60, 38, 36}, 1.3}, 1.1F}};
  const auto voxel_at = [&](const Eigen::Vector3d& middle) {
    return std::vector<std::size_t>{grid.offset(middle.cast<int>())};
  };
  for (const auto& [tube, bright] : tubes)
    for (std::size_t at = 0; at < brightness.size(); ++at)
      if (depth_in({tube}, grid.voxel_at(at).cast<double>()) > 0.0) {
        candidates.voxels[at] = 1;
        brightness[at] = std::max(brightness[at], bright);
      }
  const auto owner =
      split_trees(grid, candidates, brightness, voxel_at({8, 20, 20}), voxel_at({60, 37, 35}), RunContext())
          .value();
  for (const int x : {10, 30, 40, 50, 70})
    QVERIFY2(owner[grid.offset(Eigen::Vector3i(x, 20, 20))] == Owner::portal, qPrintable(QString::number(x)));
  QVERIFY(owner[grid.offset(Eigen::Vector3i(60, 31, 30))] == Owner::hepatic);
}

void VesselsTest::ATrunkIsClickedWhereItIsWidest() {
  Phantom::Setting setting;
  setting.liver_from = 38.0;
  const Phantom p(1, setting);
  const Counts portal = compare(p, p.found(p.trunk_and_branches(), p.liver).labels).first;
  qInfo("portal %ld right, %ld missed, %ld far", portal.right, portal.missed, portal.far);
  QVERIFY(portal.right > 1000 && portal.right > 20 * portal.missed && portal.far < 20);
}

void VesselsTest::ATreeThatIsNotSeenIsNotInvented() {
  // As in a late arterial phase: the portal vein is there, the hepatic veins are as grey as the liver.
  Phantom::Setting setting;
  setting.portal_hu = 190.0;
  setting.hepatic_hu = 114.0;
  const Phantom p(1, setting);
  const Segmented found = p.found(p.trunk_and_branches(), p.liver);
  const auto [portal, hepatic] = compare(p, found.labels);
  QVERIFY(tells(found, "hepatic_veins.faint") && tells(found, "hepatic_veins.not_found"));
  QVERIFY(!tells(found, "portal_vein.faint"));
  QCOMPARE(hepatic.right + hepatic.extra, 0L);
  QVERIFY2(portal.dice() > 0.8, qPrintable(QString::number(portal.dice())));
}

void VesselsTest::ATreeTwiceAsBrightIsFound() {
  // The contrast is that of most clicks; nothing as bright as those of one tree is too bright for it.
  Phantom::Setting setting;
  setting.liver_from = 38.0;
  setting.hepatic_hu = 150.0;
  const Phantom p(1, setting);
  const auto [portal, hepatic] = compare(p, p.found(p.trunk_and_branches(), p.liver).labels);
  qInfo("portal %ld right, %ld missed; hepatic %ld right", portal.right, portal.missed, hepatic.right);
  QVERIFY(portal.right > 1000 && portal.right > 20 * portal.missed && hepatic.right > 1000);
}

void VesselsTest::AHeartThatShinesInIsNoVein() {
  // The uppermost 10 mm of the liver are half as bright as its veins, one of which runs through them.
  Phantom::Setting setting;
  setting.heart_from = 78.0;
  const Phantom p(1, setting);
  const Counts hepatic = compare(p, p.found(p.roots(), p.liver).labels).second;
  qInfo("%ld right, %ld far", hepatic.right, hepatic.far);
  QVERIFY(hepatic.right > 1000 && hepatic.far < 20);
}

void VesselsTest::AClickBesideEveryBranchIsTold() {
  const Phantom p(1);
  Seeds seeds = p.roots();
  seeds.portal_vein = p.at({{54, 49, 14}, {20, 15, 80}, {54, 52, 30}});  // the second one in parenchyma
  const Segmented found = p.found(seeds, p.liver);
  QVERIFY(tells(found, "portal_vein.click_without_effect 2"));
  const auto of_clicks = [](const std::vector<std::string>& notes) {
    return std::count_if(notes.begin(), notes.end(), [](const std::string& note) {
      return note.find("click_without_effect") != std::string::npos;
    });
  };
  QCOMPARE(of_clicks(found.report.notes), 1);
  QCOMPARE(of_clicks(p.found(p.roots(), p.liver).report.notes), 0);
}

void VesselsTest::AClickAgainstTheLiverOnAVesselIsTold() {
  Phantom::Setting setting;
  setting.liver_from = 38.0;
  const Phantom p(1, setting);
  Seeds seeds = p.trunk_and_branches();
  // In fat; on the trunk, 20 mm before the liver, where it takes no part of that; in a branch in the liver.
  seeds.background = p.at({{20, 15, 10}, {54, 48, 18}, {39.5, 48, 51}});
  const Segmented found = p.found(seeds, p.liver);
  QCOMPARE(found.labels.voxels.at({39, 34, 15}), structure::kPortalVein);
  const std::vector<std::string>& notes = found.report.notes;
  QVERIFY(tells(found, "seed.not_liver_taken 3 portal_vein"));
  QCOMPARE(std::count_if(notes.begin(), notes.end(),
                         [](const std::string& note) { return note.starts_with("seed."); }),
           1);
}

QTEST_APPLESS_MAIN(VesselsTest)
#include "vessels_test.moc"
