// SPDX-License-Identifier: GPL-3.0-or-later
// A rendered stereo pair is loaded, reconstructed and labelled by mouse and keyboard, with the real engine.
#include <QAbstractButton>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QListWidget>
#include <QMouseEvent>
#include <QPolygonF>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <map>

#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/load_stereo_pair.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/earlier_looks.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/rig.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/ui/stereo/stereo_panel.h"
#include "rendered_pair.h"
#include "run_in_window.h"

namespace glisson {

using engine::Part;
using engine::StageState;
using stereo::Side;
using ui::MainWindow;

class StereoLabellingTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void PairIsLoadedAndReconstructed();
  void EpipolarLineOfThePointerPassesThroughItsPartner();
  void ClosingARegionLabelsTheSamePoints();
  void MarginIsALineAndTheNotchIsClickedOnTheRightPicture();
  void CloudHoldsEveryLabelWhereItWasClicked();
  void DraggedCornerTakesPointsAwayAndUndoBringsThemBack();
  void DeleteRemovesAndRedoRemovesAgain();
  void HintSaysWhatAClickDoes();
  void ALookIsKeptOnceAndForgotten();
  void WheelEnlargesAboutThePointerAndClicksStayTrue();
  void KeyboardReachesEverythingByAName();
  void ALookIsTheOneThatWasSeenWhileAnotherIsMade();
  void PointsAreNotDrawnThroughAnotherCalibration();
  void RegionsOfAnotherFrameAreSaid();
  void AnotherCaseHasNothingToUndoOfThisOne();
  void cleanupTestCase() { window_.reset(); }

 private:
  static constexpr double kDepth = 0.09;
  bool settle() {
    return QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 60000);
  }
  ui::StereoPanel& panel() { return *window_->findChild<ui::StereoPanel*>(); }
  ui::RegionEditor& editor(Side side) { return panel().stereo_view().editor(side); }
  const engine::CaseState& state() { return window_->engine().state(); }
  void push(const char* name) {
    auto* button = window_->findChild<QAbstractButton*>(QString::fromLatin1(name));
    QVERIFY2(button != nullptr, name);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  void click(Side side, double x, double y, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseClick(&editor(side), button, {}, editor(side).widget_point({x, y}).toPoint());
  }
  /// What is at one pixel of the left picture to another one.
  void drag(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    ui::RegionEditor& left = editor(Side::left);
    const QPoint end = left.widget_point(to).toPoint();
    QTest::mousePress(&left, Qt::LeftButton, {}, left.widget_point(from).toPoint());
    QMouseEvent move(QEvent::MouseMove, QPointF(end), left.mapToGlobal(QPointF(end)), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&left, &move);
    QTest::mouseRelease(&left, Qt::LeftButton, {}, end);
  }
  void key(int key, Qt::KeyboardModifiers keys = {}) {
    QTest::keyClick(&editor(Side::left), static_cast<Qt::Key>(key), keys);
  }
  /// Where the right picture shows what the left one shows at a pixel.
  Eigen::Vector2d partner(double x, double y) {
    const int column = static_cast<int>(std::lround(x)), row = static_cast<int>(std::lround(y));
    const double z = pair_.depth[static_cast<std::size_t>(row * pair_.rig.left.width + column)];
    const Point<CameraFrame> p(Eigen::Vector3d(z * pair_.rig.left.ray({x, y})));
    return pair_.rig.right.project((pair_.rig.right_from_left * p).xyz);
  }
  std::map<Feature, int> counts() {
    std::map<Feature, int> counts;
    for (int i = 0; i < state()[part::cloud]->size(); ++i) ++counts[state()[part::cloud]->feature(i)];
    return counts;
  }

  rendered::Pair pair_;
  TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
  std::shared_ptr<const stereo::Reconstructed> whole_;
};

void StereoLabellingTest::initTestCase() {
  pair_ = rendered::pair(
      rendered::plane(Eigen::Vector3d(0, 0, kDepth), Eigen::Vector3d(0.1, 0.2, -1.0).normalized()));
  stereo::write_picture(folder_.path() / "left.png", pair_.left);
  stereo::write_picture(folder_.path() / "right.png", pair_.right);
  stereo::write_calibration(folder_.path() / "scope.yaml", pair_.rig);
  window_ = std::make_unique<MainWindow>();
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  window_->show_step(MainWindow::stereo);
}

