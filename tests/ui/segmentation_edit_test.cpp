// SPDX-License-Identifier: GPL-3.0-or-later
// Edits a segmentation by mouse and keyboard, like a person at the window: the engine, the segmentation and
// the tools are the real ones, the CT is a small synthetic one.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QToolButton>
#include <QTranslator>
#include <QtTest>

#include "glisson/core/files.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/segmentation/label_table.h"
#include "glisson/ui/segmentation/segmentation_panel.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/volume/io.h"
#include "run_in_window.h"

namespace glisson {

using engine::Part;
using engine::StageState;
using scene::Plane;
using ui::EditTool;
using ui::MainWindow;

class SegmentationEditTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void init();
  void cleanup();
  void StrokeIsOneStepThatIsUndoneAndRedone();
  void CtrlErasesAndEraseTakesOnlyTheChosenLabel();
  void BrushShowsItsTrueSizeInAllSlices();
  void ShiftWheelSizesTheBrush();
  void LassoErasesWhatItEnclosesInItsSlice();
  void LassoInThreeDimensionsCutsThrough();
  void ThresholdIsPreviewedThenApplied();
  void CancelledPreviewChangesNothing();
  void EnterKeepsTheLargestIsland();
  void LockedLabelIsNotTouched();
  void HiddenLabelLeavesTheViews();
  void PaintingWithinIntensitiesSparesTheRest();
  void KeysChooseToolsAndEscLetsGo();
  void UndoWorksWhileANumberHasTheKeyboard();
  void ApprovalIsTakenBackByAnEdit();
  void SurfacesFollowTheEdit();
  void TouchingTreesAreListedAndGoneTo();
  void MouseMeansWhatItMeantBesideTheTool();
  void EditPanelFitsItsColumnInEveryLanguage_data();
  void EditPanelFitsItsColumnInEveryLanguage();
  void WholePathByHandIsSavedWithItsHistory();

 private:
  void show_window() {
    window_ = std::make_unique<MainWindow>();
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    QApplication::setActiveWindow(window_.get());  // keys go to it though no window manager says so
  }
  bool settle() {
    return QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 60000);
  }
  template <class Widget = QWidget>
  Widget* find(const char* name) {
    return panel().findChild<Widget*>(QString::fromLatin1(name));
  }
  ui::SegmentationPanel& panel() { return *window_->findChild<ui::SegmentationPanel*>(); }
  ui::EditSession& session() { return panel().session(); }
  ui::SliceView& slice(Plane plane) { return window_->views().slice(plane); }
  ui::LabelTable& table() { return *find<ui::LabelTable>("label_table"); }
  const LabelVolume& labels() { return window_->engine().state().labels->voxels; }
  long count(Label label) {
    const auto all = labels().histogram();
    return label < all.size() ? all[label] : 0;
  }
  Label at(const Eigen::Vector3d& p) {
    return labels().at(labels().grid().index_of(Point<CtFrame>(p)).array().round().cast<int>().matrix());
  }
  void press(const char* name) {
    auto* widget = find<QWidget>(name);
    QVERIFY2(widget != nullptr && widget->isEnabled(), name);
    QTest::mouseClick(widget, Qt::LeftButton);
  }
  /// As a hand: pressed at the first place, moved over the others, let go at the last.
  void drag(QWidget& view, const std::vector<QPoint>& way, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&view, Qt::LeftButton, keys, way.front());
    for (const QPoint& place : way) {
      QMouseEvent move(QEvent::MouseMove, QPointF(place), view.mapToGlobal(QPointF(place)), Qt::NoButton,
                       Qt::LeftButton, keys);
      QCoreApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, keys, way.back());
  }
  void drag(ui::SliceView& view, const std::vector<Eigen::Vector3d>& way, Qt::KeyboardModifiers keys = {}) {
    std::vector<QPoint> pixels;
    for (const Eigen::Vector3d& p : way) pixels.push_back(view.widget_point(Point<CtFrame>(p)).toPoint());
    drag(static_cast<QWidget&>(view), pixels, keys);
  }
  void choose(Label label) {
    QTreeWidgetItem* row = table().row_of(label);
    QVERIFY(row != nullptr);
    click_mark(label, ui::LabelTable::name);
    QCOMPARE(session().settings().label, label);
  }
  void click_mark(Label label, int column) {
    QTreeWidgetItem* row = table().row_of(label);
    QRect cell = table().visualItemRect(row);
    cell.setLeft(table().columnViewportPosition(column));
    cell.setWidth(table().columnWidth(column));
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, cell.center());
  }
  void open_ct() {
    window_->open(folder_->path() / "ct.nrrd");
    QVERIFY(settle());
    QVERIFY(window_->engine().state().image != nullptr);
    window_->views().slice(Plane::axial);
    QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                      slice(Plane::axial).widget_point(Point<CtFrame>(0.001, 0.001, 0.0)).toPoint());
  }
  /// The CT with the labels that it was made of, and the tools in sight.
  void open_labels() {
    open_ct();
    window_->engine().post(engine::ImportLabels{folder_->path() / "labels.seg.nrrd", {}});
    QVERIFY(settle());
    QVERIFY(window_->engine().state().labels != nullptr);
    press("mode_edit");
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<MainWindow> window_;
  Image ct_;
};

