// SPDX-License-Identifier: GPL-3.0-or-later
// What an edit would do is shown before a click or Enter does it, by mouse and keyboard at the window.
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QWheelEvent>
#include <array>

#include "segmentation_window.h"

#include "glisson/editing/tools/smooth.h"
#include "glisson/editing/tools/threshold.h"
#include "glisson/engine/parts/preview.h"
#include "glisson/ui/common/texts.h"

namespace glisson {

using scene::Plane;
using ui::edit_tool;

class SegmentationPreviewTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void ThresholdIsPreviewedThenApplied();
  void JointSmoothingSaysWhatBecomesOfEachLabel();
  void TypedEndOfARangeLeavesTheOther();
  void CancelledPreviewChangesNothing();
  void EnterKeepsTheLargestIsland();
  void EnterThatIsHeldAppliesOnce();
  void LevelTracingShowsWhatAClickTakes();
  void BranchThatAClickWouldMoveIsShownBefore();
};

void SegmentationPreviewTest::ThresholdIsPreviewedThenApplied() {
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

void SegmentationPreviewTest::JointSmoothingSaysWhatBecomesOfEachLabel() {
  open_labels();
  const double ml = 1e-3 * labels().grid().voxel_volume_mm3();
  const std::vector<Label> all = {structure::kParenchyma, structure::kPortalVein, structure::kFirstLesion};
  std::vector<long> before;
  for (const Label label : all) before.push_back(count(label));
  QTest::keyClick(window_.get(), Qt::Key_S);
  find<QComboBox>("smooth_method")->setCurrentIndex(static_cast<int>(editing::Smooth::Method::joint));
  find<QDoubleSpinBox>("smooth_radius")->setValue(5.0);
  QTRY_VERIFY(session().shows_preview());
  QVERIFY(settle());
  QVERIFY(session().voxels_to_change() > 0);
  const auto changes = session().volume_changes();
  QVERIFY(!changes.empty());
  const QString told = find<QLabel>("edit_outcome")->text();
  for (const auto& change : changes) {
    QCOMPARE(change.before, count(change.label));
    QVERIFY2(told.contains(ui::structure_text(change.label) + QStringLiteral(": ")), qPrintable(told));
  }
  press("apply_edit");
  QVERIFY(settle());
  for (const auto& change : changes) QCOMPARE(count(change.label), change.after);
  for (std::size_t n = 0; n < all.size(); ++n)
    QVERIFY2(std::abs(count(all[n]) - before[n]) <= 0.02 * before[n],
             qPrintable(QStringLiteral("%1 of %2 ml").arg(ml * count(all[n])).arg(ml * before[n])));
}

void SegmentationPreviewTest::TypedEndOfARangeLeavesTheOther() {
  using Range = std::array<double, 2>;
  open_labels();
  choose(structure::kGallbladder);  // empty so far
  const auto type = [&](const char* name, const char* digits, Qt::Key key) {
    auto* number = find<QDoubleSpinBox>(name);
    number->setFocus();
    number->selectAll();
    QTest::keyClicks(number, QString::fromLatin1(digits));
    QTest::keyClick(number, key);
  };
  const auto range = [&] {
    const auto& threshold = session().settings().of<editing::Threshold>();
    return Range{threshold.low, threshold.high};
  };
  QTest::keyClick(window_.get(), Qt::Key_T);
  type("threshold_high", "250", Qt::Key_Tab);
  QVERIFY((range() == Range{100.0, 250.0}));
  type("threshold_low", "260", Qt::Key_Tab);  // the whole number does push
  QVERIFY((range() == Range{260.0, 260.0}));
  type("threshold_high", "90", Qt::Key_Tab);
  QVERIFY((range() == Range{90.0, 90.0}));
  // Enter applies what stands there, as it always does.
  type("threshold_low", "100", Qt::Key_Tab);
  type("threshold_high", "150", Qt::Key_Return);
  QVERIFY(settle());
  QVERIFY((range() == Range{100.0, 150.0}));
  QCOMPARE(at({0, 0.02, 0}), structure::kGallbladder);   // 110 HU
  QCOMPARE(at({0, -0.015, 0}), structure::kPortalVein);  // 170 HU
  // The ends of the intensities that may be changed are typed alike.
  find<QCheckBox>("editable_by_intensity")->setChecked(true);
  const auto editable = [&] { return session().settings().region.intensity.value(); };
  type("editable_high", "180", Qt::Key_Tab);
  type("editable_low", "100", Qt::Key_Tab);
  QVERIFY((editable() == Range{100.0, 180.0}));
  type("editable_high", "160", Qt::Key_Tab);
  QVERIFY((editable() == Range{100.0, 160.0}));
  session().cancel();
  QVERIFY(settle());
}

void SegmentationPreviewTest::CancelledPreviewChangesNothing() {
  open_labels();
  const LabelVolume before = labels();
  const std::size_t steps = session().history()->done();
  choose(structure::kParenchyma);
  QTest::keyClick(window_.get(), Qt::Key_M);
  QTRY_VERIFY(session().shows_preview());
  QVERIFY(window_->engine().state()[part::preview] != nullptr);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QVERIFY(settle());
  QTRY_VERIFY(window_->engine().state()[part::preview] == nullptr);
  QCOMPARE(session().tool(), edit_tool("margin"));  // the tool stays in the hand
  QVERIFY(labels() == before);
  QCOMPARE(session().history()->done(), steps);
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QCOMPARE(session().tool(), nullptr);
}

void SegmentationPreviewTest::EnterKeepsTheLargestIsland() {
  open_labels();
  choose(structure::kPortalVein);
  press("tool_paint");
  drag(slice(Plane::axial), {{-0.02, 0.025, 0}});
  QVERIFY(settle());
  QCOMPARE(at({-0.02, 0.025, 0}), structure::kPortalVein);
  QTest::keyClick(window_.get(), Qt::Key_I);
  QTRY_VERIFY(session().shows_preview());
  QVERIFY(settle());  // also the copy that is kept before long work
  QTest::keyClick(window_.get(), Qt::Key_Return);
  QVERIFY(settle());
  QVERIFY(at({-0.02, 0.025, 0}) != structure::kPortalVein);
  QCOMPARE(at({0, -0.015, 0}), structure::kPortalVein);
}

void SegmentationPreviewTest::EnterThatIsHeldAppliesOnce() {
  open_labels();
  choose(structure::kPortalVein);
  QTest::keyClick(window_.get(), Qt::Key_M);
  QTRY_VERIFY(session().shows_preview());
  QVERIFY(settle());
  const std::size_t steps = session().history()->done();
  for (const bool repeats : {false, true, true}) {
    QTest::simulateEvent(window_.get(), true, Qt::Key_Return, {}, QStringLiteral("\r"), repeats);
    QVERIFY(settle());
  }
  QTest::keyRelease(window_.get(), Qt::Key_Return);
  QCOMPARE(session().history()->done(), steps + 1);
}

void SegmentationPreviewTest::LevelTracingShowsWhatAClickTakes() {
  open_labels();
  choose(structure::kGallbladder);
  QTest::keyClick(window_.get(), Qt::Key_L);
  ui::SliceView& axial = slice(Plane::axial);
  const QImage plain = axial.grab().toImage();
  const ui::ViewState& shared = window_->views().state();
  const auto move = [&](const Eigen::Vector3d& p) {
    QTest::mouseMove(&axial, axial.widget_point(Point<CtFrame>(p)).toPoint());
    return QTest::qWaitFor([&] {
      return shared.line() && shared.pointer() && shared.line()->place.p.xyz == shared.pointer()->p.xyz;
    });
  };
  QVERIFY(move({0.0225, 0.0, 0}));  // on the lesion's edge
  const auto line = shared.line();
  QCOMPARE(line->label, structure::kGallbladder);
  const QImage drawn = axial.grab().toImage();
  QPolygonF outline;
  for (Eigen::Index n = 0; n < line->corners.rows(); ++n) {
    outline << axial.widget_point(Point<CtFrame>(Eigen::Vector3d(line->corners.row(n).transpose())));
    const QPoint at = outline.last().toPoint();
    QVERIFY(drawn.pixel(at) != plain.pixel(at));
  }
  QVERIFY(outline.size() > 8);
  QVERIFY(slice(Plane::coronal).geometry_in_ct().width > 0);
  // A click takes what the line encloses.
  const LabelVolume before = labels();
  QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.widget_point(Point<CtFrame>(0.0225, 0.0, 0)).toPoint());
  QVERIFY(settle());
  const VolumeGrid& grid = labels().grid();
  const int layer = static_cast<int>(std::lround(grid.index_of(line->place.p).z()));
  int taken = 0;
  for (int j = 0; j < grid.size.y(); ++j)
    for (int i = 0; i < grid.size.x(); ++i) {
      const Point<CtFrame> p = grid.p_in_ct({double(i), double(j), double(layer)});
      const bool inside = outline.containsPoint(axial.widget_point(p), Qt::OddEvenFill);
      QCOMPARE(labels().at({i, j, layer}) == structure::kGallbladder, inside);
      taken += inside ? 1 : 0;
    }
  QVERIFY2(taken > 30 && taken < 70, qPrintable(QString::number(taken)));  // 8 mm of radius, pixels of 2 mm
  // The wheel shows the next slice's, the pointer's leaving and other tools show none.
  QWheelEvent wheel(axial.widget_point(Point<CtFrame>(0.0225, 0.0, 0)), {}, {}, QPoint(0, 120), Qt::NoButton,
                    {}, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&axial, &wheel);
  QTRY_VERIFY(shared.line() && shared.line()->place.p.xyz.z() > line->place.p.xyz.z());
  QTest::mouseMove(&axial, QPoint(axial.width() / 2, 4));  // above the volume
  QTRY_VERIFY(!shared.line());
  QVERIFY(move({0.0, 0.0445, 0}));
  QEvent leave(QEvent::Leave);
  QCoreApplication::sendEvent(&axial, &leave);
  QVERIFY(!shared.line());
  QVERIFY(move({0.01, 0.0445, 0}));
  QTest::keyClick(window_.get(), Qt::Key_P);
  QVERIFY(!shared.line());
}

