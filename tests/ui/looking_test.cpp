// SPDX-License-Identifier: GPL-3.0-or-later
// What a person does in order to see: windows, a larger view, places pointed at in 3D.
#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <QTranslator>
#include <QWheelEvent>

#include <Eigen/Geometry>

#include "fake_operation.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/ui/atlas/atlas_panel.h"
#include "glisson/ui/common/user_settings.h"
#include "glisson/ui/shell/main_window.h"
#include "operated_window.h"

namespace glisson {

using scene::Plane;
using ui::MainWindow;
using ui::WindowPreset;

class LookingTest : public QObject, private OperatedWindow {
  Q_OBJECT
 private slots:
  void init() {
    ui::user_settings()->clear();
    open_window();
    QApplication::setActiveWindow(window_.get());  // keys go to it though no window manager says so
  }
  void cleanup() { close_window(); }
  void AKeyShowsAWindowInAllSlicesAndSaysSo();
  void TheLastOwnWindowIsThereInTheNextSitting();
  void AnMriSaysWhyHounsfieldWindowsAreNotOffered();
  void TheStripFitsTheSmallestWindowInEveryLanguage_data();
  void TheStripFitsTheSmallestWindowInEveryLanguage();
  void DoubleClickLetsAViewFillThePlaceOfAll_data();
  void DoubleClickLetsAViewFillThePlaceOfAll();
  void WithAToolADoubleClickIsTwoClicks();
  void EscapePutsAToolAwayBeforeItGoesBack();
  void TheKeyTakesTheViewUnderThePointerInEveryStep();
  void TheWholePictureComesBackByKeyAndMenu();
  void AClickIn3DMovesTheSlicesThere();
  void AClickIn3DPlacesALandmarkAndMovesNoSlice();
  void ADragIn3DMovesNoSlice();
  void ASlabIsShownByKeyAndMadeThickerByTheWheel();
  void TheSlabsThicknessIsThereInTheNextSitting();
  void ADragMeasuresMillimetresOfThePatient_data();
  void ADragMeasuresMillimetresOfThePatient();
  void AMeasureIsDrawnInItsSliceOnly();
  void MeasuresAreTakenBackByKeyAndWiped();
  void MeasuringAndPanelsToolsPutEachOtherAway();

 private:
  void save_picture(const char* name) {
    if (!qEnvironmentVariableIsSet("GLISSON_SAVE_PICTURES")) return;
    window_->grab().save(QStringLiteral("%1/looking_%2.png")
                             .arg(qEnvironmentVariable("GLISSON_SAVE_PICTURES"), QLatin1String(name)));
  }
  QPoint middle(const QWidget& view) { return view.rect().center(); }
  void double_click(QWidget& view) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, middle(view));
    const QPointF place = middle(view);
    QMouseEvent second(QEvent::MouseButtonDblClick, place, view.mapToGlobal(place), Qt::LeftButton,
                       Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &second);
    QTest::mouseRelease(&view, Qt::LeftButton, {}, middle(view));
  }
  void drag(QWidget& view, QPoint from, QPoint to) {
    QTest::mousePress(&view, Qt::LeftButton, {}, from);
    for (const QPoint& place : {(from + to) / 2, to}) {
      QMouseEvent move(QEvent::MouseMove, QPointF(place), view.mapToGlobal(QPointF(place)), Qt::NoButton,
                       Qt::LeftButton, Qt::NoModifier);
      QCoreApplication::sendEvent(&view, &move);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to);
  }
  void turn_wheel(QWidget& view, int notches, Qt::KeyboardModifiers keys = {}) {
    QWheelEvent wheel(QPointF(middle(view)), view.mapToGlobal(QPointF(middle(view))), {}, {0, 120 * notches},
                      Qt::NoButton, keys, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&view, &wheel);
  }
  void click_action(const char* name) {
    auto* button = window_->findChild<QToolButton*>(QString::fromLatin1(name) + QStringLiteral("_button"));
    QVERIFY2(button != nullptr && button->isEnabled(), name);
    QTest::mouseClick(button, Qt::LeftButton);
  }
  QAction* action(const char* name) {
    return window_->views().bar().findChild<QAction*>(QString::fromLatin1(name));
  }
  /// At a place of the model in the 3D view.
  QPoint place_in_3d(const Eigen::Vector3d& p) {
    ui::RenderView& view = window_->views().volume();
    const auto place = view.patient().view_point(p, view.aspect());
    return {static_cast<int>(place->x() * view.width()), static_cast<int>(place->y() * view.height())};
  }
  const std::vector<ui::Measure>& measures() { return state().measures().measures(); }
  void key(int key) { QTest::keyClick(window_.get(), static_cast<Qt::Key>(key)); }
  void drag_window(QPoint to) {
    ui::SliceView& axial = slice(Plane::axial);
    QTest::mousePress(&axial, Qt::RightButton, {}, QPoint(100, 100));
    QMouseEvent move(QEvent::MouseMove, QPointF(to), axial.mapToGlobal(QPointF(to)), Qt::NoButton,
                     Qt::RightButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&axial, &move);
    QTest::mouseRelease(&axial, Qt::RightButton, {}, to);
  }
  const ui::ViewState& state() { return window_->views().state(); }
};

