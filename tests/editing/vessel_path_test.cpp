// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/vessel_path.h"

#include <QTest>
#include <fstream>

#include "edit_applied.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"

using namespace glisson;
using namespace glisson::editing;
using namespace glisson::test;

namespace {

constexpr double kBow = 22.0;              ///< mm: radius of the circle that the middle line runs on
constexpr double kFrom = 0.25, kTo = 2.4;  ///< radians of it, clicks lie at its ends

/// A vessel along an arc, as a CT would show it: an edge 1 mm wide, noise, and a stretch without contrast.
struct Arc {
  VolumeGrid grid;
  Eigen::Vector3d centre;  ///< mm along the voxel axes
  Eigen::Vector3d u, v;
  double radius = 2.5;
  double gap_from = 9.0, gap_to = 9.0;  ///< radians

  explicit Arc(const Eigen::Vector3d& spacing_mm, double r = 2.5) : radius(r) {
    grid.spacing_mm = spacing_mm;
    grid.size = (Eigen::Vector3d(68.0, 52.0, 48.0).cwiseQuotient(spacing_mm)).array().ceil().cast<int>();
    grid.origin_mm = {-12.0, 31.0, 240.0};
    centre = {34.0, 14.0, 22.0};
    u = Eigen::Vector3d(1.0, 0.0, 0.3).normalized();
    v = u.cross(Eigen::Vector3d(0.2, -0.3, 1.0).normalized().cross(u)).normalized();
    v = Eigen::Vector3d(-0.1, 1.0, 0.35);
    v = (v - u * u.dot(v)).normalized();
  }
  Eigen::Vector3d middle(double angle) const {
    return centre + kBow * (std::cos(angle) * u + std::sin(angle) * v);
  }
  double angle_of(const Eigen::Vector3d& p) const {
    return std::atan2((p - centre).dot(v), (p - centre).dot(u));
  }
  /// Distance to the whole circle; the vessel goes on beyond the clicks.
  double off(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d w = p - centre;
    const double a = w.dot(u), b = w.dot(v), c = w.dot(u.cross(v));
    return std::hypot(std::hypot(a, b) - kBow, c);
  }
  bool in_gap(double angle) const { return angle > gap_from && angle < gap_to; }
  Image image(double contrast, double noise_hu, unsigned seed = 3) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, noise_hu);
    return image_of(grid, [&](const Eigen::Vector3i& at) {
      const Eigen::Vector3d p = place_of(grid, at);
      const double inside = std::clamp((radius - off(p)) / 1.0 + 0.5, 0.0, 1.0);
      return 110.0 + (in_gap(angle_of(p)) ? 0.0 : contrast * inside) + noise(random);
    });
  }
  Points clicks(const std::vector<double>& angles, double astray_mm = 0.8) const {
    Points points(static_cast<Eigen::Index>(angles.size()), 3);
    double sign = 1.0;
    for (std::size_t n = 0; n < angles.size(); ++n, sign = -sign)
      points.row(static_cast<Eigen::Index>(n)) =
          p_at(grid, middle(angles[n]) + sign * astray_mm * u.cross(v)).transpose();
    return points;
  }
};

/// What is measured on labelled voxels, not on what the tool says of itself.
struct Measured {
  double off_mm = 0.0;     ///< of the centroids of stretches of the arc from its middle line, mean
  double radius_mm = 0.0;  ///< of a tube of the same volume
  double dice = 0.0;       ///< with the voxels that lie within the radius
};