void SegmentationEditTest::initTestCase() {
  folder_ = std::make_unique<TemporaryFolder>();
  ct_.grid.size = {84, 66, 44};
  ct_.grid.spacing_mm = {2.0, 2.0, 2.0};
  ct_.grid.origin_mm = {-83.0, -65.0, -43.0};
  auto voxels = std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(ct_.grid.voxel_count()));
  LabelMap map;
  map.voxels = LabelVolume(ct_.grid);
  for (int k = 0; k < ct_.grid.size.z(); ++k)
    for (int j = 0; j < ct_.grid.size.y(); ++j)
      for (int i = 0; i < ct_.grid.size.x(); ++i) {
        const Eigen::Vector3d p = ct_.grid.p_in_ct({double(i), double(j), double(k)}).xyz;
        const bool liver = p.cwiseQuotient(Eigen::Vector3d(0.065, 0.045, 0.032)).norm() < 1.0;
        const bool lesion = (p - Eigen::Vector3d(0.03, 0.0, 0.0)).norm() < 8e-3;
        const bool portal = std::hypot(p.y() + 0.015, p.z()) < 4e-3 && std::abs(p.x()) < 0.04;
        const bool neighbour = (p - Eigen::Vector3d(-0.06, 0.05, 0.0)).norm() < 8e-3;
        (*voxels)[static_cast<std::size_t>(ct_.grid.offset({i, j, k}))] =
            static_cast<std::int16_t>((lesion               ? 60
                                       : liver && portal    ? 170
                                       : liver || neighbour ? 110
                                                            : -80) +
                                      (i * 7 + j * 5 + k * 3) % 5);
        if (liver)
          map.voxels.set({i, j, k}, lesion   ? structure::kFirstLesion
                                    : portal ? structure::kPortalVein
                                             : structure::kParenchyma);
      }
  ct_.voxels = voxels;
  for (const Label label : {structure::kParenchyma, structure::kPortalVein, structure::kFirstLesion})
    map.infos.push_back(structure_info(label));
  write_image(folder_->path() / "ct.nrrd", ct_);
  write_labels(folder_->path() / "labels.seg.nrrd", map.voxels, map.infos);
}

void SegmentationEditTest::init() { show_window(); }

void SegmentationEditTest::cleanup() { window_.reset(); }