void LookingTest::AKeyShowsAWindowInAllSlicesAndSaysSo() {
  open_ct();
  QVERIFY(slice(Plane::axial).shown_text().startsWith(QStringLiteral("Abdomen  WL 80  WW 400")));
  std::array<Picture, 3> before;
  for (int k = 0; k < 3; ++k) before[static_cast<std::size_t>(k)] = slice(static_cast<Plane>(k)).slice();
  key(Qt::Key_F3);
  QCOMPARE(state().preset(), WindowPreset::liver);
  for (int k = 0; k < 3; ++k) {
    QVERIFY(*before[static_cast<std::size_t>(k)].bytes != *slice(static_cast<Plane>(k)).slice().bytes);
    QVERIFY(slice(static_cast<Plane>(k)).shown_text().startsWith(QStringLiteral("Liver  WL 100  WW 180")));
  }
  auto* windows = window_->findChild<QToolButton*>(QStringLiteral("windows"));
  QVERIFY(windows->isVisible());
  QCOMPARE(windows->text(), QStringLiteral("Window: Liver"));
  QVERIFY(window_->views().bar().preset_action(WindowPreset::liver)->isChecked());
  window_->show_step(MainWindow::stereo);  // there is nothing to be seen of it
  key(Qt::Key_F6);
  QCOMPARE(state().preset(), WindowPreset::liver);
}

void LookingTest::TheLastOwnWindowIsThereInTheNextSitting() {
  open_ct();
  drag_window({160, 80});
  QCOMPARE(state().preset(), WindowPreset::own);
  const ui::GreyWindow own{state().style().level, state().style().width};
  QVERIFY(own.width > 400.0);
  key(Qt::Key_F2);
  QVERIFY(state().style().width != own.width);
  key(Qt::Key_F7);
  QCOMPARE(state().style().width, own.width);
  window_ = std::make_unique<MainWindow>(operation_->options());
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  QApplication::setActiveWindow(window_.get());
  open_ct();
  QCOMPARE(state().preset(), WindowPreset::abdomen);
  key(Qt::Key_F7);
  QCOMPARE((ui::GreyWindow{state().style().level, state().style().width}), own);
}

void LookingTest::AnMriSaysWhyHounsfieldWindowsAreNotOffered() {
  auto* reason = window_->views().bar().findChild<QAction*>(QStringLiteral("no_hounsfield"));
  open_ct();
  QVERIFY(!reason->isVisible());
  operation_->ct.modality = Modality::mr;
  window_->engine().post(engine::ImportImage{"mr.nii"});
  QVERIFY(settle());
  QCOMPARE(state().image()->modality, Modality::mr);
  QCOMPARE(state().preset(), WindowPreset::whole);
  QVERIFY(reason->isVisible() && reason->text().contains(QStringLiteral("need a CT")));
  const double width = state().style().width;
  for (const WindowPreset preset : ui::kWindowPresets)
    QCOMPARE(window_->views().bar().preset_action(preset)->isEnabled(), !ui::is_hounsfield(preset));
  key(Qt::Key_F5);
  QCOMPARE(state().style().width, width);
}

void LookingTest::TheStripFitsTheSmallestWindowInEveryLanguage_data() {
  QTest::addColumn<QString>("language");
  for (const char* language : {"en", "de", "fr"}) QTest::newRow(language) << QString::fromLatin1(language);
}

