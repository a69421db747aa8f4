// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>
#include <QCoreApplication>
#include <QMouseEvent>
#include <QTest>

#include "glisson/core/files.h"
#include "glisson/editing/tools/paint.h"
#include "glisson/engine/commands/edit_labels.h"
#include "glisson/engine/commands/import_labels.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/segmentation/label_table.h"
#include "glisson/ui/segmentation/segmentation_panel.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/volume/io.h"
#include "run_in_window.h"

namespace glisson {

/// The window at its segmentation step, a small synthetic CT (an ellipsoid of a liver with a portal vein and
/// a lesion, all about the origin) and a hand at mouse and keyboard: the engine, the segmentation and the
/// tools are the real ones.
class SegmentationWindow {
 protected:
  void make_ct() {
    folder_ = std::make_unique<TemporaryFolder>();
    ct_.grid.size = {84, 66, 52};  // smaller than a liver is odd, and the window would say so
    ct_.grid.spacing_mm = {2.0, 2.0, 2.0};
    ct_.grid.origin_mm = {-83.0, -65.0, -51.0};
    auto voxels =
        std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(ct_.grid.voxel_count()));
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
              static_cast<std::int16_t>((std::abs(p.y()) > 0.064 ? -1000  // air, as about every patient
                                         : lesion                ? 60
                                         : liver && portal       ? 170
                                         : liver || neighbour    ? 110
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
  void show_window() {
    window_ = std::make_unique<ui::MainWindow>();
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
  ui::SliceView& slice(scene::Plane plane) { return window_->views().slice(plane); }
  ui::LabelTable& table() { return *find<ui::LabelTable>("label_table"); }
  const LabelVolume& labels() { return window_->engine().state()[part::labels]->voxels; }
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
    QVERIFY(window_->engine().state()[part::image] != nullptr);
    window_->views().slice(scene::Plane::axial);
    QTest::mouseClick(&slice(scene::Plane::axial), Qt::LeftButton, {},
                      slice(scene::Plane::axial).widget_point(Point<CtFrame>(0.001, 0.001, 0.0)).toPoint());
  }
  /// The CT with the labels that it was made of, and the tools in sight.
  void open_labels() {
    open_ct();
    window_->engine().post(engine::ImportLabels{folder_->path() / "labels.seg.nrrd", {}});
    QVERIFY(settle());
    QVERIFY(window_->engine().state()[part::labels] != nullptr);
    press("mode_edit");
  }

  /// A hand adds to the liver above it.
  void correct_by_hand() {
    open_labels();
    editing::Paint paint;
    paint.label = structure::kParenchyma;
    paint.brush = editing::Paint::Brush::ball;
    paint.radius = 8e-3;
    paint.path = Eigen::RowVector3d(0.0, -0.047, 0.0);
    window_->engine().post(engine::EditLabels{{paint, {}}, 0});
    QVERIFY(settle());
    press("mode_seeds");
  }

  void seed_liver() {
    press("seed_parenchyma");
    for (const Eigen::Vector3d& p : {Eigen::Vector3d(-0.03, 0.01, 0), {0.0, 0.02, 0}, {0.045, -0.01, 0}})
      QTest::mouseClick(&slice(scene::Plane::axial), Qt::LeftButton, {},
                        slice(scene::Plane::axial).widget_point(Point<CtFrame>(p)).toPoint());
    QVERIFY(settle());
    QCOMPARE(window_->engine().state()[part::seeds]->liver.rows(), 3);
    QTest::keyClick(window_.get(), Qt::Key_Escape);
  }
  void press_segment() {
    QTest::mouseClick(window_->findChild<ui::TaskButton*>(QStringLiteral("segment"))->button(),
                      Qt::LeftButton);
  }
  void grow() {
    press_segment();
    QVERIFY(settle());
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<ui::MainWindow> window_;
  Image ct_;
};

}  // namespace glisson
