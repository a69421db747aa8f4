// SPDX-License-Identifier: GPL-3.0-or-later
// The anterior margin of a liver that the image's edge cuts off.
#include <QTest>
#include <algorithm>
#include <numbers>

#include "anatomy.h"
#include "cut_faces.h"
#include "glisson/geometry/closest_point_tree.h"
#include "glisson/geometry/sharpness.h"
#include "glisson/model/build.h"
#include "glisson/patient/cut_organ.h"

using namespace glisson;

namespace {

const Eigen::Vector3d kHalfAxes(80, 60, 60), kInferiorAnterior(0.0, -1.0, -1.0);
constexpr double kLowest = -64.0, kCut = -24.0;  // mm: where the image begins, whole and cut

/// The upper part of an ellipsoid, cut by a plane that faces down, backwards and to the left: a sharp rim,
/// lowest on the right. Millimetres.
bool is_liver(const Eigen::Vector3d& p) {
  return p.cwiseQuotient(kHalfAxes).norm() < 1.0 && p.dot(Eigen::Vector3d(0.45, 0.45, -1.0)) < 5.0;
}

LabelMap liver_from(double lowest_mm) {
  VolumeGrid grid;
  grid.spacing_mm << 1.5, 1.5, 2.0;
  grid.origin_mm << -90.0, -70.0, lowest_mm;
  grid.size << 121, 94, static_cast<int>((66.0 - lowest_mm) / 2.0);
  std::vector<Label> dense;
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i)
        dense.push_back(is_liver(1e3 * grid.p_in_ct({double(i), double(j), double(k)}).xyz)
                            ? structure::kParenchyma
                            : structure::kBackground);
  LabelMap map;
  map.voxels = LabelVolume(grid, dense);
  return map;
}

model::BuiltModel built(const LabelMap& labels, const Image* image = nullptr) {
  model::ModelOptions options;
  options.vessels = false;
  options.mesh.target_vertices = 150;
  return *model::build_from_labels(labels, options, RunContext(), image);
}

TriangleMesh faces_of(const LabelMap& labels) {
  const auto liver = labels.voxels.mask([](Label label) { return label == structure::kParenchyma; });
  return model::cut_faces(labels.voxels.grid(), image_cut(labels.voxels.grid(), liver));
}

std::string note_of(const model::BuiltModel& model, const std::string& code) {
  for (const std::string& note : model.report.notes)
    if (note.rfind(code, 0) == 0) return note;
  return {};
}

double farthest_from(const Points& line, const Points& other) {
  double farthest = 0.0;
  for (Eigen::Index i = 0; i < line.rows(); ++i)
    farthest = std::max(farthest, (other.rowwise() - line.row(i)).rowwise().norm().minCoeff());
  return farthest;
}

}  // namespace

class CutMarginTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void AWholeLiverKeepsItsBits();
  void NoMarginLiesOnTheCut();
  void TheTrueMarginStaysElsewhere();
  void WhatWasLeftOutIsTold();
  void PaddingIsAnEnd();
  void ALiverLeftOfTheCavaIsTold();
  void FacesLieWhereTheImageEnds_data();
  void FacesLieWhereTheImageEnds();

 private:
  model::BuiltModel whole_, cut_;
  TriangleMesh faces_;
};

void CutMarginTest::initTestCase() {
  whole_ = built(liver_from(kLowest));
  const LabelMap labels = liver_from(kCut);
  cut_ = built(labels);
  faces_ = faces_of(labels);
  for (const std::string& note : cut_.report.notes) qInfo("%s", note.c_str());
}

void CutMarginTest::AWholeLiverKeepsItsBits() {
  QVERIFY(whole_.model.landmarks.anterior_margin.rows() > 30);
  QVERIFY(whole_.model.landmarks.anterior_margin ==
          model::detect_anterior_margin(whole_.model.surfaces.front().mesh, kInferiorAnterior));
  QVERIFY(note_of(whole_, "landmarks.").empty());
}

void CutMarginTest::NoMarginLiesOnTheCut() {
  const ClosestPointTree tree(faces_);
  const auto nearest = [&](const Points& line) {
    double least = 1.0;
    for (Eigen::Index i = 0; i < line.rows(); ++i)
      least = std::min(least, tree.closest(line.row(i).transpose()).distance);
    return 1e3 * least;
  };
  // Where nobody knows of the cut, the line runs along it.
  QVERIFY(nearest(model::detect_anterior_margin(cut_.model.surfaces.front().mesh, kInferiorAnterior)) < 3.0);
  const Points& margin = cut_.model.landmarks.anterior_margin;
  QVERIFY(margin.rows() > 20);
  // The line is made even on the surface: it may come nearer by less than its spacing.
  QVERIFY2(nearest(margin) > 1e3 * kSharpnessRadius - 1.5, qPrintable(QString::number(nearest(margin))));
}

void CutMarginTest::TheTrueMarginStaysElsewhere() {
  const Points &margin = cut_.model.landmarks.anterior_margin,
               &truth = whole_.model.landmarks.anterior_margin;
  const double beside = 1e3 * farthest_from(margin, truth);
  QVERIFY2(beside < 4.0, qPrintable(QString::number(beside)));
  const ClosestPointTree tree(faces_);
  // The cut parts the margin, and the longer part stays: the front of the left. Where it ends in the back is
  // a matter of thresholds, which come from the shape.
  std::vector<Eigen::Index> away;
  for (Eigen::Index i = 0; i < truth.rows(); ++i)
    if (truth(i, 0) > 0.0 && truth(i, 1) < 0.0 && truth(i, 2) > 1e-3 * kCut &&
        tree.closest(truth.row(i).transpose()).distance > kSharpnessRadius + 3e-3)
      away.push_back(i);
  QVERIFY(away.size() > 20);
  const double missed = 1e3 * farthest_from(truth(away, Eigen::all), margin);
  QVERIFY2(missed < 6.0, qPrintable(QString::number(missed)));
}