void LookingTest::TheStripFitsTheSmallestWindowInEveryLanguage() {
  QFETCH(QString, language);
  QTranslator translator;
  if (language != QStringLiteral("en")) {
    QVERIFY(translator.load(QStringLiteral(":/glisson/translations/glisson_") + language));
    QCoreApplication::installTranslator(&translator);
  }
  window_ = std::make_unique<MainWindow>(operation_->options());
  window_->resize(window_->minimumSize());
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  open_ct();
  ui::ViewBar& bar = window_->views().bar();
  for (const WindowPreset preset : ui::kWindowPresets) {
    bar.preset_action(preset)->trigger();
    QVERIFY2(
        bar.minimumSizeHint().width() <= bar.width(),
        qPrintable(QStringLiteral("%1 of %2 pixels").arg(bar.minimumSizeHint().width()).arg(bar.width())));
  }
  QCoreApplication::removeTranslator(&translator);
}

void LookingTest::DoubleClickLetsAViewFillThePlaceOfAll_data() {
  QTest::addColumn<int>("which");
  QTest::addColumn<int>("step");
  for (const int step : {MainWindow::segmentation, MainWindow::model, MainWindow::atlas})
    for (int which = 0; which < 4; ++which) QTest::addRow("view %d in step %d", which, step) << which << step;
}

void LookingTest::DoubleClickLetsAViewFillThePlaceOfAll() {
  QFETCH(int, which);
  QFETCH(int, step);
  reach_model();
  window_->show_step(step);
  ui::LinkedViews& views = window_->views();
  QWidget& view = which < 3 ? static_cast<QWidget&>(slice(static_cast<Plane>(which))) : views.volume();
  const QSize before = view.size();
  double_click(view);
  QCOMPARE(views.alone(), &view);
  QTRY_VERIFY(view.width() > 1.7 * before.width() && view.height() > 1.7 * before.height());
  for (int other = 0; other < 3; ++other)
    QCOMPARE(slice(static_cast<Plane>(other)).isVisible(), other == which);
  QCOMPARE(views.volume().isVisible(), which == 3);
  double_click(view);
  QTRY_COMPARE(view.size(), before);
  QVERIFY(slice(Plane::sagittal).isVisible() && views.volume().isVisible());
  double_click(view);
  QApplication::processEvents();
  save_picture("alone");
  QVERIFY(views.alone() != nullptr && views.bar().alone_action()->isChecked());
  key(Qt::Key_Escape);
  QVERIFY(views.alone() == nullptr && !views.bar().alone_action()->isChecked());
  QTRY_COMPARE(view.size(), before);
}

void LookingTest::WithAToolADoubleClickIsTwoClicks() {
  reach_model();
  auto* seeds =
      window_->panel(MainWindow::segmentation).findChild<QPushButton*>(QStringLiteral("seed_parenchyma"));
  QTest::mouseClick(seeds, Qt::LeftButton);
  double_click(slice(Plane::axial));
  QVERIFY(window_->views().alone() == nullptr);
  window_->show_step(MainWindow::atlas);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  auto* panel = window_->findChild<ui::AtlasPanel*>();
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("place_notch")), Qt::LeftButton);
  const auto before = panel->landmarks().umbilical_notch.rows();
  double_click(window_->views().volume());
  QVERIFY(window_->views().alone() == nullptr);
  QCOMPARE(panel->landmarks().umbilical_notch.rows(), before + 2);
}

void LookingTest::EscapePutsAToolAwayBeforeItGoesBack() {
  open_ct();
  double_click(slice(Plane::axial));
  auto* seeds =
      window_->panel(MainWindow::segmentation).findChild<QPushButton*>(QStringLiteral("seed_parenchyma"));
  QTest::mouseClick(seeds, Qt::LeftButton);
  QCOMPARE(state().hand(), ui::Hand::point);
  key(Qt::Key_R);
  QVERIFY(state().is_measuring());
  key(Qt::Key_Escape);
  QVERIFY(!state().is_measuring() && state().hand() == ui::Hand::point &&
          window_->views().alone() != nullptr);
  key(Qt::Key_Escape);
  QVERIFY(state().hand() == ui::Hand::crosshair && window_->views().alone() != nullptr);
  key(Qt::Key_Escape);
  QVERIFY(window_->views().alone() == nullptr);
}

