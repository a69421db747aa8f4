// SPDX-License-Identifier: GPL-3.0-or-later
// Seeds, the box in which growth works, and growth itself, by mouse and keyboard.
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/scene/slice_drawing.h"
#include "segmentation_window.h"

namespace glisson {

using scene::Plane;

class SegmentationSeedsTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void PaintedLesionIsNotTheOneThatIsClickedNext();
  void ButtonsKeepTheirPlaceHoweverManyLesionsThereAre();
  void ClearedSeedsArePutBack();
  void ADragAcrossALesionTellsItsDiameter();
  void AProposalThatFindsNoLiverSaysSoAndASeedIsNotReplaced();
  void BoxDrawnInSlicesIsWhereGrowthWorks();
  void BoxIsMovedByItsEdgesTypedAndCleared();
  void BoxWithoutALiverSeedIsSaid();
  void ContourIsDrawnWhileItEvolvesAndGoneWhenCancelled();
  void AClickCorrectsTheLiverAroundItAtOnceUnlessThatIsOff();
  void AClickFindsALesionAtOnce();
  void ControlsStayUnderTheHandThatPressesSegment();
  void TheLineBelowTheViewsFollowsACorrection();
  void NotesThatThePanelMayHideAreToldBelow();

 private:
  /// What the views share.
  const ui::ViewState& shared() { return window_->views().state(); }
};

void SegmentationSeedsTest::PaintedLesionIsNotTheOneThatIsClickedNext() {
  open_labels();  // with a lesion that has no seed
  press("mode_seeds");
  QVERIFY(!find<QPushButton>("seed_lesion_1")->isVisible());
  press("seed_lesion_2");
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                    slice(Plane::axial).widget_point(Point<CtFrame>(-0.03, 0.01, 0)).toPoint());
  QVERIFY(settle());
  const auto seeds = [&] { return window_->engine().state()[part::seeds]; };
  QCOMPARE(seeds()->lesions.size(), std::size_t{2});
  QCOMPARE(seeds()->lesions[0].rows(), Eigen::Index{0});
  QCOMPARE(seeds()->lesions[1].rows(), Eigen::Index{1});
  QVERIFY(!find<QPushButton>("seed_lesion_1")->isVisible());
  // A better seed gets the number of the one that was deleted for it.
  find<QListWidget>("seed_list")->setCurrentRow(0);
  press("delete_seeds");
  QVERIFY(settle());
  QVERIFY(seeds()->lesions.empty());
  QVERIFY(find<QPushButton>("seed_lesion_2")->isVisible());
}

void SegmentationSeedsTest::ButtonsKeepTheirPlaceHoweverManyLesionsThereAre() {
  open_ct();
  press("mode_seeds");
  const auto places = [&] {
    QCoreApplication::processEvents();
    QList<QPoint> all;
    for (const char* name : {"seed_parenchyma", "seed_background", "seed_lesions", "delete_seeds"})
      all << find<QWidget>(name)->mapTo(&panel(), QPoint());
    for (const char* name : {"segment", "propose_seeds"})
      all << window_->findChild<ui::TaskButton*>(QLatin1String(name))->button()->mapTo(&panel(), QPoint());
    return all;
  };
  const auto click = [&](const Eigen::Vector3d& p) {
    QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                      slice(Plane::axial).widget_point(Point<CtFrame>(p)).toPoint());
    QVERIFY(settle());
  };
  const QList<QPoint> before = places();
  press("seed_parenchyma");
  click({0.0, 0.02, 0});  // nothing is in the way of *Segment* any more
  QCOMPARE(places(), before);
  for (int lesion = 0; lesion < 8; ++lesion) {
    const std::string name = "seed_" + structure_name(static_cast<Label>(structure::kFirstLesion + lesion));
    press(name.c_str());
    click({-0.03 + 0.006 * lesion, 0.0, 0});
    QCOMPARE(places(), before);
    const auto* button = find<QPushButton>(name.c_str());
    QCOMPARE(button->visibleRegion().boundingRect(), button->rect());
  }
  // The ninth can be scrolled to, and is in sight, all of it, when it is chosen.
  auto* next =
      find<QPushButton>(("seed_" + structure_name(static_cast<Label>(structure::kFirstLesion + 8))).c_str());
  QVERIFY(next != nullptr);
  panel().choose_structure(static_cast<Label>(structure::kFirstLesion + 8));
  QCOMPARE(next->visibleRegion().boundingRect(), next->rect());
}

