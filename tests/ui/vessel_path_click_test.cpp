// SPDX-License-Identifier: GPL-3.0-or-later
// Mends a vessel by clicks in a slice, like a person at the window.
#include <QLabel>
#include <QToolButton>

#include "segmentation_window.h"

namespace glisson {

using scene::Plane;
using ui::edit_tool;

class VesselPathClickTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void VesselPathIsShownAfterOneClickAndMadeByTheSecond();
};

void VesselPathClickTest::VesselPathIsShownAfterOneClickAndMadeByTheSecond() {
  open_labels();
  ui::SliceView& axial = slice(Plane::axial);
  const ui::ViewState& shared = window_->views().state();
  // A piece of the portal vein is lost.
  choose(structure::kPortalVein);
  const Eigen::Vector3d left(-0.02, -0.015, 0), right(0.02, -0.015, 0), between(0.0, -0.015, 0);
  session().set_tool(edit_tool("paint"));
  ui::EditSettings settings = session().settings();
  settings.ball = true;
  settings.brush_radius = 8e-3;
  session().set_settings(settings);
  drag(axial, {{-0.004, -0.015, 0}, {0.004, -0.015, 0}}, Qt::ControlModifier);
  QVERIFY(settle());
  QVERIFY(at(between) != structure::kPortalVein && at(left) == structure::kPortalVein);
  const LabelVolume before = labels();
  const auto click = [&](const Eigen::Vector3d& p, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(&axial, Qt::LeftButton, keys, axial.widget_point(Point<CtFrame>(p)).toPoint());
  };
  const auto point_at = [&](const Eigen::Vector3d& p) {
    QTest::mouseMove(&axial, axial.widget_point(Point<CtFrame>(p)).toPoint());
  };
  QTest::keyClick(window_.get(), Qt::Key_V);
  QCOMPARE(session().tool(), edit_tool("vessel_path"));
  const auto* told = find<QLabel>("edit_outcome");
  point_at(right);
  QVERIFY(!shared.preview() && !told->isVisible());  // of what nobody has begun nothing is shown
  click(left);
  QVERIFY(told->text().contains(QStringLiteral("Click the other end")));
  QVERIFY(shared.line());
  QVERIFY(labels() == before);
  point_at(right);
  QTRY_VERIFY(shared.preview() && session().branch());
  QVERIFY(shared.line());  // the first click stays marked
  QVERIFY2(told->text().contains(QStringLiteral("A click here makes a vessel of")), qPrintable(told->text()));
  const LabelVolume shown = shared.preview()->voxels;
  // Esc drops the click, not the tool.
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  QCOMPARE(session().clicked(), std::size_t(0));
  QCOMPARE(session().tool(), edit_tool("vessel_path"));
  QTRY_VERIFY(!shared.preview() && !shared.line());
  click(left);
  point_at(right);
  QTRY_VERIFY(shared.preview());
  click(right);
  QVERIFY(settle());
  QVERIFY(labels() == shown);
  QCOMPARE(at(between), structure::kPortalVein);
  QCOMPARE(session().clicked(), std::size_t(0));
  QVERIFY(!shared.line());
  QCOMPARE(find<QToolButton>("undo")->text(), QStringLiteral("Undo: Vessel path, Portal vein"));
  session().undo();
  QVERIFY(settle());
  QVERIFY(labels() == before);
  // Ctrl adds a point between: still nothing is made.
  click(left);
  click(between, Qt::ControlModifier);
  QVERIFY(settle());
  QCOMPARE(session().clicked(), std::size_t(2));
  QVERIFY(labels() == before);
  click(right);
  QVERIFY(settle());
  QCOMPARE(at(between), structure::kPortalVein);
  // With a label that is no vessel the tool says what to choose, before and after the clicks.
  session().undo();
  QVERIFY(settle());
  choose(structure::kParenchyma);
  bool hinted = false;
  for (const QLabel* label : window_->findChildren<QLabel*>())
    hinted = hinted || (label->isVisible() && label->text().startsWith("First choose a vessel"));
  QVERIFY(hinted);
  click(left);
  click(right);
  QVERIFY(settle());
  QVERIFY2(told->text().contains(QStringLiteral("which is no vessel")), qPrintable(told->text()));
  QVERIFY(labels() == before);
  choose(structure::kPortalVein);
  // A locked label is not worked on, and a refusal is told.
  click(left);
  click(left);
  QVERIFY(settle());
  QVERIFY2(told->text().contains(QStringLiteral("same place twice")), qPrintable(told->text()));
  QVERIFY(labels() == before);
  settings = session().settings();
  settings.region.locked = {structure::kPortalVein};
  session().set_settings(settings);
  click(left);
  QCOMPARE(session().clicked(), std::size_t(0));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::VesselPathClickTest>(argc, argv); }
#include "vessel_path_click_test.moc"