/// Between two angles of the arc.
Measured measured(const Arc& arc, const LabelVolume& labels, Label label, double from, double to) {
  constexpr int kStretches = 12;
  std::array<Eigen::Vector3d, kStretches> sums;
  sums.fill(Eigen::Vector3d::Zero());
  std::array<double, kStretches> weights{};
  double both = 0.0, all = 0.0, found = 0.0;
  for (int k = 0; k < arc.grid.size.z(); ++k)
    for (int j = 0; j < arc.grid.size.y(); ++j)
      for (int i = 0; i < arc.grid.size.x(); ++i) {
        const Eigen::Vector3d p = place_of(arc.grid, {i, j, k});
        const double angle = arc.angle_of(p);
        if (angle < from || angle >= to) continue;
        const bool is = labels.at({i, j, k}) == label, should = arc.off(p) <= arc.radius;
        both += is && should ? 1.0 : 0.0;
        all += (is ? 1.0 : 0.0) + (should ? 1.0 : 0.0);
        if (!is) continue;
        found += 1.0;
        const auto n = static_cast<std::size_t>(kStretches * (angle - from) / (to - from));
        sums[n] += p;
        weights[n] += 1.0;
      }
  Measured result;
  for (std::size_t n = 0; n < kStretches; ++n)
    result.off_mm += (weights[n] > 0.0 ? arc.off(sums[n] / weights[n]) : 20.0) / kStretches;
  result.dice = all > 0.0 ? 2.0 * both / all : 0.0;
  result.radius_mm = std::sqrt(found * arc.grid.voxel_volume_mm3() / (M_PI * kBow * (to - from)));
  return result;
}

VesselPath way_of(const Points& path, Label label = structure::kPortalVein) {
  VesselPath tool;
  tool.label = label;
  tool.path = path;
  return tool;
}

LabelMap all_parenchyma(const VolumeGrid& grid) {
  return labels_of(grid, [](const Eigen::Vector3i&) { return structure::kParenchyma; });
}

Mask mask_of(const LabelVolume& labels, Label label) {
  Mask mask(labels.grid().size, labels.grid().spacing_mm);
  const std::vector<Label> dense = labels.dense();
  for (std::size_t at = 0; at < dense.size(); ++at) mask.voxels[at] = dense[at] == label ? 1 : 0;
  return mask;
}

/// Pieces of a label that hang together through faces, by a flood that knows nothing of the tools.
int pieces(const LabelVolume& labels, Label label) {
  Mask mask = mask_of(labels, label);
  int count = 0;
  std::vector<Eigen::Vector3i> todo;
  const auto take = [&](const Eigen::Vector3i& v) {
    if (!labels.grid().contains(v)) return;
    std::uint8_t& voxel = mask.voxels[mask.offset(v.x(), v.y(), v.z())];
    if (voxel == 0) return;
    voxel = 0;
    todo.push_back(v);
  };
  for (int k = 0; k < mask.size.z(); ++k)
    for (int j = 0; j < mask.size.y(); ++j)
      for (int i = 0; i < mask.size.x(); ++i) {
        take({i, j, k});
        if (todo.empty()) continue;
        ++count;
        while (!todo.empty()) {
          const Eigen::Vector3i v = todo.back();
          todo.pop_back();
          for (int axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) take(v + step * Eigen::Vector3i::Unit(axis));
        }
      }
  return count;
}

QString refusal(const LabelMap& labels, const Image& image, const VesselPath& tool,
                const EditableRegion& region = {}) {
  try {
    applied(labels, image, tool, region);
  } catch (const InputError& error) {
    return QString::fromStdString(error.file() + ", " + error.field() + ": " + error.problem());
  }
  return {};
}

}  // namespace

class VesselPathTest : public QObject {
  Q_OBJECT
 private slots:
  void ACurvedVesselIsFollowed_data();
  void ACurvedVesselIsFollowed();
  void AGapWithoutContrastIsMended();
  void AVesselThinnerThanAVoxelHangsTogether();
  void WhereNothingIsSeenItSaysSo();
  void OtherStructuresAndLockedLabelsStay();
  void TheRadiusIsLimited();
  void APointMoreBindsTheWay();
  void WhatCannotBeDoneIsRefused();
  void ScriptsSayIt();
  void ItCanBeCancelled();
};