/// The button stands beside others, and a dozen clicks are soon gone.
void SegmentationSeedsTest::ClearedSeedsArePutBack() {
  open_ct();
  seed_liver();
  const auto seeds = [&] { return window_->engine().state()[part::seeds]; };
  const Points liver = seeds()->liver;
  press("clear_seeds");
  QVERIFY(settle());
  QCOMPARE(seeds()->liver.rows(), Eigen::Index{0});
  QCOMPARE(find<QPushButton>("clear_seeds")->text(), QStringLiteral("Put back"));
  press("clear_seeds");
  QVERIFY(settle());
  QVERIFY(seeds()->liver == liver);
  QCOMPARE(find<QPushButton>("clear_seeds")->text(), QStringLiteral("Clear"));
  // With a new seed there is nothing to go back to.
  press("clear_seeds");
  QVERIFY(settle());
  press("seed_parenchyma");
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                    slice(Plane::axial).widget_point(Point<CtFrame>(0.0, 0.02, 0)).toPoint());
  QVERIFY(settle());
  QCOMPARE(find<QPushButton>("clear_seeds")->text(), QStringLiteral("Clear"));
  QCOMPARE(seeds()->liver.rows(), Eigen::Index{1});
}

void SegmentationSeedsTest::ADragAcrossALesionTellsItsDiameter() {
  open_ct();
  press("mode_seeds");
  press("seed_lesion_1");
  const auto seeds = [&] { return window_->engine().state()[part::seeds]; };
  drag(slice(Plane::axial), {{0.022, 0, 0}, {0.03, 0, 0}, {0.038, 0, 0}});
  QVERIFY(settle());
  QCOMPARE(seeds()->lesions.size(), std::size_t{1});
  QVERIFY((seeds()->lesions[0].row(0).transpose() - Eigen::Vector3d(0.03, 0, 0)).norm() < 1e-3);
  QVERIFY(std::abs(seeds()->lesion_diameter_mm(0) - 16.0) < 1.0);
  QVERIFY(find<QListWidget>("seed_list")->item(0)->text().contains("16 mm"));
  // Notes name a seed by its number.
  QVERIFY(find<QListWidget>("seed_list")->item(0)->text().startsWith(QString::fromUtf8("Lesion 1 · 1")));
  QCOMPARE(shared().line(), nullptr);
  // A click says only where.
  press("seed_lesion_2");
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                    slice(Plane::axial).widget_point(Point<CtFrame>(-0.03, 0.01, 0)).toPoint());
  QVERIFY(settle());
  QCOMPARE(seeds()->lesions.size(), std::size_t{2});
  QCOMPARE(seeds()->lesion_diameter_mm(1), 0.0);
  // A drag that is dropped places nothing; a lesion without a seed has no diameter.
  const QPoint from = slice(Plane::axial).widget_point(Point<CtFrame>(0.02, 0, 0)).toPoint();
  QTest::mousePress(&slice(Plane::axial), Qt::LeftButton, {}, from);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QTest::mouseRelease(&slice(Plane::axial), Qt::LeftButton, {}, from + QPoint(40, 0));
  QVERIFY(settle());
  QCOMPARE(seeds()->lesions[1].rows(), Eigen::Index{1});
  find<QListWidget>("seed_list")->setCurrentRow(0);
  press("delete_seeds");
  QVERIFY(settle());
  QCOMPARE(seeds()->lesion_diameter_mm(0), 0.0);
}