void CutMarginTest::WhatWasLeftOutIsTold() {
  const std::string note = note_of(cut_, "landmarks.margin_on_cut ");
  QVERIFY2(!note.empty(), "nothing was told");
  const double length_mm = std::stod(note.substr(note.find(' ')));
  QVERIFY2(length_mm > 10.0 && length_mm < 200.0, note.c_str());
}

/// The same cut where the image goes on with voxels that nobody has scanned.
void CutMarginTest::PaddingIsAnEnd() {
  LabelMap labels = liver_from(kLowest);
  Image image;
  image.grid = labels.voxels.grid();
  std::vector<std::int16_t> voxels(static_cast<std::size_t>(image.grid.voxel_count()), 50);
  for (int k = 0; k < static_cast<int>((kCut - kLowest) / image.grid.spacing_mm.z()); ++k)
    for (int j = 0; j < image.grid.size.y(); ++j)
      for (int i = 0; i < image.grid.size.x(); ++i) {
        labels.voxels.set({i, j, k}, structure::kBackground);
        voxels[static_cast<std::size_t>(image.grid.offset({i, j, k}))] = -1024;
      }
  image.voxels = std::make_shared<const std::vector<std::int16_t>>(voxels);
  const model::BuiltModel padded = built(labels, &image);
  // A rim that ends one voxel before the padding counts, too: there the image may be blurred.
  const long at_padding = told_cut(padded.report.notes), at_end = told_cut(cut_.report.notes);
  QVERIFY2(at_end > 0 && at_padding >= at_end &&
               static_cast<double>(at_padding) < 1.25 * static_cast<double>(at_end),
           qPrintable(QStringLiteral("%1 cm2, %2 where the image ends").arg(at_padding).arg(at_end)));
  const Points& margin = padded.model.landmarks.anterior_margin;
  QVERIFY(margin.rows() > 20);
  const ClosestPointTree tree(faces_);
  for (Eigen::Index i = 0; i < margin.rows(); ++i)
    QVERIFY(1e3 * tree.closest(margin.row(i).transpose()).distance > 1e3 * kSharpnessRadius - 1.5);
}

/// Whoever has let it in as the remnant of a right hepatectomy is told with each model.
void CutMarginTest::ALiverLeftOfTheCavaIsTold() {
  for (const bool on_its_right : {false, true}) {
    LabelMap labels = liver_from(kLowest);
    for (int k = 0; k < labels.voxels.grid().size.z(); ++k)
      for (int j = 85; j < 90; ++j)
        for (int i = 0; i < 5; ++i)
          labels.voxels.set({on_its_right ? i + 2 : i + 110, j, k}, structure::kVenaCava);
    const auto anatomy = model::anatomy_of(labels, {}, RunContext());
    QCOMPARE(std::ranges::count(anatomy->notes, "liver.perhaps_mirrored"), on_its_right ? 1L : 0L);
  }
}

void CutMarginTest::FacesLieWhereTheImageEnds_data() {
  QTest::addColumn<int>("axis");
  QTest::addColumn<bool>("high");
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true})
      QTest::addRow("axis %d, %s", axis, high ? "end" : "begin") << axis << high;
}

void CutMarginTest::FacesLieWhereTheImageEnds() {
  QFETCH(int, axis);
  QFETCH(bool, high);
  VolumeGrid grid;
  grid.size << 9, 8, 7;
  grid.spacing_mm << 1.0, 2.0, 3.0;
  grid.origin_mm << -5.0, 40.0, 900.0;
  grid.direction.col(0) << 0, -1, 0;
  grid.direction.col(1) << 1, 0, 0;
  std::vector<std::uint8_t> organ(9UL * 8UL * 7UL, 0);
  QCOMPARE(model::cut_faces(grid, image_cut(grid, organ)).triangle_count(), 0);
  Eigen::Vector3i low(3, 3, 2), end(6, 5, 4);
  (high ? end : low)[axis] = high ? grid.size[axis] : 0;
  for (int k = low[2]; k < end[2]; ++k)
    for (int j = low[1]; j < end[1]; ++j)
      for (int i = low[0]; i < end[0]; ++i) organ[static_cast<std::size_t>(grid.offset({i, j, k}))] = 1;
  const TriangleMesh faces = model::cut_faces(grid, image_cut(grid, organ));
  QVERIFY(std::abs(1e6 * area(faces) - area_mm2(grid, image_cut(grid, organ))) < 1e-9);
  for (int v = 0; v < faces.vertex_count(); ++v) {
    const Eigen::Vector3d index = grid.index_of(Point<CtFrame>(faces.vertex(v)));
    QVERIFY(std::abs(index[axis] - (high ? grid.size[axis] - 0.5 : -0.5)) < 1e-9);
    for (int other = 0; other < 3; ++other)
      QVERIFY(index[other] > low[other] - 0.5 - 1e-9 && index[other] < end[other] - 0.5 + 1e-9);
  }
}

QTEST_APPLESS_MAIN(CutMarginTest)
#include "cut_margin_test.moc"