void VesselPathTest::ACurvedVesselIsFollowed_data() {
  QTest::addColumn<double>("in_plane");
  QTest::addColumn<double>("thickness");
  QTest::addColumn<double>("radius");
  QTest::addColumn<double>("contrast");
  QTest::newRow("cubes") << 0.7 << 0.7 << 2.5 << 60.0;
  QTest::newRow("thin") << 0.7 << 0.7 << 1.5 << 60.0;
  QTest::newRow("thick slices") << 0.7 << 3.0 << 3.5 << 60.0;
  QTest::newRow("dark") << 0.7 << 0.7 << 2.5 << -50.0;
  QTest::newRow("wide") << 0.8 << 1.6 << 5.0 << 60.0;
}

void VesselPathTest::ACurvedVesselIsFollowed() {
  QFETCH(double, in_plane);
  QFETCH(double, thickness);
  QFETCH(double, radius);
  QFETCH(double, contrast);
  const Arc arc({in_plane, in_plane, thickness}, radius);
  const LabelMap before = all_parenchyma(arc.grid);
  const VesselPath tool = way_of(arc.clicks({kFrom, kTo}));
  const Edited edited = applied(before, arc.image(contrast, 12.0), tool);
  const Measured is = measured(arc, edited.labels.voxels, tool.label, kFrom, kTo);
  // The straight tube between the clicks, with the radius that is known: what a brush would draw.
  Paint straight;
  straight.label = tool.label;
  straight.brush = Paint::Brush::ball;
  straight.radius = 1e-3 * radius;
  straight.path = tool.path;
  const Measured line = measured(arc, applied(before, arc.image(contrast, 12.0), straight).labels.voxels,
                                 tool.label, kFrom, kTo);
  const QString figures = QString("off %1 mm, radius %2 mm, Dice %3; straight: off %4 mm, Dice %5")
                              .arg(is.off_mm)
                              .arg(is.radius_mm)
                              .arg(is.dice)
                              .arg(line.off_mm)
                              .arg(line.dice);
  qInfo() << qPrintable(figures);
  QVERIFY2(is.off_mm < std::cbrt(arc.grid.voxel_volume_mm3()), qPrintable(figures));
  QVERIFY2(std::abs(is.radius_mm / radius - 1.0) < 0.2, qPrintable(figures));
  QVERIFY2(is.dice > 0.8, qPrintable(figures));
  QVERIFY2(line.off_mm > 3.0 * is.off_mm && line.dice < 0.5 * is.dice, qPrintable(figures));
  QCOMPARE(pieces(edited.labels.voxels, tool.label), 1);
  QVERIFY(edited.notes.empty());
}

void VesselPathTest::AGapWithoutContrastIsMended() {
  for (const Eigen::Vector3d& spacing : {Eigen::Vector3d(0.7, 0.7, 0.7), Eigen::Vector3d(0.7, 0.7, 3.0)}) {
    Arc arc(spacing, 3.0);
    arc.gap_from = 1.2;  // 8 mm
    arc.gap_to = 1.2 + 8.0 / kBow;
    // A tree of which the part about the gap was not found.
    const double from = arc.gap_from - 0.15, to = arc.gap_to + 0.15;
    const LabelMap before = labels_of(arc.grid, [&](const Eigen::Vector3i& at) {
      const Eigen::Vector3d p = place_of(arc.grid, at);
      const double angle = arc.angle_of(p);
      const bool known = arc.off(p) <= arc.radius && (angle < from || angle > to);
      return known ? structure::kHepaticVeins : structure::kParenchyma;
    });
    QCOMPARE(pieces(before.voxels, structure::kHepaticVeins), 2);
    const auto tool = way_of(arc.clicks({from - 0.1, to + 0.1}), structure::kHepaticVeins);
    const Edited edited = applied(before, arc.image(60.0, 12.0), tool);
    QCOMPARE(pieces(edited.labels.voxels, structure::kHepaticVeins), 1);
    const Measured is = measured(arc, edited.labels.voxels, structure::kHepaticVeins, from, to);
    const QString figures =
        QString("off %1 mm, radius %2 mm, Dice %3").arg(is.off_mm).arg(is.radius_mm).arg(is.dice);
    qInfo() << qPrintable(figures);
    QVERIFY2(is.off_mm < std::cbrt(arc.grid.voxel_volume_mm3()), qPrintable(figures));
    QVERIFY2(std::abs(is.radius_mm / arc.radius - 1.0) < 0.2, qPrintable(figures));
    QVERIFY2(is.dice > 0.8, qPrintable(figures));
  }
}