void SegmentationSeedsTest::AProposalThatFindsNoLiverSaysSoAndASeedIsNotReplaced() {
  open_labels();
  press("mode_seeds");
  auto* propose = find<ui::TaskButton>("propose_seeds");
  press("seed_background");
  QTest::mouseClick(propose->button(), Qt::LeftButton);  // this liver lies in the patient's middle
  // A click meanwhile would put the seeds of before in the place of those that are found.
  QVERIFY(!find<QPushButton>("seed_background")->isEnabled());
  QCOMPARE(shared().hand(), ui::Hand::crosshair);
  QVERIFY(settle());
  QVERIFY(find<QPushButton>("seed_background")->isEnabled());
  const auto said = [&] {
    QStringList all;
    for (const QLabel* label : propose->findChildren<QLabel*>()) all << label->text();
    return all.join(' ');
  };
  QVERIFY2(said().contains("Click the liver yourself"), qPrintable(said()));
  QVERIFY(!window_->engine().state()[part::seeds] ||
          window_->engine().state()[part::seeds]->liver.rows() == 0);
  seed_liver();
  QTest::mouseClick(propose->button(), Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY2(said().contains("has seeds already"), qPrintable(said()));
}

void SegmentationSeedsTest::BoxDrawnInSlicesIsWhereGrowthWorks() {
  open_ct();
  seed_liver();
  press("draw_region");
  // The right half of the liver, in the axial slice; then its depth, by an edge in the coronal one.
  drag(slice(Plane::axial), {{-0.08, -0.06, 0}, {-0.02, 0.0, 0}, {0.011, 0.062, 0}});
  const auto drawn = shared().box();
  QVERIFY(drawn.has_value());
  QVERIFY(std::abs(drawn->max().x() - 0.011) < 1e-3 && std::abs(drawn->min().y() + 0.06) < 1e-3);
  QCOMPARE(drawn->min().z(), 1e-3 * ct_.grid.origin_mm.z());  // as deep as the volume
  QCOMPARE(drawn->max().z(), -1e-3 * ct_.grid.origin_mm.z());
  drag(slice(Plane::coronal), {{-0.03, 0, -1e-3 * ct_.grid.origin_mm.z()}, {-0.03, 0, 0.021}});
  QVERIFY(std::abs(shared().box()->max().z() - 0.021) < 1e-3);
  QCOMPARE(shared().box()->max().x(), drawn->max().x());
  press("own_resolution");
  QCOMPARE(find<QDoubleSpinBox>("segment_resolution")->value(), 2.0);  // the CT's voxels
  QTest::keyClick(window_.get(), Qt::Key_Escape);                      // the mouse is the crosshair's again
  QCOMPARE(shared().hand(), ui::Hand::crosshair);
  QVERIFY(shared().box().has_value());
  grow();
  QVERIFY(window_->engine().state()[part::labels] != nullptr);
  QCOMPARE(at({-0.03, 0.01, 0}), structure::kParenchyma);
  const Eigen::AlignedBox3d box = *shared().box();
  long inside = 0;
  const VolumeGrid& grid = labels().grid();
  for (int k = 0; k < grid.size.z(); ++k)
    for (int j = 0; j < grid.size.y(); ++j)
      for (int i = 0; i < grid.size.x(); ++i) {
        if (labels().at({i, j, k}) == 0) continue;
        QVERIFY(box.contains(grid.p_in_ct({double(i), double(j), double(k)}).xyz));
        ++inside;
      }
  QVERIFY(inside > 10000);
  // The rest of the liver is found by growing everywhere, and the box is then only in the way.
  press("clear_region");
  grow();
  QCOMPARE(at({0.05, -0.01, 0}), structure::kParenchyma);
}

void SegmentationSeedsTest::BoxIsMovedByItsEdgesTypedAndCleared() {
  open_ct();
  const QImage plain = slice(Plane::sagittal).grab().toImage();
  press("draw_region");
  drag(slice(Plane::axial), {{-0.05, -0.04, 0}, {0.03, 0.03, 0}});
  const Eigen::AlignedBox3d drawn = *shared().box();
  QVERIFY(slice(Plane::sagittal).grab().toImage() != plain);  // all slices show it
  // A corner is two edges.
  drag(slice(Plane::axial), {drawn.max(), {0.045, 0.035, 0}});
  QVERIFY((shared().box()->max().head<2>() - Eigen::Vector2d(0.045, 0.035)).norm() < 1.5e-3);
  QCOMPARE(shared().box()->min(), drawn.min());
  const Eigen::AlignedBox3d moved = *shared().box();
  // A click that draws nothing leaves it; Esc takes a drag back.
  drag(slice(Plane::axial), {{0.0, 0.0, 0}});
  QCOMPARE(shared().box()->min(), moved.min());
  QTest::mousePress(&slice(Plane::axial), Qt::LeftButton, {}, slice(Plane::axial).widget_point({}).toPoint());
  QTest::mouseMove(&slice(Plane::axial), slice(Plane::axial).widget_point({0.02, 0.02, 0}).toPoint());
  QTRY_VERIFY(shared().box()->min() != moved.min());
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QTest::mouseRelease(&slice(Plane::axial), Qt::LeftButton, {},
                      slice(Plane::axial).widget_point({0.02, 0.02, 0}).toPoint());
  QCOMPARE(shared().box()->min(), moved.min());
  QCOMPARE(shared().box()->max(), moved.max());
  // Typed: the side that was typed and no other.
  auto* top = find<QDoubleSpinBox>("region_z_high");
  QVERIFY(top->isVisible());
  top->setFocus();
  top->selectAll();
  QTest::keyClicks(top, QStringLiteral("20"));
  QTest::keyClick(top, Qt::Key_Return);
  QCOMPARE(shared().box()->max().z(), 0.02);
  top->selectAll();
  QTest::keyClicks(top, QStringLiteral("-43"));  // no box is as thin as that: the last good one stays
  QVERIFY(shared().box()->sizes().minCoeff() > 0.0);
  top->selectAll();
  QTest::keyClicks(top, QStringLiteral("20"));
  QCOMPARE(shared().box()->max().z(), 0.02);
  QCOMPARE(shared().box()->min(), moved.min());
  // The tools' page has no use for it; a tool takes the mouse.
  press("draw_region");
  press("draw_region");
  QTest::keyClick(window_.get(), Qt::Key_P);
  QCOMPARE(shared().hand(), ui::Hand::brush);
  QVERIFY(!shared().box().has_value());
  press("mode_seeds");
  QVERIFY(shared().box().has_value());
  press("seed_parenchyma");
  QCOMPARE(shared().hand(), ui::Hand::point);
  press("clear_region");
  QVERIFY(!shared().box().has_value());
  QVERIFY(!top->isVisible());
}

void SegmentationSeedsTest::BoxWithoutALiverSeedIsSaid() {
  open_ct();
  seed_liver();
  auto* segment = window_->findChild<ui::TaskButton*>(QStringLiteral("segment"));
  QVERIFY(segment->button()->isEnabled());
  press("draw_region");
  drag(slice(Plane::axial), {{-0.08, 0.04, 0}, {-0.04, 0.06, 0}});  // no seed is there
  QVERIFY(!segment->button()->isEnabled());
  drag(slice(Plane::axial), {{-0.04, 0.04, 0}, {0.01, -0.04, 0}});  // a corner is moved beyond it
  QVERIFY(segment->button()->isEnabled());
}

void SegmentationSeedsTest::ContourIsDrawnWhileItEvolvesAndGoneWhenCancelled() {
  open_ct();
  seed_liver();
  find<QDoubleSpinBox>("segment_resolution")->setValue(0.5);  // long enough to be looked at
  const QImage before = slice(Plane::axial).grab().toImage();
  auto* segment = window_->findChild<ui::TaskButton*>(QStringLiteral("segment"));
  QTest::mouseClick(segment->button(), Qt::LeftButton);
  std::vector<std::shared_ptr<const LabelVolume>> contours;
  QVERIFY(QTest::qWaitFor(
      [&] {
        const auto& evolving = shared().evolving();
        if (evolving && (contours.empty() || contours.back() != evolving)) contours.push_back(evolving);
        return contours.size() >= 3 || !segment->is_running();
      },
      60000));
  QVERIFY2(contours.size() >= 3, qPrintable(window_->status_text()));
  QVERIFY(segment->is_running());
  // It is the liver on its way: about the seeds, and another one from time to time.
  const VolumeGrid& grid = contours.back()->grid();
  QVERIFY(grid.same_as(ct_.grid));
  const Eigen::Vector3i seed =
      grid.index_of(Point<CtFrame>(-0.03, 0.01, 0)).array().round().cast<int>().matrix();
  QCOMPARE(contours.back()->at(seed), structure::kParenchyma);
  QVERIFY(!(*contours.front() == *contours.back()));
  // Its outline is drawn where the contour meets the slice.
  const QImage now = slice(Plane::axial).grab().toImage();
  const QImage outline = scene::outline_overlay(*shared().evolving(), slice(Plane::axial).geometry_in_ct());
  QVERIFY(!outline.isNull());
  const scene::SliceGeometry& geometry = slice(Plane::axial).geometry_in_ct();
  int drawn = 0, wanted = 0;
  for (int v = 0; v < outline.height(); ++v)
    for (int u = 0; u < outline.width(); ++u) {
      if (outline.pixelColor(u, v).alpha() == 0) continue;
      const QPoint at = slice(Plane::axial).widget_point(geometry.p_in_ct({double(u), double(v)})).toPoint();
      if (!now.rect().contains(at)) continue;
      ++wanted;
      drawn += now.pixel(at) != before.pixel(at) ? 1 : 0;
    }
  QVERIFY2(wanted > 50 && drawn > 0.9 * wanted,
           qPrintable(QStringLiteral("%1 of %2").arg(drawn).arg(wanted)));
  QTest::mouseClick(segment->cancel_button(), Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY(!shared().evolving());
  QVERIFY(!window_->engine().snapshot()->evolving);
  QVERIFY(window_->engine().state()[part::labels] == nullptr);
  QCOMPARE(slice(Plane::axial).grab().toImage(), before);
}

void SegmentationSeedsTest::AClickCorrectsTheLiverAroundItAtOnceUnlessThatIsOff() {
  open_labels();
  press("mode_seeds");
  const auto click = [&](const Eigen::Vector3d& p) {
    QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                      slice(Plane::axial).widget_point(Point<CtFrame>(p)).toPoint());
    QVERIFY(settle());
  };
  const auto notes = [&] {
    QString all;
    for (const QLabel* label : panel().findChildren<QLabel*>())
      if (label->isVisible()) all += label->text() + '\n';
    return all;
  };
  // A place in the liver that is said to be none.
  const Eigen::Vector3d wrong(-0.02, 0.025, 0.0);
  QCOMPARE(at(wrong), structure::kParenchyma);
  press("seed_background");
  click(wrong);
  QCOMPARE(at(wrong), structure::kBackground);
  QVERIFY2(notes().contains(QLatin1String("Corrected around the click: ")), qPrintable(notes()));
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QCOMPARE(at(wrong), structure::kParenchyma);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(settle());
  QCOMPARE(at(wrong), structure::kBackground);
  const long lesion = count(structure::kFirstLesion), portal = count(structure::kPortalVein);
  // Beside it that was too much.
  const Eigen::Vector3d beside = wrong + Eigen::Vector3d(0.0035, 0.0, 0.0);
  QCOMPARE(at(beside), structure::kBackground);
  press("seed_parenchyma");
  click(beside);
  QCOMPARE(at(beside), structure::kParenchyma);
  QCOMPARE(count(structure::kFirstLesion), lesion);
  QCOMPARE(count(structure::kPortalVein), portal);
  // What the liver does not reach changes nothing, and is said.
  click({-0.06, 0.05, 0.0});
  QCOMPARE(at({-0.06, 0.05, 0.0}), structure::kBackground);
  QVERIFY2(notes().contains(QLatin1String("Liver seed 2 had no effect: ")), qPrintable(notes()));
  // Switched off, or with a locked liver, a seed is a seed.
  const long liver = count(structure::kParenchyma);
  press("correct_at_once");
  press("seed_background");
  click({0.0, -0.03, 0.0});
  QCOMPARE(count(structure::kParenchyma), liver);
  QVERIFY2(notes().contains(QLatin1String("counts when you segment again")), qPrintable(notes()));
  press("correct_at_once");
  click_mark(structure::kParenchyma, ui::LabelTable::locked);
  click({0.0, -0.032, 0.0});
  QCOMPARE(count(structure::kParenchyma), liver);
  QVERIFY2(notes().contains(QLatin1String("Locked: this click changes nothing.")), qPrintable(notes()));
  QCOMPARE(window_->engine().state()[part::seeds]->background.rows(), Eigen::Index{3});
}

void SegmentationSeedsTest::AClickFindsALesionAtOnce() {
  open_labels();
  const long whole = count(structure::kFirstLesion), portal = count(structure::kPortalVein);
  editing::Paint over;  // a hand has painted liver over the lesion
  over.label = structure::kParenchyma;
  over.brush = editing::Paint::Brush::ball;
  over.radius = 10e-3;
  over.path = Eigen::RowVector3d(0.03, 0.0, 0.0);
  window_->engine().post(engine::EditLabels{{over, {}}, 0});
  QVERIFY(settle());
  QCOMPARE(count(structure::kFirstLesion), 0L);
  press("mode_seeds");
  press("seed_lesion_1");
  const QPoint middle = slice(Plane::axial).widget_point(Point<CtFrame>(0.03, 0.0, 0.0)).toPoint();
  drag(slice(Plane::axial), {middle, middle});
  QVERIFY(settle());
  QCOMPARE(window_->engine().state()[part::seeds]->lesions.size(), std::size_t{1});
  const double share = static_cast<double>(count(structure::kFirstLesion)) / static_cast<double>(whole);
  QVERIFY2(share > 0.7 && share < 1.4, qPrintable(QString::number(share)));
  QCOMPARE(count(structure::kPortalVein), portal);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QCOMPARE(count(structure::kFirstLesion), 0L);
}

/// Segment is switched off while it works, Cancel is hidden afterwards: the panel must not scroll to what has
/// the keyboard then.
void SegmentationSeedsTest::ControlsStayUnderTheHandThatPressesSegment() {
  open_ct();
  seed_liver();
  QWidget* button = window_->findChild<ui::TaskButton*>(QStringLiteral("segment"))->button();
  const auto place = [&] { return button->mapTo(window_.get(), QPoint()); };
  const QPoint before = place();
  QVERIFY(!button->visibleRegion().isEmpty());
  const auto scrolled = [&] {
    int most = 0;
    for (QWidget* above = button->parentWidget(); above != nullptr; above = above->parentWidget())
      if (const auto* area = qobject_cast<QScrollArea*>(above))
        most = std::max(most, area->verticalScrollBar()->value());
    return most;
  };
  QCOMPARE(scrolled(), 0);
  press_segment();
  QCOMPARE(place(), before);
  QVERIFY(settle());
  QCOMPARE(scrolled(), 0);
}

/// It told the label of before the correction until the pointer moved.
void SegmentationSeedsTest::TheLineBelowTheViewsFollowsACorrection() {
  open_labels();
  press("mode_seeds");
  const auto says_liver = [&] { return window_->views().probe_line().contains(QLatin1String("Liver")); };
  press("seed_background");
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                    slice(Plane::axial).widget_point(Point<CtFrame>(-0.02, 0.025, 0)).toPoint());
  QVERIFY(settle());
  QCOMPARE(at({-0.02, 0.025, 0}), structure::kBackground);
  QVERIFY2(!says_liver(), qPrintable(window_->views().probe_line()));
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY2(says_liver(), qPrintable(window_->views().probe_line()));
}