void LookingTest::TheKeyTakesTheViewUnderThePointerInEveryStep() {
  reach_model();
  for (const int step : {MainWindow::segmentation, MainWindow::model, MainWindow::atlas}) {
    window_->show_step(step);
    QTest::mouseMove(&slice(Plane::coronal), middle(slice(Plane::coronal)));
    QTest::mouseMove(&slice(Plane::coronal), middle(slice(Plane::coronal)) + QPoint(9, 9));
    QApplication::processEvents();
    key(Qt::Key_F11);
    QCOMPARE(window_->views().alone(), &slice(Plane::coronal));
    key(Qt::Key_F11);
    QVERIFY(window_->views().alone() == nullptr);
  }
}

void LookingTest::TheWholePictureComesBackByKeyAndMenu() {
  open_ct();
  ui::SliceView& axial = slice(Plane::axial);
  const Point<CtFrame> p(0.02, 0.01, 0.0);
  const QPointF before = axial.widget_point(p);
  axial.setFocus();
  turn_wheel(axial, 3, Qt::ControlModifier);
  QVERIFY(axial.widget_point(p) != before);
  QTest::keyClick(&axial, Qt::Key_Home);
  QCOMPARE(axial.widget_point(p), before);
  turn_wheel(axial, 3, Qt::ControlModifier);
  double_click(axial);  // no longer what it was for
  QTRY_VERIFY(axial.widget_point(p) != before);
  key(Qt::Key_Escape);
  const double width = state().style().width;
  QTest::mouseClick(&axial, Qt::RightButton, {}, middle(axial));  // no drag: a menu
  QCOMPARE(state().style().width, width);
  auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
  QVERIFY(menu != nullptr && menu->actions().contains(window_->views().bar().whole_action()));
  window_->views().bar().whole_action()->trigger();
  menu->close();
  QTRY_COMPARE(axial.widget_point(p), before);
  click_action("whole_picture");
}

void LookingTest::AClickIn3DMovesTheSlicesThere() {
  reach_model();
  window_->show_step(MainWindow::model);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  const Eigen::Vector3d skin(0.015, -0.04, 0.012);  // on the anterior face, before nothing solid
  QTest::mouseClick(&window_->views().volume(), Qt::LeftButton, {}, place_in_3d(skin));
  QVERIFY((state().crosshair().xyz - skin).norm() < 2e-3);  // a pixel or so
  QVERIFY(std::abs(slice(Plane::axial).geometry_in_ct().origin.z() - skin.z()) < 2e-3);
  QVERIFY(std::abs(slice(Plane::sagittal).geometry_in_ct().origin.x() - skin.x()) < 2e-3);
  const Eigen::Vector3d lesion(0.03, 0.0, 0.0);  // seen through the liver, a vein before its middle
  QTest::mouseClick(&window_->views().volume(), Qt::LeftButton, {},
                    place_in_3d(lesion + Eigen::Vector3d(0.0, 0.0, 4.7e-3)));
  QVERIFY((state().crosshair().xyz - lesion).norm() < 8e-3);
  const Eigen::Vector3d before = state().crosshair().xyz;
  QTest::mouseClick(&window_->views().volume(), Qt::LeftButton, {}, QPoint(4, 60));  // beside it
  QVERIFY(state().crosshair().xyz == before);
  window_->show_step(MainWindow::segmentation);  // there the labels' surfaces are seen
  QTRY_VERIFY(window_->views().seen_point(0.5, 0.5).has_value());
  QTRY_VERIFY(!window_->views().label_surfaces().is_making());
  const auto seen = window_->views().seen_point(0.5, 0.5);
  QTest::mouseClick(&window_->views().volume(), Qt::LeftButton, {}, middle(window_->views().volume()));
  QVERIFY((state().crosshair().xyz - *seen).norm() < 2e-3);
}

void LookingTest::AClickIn3DPlacesALandmarkAndMovesNoSlice() {
  reach_model();
  window_->show_step(MainWindow::atlas);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  auto* panel = window_->findChild<ui::AtlasPanel*>();
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("place_notch")), Qt::LeftButton);
  const auto placed = panel->landmarks().umbilical_notch.rows();
  const Eigen::Vector3d before = state().crosshair().xyz, skin(0.015, -0.04, 0.012);
  QTest::mouseClick(&window_->views().volume(), Qt::LeftButton, {}, place_in_3d(skin));
  QCOMPARE(panel->landmarks().umbilical_notch.rows(), placed + 1);
  QVERIFY(state().crosshair().xyz == before);
  key(Qt::Key_Escape);  // ends placing
  QVERIFY(settle());
  QTest::mouseClick(&window_->views().volume(), Qt::LeftButton, {}, place_in_3d(skin));
  QCOMPARE(panel->landmarks().umbilical_notch.rows(), placed + 1);
  QVERIFY((state().crosshair().xyz - skin).norm() < 2e-3);
}