void VesselPathTest::AVesselThinnerThanAVoxelHangsTogether() {
  const Arc arc({0.9, 0.9, 0.9}, 0.45);
  const Edited edited =
      applied(all_parenchyma(arc.grid), arc.image(120.0, 3.0), way_of(arc.clicks({kFrom, kTo}, 0.0)));
  QCOMPARE(pieces(edited.labels.voxels, structure::kPortalVein), 1);
  const Measured is = measured(arc, edited.labels.voxels, structure::kPortalVein, kFrom, kTo);
  QVERIFY2(is.off_mm < 1.3 && is.radius_mm < 1.5, qPrintable(QString::number(is.off_mm)));
}

void VesselPathTest::WhereNothingIsSeenItSaysSo() {
  const Arc arc({0.8, 0.8, 0.8});
  Edited edited = applied(all_parenchyma(arc.grid), arc.image(0.0, 12.0), way_of(arc.clicks({0.4, 1.0})));
  QCOMPARE(pieces(edited.labels.voxels, structure::kPortalVein), 1);
  QVERIFY2(edited.notes == std::vector<std::string>{"vessel_path.radius_unseen"},
           edited.notes.empty() ? "no note" : edited.notes.front().c_str());
  // No wider than it must be.
  QVERIFY(ml_of(edited.labels, structure::kPortalVein) < 0.05);
  Arc mostly = arc;
  mostly.gap_from = 0.7;
  mostly.gap_to = 1.7;
  edited = applied(all_parenchyma(arc.grid), mostly.image(60.0, 5.0), way_of(arc.clicks({0.5, 1.9})));
  QVERIFY(edited.notes.size() == 1 && edited.notes.front().starts_with("vessel_path.faint:"));
}

void VesselPathTest::OtherStructuresAndLockedLabelsStay() {
  const Arc arc({0.7, 0.7, 0.7}, 3.0);
  const Image image = arc.image(60.0, 8.0);
  // A hepatic vein runs along the vessel and into it, a lesion lies beside it.
  const LabelMap before = labels_of(arc.grid, [&](const Eigen::Vector3i& at) {
    const Eigen::Vector3d p = place_of(arc.grid, at);
    if ((p - arc.middle(1.6)).dot(arc.u.cross(arc.v)) > 1.0 && arc.off(p) < 6.0)
      return structure::kHepaticVeins;
    if ((p - arc.middle(0.9) - 4.0 * arc.u).norm() < 2.5) return structure::kFirstLesion;
    return structure::kParenchyma;
  });
  const auto tool = way_of(arc.clicks({kFrom, kTo}, 0.0));
  const Edited edited = applied(before, image, tool);
  const std::vector<Label> was = before.voxels.dense(), is = edited.labels.voxels.dense();
  long won = 0;
  for (std::size_t at = 0; at < was.size(); ++at) {
    if (was[at] != structure::kParenchyma) QCOMPARE(is[at], was[at]);
    won += is[at] == structure::kPortalVein ? 1 : 0;
  }
  QVERIFY(won > 1000);
  QCOMPARE(won, edited.voxels_changed);
  QCOMPARE(pieces(edited.labels.voxels, structure::kPortalVein), 1);
  EditableRegion locked;
  locked.locked = {structure::kParenchyma};
  QVERIFY(refusal(before, image, tool, locked).contains("point 1 lies in parenchyma, which may not"));
  locked.locked = {structure::kPortalVein};
  QVERIFY(refusal(before, image, tool, locked).startsWith("vessel_path, label: "));
}