void SegmentationEditTest::StrokeIsOneStepThatIsUndoneAndRedone() {
  open_labels();
  const LabelVolume before = labels();
  const std::size_t steps = session().history()->done();
  choose(structure::kHepaticVeins);
  press("tool_paint");
  drag(slice(Plane::axial), {{-0.03, 0.01, 0}, {-0.01, 0.012, 0}, {0.01, 0.01, 0}, {0.02, 0.02, 0}});
  QVERIFY(settle());
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

void SegmentationEditTest::ThresholdIsPreviewedThenApplied() {
  open_labels();
  choose(structure::kGallbladder);  // empty so far
  const LabelVolume before = labels();
  QTest::keyClick(window_.get(), Qt::Key_T);
  find<QDoubleSpinBox>("threshold_low")->setValue(150.0);
  find<QDoubleSpinBox>("threshold_high")->setValue(200.0);
  QTRY_VERIFY(session().shows_preview());  // by itself, once the numbers rest
  QVERIFY(settle());
  QVERIFY(session().shows_preview());
  QVERIFY(labels() == before);
  QVERIFY(session().voxels_to_change() > 0);
  QVERIFY(find<QLabel>("edit_outcome")->text().contains(QStringLiteral("would change")));
  const long would = session().voxels_to_change();
  press("apply_edit");
  QVERIFY(settle());
  QCOMPARE(count(structure::kGallbladder), would);
  QCOMPARE(at({0, -0.015, 0}), structure::kGallbladder);
  QVERIFY(!session().shows_preview());
}

void SegmentationEditTest::CancelledPreviewChangesNothing() {
  open_labels();
  const LabelVolume before = labels();
  const std::size_t steps = session().history()->done();
  choose(structure::kParenchyma);
  QTest::keyClick(window_.get(), Qt::Key_M);
  QTRY_VERIFY(session().shows_preview());
  QVERIFY(window_->engine().state().preview != nullptr);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QVERIFY(settle());
  QTRY_VERIFY(window_->engine().state().preview == nullptr);
  QCOMPARE(session().tool(), EditTool::margin);  // the tool stays in the hand
  QVERIFY(labels() == before);
  QCOMPARE(session().history()->done(), steps);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QCOMPARE(session().tool(), EditTool::none);
}

void SegmentationEditTest::EnterKeepsTheLargestIsland() {
  open_labels();
  choose(structure::kPortalVein);
  press("tool_paint");
  drag(slice(Plane::axial), {{-0.02, 0.025, 0}});
  QVERIFY(settle());
  QCOMPARE(at({-0.02, 0.025, 0}), structure::kPortalVein);
  QTest::keyClick(window_.get(), Qt::Key_I);
  QTRY_VERIFY(session().shows_preview());
  QTest::keyClick(window_.get(), Qt::Key_Return);
  QVERIFY(settle());
  QVERIFY(at({-0.02, 0.025, 0}) != structure::kPortalVein);
  QCOMPARE(at({0, -0.015, 0}), structure::kPortalVein);
}

void SegmentationEditTest::LockedLabelIsNotTouched() {
  open_labels();
  click_mark(structure::kFirstLesion, ui::LabelTable::locked);
  const long lesion = count(structure::kFirstLesion);
  choose(structure::kPortalVein);
  press("tool_paint");
  drag(slice(Plane::axial), {{0.01, 0, 0}, {0.05, 0, 0}});
  QVERIFY(settle());
  QCOMPARE(count(structure::kFirstLesion), lesion);
  QCOMPARE(at({0.012, 0, 0}), structure::kPortalVein);
  const LabelVolume before = labels();
  choose(structure::kFirstLesion);
  drag(slice(Plane::axial), {{0.0, 0.02, 0}, {0.01, 0.02, 0}});
  QVERIFY(settle());
  QVERIFY(labels() == before);
  QVERIFY(find<QLabel>("edit_outcome")->text().contains(QStringLiteral("locked")));
}

void SegmentationEditTest::HiddenLabelLeavesTheViews() {
  open_labels();
  const Picture before = slice(Plane::axial).slice();
  click_mark(structure::kParenchyma, ui::LabelTable::shown);
  QVERIFY(*slice(Plane::axial).slice().bytes != *before.bytes);
  click_mark(structure::kParenchyma, ui::LabelTable::shown);
  QVERIFY(*slice(Plane::axial).slice().bytes == *before.bytes);
}

void SegmentationEditTest::PaintingWithinIntensitiesSparesTheRest() {
  open_labels();
  choose(structure::kHepaticVeins);
  QTest::keyClick(window_.get(), Qt::Key_T);
  find<QDoubleSpinBox>("threshold_low")->setValue(150.0);
  find<QDoubleSpinBox>("threshold_high")->setValue(200.0);
  press("threshold_mask");
  QCOMPARE(session().tool(), EditTool::paint);
  drag(slice(Plane::axial), {{-0.01, -0.022, 0}, {0.01, -0.008, 0}});  // across the portal vein
  QVERIFY(settle());
  QVERIFY(count(structure::kHepaticVeins) > 0);
  for (const int k : {21, 22})
    for (int j = 0; j < ct_.grid.size.y(); ++j)
      for (int i = 0; i < ct_.grid.size.x(); ++i)
        if (labels().at({i, j, k}) == structure::kHepaticVeins) QVERIFY(ct_.at({i, j, k}) >= 150);
}

void SegmentationEditTest::KeysChooseToolsAndEscLetsGo() {
  open_labels();
  press("mode_seeds");
  QVERIFY(!find<QToolButton>("tool_paint")->isVisible());
  for (const EditTool tool : ui::kEditTools) {
    QTest::keyClick(window_.get(), static_cast<Qt::Key>(ui::tool_key(tool)));
    QCOMPARE(session().tool(), tool);
    QVERIFY(find<QToolButton>(("tool_" + ui::tool_code(tool)).c_str())->isChecked());
  }
  QVERIFY(find<QToolButton>("tool_paint")->isVisible());  // the tools came into sight
  for (int i = 0; i < 3 && session().tool() != EditTool::none; ++i)
    QTest::keyClick(window_.get(), Qt::Key_Escape);
  QCOMPARE(session().tool(), EditTool::none);
  QVERIFY(settle());
  // Seeds and tools share the mouse: one lets go when the other is taken.
  QTest::keyClick(window_.get(), Qt::Key_P);
  press("mode_seeds");
  press("seed_portal_vein");
  QCOMPARE(session().tool(), EditTool::none);
  const LabelVolume before = labels();
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {}, slice(Plane::axial).rect().center());
  QVERIFY(settle());
  QVERIFY(labels() == before);
  QCOMPARE(window_->engine().state().seeds->portal_vein.rows(), 1);
}