void LookingTest::ADragIn3DMovesNoSlice() {
  reach_model();
  window_->show_step(MainWindow::model);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  const Eigen::Vector3d before = state().crosshair().xyz;
  drag(window_->views().volume(), place_in_3d({0.015, -0.04, 0.012}), place_in_3d({0.03, -0.04, 0.012}));
  QVERIFY(state().crosshair().xyz == before);
}

void LookingTest::ASlabIsShownByKeyAndMadeThickerByTheWheel() {
  open_ct();
  std::array<Picture, 3> before;
  for (int k = 0; k < 3; ++k) before[static_cast<std::size_t>(k)] = slice(static_cast<Plane>(k)).slice();
  QVERIFY(slice(Plane::axial).slab_text().isEmpty());
  key(Qt::Key_F9);
  for (int k = 0; k < 3; ++k) {
    QCOMPARE(slice(static_cast<Plane>(k)).slab_text(), QStringLiteral("MIP 10 mm"));
    QVERIFY(*before[static_cast<std::size_t>(k)].bytes != *slice(static_cast<Plane>(k)).slice().bytes);
  }
  const double place = state().crosshair().xyz.z();
  turn_wheel(slice(Plane::axial), 5, Qt::ShiftModifier);
  QCOMPARE(slice(Plane::axial).slab_text(), QStringLiteral("MIP 15 mm"));
  QCOMPARE(state().crosshair().xyz.z(), place);
  auto* thickness = window_->findChild<QSpinBox*>(QStringLiteral("slab_thickness"));
  QCOMPARE(thickness->value(), 15);
  thickness->setValue(30);
  QCOMPARE(slice(Plane::coronal).slab_text(), QStringLiteral("MIP 30 mm"));
  save_picture("slab");
  QVERIFY(action("slab_mip")->isChecked());
  click_action("slab_mip");
  for (int k = 0; k < 3; ++k)
    QVERIFY(*before[static_cast<std::size_t>(k)].bytes == *slice(static_cast<Plane>(k)).slice().bytes);
  turn_wheel(slice(Plane::axial), 1, Qt::ShiftModifier);  // the next slice again
  QVERIFY(state().crosshair().xyz.z() > place);
}

void LookingTest::TheSlabsThicknessIsThereInTheNextSitting() {
  open_ct();
  window_->findChild<QSpinBox*>(QStringLiteral("slab_thickness"))->setValue(22);
  window_ = std::make_unique<MainWindow>(operation_->options());
  QCOMPARE(window_->findChild<QSpinBox*>(QStringLiteral("slab_thickness"))->value(), 22);
  QVERIFY(!state().shows_slab());
}

void LookingTest::ADragMeasuresMillimetresOfThePatient_data() {
  QTest::addColumn<double>("askew");
  QTest::addColumn<double>("thickness");
  QTest::newRow("cubes") << 0.0 << 2.0;
  QTest::newRow("thick slices") << 0.0 << 5.0;
  QTest::newRow("thick slices, askew") << 0.3 << 5.0;
}

void LookingTest::ADragMeasuresMillimetresOfThePatient() {
  QFETCH(double, askew);
  QFETCH(double, thickness);
  operation_->ct.grid.spacing_mm.z() = thickness;
  operation_->ct.grid.direction = Eigen::AngleAxisd(askew, Eigen::Vector3d(1, 1, 0).normalized()).matrix();
  open_ct();
  key(Qt::Key_R);
  std::size_t kept = 0;
  for (const Plane plane : {Plane::axial, Plane::coronal, Plane::sagittal}) {
    ui::SliceView& view = slice(plane);
    Eigen::Vector3d from = state().crosshair().xyz, to = from;
    const int normal = scene::normal_axis(plane), first = normal == 0 ? 1 : 0, second = 3 - normal - first;
    to[first] += 0.012;
    to[second] += 0.016;
    drag(view, view.widget_point(Point<CtFrame>(from)).toPoint(),
         view.widget_point(Point<CtFrame>(to)).toPoint());
    QCOMPARE(measures().size(), ++kept);
    QCOMPARE(measures().back().plane, plane);
    const double pixel =
        1.0 / std::abs(view.widget_point(Point<CtFrame>(from)).x() -
                       view.widget_point(Point<CtFrame>(from + Eigen::Vector3d::Unit(first))).x());
    QVERIFY(std::abs(measures().back().line.length() - 0.02) < 1.5 * pixel);
    QVERIFY(ui::MeasureBook::text(measures().back()).endsWith(QStringLiteral(" mm")));
  }
}

