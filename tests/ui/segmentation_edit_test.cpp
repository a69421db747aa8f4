// SPDX-License-Identifier: GPL-3.0-or-later
// Edits a segmentation by mouse and keyboard, like a person at the window: what tools do in the views.
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QToolButton>
#include <QWheelEvent>

#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/open_case.h"
#include "segmentation_window.h"

namespace glisson {

using scene::Plane;
using ui::edit_tool;
using ui::MainWindow;

class SegmentationEditTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void StrokeIsOneStepThatIsUndoneAndRedone();
  void CtrlErasesAndEraseTakesOnlyTheChosenLabel();
  void BrushShowsItsTrueSizeInAllSlices();
  void ShiftWheelSizesTheBrush();
  void LassoErasesWhatItEnclosesInItsSlice();
  void LassoInThreeDimensionsCutsThrough();
  void PaintingWithinIntensitiesSparesTheRest();
  void SurfacesFollowTheEdit();
  void SurfacesOfTheFormerCaseGoAtOnce();
  void TouchingTreesAreListedAndGoneTo();
  void MouseMeansWhatItMeantBesideTheTool();
};

void SegmentationEditTest::StrokeIsOneStepThatIsUndoneAndRedone() {
  open_labels();
  const LabelVolume before = labels();
  const std::size_t steps = session().history()->done();
  choose(structure::kHepaticVeins);
  press("tool_paint");
  const QSignalSpy markers(&window_->views().state(), &ui::ViewState::markers_changed);
  drag(slice(Plane::axial), {{-0.03, 0.01, 0}, {-0.01, 0.012, 0}, {0.01, 0.01, 0}, {0.02, 0.02, 0}});
  QVERIFY(settle());
  QVERIFY(markers.isEmpty());  // they would have the 3D view drawn anew for every stretch of a stroke
  for (const Eigen::Vector3d& p :
       {Eigen::Vector3d(-0.03, 0.01, 0), {-0.02, 0.011, 0}, {0.0, 0.011, 0}, {0.015, 0.015, 0}})
    QCOMPARE(at(p), structure::kHepaticVeins);
  QCOMPARE(at({-0.03, 0.01, 0.004}), structure::kParenchyma);  // a disc stays in its slice
  QCOMPARE(session().history()->done(), steps + 1);            // one drag, one step
  const LabelVolume painted = labels();
  QVERIFY(find<QToolButton>("undo")->text().contains(QStringLiteral("Paint, 10 mm, Hepatic veins")));
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY(labels() == before);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(settle());
  QVERIFY(labels() == painted);
}

void SegmentationEditTest::CtrlErasesAndEraseTakesOnlyTheChosenLabel() {
  open_labels();
  choose(structure::kPortalVein);
  press("tool_paint");
  QCOMPARE(at({0.0, -0.015, 0}), structure::kPortalVein);
  drag(slice(Plane::axial), {{0.0, -0.015, 0}, {0.004, -0.015, 0}}, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY(at({0.0, -0.015, 0}) != structure::kPortalVein);
  press("tool_erase");
  const long liver = count(structure::kParenchyma);
  drag(slice(Plane::axial), {{0.02, -0.015, 0}, {0.024, -0.013, 0}});
  QVERIFY(settle());
  QVERIFY(at({0.02, -0.015, 0}) != structure::kPortalVein);
  QVERIFY(count(structure::kParenchyma) >= liver);  // of another label nothing is taken
}

void SegmentationEditTest::BrushShowsItsTrueSizeInAllSlices() {
  open_labels();
  press("tool_paint");
  find<QComboBox>("brush_shape")->setCurrentIndex(1);  // ball
  find<QDoubleSpinBox>("brush_diameter")->setValue(30.0);
  const Point<CtFrame> pointer(0.001, 0.001, slice(Plane::axial).geometry_in_ct().origin.z());
  const auto shot = [&](Plane plane) { return slice(plane).grab().toImage(); };
  window_->views().slice(Plane::axial);
  std::map<Plane, QImage> before;
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) before[plane] = shot(plane);
  QTest::mouseMove(&slice(Plane::axial), slice(Plane::axial).widget_point(pointer).toPoint());
  QTRY_VERIFY(shot(Plane::axial) != before[Plane::axial]);
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    const QImage after = shot(plane);
    const double off = std::abs(slice(plane).geometry_in_ct().distance_of(pointer));
    const double radius = std::sqrt(0.015 * 0.015 - off * off);
    const QPointF centre = slice(plane).widget_point(pointer);
    const Eigen::Vector3d right = slice(plane).geometry_in_ct().right.normalized();
    const QPointF edge = slice(plane).widget_point(Point<CtFrame>(pointer.xyz + radius * right));
    const double wanted = edge.x() - centre.x();
    // The farthest pixels that have changed lie on the circle.
    double found = 0.0;
    for (int v = 0; v < after.height(); ++v)
      for (int u = 0; u < after.width(); ++u)
        if (after.pixel(u, v) != before[plane].pixel(u, v))
          found = std::max(found, std::hypot(u + 0.5 - centre.x(), v + 0.5 - centre.y()));
    QVERIFY2(std::abs(found - wanted) < 4.0,
             qPrintable(QStringLiteral("%1 pixels instead of %2").arg(found).arg(wanted)));
  }
}