void VesselPathTest::TheRadiusIsLimited() {
  const Arc arc({0.8, 0.8, 0.8}, 4.0);
  VesselPath tool = way_of(arc.clicks({kFrom, kTo}, 0.0));
  tool.largest_radius = 2e-3;
  const Edited edited = applied(all_parenchyma(arc.grid), arc.image(60.0, 8.0), tool);
  const Measured is = measured(arc, edited.labels.voxels, tool.label, kFrom, kTo);
  QVERIFY2(std::abs(is.radius_mm - 2.0) < 0.3, qPrintable(QString::number(is.radius_mm)));
}

void VesselPathTest::APointMoreBindsTheWay() {
  // Two vessels part and meet again: which one is meant says a point between the ends.
  const Arc arc({0.8, 0.8, 0.8}, 2.0);
  const Eigen::Vector3d a = arc.middle(0.4), b = arc.middle(2.2);
  const Image image = image_of(arc.grid, [&](const Eigen::Vector3i& at) {
    const Eigen::Vector3d p = place_of(arc.grid, at);
    const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    const double straight = (p - a - t * (b - a)).norm();
    return 110.0 + 60.0 * std::clamp(2.5 - std::min(arc.off(p), straight), 0.0, 1.0);
  });
  const LabelMap before = all_parenchyma(arc.grid);
  const auto of_arc = [&](const Points& path) {
    return measured(arc, applied(before, image, way_of(path)).labels.voxels, structure::kPortalVein, 0.6,
                    2.0);
  };
  QVERIFY(of_arc(arc.clicks({0.4, 2.2}, 0.0)).dice < 0.2);
  QVERIFY(of_arc(arc.clicks({0.4, 1.3, 2.2}, 0.0)).dice > 0.8);
}

void VesselPathTest::WhatCannotBeDoneIsRefused() {
  const Arc arc({1.0, 1.0, 1.0});
  Image image = arc.image(60.0, 5.0);
  const LabelMap before = all_parenchyma(arc.grid);
  const Points good = arc.clicks({0.4, 1.4}, 0.0);
  QVERIFY(refusal(before, image, way_of(good)).isEmpty());
  for (const Label label : {structure::kParenchyma, structure::kGallbladder, structure::kFirstLesion}) {
    const QString said = refusal(before, image, way_of(good, label));
    QVERIFY2(said.startsWith("vessel_path, label: ") && said.contains("which is no vessel"),
             qPrintable(said));
  }
  QVERIFY(
      refusal(before, image, way_of(good.topRows(1))).startsWith("vessel_path, path: has fewer than two"));
  Points path = good;
  path.row(1) = path.row(0);
  QVERIFY(refusal(before, image, way_of(path)).contains("same place twice (point 1 and point 2)"));
  path.row(0) = arc.grid.p_in_ct({50.0, 20.0, 30.0}).xyz.transpose();
  path.row(1) = arc.grid.p_in_ct({50.2, 20.0, 30.0}).xyz.transpose();
  QVERIFY(refusal(before, image, way_of(path)).contains("point 1 and point 2 are one voxel"));
  path.row(1) = arc.grid.p_in_ct({-3.0, 5.0, 5.0}).xyz.transpose();
  QVERIFY(refusal(before, image, way_of(path)).contains("point 2 lies outside the volume"));
  path.row(1).x() += 0.2;
  QVERIFY(refusal(before, image, way_of(path)).contains("between point 1 and point 2, more than 100 mm"));
  path.row(1).x() = std::numeric_limits<double>::quiet_NaN();
  QVERIFY(!refusal(before, image, way_of(path)).isEmpty());
  VesselPath tool = way_of(good);
  for (const double radius : {0.0, 0.3e-3, 9e-3}) {
    tool.largest_radius = radius;
    QVERIFY(refusal(before, image, tool).startsWith("vessel_path, largest_radius: "));
  }
  QVERIFY(refusal(before, image, way_of(good, structure::kBackground)).startsWith("vessel_path, label: "));
  // A wall of air between the ends, and a point in it.
  const Image air = image_of(arc.grid, [&](const Eigen::Vector3i& at) {
    const Eigen::Vector3d along = std::cos(0.9) * arc.v - std::sin(0.9) * arc.u;
    const bool wall = std::abs((place_of(arc.grid, at) - arc.middle(0.9)).dot(along)) < 2.5;
    return wall ? -900.0 : static_cast<double>(image.at(at));
  });
  QVERIFY(refusal(before, air, way_of(good)).contains("has no way from point 1 to point 2"));
  path = good;
  path.row(1) = p_at(arc.grid, arc.middle(0.9)).transpose();
  QVERIFY(refusal(before, air, way_of(path)).contains("point 2 lies in air, fat or bone"));
  // The same numbers mean nothing in an MRI.
  Image mr = air;
  mr.modality = Modality::mr;
  QVERIFY(refusal(before, mr, way_of(good)).isEmpty());
}