void LookingTest::AMeasureIsDrawnInItsSliceOnly() {
  open_ct();
  ui::SliceView& axial = slice(Plane::axial);
  const auto drawn = [&axial] { return axial.grab().toImage(); };
  key(Qt::Key_R);
  QCOMPARE(axial.cursor().shape(), Qt::CrossCursor);
  const QImage none = drawn();
  drag(axial, middle(axial) + QPoint(-40, -30), middle(axial) + QPoint(30, 25));
  QVERIFY(drawn() != none);
  const QImage with = drawn();
  save_picture("measure");
  turn_wheel(axial, 2);
  const QImage elsewhere = drawn();
  key(Qt::Key_Escape);
  click_action("wipe_measures");
  QVERIFY(drawn() == elsewhere);
  turn_wheel(axial, -2);
  QVERIFY(drawn() != with && axial.cursor().shape() == Qt::ArrowCursor);
}

void LookingTest::MeasuresAreTakenBackByKeyAndWiped() {
  open_ct();
  ui::SliceView& coronal = slice(Plane::coronal);
  const QPoint here = middle(coronal);
  key(Qt::Key_C);
  drag(coronal, here - QPoint(40, 0), here + QPoint(40, 0));
  drag(coronal, here - QPoint(0, 20), here + QPoint(0, 20));
  QVERIFY(measures().size() == 1 && measures()[0].across);
  const QRegularExpression two(QStringLiteral("^[0-9]+\\.[0-9] × [0-9]+\\.[0-9] mm$"));
  QVERIFY(two.match(ui::MeasureBook::text(measures()[0])).hasMatch());
  coronal.setFocus();
  QTest::keyClick(&coronal, Qt::Key_Backspace);
  QVERIFY(measures().size() == 1 && !measures()[0].across);
  drag(coronal, here + QPoint(-40, 50), here + QPoint(40, 50));
  drag(slice(Plane::axial), middle(slice(Plane::axial)), middle(slice(Plane::axial)) + QPoint(30, 30));
  QCOMPARE(measures().size(), std::size_t{3});
  window_->show_step(MainWindow::model);
  window_->show_step(MainWindow::segmentation);
  QCOMPARE(measures().size(), std::size_t{3});  // kept until they are wiped
  click_action("wipe_measures");
  QVERIFY(measures().empty());
  drag(coronal, here - QPoint(40, 0), here + QPoint(40, 0));
  QCOMPARE(measures().size(), std::size_t{1});
  window_->engine().post(engine::ImportImage{"other.nii"});
  QVERIFY(settle());
  QVERIFY(measures().empty());  // they lay in the former image
}

void LookingTest::MeasuringAndPanelsToolsPutEachOtherAway() {
  open_ct();
  auto* seeds =
      window_->panel(MainWindow::segmentation).findChild<QPushButton*>(QStringLiteral("seed_parenchyma"));
  key(Qt::Key_R);
  QTest::mouseClick(seeds, Qt::LeftButton);
  QVERIFY(!state().is_measuring() && !action("measure_distance")->isChecked());
  QCOMPARE(state().hand(), ui::Hand::point);
  click_action("measure_distance");
  ui::SliceView& axial = slice(Plane::axial);
  drag(axial, middle(axial), middle(axial) + QPoint(30, 30));
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::seeds] == nullptr);  // no seed was placed
  QCOMPARE(measures().size(), std::size_t{1});
  key(Qt::Key_R);  // puts it away again
  QVERIFY(!state().is_measuring());
  QTest::mouseClick(&axial, Qt::LeftButton, {}, middle(axial));
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::seeds] != nullptr);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::LookingTest>(argc, argv); }
#include "looking_test.moc"