void SegmentationEditTest::ShiftWheelSizesTheBrush() {
  open_labels();
  press("tool_paint");
  const double before = session().settings().brush_radius;
  const double z = slice(Plane::axial).geometry_in_ct().origin.z();
  const auto turn = [&](Qt::KeyboardModifiers keys, int angle) {
    ui::SliceView& axial = slice(Plane::axial);
    QWheelEvent wheel(QPointF(100, 100), axial.mapToGlobal(QPointF(100, 100)), {}, QPoint(0, angle),
                      Qt::NoButton, keys, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&axial, &wheel);
  };
  turn(Qt::ShiftModifier, 120);
  QVERIFY(session().settings().brush_radius > before);
  QCOMPARE(find<QDoubleSpinBox>("brush_diameter")->value(), 2e3 * session().settings().brush_radius);
  QCOMPARE(slice(Plane::axial).geometry_in_ct().origin.z(), z);
  turn({}, 120);  // without Shift it is the next slice, as always
  QVERIFY(slice(Plane::axial).geometry_in_ct().origin.z() > z);
}

void SegmentationEditTest::LassoErasesWhatItEnclosesInItsSlice() {
  open_labels();
  choose(structure::kFirstLesion);
  press("tool_scissors");
  QCOMPARE(at({0.03, 0, 0}), structure::kFirstLesion);
  const std::vector<Eigen::Vector3d> around = {
      {0.018, -0.012, 0}, {0.042, -0.012, 0}, {0.042, 0.012, 0}, {0.018, 0.012, 0}};
  drag(slice(Plane::axial), around);
  QVERIFY(settle());
  QVERIFY(at({0.03, 0, 0}) != structure::kFirstLesion);
  QCOMPARE(at({0.03, 0, 0.004}), structure::kFirstLesion);
  QVERIFY(count(structure::kFirstLesion) > 0);
  find<QComboBox>("scissors_depth")->setCurrentIndex(2);  // through
  drag(slice(Plane::axial), around);
  QVERIFY(settle());
  QCOMPARE(count(structure::kFirstLesion), 0L);
}

void SegmentationEditTest::LassoInThreeDimensionsCutsThrough() {
  open_labels();
  QTRY_VERIFY(!window_->views().label_surfaces().is_making());
  choose(structure::kFirstLesion);
  QTest::keyClick(window_.get(), Qt::Key_X);
  ui::RenderView& view = window_->views().volume();
  std::vector<QPoint> around;
  for (const auto& [x, z] : {std::pair{0.018, -0.012}, {0.042, -0.012}, {0.042, 0.012}, {0.018, 0.012}}) {
    const auto place = view.patient().view_point({x, 0.0, z}, view.aspect());
    QVERIFY(place.has_value());
    around.emplace_back(static_cast<int>(place->x() * view.width()),
                        static_cast<int>(place->y() * view.height()));
  }
  const long liver = count(structure::kParenchyma), vessel = count(structure::kPortalVein);
  drag(view, around);
  QVERIFY(settle());
  QCOMPARE(count(structure::kFirstLesion), 0L);
  QVERIFY(count(structure::kParenchyma) >= liver);
  QCOMPARE(count(structure::kPortalVein), vessel);
}