void SegmentationPreviewTest::BranchThatAClickWouldMoveIsShownBefore() {
  open_labels();
  // A thinner branch of the portal vein; the trunk's end is the tree's root or a tip of it.
  choose(structure::kPortalVein);
  press("tool_paint");
  find<QDoubleSpinBox>("brush_diameter")->setValue(5.0);
  drag(slice(Plane::axial), {{0.0, -0.012, 0}, {0.0, 0.03, 0}});
  QVERIFY(settle());
  QTest::keyClick(window_.get(), Qt::Key_B);
  ui::SliceView& axial = slice(Plane::axial);
  const ui::ViewState& shared = window_->views().state();
  const LabelVolume before = labels();
  const long portal = count(structure::kPortalVein);
  const QImage plain = axial.grab().toImage();
  const auto point_at = [&](const Eigen::Vector3d& p) {
    QTest::mouseMove(&axial, axial.widget_point(Point<CtFrame>(p)).toPoint());
  };
  const auto* told = find<QLabel>("edit_outcome");
  point_at({0.0005, 0.015, 0});  // half-way along the branch
  QTRY_VERIFY(shared.preview() && session().branch());
  const LabelVolume shown = shared.preview()->voxels;
  const QString text = told->text();
  QVERIFY2(text.contains(QStringLiteral("Portal vein → Hepatic veins")), qPrintable(text));
  QVERIFY(axial.grab().toImage() != plain);
  QTRY_VERIFY(told->visibleRegion().boundingRect().height() == told->height());  // not scrolled away
  QVERIFY(labels() == before);                                                   // only shown
  QCOMPARE(session().branch()->result.voxels_changed, shown.histogram()[structure::kHepaticVeins]);
  // On the trunk that branch is not shown any longer, whether or not it is known what moves there.
  Eigen::Vector3d trunk = Eigen::Vector3d::Zero();
  for (int x = 0; x < before.grid().size.x(); ++x)
    for (int y = 0; y < before.grid().size.y(); ++y) {
      const Eigen::Vector3i v(x, y, before.grid().size.z() / 2);
      if (before.at(v) == structure::kPortalVein && shown.at(v) == structure::kPortalVein)
        trunk = before.grid().p_in_ct(v.cast<double>()).xyz;
    }
  std::vector<bool> shows;
  const auto seen = connect(&session(), &ui::EditSession::changed, this,
                            [&] { shows.push_back(session().branch() != nullptr); });
  point_at(trunk);
  QTRY_VERIFY(!shows.empty());
  QVERIFY(!shows.front());
  disconnect(seen);
  // Beside the vessels nothing would move.
  point_at({0.03, 0.012, 0});
  QTRY_VERIFY(!shared.preview() && !session().branch());
  QVERIFY(!told->isVisible());
  // The click does what was shown.
  point_at({0.0005, 0.015, 0});
  QTRY_VERIFY(shared.preview());
  QTest::mouseClick(&axial, Qt::LeftButton, {},
                    axial.widget_point(Point<CtFrame>(0.0005, 0.015, 0)).toPoint());
  QVERIFY(settle());
  QVERIFY(labels() == shown);
  QVERIFY(count(structure::kPortalVein) < portal && count(structure::kPortalVein) > portal / 2);
  QVERIFY(!shared.preview());  // not at once the way back
  // Another tool puts it away.
  point_at({0.001, 0.02, 0});
  QTRY_VERIFY(shared.preview());
  QVERIFY(told->text().contains(QStringLiteral("Hepatic veins → Portal vein")));
  std::optional<bool> shown_of_former;
  const auto change = connect(&session(), &ui::EditSession::tool_changed, this,
                              [&] { shown_of_former = session().branch() != nullptr; });
  QTest::keyClick(window_.get(), Qt::Key_P);
  disconnect(change);
  QVERIFY(shown_of_former.has_value() && !*shown_of_former);
  QVERIFY(!shared.preview() && !session().branch());
}

}  // namespace glisson

int main(int argc, char** argv) {
  return glisson::run_in_window<glisson::SegmentationPreviewTest>(argc, argv);
}
#include "segmentation_preview_test.moc"