void StereoLabellingTest::PairIsLoadedAndReconstructed() {
  auto* run = window_->findChild<ui::TaskButton*>(QStringLiteral("reconstruct"));
  QVERIFY(!run->button()->isEnabled());
  window_->open(folder_.path() / "scope.yaml");
  window_->engine().post(
      engine::LoadStereoPair{folder_.path() / "left.png", folder_.path() / "right.png", {}});
  QVERIFY(settle());
  QVERIFY(state()[part::frame] && state()[part::rig]);
  QTRY_VERIFY(run->button()->isEnabled());
  QTest::mouseClick(run->button(), Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY2(state()[part::cloud] && state()[part::points], qPrintable(window_->status_text()));
  whole_ = state()[part::points]->whole;
  QVERIFY(state()[part::cloud]->size() > 100);
  QCOMPARE(counts().size(), std::size_t{1});  // nothing was labelled
}

void StereoLabellingTest::EpipolarLineOfThePointerPassesThroughItsPartner() {
  push("show_epipolar");
  const QPoint place = editor(Side::left).widget_point({250, 200}).toPoint();
  QTest::mouseMove(&editor(Side::left), place);
  QTRY_VERIFY(!editor(Side::right).guide().empty());
  const Eigen::Vector2d pixel = editor(Side::left).place_at(place).pixel;
  stereo::Region line;
  line.closed = false;
  line.polygon = editor(Side::right).guide();
  QVERIFY(stereo::closest_on_outline(line, partner(pixel.x(), pixel.y())).distance_px < 0.5);
  push("show_epipolar");
  QVERIFY(editor(Side::right).guide().empty());
}

void StereoLabellingTest::ClosingARegionLabelsTheSamePoints() {
  push("region_1");
  click(Side::left, 160, 120);
  click(Side::left, 480, 130);
  click(Side::left, 600, 20);
  key(Qt::Key_Backspace);
  QCOMPARE(panel().stereo_view().drawing().unfinished()->polygon.size(), std::size_t{2});
  click(Side::left, 470, 380);
  click(Side::left, 170, 370);
  QVERIFY(!state()[part::regions]);  // an open outline is nobody's business
  click(Side::left, 162, 122);
  QVERIFY(settle());
  QTRY_COMPARE(window_->engine().snapshot()->stage(part::cloud), StageState::current);
  QCOMPARE(state()[part::regions]->regions.size(), std::size_t{1});
  QVERIFY(state()[part::points]->whole == whole_);
  QVERIFY(state()[part::cloud]->size() < whole_->cloud.size());
  QVERIFY(state()[part::points]->area_cm2 > 1.0 && state()[part::points]->density_per_cm2 > 0.7);
}

void StereoLabellingTest::MarginIsALineAndTheNotchIsClickedOnTheRightPicture() {
  push("region_curve");
  click(Side::left, 180, 330);
  click(Side::left, 300, 345);
  click(Side::left, 450, 335);
  key(Qt::Key_Return);
  push("region_3");
  for (const auto& [x, y] :
       {std::pair(290.0, 300.0), std::pair(370.0, 300.0), std::pair(370.0, 362.0), std::pair(290.0, 362.0)}) {
    const Eigen::Vector2d right = partner(x, y);
    click(Side::right, right.x(), right.y());
  }
  QTest::keyClick(&editor(Side::right), Qt::Key_Return);
  QVERIFY(settle());
  QCOMPARE(state()[part::regions]->regions.size(), std::size_t{3});
  QVERIFY(!state()[part::regions]->regions[1].closed);
  QVERIFY(state()[part::regions]->regions[2].side == Side::right);
  QCOMPARE(window_->findChild<QListWidget*>(QStringLiteral("region_list"))->count(), 3);
  key(Qt::Key_Escape);
  QVERIFY(!panel().stereo_view().drawing().tool());
  QVERIFY(!window_->findChild<QPushButton*>(QStringLiteral("region_3"))->isChecked());
}

void StereoLabellingTest::CloudHoldsEveryLabelWhereItWasClicked() {
  QVERIFY(settle());
  QTRY_COMPARE(counts().size(), std::size_t{3});
  const LabelledCloud& cloud = *state()[part::cloud];
  for (int i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector2d pixel = pair_.rig.left.project(cloud.points.row(i).transpose());
    // A pixel's room at the borders: clicks are rounded to the screen's, which are larger.
    const bool in_notch = pixel.x() > 294 && pixel.x() < 366 && pixel.y() > 304 && pixel.y() < 358;
    const bool near_notch = pixel.x() > 286 && pixel.x() < 374 && pixel.y() > 296 && pixel.y() < 366;
    if (in_notch) QVERIFY(cloud.feature(i) == Feature::umbilical_notch);
    if (!near_notch) QVERIFY(cloud.feature(i) != Feature::umbilical_notch);
    if (pixel.y() < 310 && !near_notch) QVERIFY(cloud.feature(i) == Feature::surface);
  }
  const auto* legend = window_->findChild<QLabel*>(QStringLiteral("cloud_legend"));
  QVERIFY(legend->isVisible() && legend->text().contains(QStringLiteral("points per cm²")));
  for (const auto& [feature, count] : counts())
    QVERIFY(legend->text().contains(QStringLiteral("%1: %2").arg(ui::feature_name(feature)).arg(count)));
}

void StereoLabellingTest::DraggedCornerTakesPointsAwayAndUndoBringsThemBack() {
  const int before = state()[part::cloud]->size();
  drag({160, 120}, {380, 300});
  QVERIFY(settle());
  QTRY_VERIFY(state()[part::cloud]->size() < before);
  QVERIFY((state()[part::regions]->regions[0].polygon[0] - Eigen::Vector2d(380, 300)).norm() < 2.0);
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QTRY_COMPARE(state()[part::cloud]->size(), before);
  QVERIFY(state()[part::points]->whole == whole_);
}

void StereoLabellingTest::DeleteRemovesAndRedoRemovesAgain() {
  click(Side::left, 200, 200);  // inside the surface's region only
  QVERIFY(panel().stereo_view().drawing().selected() == std::optional<std::size_t>(0));
  key(Qt::Key_Delete);
  QVERIFY(settle());
  QTRY_COMPARE(counts().count(Feature::surface), std::size_t{0});
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QTRY_COMPARE(counts().size(), std::size_t{3});
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(settle());
  QTRY_COMPARE(counts().count(Feature::surface), std::size_t{0});
  push("undo_region");
  QVERIFY(settle());
  QTRY_COMPARE(counts().size(), std::size_t{3});
}

void StereoLabellingTest::HintSaysWhatAClickDoes() {
  const auto* hint = window_->findChild<QLabel*>(QStringLiteral("stereo_hint"));
  ui::RegionEditor& left = editor(Side::left);
  const auto hover = [&](double x, double y) {
    const QPointF place = left.widget_point({x, y});
    QMouseEvent move(QEvent::MouseMove, place, left.mapToGlobal(place), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(&left, &move);
  };
  hover(480, 130);
  QVERIFY(hint->text().contains(QStringLiteral("moves this corner")));
  QVERIFY(left.cursor().shape() == Qt::SizeAllCursor);
  hover(240, 220);
  QVERIFY(hint->text().contains(QStringLiteral("selects this region")));
  push("region_2");
  hover(240, 220);
  QVERIFY(hint->text().contains(QStringLiteral("begins here")));
  QVERIFY(left.cursor().shape() == Qt::CrossCursor);
  key(Qt::Key_Escape);
}

void StereoLabellingTest::ALookIsKeptOnceAndForgotten() {
  auto* keep = window_->findChild<QPushButton*>(QStringLiteral("keep_look"));
  auto* forget = window_->findChild<QPushButton*>(QStringLiteral("forget_looks"));
  auto* said = window_->findChild<QLabel*>(QStringLiteral("looks_said"));
  QVERIFY(keep && forget && said);
  QVERIFY(keep->isEnabled() && !forget->isEnabled());
  QTest::mouseClick(keep, Qt::LeftButton);
  QVERIFY(settle());
  QCOMPARE(state()[part::earlier_looks]->clouds.size(), std::size_t{1});
  // The same points once more would be joined with themselves.
  QVERIFY(!keep->isEnabled() && forget->isEnabled());
  QVERIFY(said->text().contains(QStringLiteral("elsewhere")));
  QTest::mouseClick(forget, Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY(!state()[part::earlier_looks]);
  QVERIFY(keep->isEnabled() && !forget->isEnabled());
}

void StereoLabellingTest::WheelEnlargesAboutThePointerAndClicksStayTrue() {
  ui::RegionEditor& left = editor(Side::left);
  const Eigen::Vector2d pixel(500.0, 320.0);
  const QPointF place = left.widget_point(pixel);
  const auto wheel = [&](int notches) {
    QWheelEvent event(place, left.mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&left, &event);
  };
  const double before = left.widget_point({510.0, 320.0}).x() - place.x();
  wheel(5);
  QVERIFY((left.pixel_at(place) - pixel).norm() < 1e-6);  // what is under the pointer stays there
  QVERIFY(std::abs((left.widget_point({510.0, 320.0}).x() - left.widget_point(pixel).x()) / before -
                   std::pow(1.25, 5)) < 1e-6);
  const std::size_t regions = state()[part::regions]->regions.size();
  push("region_1");
  for (const auto& [x, y] : {std::pair(490.0, 310.0), {510.0, 310.0}, {510.0, 330.0}, {490.0, 310.0}})
    click(Side::left, x, y);
  QVERIFY(settle());
  QCOMPARE(state()[part::regions]->regions.size(), regions + 1);
  // A pixel of the screen is a third of one of the picture now.
  QVERIFY((state()[part::regions]->regions.back().polygon[1] - Eigen::Vector2d(510.0, 310.0)).norm() < 0.7);
  key(Qt::Key_Escape);
  wheel(-9);
  QVERIFY(std::abs(left.widget_point({510.0, 320.0}).x() - left.widget_point(pixel).x() - before) < 1e-6);
  QVERIFY((left.widget_point(pixel) - place).manhattanLength() < 1e-6);  // fits again
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QCOMPARE(state()[part::regions]->regions.size(), regions);
}

void StereoLabellingTest::KeyboardReachesEverythingByAName() {
  // Whatever a tab reaches has a name for a screen reader.
  QStringList met;
  for (const QWidget* now : panel().findChildren<QWidget*>()) {
    if (!now->isVisible() || (now->focusPolicy() & Qt::TabFocus) == 0 || now->focusProxy() != nullptr)
      continue;
    if (now->objectName().startsWith(QStringLiteral("qt_"))) continue;  // a spin box's own line
    const auto* button = qobject_cast<const QAbstractButton*>(now);
    QVERIFY2(
        !now->accessibleName().isEmpty() || (button != nullptr && button->text().size() > 1),
        qPrintable(now->objectName() + QLatin1Char(' ') + QLatin1String(now->metaObject()->className())));
    met << now->objectName();
  }
  for (const char* name :
       {"region_1", "region_2", "region_3", "region_curve", "region_list", "method", "features"})
    QVERIFY2(met.contains(QString::fromLatin1(name)), name);
  for (const char* name : {"show_epipolar", "show_missing", "show_loupe"}) {
    auto* toggle = window_->findChild<QToolButton*>(QString::fromLatin1(name));
    QVERIFY(toggle->focusPolicy() == Qt::TabFocus && !toggle->toolTip().isEmpty());
  }
  // Ctrl+Y does again what Ctrl+Z undid.
  editor(Side::left).setFocus();
  const std::size_t regions = state()[part::regions]->regions.size();
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  const std::size_t undone = panel().stereo_view().drawing().regions().size();
  QVERIFY(panel().stereo_view().drawing().can_redo());
  key(Qt::Key_Y, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY(!panel().stereo_view().drawing().can_redo() ||
          undone != panel().stereo_view().drawing().regions().size());
  QCOMPARE(state()[part::regions]->regions.size(), regions);
}

void StereoLabellingTest::ALookIsTheOneThatWasSeenWhileAnotherIsMade() {
  const auto seen = state()[part::cloud];
  QVERIFY(!state()[part::earlier_looks]);
  engine::Reconstruct other;  // of other points than the panel's own
  other.options.kind = stereo::Features::akaze;
  window_->engine().post(other);
  push("keep_look");
  QVERIFY(settle());
  QVERIFY(state()[part::cloud] != seen);
  QVERIFY(state()[part::earlier_looks] && state()[part::earlier_looks]->clouds[0] == seen);
  push("forget_looks");
  engine::Reconstruct again;
  window_->engine().post(again);
  QVERIFY(settle());
}

void StereoLabellingTest::PointsAreNotDrawnThroughAnotherCalibration() {
  QVERIFY(!editor(Side::left).dots().empty());
  push("show_missing");
  QVERIFY(editor(Side::left).has_veil());
  StereoRig other = pair_.rig;
  for (Camera* camera : {&other.left, &other.right}) camera->matrix.topLeftCorner<2, 2>() *= 1.2;
  stereo::write_calibration(folder_.path() / "other.yaml", other);
  window_->open(folder_.path() / "other.yaml");
  QVERIFY(settle());
  QVERIFY(editor(Side::left).dots().empty() && editor(Side::right).dots().empty());
  QVERIFY(!editor(Side::left).has_veil());
  QVERIFY(window_->findChild<QLabel*>(QStringLiteral("cloud_legend"))->text().contains("Out of date"));
  QTest::mouseClick(window_->findChild<ui::TaskButton*>(QStringLiteral("reconstruct"))->button(),
                    Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY(!editor(Side::left).dots().empty() && editor(Side::left).has_veil());
  push("show_missing");
  // An imported cloud was seen by the calibration that was there when it came.
  write_cloud(folder_.path() / "cloud.ply", *state()[part::cloud]);
  window_->engine().post(engine::ImportCloud{folder_.path() / "cloud.ply"});
  QVERIFY(settle());
  QVERIFY(!editor(Side::left).dots().empty());
  window_->open(folder_.path() / "scope.yaml");
  QVERIFY(settle());
  QVERIFY(editor(Side::left).dots().empty() && editor(Side::right).dots().empty());
  QTest::mouseClick(window_->findChild<ui::TaskButton*>(QStringLiteral("reconstruct"))->button(),
                    Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY(!editor(Side::left).dots().empty());
}

void StereoLabellingTest::RegionsOfAnotherFrameAreSaid() {
  const auto* warning = window_->findChild<QLabel*>(QStringLiteral("stereo_warnings"));
  QVERIFY(!warning->isVisible());
  QVERIFY(!editor(Side::left).dots().empty());
  const auto other = rendered::pair(rendered::plane({0, 0, 0.1}, {0, 0, -1}), {0.002, 30.0, 1.0});
  stereo::write_picture(folder_.path() / "l2.png", other.left);
  stereo::write_picture(folder_.path() / "r2.png", other.right);
  window_->engine().post(engine::LoadStereoPair{folder_.path() / "l2.png", folder_.path() / "r2.png", {}});
  QVERIFY(settle());
  QTRY_VERIFY(warning->isVisible() && warning->text().contains(QStringLiteral("another frame")));
  QVERIFY(!panel().stereo_view().drawing().can_undo());  // those steps were the other frame's
  // The points lie elsewhere in these pictures; in three dimensions they stay.
  QVERIFY(editor(Side::left).dots().empty() && editor(Side::right).dots().empty());
  QVERIFY(window_->findChild<QLabel*>(QStringLiteral("cloud_legend"))->text().contains("Out of date"));
  // Who moves one stores all; the others are the other frame's still.
  const std::size_t others = state()[part::regions]->regions.size() - 1;
  const auto corner = state()[part::regions]->regions[0].polygon[0];
  drag(corner, corner + Eigen::Vector2d(30, 40));
  QVERIFY(settle());
  QCOMPARE(state()[part::regions]->regions.size(), others + 1);
  QTRY_VERIFY(warning->text().contains(QStringLiteral("another frame: %1").arg(others)));
  push("clear_regions");
  QVERIFY(settle());
  QTRY_VERIFY(!warning->isVisible());
  QVERIFY(state()[part::regions]->regions.empty());
}

/// Neither has regions now: what was drawn here is of another patient.
void StereoLabellingTest::AnotherCaseHasNothingToUndoOfThisOne() {
  const ui::RegionDrawing& drawing = panel().stereo_view().drawing();
  QVERIFY(drawing.regions().empty() && drawing.can_undo());
  engine::CaseState other;
  other[part::frame] = state()[part::frame];
  QVERIFY(engine::save_case(folder_.path() / "other.glisson", other, RunContext()));
  window_->engine().post(engine::OpenCase{folder_.path() / "other.glisson"});
  QVERIFY(settle());
  QVERIFY(state()[part::frame] && !state()[part::regions]);
  QVERIFY(!drawing.can_undo() && !drawing.can_redo());
  key(Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY(drawing.regions().empty() && !state()[part::regions]);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::StereoLabellingTest>(argc, argv); }
#include "stereo_labelling_test.moc"