void SegmentationEditTest::UndoWorksWhileANumberHasTheKeyboard() {
  open_labels();
  const LabelVolume before = labels();
  choose(structure::kHepaticVeins);
  press("tool_paint");
  drag(slice(Plane::axial), {{-0.03, 0.01, 0}, {0.01, 0.01, 0}});
  QVERIFY(settle());
  auto* number = find<QDoubleSpinBox>("brush_diameter");
  number->setFocus();
  QTest::keyClicks(number, QStringLiteral("7"));
  QTest::keyClick(number, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY(labels() == before);
}

void SegmentationEditTest::ApprovalIsTakenBackByAnEdit() {
  open_labels();
  choose(structure::kPortalVein);
  press("approve_label");
  QVERIFY(settle());
  QCOMPARE(window_->engine().state().review->at(structure::kPortalVein), ReviewState::approved);
  QVERIFY(!find<QPushButton>("approve_label")->isEnabled());
  press("tool_paint");
  drag(slice(Plane::axial), {{-0.02, 0.02, 0}, {0.0, 0.02, 0}});
  QVERIFY(settle());
  QCOMPARE(window_->engine().state().review->at(structure::kPortalVein), ReviewState::to_review);
  QVERIFY(find<QPushButton>("approve_label")->isEnabled());
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
  drag(slice(Plane::axial), {{-0.05, -0.05, 0}});
  QVERIFY(settle());
  QTRY_VERIFY(!source.is_making() && has(structure::kVenaCava));
  window_->show_step(MainWindow::model);  // other steps show the model
  QTRY_VERIFY(source.surfaces()->blocks().empty());
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

void SegmentationEditTest::EditPanelFitsItsColumnInEveryLanguage_data() {
  QTest::addColumn<QString>("language");
  for (const char* language : {"en", "de", "fr"}) QTest::newRow(language) << QString::fromLatin1(language);
}

void SegmentationEditTest::EditPanelFitsItsColumnInEveryLanguage() {
  QFETCH(QString, language);
  QTranslator translator;
  if (language != QStringLiteral("en")) {
    QVERIFY(translator.load(QStringLiteral(":/glisson/translations/glisson_") + language));
    QCoreApplication::installTranslator(&translator);
  }
  show_window();
  open_labels();
  auto* column = qobject_cast<QScrollArea*>(panel().parentWidget()->parentWidget());
  QVERIFY(column != nullptr);
  const int room = column->width() - column->verticalScrollBar()->sizeHint().width();
  for (const EditTool tool : ui::kEditTools) {
    session().set_tool(tool);
    QCoreApplication::processEvents();
    const QByteArray what = QStringLiteral("%1 needs %2 of %3 pixels")
                                .arg(QString::fromStdString(ui::tool_code(tool)))
                                .arg(panel().minimumSizeHint().width())
                                .arg(room)
                                .toUtf8();
    QVERIFY2(panel().minimumSizeHint().width() <= room, what.constData());
  }
  session().cancel();
  QVERIFY(settle());
  QCOMPARE(window_->size(), QSize(1280, 800));
  QCoreApplication::removeTranslator(&translator);
}

void SegmentationEditTest::WholePathByHandIsSavedWithItsHistory() {
  open_ct();
  press("seed_parenchyma");
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(-0.03, 0.01, 0), {0.0, 0.02, 0}, {0.045, -0.01, 0}})
    QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                      slice(Plane::axial).widget_point(Point<CtFrame>(p)).toPoint());
  press("seed_portal_vein");
  for (const double x : {-0.03, 0.02})
    QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                      slice(Plane::axial).widget_point(Point<CtFrame>(x, -0.015, 0)).toPoint());
  QVERIFY(settle());
  QTest::mouseClick(window_->findChild<ui::TaskButton*>(QStringLiteral("segment"))->button(), Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY2(window_->engine().state().labels != nullptr, qPrintable(window_->status_text()));
  QCOMPARE(at({0.0, 0.02, 0}), structure::kParenchyma);
  const LabelVolume grown = labels();

  press("mode_edit");
  choose(structure::kFirstLesion);
  QTest::keyClick(window_.get(), Qt::Key_P);
  drag(slice(Plane::axial), {{0.026, 0, 0}, {0.034, 0, 0}});
  QVERIFY(settle());
  QCOMPARE(at({0.03, 0, 0}), structure::kFirstLesion);
  choose(structure::kParenchyma);
  QTest::keyClick(window_.get(), Qt::Key_X);
  drag(slice(Plane::axial), {{-0.07, -0.02, 0}, {-0.05, -0.02, 0}, {-0.05, 0.02, 0}, {-0.07, 0.02, 0}});
  QVERIFY(settle());
  QVERIFY(at({-0.055, 0, 0}) != structure::kParenchyma);
  press("approve_label");
  QVERIFY(settle());
  const LabelVolume edited = labels();
  QVERIFY(!(edited == grown));

  const std::filesystem::path path = folder_->path() / "edited.glisson";
  window_->engine().post(engine::SaveCase{path});
  QVERIFY(settle());
  show_window();
  window_->open(path);
  QVERIFY(settle());
  QVERIFY(labels() == edited);
  QCOMPARE(window_->engine().state().review->at(structure::kParenchyma), ReviewState::approved);
  press("mode_edit");
  QVERIFY(find<QToolButton>("undo")->text().contains(QStringLiteral("Scissors: erase inside, Liver")));
  for (int step = 0; step < 2; ++step) QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY(labels() == grown);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::SegmentationEditTest>(argc, argv); }
#include "segmentation_edit_test.moc"