/// In a window of 800 pixels what is noted about a segmentation lies below the panel's visible part.
void SegmentationSeedsTest::NotesThatThePanelMayHideAreToldBelow() {
  open_ct();
  seed_liver();
  press("seed_lesion_1");  // where the liver is like all of it
  QTest::mouseClick(&slice(Plane::axial), Qt::LeftButton, {},
                    slice(Plane::axial).widget_point(Point<CtFrame>(-0.03, 0.01, 0)).toPoint());
  QVERIFY(settle());
  grow();
  const auto line = [&] { return window_->status_text(); };
  QVERIFY2(line().contains(QLatin1String("notes to read, on the right: ")), qPrintable(line()));
  // They stay a part of the case: who opens it is told so.
  const auto path = folder_->path() / "noted.glisson";
  window_->engine().post(engine::SaveCase{path, true});
  QVERIFY(settle());
  QVERIFY2(!line().contains(QLatin1String("notes to read")), qPrintable(line()));
  window_->engine().post(engine::OpenCase{path});
  QVERIFY(settle());
  QVERIFY2(line().contains(QLatin1String("notes to read, under Segmentation: ")), qPrintable(line()));
  const auto* notes = find<QLabel>("label_notes");
  auto* attention = find<QPushButton>("attention");
  QVERIFY(notes->visibleRegion().isEmpty() && !attention->visibleRegion().isEmpty());
  QVERIFY2(attention->text().contains(QLatin1String("Notes to read: ")), qPrintable(attention->text()));
  press("mode_edit");
  QVERIFY(!attention->visibleRegion().isEmpty());
  QTest::mouseClick(attention, Qt::LeftButton);
  QTRY_VERIFY(!notes->visibleRegion().isEmpty());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::SegmentationSeedsTest>(argc, argv); }
#include "segmentation_seeds_test.moc"