void VesselPathTest::ScriptsSayIt() {
  const TemporaryFolder folder;
  const auto file = folder.path() / "edits.json";
  const std::vector<Edit> read = [&] {
    std::ofstream(file) << R"({"edits": [{"tool": "vessel_path", "label": "hepatic_veins",
        "path_mm": [[1, 2, 3], [4, 5, 6]]}, {"tool": "vessel_path", "label": "portal_vein",
        "largest_radius_mm": 3, "path_mm": [[1, 2, 3], [4, 5, 6], [7, 8, 10]]}]})";
    return read_edits(file);
  }();
  QCOMPARE(read.size(), std::size_t(2));
  const auto& first = read[0].tool.as<VesselPath>();
  QVERIFY(first.label == structure::kHepaticVeins && first.largest_radius == 8e-3 && first.path.rows() == 2);
  QVERIFY((first.path.row(1).transpose() - Eigen::Vector3d(4e-3, 5e-3, 6e-3)).norm() < 1e-12);
  QCOMPARE(read[1].tool.as<VesselPath>().largest_radius, 3e-3);
  write_edits(folder.path() / "again.json", read);
  QVERIFY(read_edits(folder.path() / "again.json")[1].tool.as<VesselPath>().path.rows() == 3);
  std::ofstream(file)
      << R"({"edits": [{"tool": "vessel_path", "label": "portal_vein", "path_mm": [[1, 2, 3]]}]})";
  try {
    read_edits(file);
    QFAIL("read");
  } catch (const InputError& error) {
    QVERIFY2(error.field().starts_with("edit 1"), error.what());
  }
}

void VesselPathTest::ItCanBeCancelled() {
  const Arc arc({0.8, 0.8, 0.8});
  const Image image = arc.image(60.0, 8.0);
  const LabelMap before = all_parenchyma(arc.grid);
  const Edit edit{way_of(arc.clicks({kFrom, kTo})), {}};
  std::vector<double> parts;
  QVERIFY(apply_edit(before, image, edit,
                     RunContext([&](double part, std::string_view) { parts.push_back(part); }, nullptr, 1))
              .has_value());
  QVERIFY(parts.size() > 4 && std::ranges::is_sorted(parts) && parts.back() == 1.0);
  for (std::size_t stop = 1; stop < parts.size(); ++stop) {
    const auto flag = std::make_shared<CancelFlag>();
    std::size_t heard = 0;
    const RunContext context(
        [&](double, std::string_view) {
          if (++heard == stop) flag->request();
        },
        flag, 1);
    QVERIFY(!apply_edit(before, image, edit, context).has_value());
  }
}

QTEST_APPLESS_MAIN(VesselPathTest)
#include "vessel_path_test.moc"