void SegmentationEditTest::PaintingWithinIntensitiesSparesTheRest() {
  open_labels();
  choose(structure::kHepaticVeins);
  QTest::keyClick(window_.get(), Qt::Key_T);
  find<QDoubleSpinBox>("threshold_low")->setValue(150.0);
  find<QDoubleSpinBox>("threshold_high")->setValue(200.0);
  press("threshold_mask");
  QCOMPARE(session().tool(), edit_tool("paint"));
  drag(slice(Plane::axial), {{-0.01, -0.022, 0}, {0.01, -0.008, 0}});  // across the portal vein
  QVERIFY(settle());
  QVERIFY(count(structure::kHepaticVeins) > 0);
  for (const int k : {21, 22})
    for (int j = 0; j < ct_.grid.size.y(); ++j)
      for (int i = 0; i < ct_.grid.size.x(); ++i)
        if (labels().at({i, j, k}) == structure::kHepaticVeins) QVERIFY(ct_.at({i, j, k}) >= 150);
}

void SegmentationEditTest::SurfacesFollowTheEdit() {
  open_labels();
  const ui::LabelSurfaceSource& source = window_->views().label_surfaces();
  QTRY_VERIFY(!source.is_making() && !source.surfaces()->blocks().empty());
  const auto has = [&](Label label) {
    const auto& blocks = source.surfaces()->blocks();
    return std::any_of(blocks.begin(), blocks.end(),
                       [&](const auto& entry) { return entry.first.first == label; });
  };
  QVERIFY(has(structure::kParenchyma) && has(structure::kPortalVein) && !has(structure::kVenaCava));
  choose(structure::kVenaCava);
  press("tool_paint");
  find<QComboBox>("brush_shape")->setCurrentIndex(1);
  bool flickered = false;
  const QMetaObject::Connection watched = connect(&source, &ui::LabelSurfaceSource::changed, this, [&] {
    flickered = flickered || !has(structure::kParenchyma);
  });
  drag(slice(Plane::axial), {{-0.05, -0.05, 0}});
  QVERIFY(settle());
  QTRY_VERIFY(!source.is_making() && has(structure::kVenaCava));
  QVERIFY(!flickered);  // the former ones stay until the new ones are there
  disconnect(watched);
  window_->show_step(MainWindow::model);  // with no model yet they stand in for it
  QVERIFY(has(structure::kVenaCava));
}

/// Another patient's liver in 3D beside this one's slices.
void SegmentationEditTest::SurfacesOfTheFormerCaseGoAtOnce() {
  open_labels();
  const ui::LabelSurfaceSource& source = window_->views().label_surfaces();
  const auto has_portal_vein = [&] {
    const auto& blocks = source.surfaces()->blocks();
    return std::any_of(blocks.begin(), blocks.end(),
                       [](const auto& entry) { return entry.first.first == structure::kPortalVein; });
  };
  QTRY_VERIFY(!source.is_making() && has_portal_vein());
  QVERIFY(window_->views().seen_point(0.5, 0.5));
  engine::CaseState other;
  other[part::image] = std::make_shared<const Image>(ct_);
  auto small = std::make_shared<LabelMap>(LabelMap{LabelVolume(ct_.grid), {}});
  small->infos = {structure_info(structure::kParenchyma)};
  for (int k = 20; k < 26; ++k)
    for (int i = 30; i < 40; ++i) small->voxels.set({i, 30, k}, structure::kParenchyma);
  other[part::labels] = small;
  const TemporaryFolder folder;
  QVERIFY(engine::save_case(folder.path() / "other.glisson", other, RunContext()));
  ui::EngineBridge& engine = window_->engine();
  const std::shared_ptr<const Image> former = engine.state()[part::image];
  int looks = 0;
  bool seen = false;
  const auto look = [&] {
    if (engine.state()[part::image] == former) return;
    if (++looks == 1) seen = window_->views().seen_point(0.5, 0.5).has_value();
    seen = seen || has_portal_vein();
  };
  const QMetaObject::Connection by_case = connect(&engine, &ui::EngineBridge::case_changed, this, look);
  const QMetaObject::Connection by_source = connect(&source, &ui::LabelSurfaceSource::changed, this, look);
  engine.post(engine::OpenCase{folder.path() / "other.glisson"});
  QVERIFY(settle());
  QTRY_VERIFY(!source.is_making() && !source.surfaces()->blocks().empty());
  disconnect(by_case);
  disconnect(by_source);
  QVERIFY(looks > 0);
  QVERIFY(!seen);
}

void SegmentationEditTest::TouchingTreesAreListedAndGoneTo() {
  open_labels();
  // A thin hepatic twig that leaves the portal vein: the trees touch at its foot.
  choose(structure::kHepaticVeins);
  press("tool_paint");
  find<QDoubleSpinBox>("brush_diameter")->setValue(5.0);
  drag(slice(Plane::axial), {{0.0, -0.009, 0}, {0.0, 0.02, 0}});
  QVERIFY(settle());
  QVERIFY(count(structure::kHepaticVeins) > 0);
  QTest::keyClick(window_.get(), Qt::Key_B);
  auto* list = find<QListWidget>("bridges");
  QTRY_VERIFY(list->isVisible() && list->count() > 0);
  QVERIFY(list->item(0)->text().contains(QStringLiteral("mm²")));
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(0)).center());
  const auto shown = [&](Plane plane) {
    return slice(plane).geometry_in_ct().origin[scene::normal_axis(plane)];
  };
  QVERIFY(std::abs(shown(Plane::sagittal)) < 6e-3);  // the foot of the twig
  QVERIFY(std::abs(shown(Plane::coronal) + 0.0105) < 5e-3);
  // Of other labels nothing is listed until they have been looked at.
  ui::EngineBridge& engine = window_->engine();
  const std::shared_ptr<const LabelMap> former = engine.state()[part::labels];
  std::optional<int> listed;
  const QMetaObject::Connection looks = connect(&engine, &ui::EngineBridge::case_changed, this, [&] {
    if (!listed && engine.state()[part::labels] != former) listed = list->count();
  });
  engine.post(engine::ImportLabels{folder_->path() / "labels.seg.nrrd", {}});
  QVERIFY(settle());
  disconnect(looks);
  QCOMPARE(listed.value(), 0);
  press("tool_paint");
  QVERIFY(!list->isVisible());
}

void SegmentationEditTest::MouseMeansWhatItMeantBesideTheTool() {
  open_labels();
  press("tool_paint");
  const LabelVolume before = labels();
  ui::SliceView& axial = slice(Plane::axial);
  const double width = window_->views().slice(Plane::axial).slice().width;
  QVERIFY(width > 0);
  const Picture picture = axial.slice();
  QTest::mousePress(&axial, Qt::RightButton, {}, QPoint(100, 100));
  QMouseEvent move(QEvent::MouseMove, QPointF(160, 80), axial.mapToGlobal(QPointF(160, 80)), Qt::NoButton,
                   Qt::RightButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&axial, &move);
  QTest::mouseRelease(&axial, Qt::RightButton, {}, QPoint(160, 80));
  QVERIFY(*axial.slice().bytes != *picture.bytes);  // contrast
  const QPointF place = axial.widget_point(Point<CtFrame>());
  QTest::mousePress(&axial, Qt::MiddleButton, {}, QPoint(100, 100));
  QMouseEvent pan(QEvent::MouseMove, QPointF(120, 100), axial.mapToGlobal(QPointF(120, 100)), Qt::NoButton,
                  Qt::MiddleButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&axial, &pan);
  QTest::mouseRelease(&axial, Qt::MiddleButton, {}, QPoint(120, 100));
  QVERIFY(axial.widget_point(Point<CtFrame>()) != place);
  QVERIFY(settle());
  QVERIFY(labels() == before);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::SegmentationEditTest>(argc, argv); }
#include "segmentation_edit_test.moc"
