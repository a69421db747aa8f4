// SPDX-License-Identifier: GPL-3.0-or-later
// Drives the window by mouse and keyboard, from opening a CT to the recorded live view. The engine's
// scheduling is the real one; what its commands compute is made by FakeOperation.
#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QApplication>
#include <QDialog>
#include <QDropEvent>
#include <QLabel>
#include <QListWidget>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QToolButton>
#include <QTranslator>
#include <QtTest>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/reconstruct.h"
#include "glisson/engine/commands/register.h"
#include "glisson/engine/commands/segment.h"
#include "glisson/engine/commands/set_calibration.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/ui/atlas/atlas_panel.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/guidance_panel.h"
#include "glisson/ui/scene/colours.h"
#include "glisson/ui/segmentation/seed_book.h"
#include "glisson/ui/segmentation/segmentation_panel.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/ui/stereo/stereo_panel.h"
#include "run_in_window.h"

namespace glisson {

using engine::Part;
using engine::StageState;
using ui::MainWindow;

class WindowTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void WelcomesUntilSomethingIsOpen();
  void EveryPanelFitsItsColumnInEveryLanguage_data();
  void EveryPanelFitsItsColumnInEveryLanguage();
  void OpensWhatIsDropped();
  void ErrorsAreShownAndLeaveTheCase();
  void UnsavedChangesAreNotLostUnasked();
  void ClickMovesTheCrosshairInAllSlices();
  void ProbeLineSaysWhatIsUnderThePointer();
  void WheelStepsBySlices();
  void RightDragChangesTheWindow();
  void SeedsAreClickedListedAndDeleted();
  void CancelLeavesTheCaseAsItWas();
  void EditMakesLaterStepsStale();
  void NotchIsPlacedOnTheSurface();
  void TheFirstClickAfterClearReplacesTheModelsOwn();
  void LandmarksAreDrawnWithTheModelOnly();
  void RegionIsClickedClosedDraggedAndTakenBack();
  void LiveViewPlaysShowsAgeAndRecords();
  void WholePathByMouse();

 private:
  bool settle() {
    return QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 20000);
  }
  ui::TaskButton* task(const char* name) {
    return window_->findChild<ui::TaskButton*>(QString::fromLatin1(name));
  }
  void press(const char* name) { QTest::mouseClick(task(name)->button(), Qt::LeftButton); }
  StageState stage(Part part) { return window_->engine().snapshot()->stage(part); }
  ui::SliceView& slice(scene::Plane plane) { return window_->views().slice(plane); }
  void click(ui::SliceView& view, const Point<CtFrame>& p) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.widget_point(p).toPoint());
  }
  void open_ct() {
    window_->open("ct.nii");
    QVERIFY(settle());
    QVERIFY(window_->engine().state()[part::image] != nullptr);
  }
  void reach_model() {
    open_ct();
    segmentation::Seeds seeds;
    ui::add_seed(seeds, structure::kParenchyma, {0, 0, 0});
    window_->engine().post(engine::SetSeeds{seeds});
    window_->engine().post(engine::Segment{});
    window_->engine().post(engine::BuildModel{});
    QVERIFY(settle());
  }
  void reach_registration() {
    reach_model();
    operation_->film(folder_->path() / "scope.mkv", 40);
    window_->engine().post(engine::SetCalibration{"scope.yml"});
    window_->engine().post(engine::SetVideo{operation_->video, {}});
    window_->engine().post(engine::LoadVideoFrame{2});
    window_->engine().post(engine::SetRegions{});
    window_->engine().post(engine::Reconstruct{});
    window_->engine().post(engine::Register{});
    QVERIFY(settle());
    QCOMPARE(stage(part::registration), StageState::current);
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<MainWindow> window_;
};

void WindowTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  window_ = std::make_unique<MainWindow>(operation_->options());
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void WindowTest::cleanup() {
  operation_->hold = false;
  window_.reset();
  operation_.reset();
  folder_.reset();
}

void WindowTest::WelcomesUntilSomethingIsOpen() {
  QVERIFY(!window_->views().isVisible());
  QVERIFY(!task("segment")->button()->isEnabled());  // and the panel says what is missing
  open_ct();
  QVERIFY(window_->views().isVisible());
  QCOMPARE(window_->size(), QSize(1280, 800));  // nothing forces the window beyond a small screen
}

void WindowTest::EveryPanelFitsItsColumnInEveryLanguage_data() {
  QTest::addColumn<QString>("language");
  for (const char* language : {"en", "de", "fr"}) QTest::newRow(language) << QString::fromLatin1(language);
}

void WindowTest::EveryPanelFitsItsColumnInEveryLanguage() {
  QFETCH(QString, language);
  QTranslator translator;
  if (language != QStringLiteral("en")) {
    QVERIFY(translator.load(QStringLiteral(":/glisson/translations/glisson_") + language));
    QCoreApplication::installTranslator(&translator);
  }
  window_ = std::make_unique<MainWindow>(operation_->options());
  window_->resize(1280, 800);
  window_->show();
  reach_registration();
  segmentation::Seeds seeds;  // every structure, twice: the widest texts
  for (const int label : {+structure::kBackground, +structure::kParenchyma, +structure::kPortalVein,
                          +structure::kHepaticVeins, +structure::kVenaCava, +structure::kGallbladder,
                          +structure::kFirstLesion, structure::kFirstLesion + 1})
    for (int i = 0; i < 2; ++i) ui::add_seed(seeds, static_cast<Label>(label), {0, 0, 0});
  window_->engine().post(engine::SetSeeds{seeds});
  QVERIFY(settle());
  for (int step = 0; step < 5; ++step) {
    window_->show_step(step);
    ui::Panel& panel = window_->panel(step);
    auto* column = qobject_cast<QScrollArea*>(panel.parentWidget()->parentWidget());
    QVERIFY(column != nullptr);
    const int room = column->width() - column->verticalScrollBar()->sizeHint().width();
    QVERIFY2(panel.minimumSizeHint().width() <= room, qPrintable(QStringLiteral("%1 needs %2 of %3 pixels")
                                                                     .arg(panel.title())
                                                                     .arg(panel.minimumSizeHint().width())
                                                                     .arg(room)));
  }
  QCOMPARE(window_->size(), QSize(1280, 800));
  QCoreApplication::removeTranslator(&translator);
}

void WindowTest::OpensWhatIsDropped() {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QStringLiteral("/patient/ct.nii.gz"))});
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &drop);
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::image] != nullptr);
}

void WindowTest::ErrorsAreShownAndLeaveTheCase() {
  open_ct();
  const auto before = window_->engine().state()[part::image];
  window_->open("broken.nii");
  QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("same_patient")), Qt::LeftButton);
  QTRY_VERIFY(!window_->status_text().isEmpty());
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::image] == before);
  QVERIFY(window_->status_text().contains(QStringLiteral("cut off after 12 bytes")));
  QVERIFY(window_->status_text().contains(QStringLiteral("Copy the file again")));
}

void WindowTest::UnsavedChangesAreNotLostUnasked() {
  open_ct();
  QVERIFY(window_->isWindowModified());
  const auto before = window_->engine().state()[part::image];
  for (const auto answer : {QMessageBox::Cancel, QMessageBox::Discard}) {
    window_->open(folder_->path() / "other.glisson" / "case.json");
    const QPointer<QMessageBox> question = window_->findChild<QMessageBox*>();
    QVERIFY(question != nullptr && question->isVisible());
    QVERIFY(window_->engine().tasks().empty());  // nothing is opened unasked
    QSignalSpy ended(&window_->engine(), &ui::EngineBridge::finished);
    QTest::mouseClick(question->button(answer), Qt::LeftButton);
    QTRY_VERIFY(question.isNull());
    QVERIFY(settle());
    if (answer == QMessageBox::Cancel)
      QVERIFY(ended.isEmpty() && window_->engine().state()[part::image] == before);
    if (answer == QMessageBox::Discard) QTRY_COMPARE(ended.count(), 1);
  }
}

void WindowTest::ClickMovesTheCrosshairInAllSlices() {
  open_ct();
  const Point<CtFrame> target(0.03, -0.012, 0.0);
  click(slice(scene::Plane::axial), target);
  QVERIFY(std::abs(slice(scene::Plane::sagittal).geometry_in_ct().origin.x() - 0.03) < 1e-3);
  QVERIFY(std::abs(slice(scene::Plane::coronal).geometry_in_ct().origin.y() + 0.012) < 1e-3);
}

void WindowTest::ProbeLineSaysWhatIsUnderThePointer() {
  reach_model();
  ui::SliceView& axial = slice(scene::Plane::axial);
  const Point<CtFrame> lesion(0.03, 0.0, axial.geometry_in_ct().origin.z());
  QTest::mouseMove(&axial, axial.widget_point(lesion).toPoint());
  QTRY_VERIFY(window_->views().probe_line().contains(QStringLiteral("60 HU")));
  QVERIFY(window_->views().probe_line().contains(QStringLiteral("L 30")) ||
          window_->views().probe_line().contains(QStringLiteral("L 29")));
  QVERIFY(window_->views().probe_line().contains(QStringLiteral("Lesion 1")));
  const Point<CtFrame> liver(-0.04, 0.0, axial.geometry_in_ct().origin.z());
  QTest::mouseMove(&axial, axial.widget_point(liver).toPoint());
  QTRY_VERIFY(window_->views().probe_line().contains(QStringLiteral("110 HU")));
  QVERIFY(window_->views().probe_line().startsWith(QLatin1Char('R')));
  QVERIFY(window_->views().probe_line().contains(QStringLiteral("Liver")));
}

void WindowTest::WheelStepsBySlices() {
  open_ct();
  ui::SliceView& axial = slice(scene::Plane::axial);
  const double before = axial.geometry_in_ct().origin.z();
  QWheelEvent wheel(QPointF(100, 100), axial.mapToGlobal(QPointF(100, 100)), {}, QPoint(0, 240), Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&axial, &wheel);
  QVERIFY(std::abs(axial.geometry_in_ct().origin.z() - before - 0.004) < 1e-9);  // two slices of 2 mm
}

void WindowTest::RightDragChangesTheWindow() {
  open_ct();
  ui::SliceView& axial = slice(scene::Plane::axial);
  const Picture before = axial.slice();
  QTest::mousePress(&axial, Qt::RightButton, {}, QPoint(100, 100));
  QMouseEvent move(QEvent::MouseMove, QPointF(160, 80), axial.mapToGlobal(QPointF(160, 80)), Qt::NoButton,
                   Qt::RightButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&axial, &move);
  QTest::mouseRelease(&axial, Qt::RightButton, {}, QPoint(160, 80));
  QVERIFY(*before.bytes != *axial.slice().bytes);
}

void WindowTest::SeedsAreClickedListedAndDeleted() {
  open_ct();
  auto* panel = window_->findChild<ui::SegmentationPanel*>();
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("seed_parenchyma")), Qt::LeftButton);
  const double z = slice(scene::Plane::axial).geometry_in_ct().origin.z();
  click(slice(scene::Plane::axial), Point<CtFrame>(-0.03, 0.01, z));
  click(slice(scene::Plane::axial), Point<CtFrame>(0.02, 0.01, z));
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("seed_lesion_1")), Qt::LeftButton);
  click(slice(scene::Plane::axial), Point<CtFrame>(0.03, 0.0, z));
  QVERIFY(settle());
  const auto& stored = window_->engine().state()[part::seeds];
  QVERIFY(stored != nullptr);
  QCOMPARE(stored->liver.rows(), 2);
  QVERIFY(std::abs(stored->liver(0, 0) + 0.03) < 1e-3 && std::abs(stored->liver(0, 1) - 0.01) < 1e-3);
  QCOMPARE(stored->lesions.size(), std::size_t{1});
  auto* list = panel->findChild<QListWidget*>(QStringLiteral("seed_list"));
  QCOMPARE(list->count(), 3);
  list->setCurrentRow(0);
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("delete_seeds")), Qt::LeftButton);
  QVERIFY(settle());
  QCOMPARE(window_->engine().state()[part::seeds]->liver.rows(), 1);
  QVERIFY(std::abs(window_->engine().state()[part::seeds]->liver(0, 0) - 0.02) < 1e-3);
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("seed_lesion_1")),
                    Qt::LeftButton);                               // ends placing
  click(slice(scene::Plane::axial), Point<CtFrame>(0.0, 0.0, z));  // only the crosshair now
  QVERIFY(settle());
  QCOMPARE(window_->engine().state()[part::seeds]->liver.rows(), 1);
}

void WindowTest::CancelLeavesTheCaseAsItWas() {
  open_ct();
  segmentation::Seeds seeds;
  ui::add_seed(seeds, structure::kParenchyma, {0, 0, 0});
  window_->engine().post(engine::SetSeeds{seeds});
  QVERIFY(settle());
  operation_->hold = true;
  press("segment");
  QTRY_VERIFY(task("segment")->cancel_button()->isVisible());
  QTRY_COMPARE(window_->panel(MainWindow::segmentation).step_state(), ui::StepState::running);
  window_->show_step(MainWindow::model);  // the window stays alive meanwhile
  window_->show_step(MainWindow::segmentation);
  QTest::mouseClick(task("segment")->cancel_button(), Qt::LeftButton);
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::labels] == nullptr);
  QCOMPARE(window_->panel(MainWindow::segmentation).step_state(), ui::StepState::waiting);
  operation_->hold = false;
  press("segment");
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::labels] != nullptr);
}

void WindowTest::EditMakesLaterStepsStale() {
  reach_registration();
  QCOMPARE(window_->panel(MainWindow::guidance).step_state(), ui::StepState::done);
  segmentation::Seeds seeds;
  ui::add_seed(seeds, structure::kParenchyma, {0.01, 0, 0});
  window_->engine().post(engine::SetSeeds{seeds});
  QVERIFY(settle());
  QCOMPARE(window_->panel(MainWindow::segmentation).step_state(), ui::StepState::stale);
  QCOMPARE(window_->panel(MainWindow::model).step_state(), ui::StepState::stale);
  QCOMPARE(window_->panel(MainWindow::guidance).step_state(), ui::StepState::stale);
  QCOMPARE(window_->panel(MainWindow::stereo).step_state(), ui::StepState::done);
  QVERIFY(!task("start_tracking")->button()->isEnabled());
}

void WindowTest::NotchIsPlacedOnTheSurface() {
  reach_model();
  window_->show_step(MainWindow::atlas);
  ui::RenderView& view = window_->views().volume();
  // The model is made drawable beside the window.
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  auto* panel = window_->findChild<ui::AtlasPanel*>();
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("place_notch")), Qt::LeftButton);
  const auto before = panel->landmarks().umbilical_notch.rows();
  const Eigen::Vector3d wanted(0.02, -0.04, 0.005);  // on the anterior face
  const auto place = view.patient().view_point(wanted, view.aspect());
  QVERIFY(place.has_value());
  QTest::mouseClick(
      &view, Qt::LeftButton, {},
      QPoint(static_cast<int>(place->x() * view.width()), static_cast<int>(place->y() * view.height())));
  QVERIFY(settle());
  const auto& stored = window_->engine().state()[part::landmarks];
  QVERIFY(stored != nullptr);
  QCOMPARE(stored->umbilical_notch.rows(), before + 1);
  QVERIFY((stored->umbilical_notch.bottomRows(1).transpose() - wanted).norm() < 2e-3);  // a pixel or so
}

void WindowTest::TheFirstClickAfterClearReplacesTheModelsOwn() {
  operation_->model.landmarks.umbilical_notch = Points::Constant(3, 3, 0.02);
  reach_model();
  window_->show_step(MainWindow::atlas);
  QTRY_VERIFY(window_->views().surface_point(0.5, 0.5).has_value());
  auto* panel = window_->findChild<ui::AtlasPanel*>();
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("clear_landmarks")), Qt::LeftButton);
  QVERIFY(settle());
  QTRY_COMPARE(panel->landmarks().umbilical_notch.rows(), 3);  // what the registration would use
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("place_notch")), Qt::LeftButton);
  ui::RenderView& view = window_->views().volume();
  for (const int points : {1, 2}) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, view.rect().center());
    QVERIFY(settle());
    QTRY_COMPARE(window_->engine().state()[part::landmarks]->umbilical_notch.rows(), points);
  }
}

void WindowTest::LandmarksAreDrawnWithTheModelOnly() {
  reach_model();
  Landmarks placed;
  placed.umbilical_notch.resize(1, 3);
  placed.umbilical_notch << 0.02, -0.04, 0.005;
  ui::LinkedViews& views = window_->views();
  const QColor colour = scene::colour_of(Feature::umbilical_notch);
  const auto is_drawn = [&] {
    vtkActorCollection& actors = *views.volume().patient().renderer().GetActors();
    vtkCollectionSimpleIterator at;
    actors.InitTraversal(at);
    while (vtkActor* actor = actors.GetNextActor(at)) {
      const double* rgb = actor->GetProperty()->GetColor();
      if (QColor::fromRgbF(rgb[0], rgb[1], rgb[2]).rgb() == colour.rgb()) return true;
    }
    return false;
  };
  window_->show_step(MainWindow::atlas);
  window_->engine().post(engine::SetLandmarks{placed});
  QTRY_VERIFY(is_drawn());
  window_->show_step(MainWindow::segmentation);  // there the labels stand in for the model
  QTRY_VERIFY(!is_drawn());
  placed.umbilical_notch(0, 0) = 0.01;
  window_->engine().post(engine::SetLandmarks{placed});
  QVERIFY(settle());
  QTRY_VERIFY(views.label_surfaces().surfaces() != nullptr);
  QVERIFY(!is_drawn());
  window_->show_step(MainWindow::atlas);
  QTRY_VERIFY(is_drawn());
}

void WindowTest::RegionIsClickedClosedDraggedAndTakenBack() {
  reach_registration();
  window_->show_step(MainWindow::stereo);
  auto* panel = window_->findChild<ui::StereoPanel*>();
  ui::RegionEditor& editor = panel->stereo_view().editor(stereo::Side::left);
  QTRY_VERIFY(editor.isVisible() && !editor.picture().empty());
  QTest::mouseClick(panel->findChild<QPushButton*>(QStringLiteral("region_2")), Qt::LeftButton);
  const auto at = [&](double x, double y) { return editor.widget_point({x, y}).toPoint(); };
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(100, 50));
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(200, 60));
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(300, 170));
  QTest::keyClick(&editor, Qt::Key_Backspace);
  QCOMPARE(panel->stereo_view().drawing().unfinished()->polygon.size(), std::size_t{2});
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(180, 120));
  QTest::mouseClick(&editor, Qt::LeftButton, {}, at(100, 50));
  QVERIFY(settle());
  const auto& regions = window_->engine().state()[part::regions];
  QVERIFY(regions != nullptr);
  QCOMPARE(regions->regions.size(), std::size_t{1});
  QCOMPARE(regions->regions[0].feature, Feature::anterior_margin);
  QCOMPARE(regions->regions[0].polygon.size(), std::size_t{3});
  QVERIFY((regions->regions[0].polygon[1] - Eigen::Vector2d(200, 60)).norm() < 1.0);
  QCOMPARE(stage(part::cloud), StageState::stale);  // the cloud was made without it
  QTest::keyClick(&editor, Qt::Key_Escape);
  QTest::mousePress(&editor, Qt::LeftButton, {}, at(200, 60));
  QMouseEvent move(QEvent::MouseMove, QPointF(at(230, 70)), editor.mapToGlobal(QPointF(at(230, 70))),
                   Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&editor, &move);
  QTest::mouseRelease(&editor, Qt::LeftButton, {}, at(230, 70));
  QVERIFY(settle());
  QVERIFY(
      (window_->engine().state()[part::regions]->regions[0].polygon[1] - Eigen::Vector2d(230, 70)).norm() <
      1.0);
  QTest::mouseClick(&editor, Qt::RightButton, {}, at(170, 75));
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::regions]->regions.empty());
}

void WindowTest::LiveViewPlaysShowsAgeAndRecords() {
  reach_registration();
  window_->show_step(MainWindow::guidance);
  auto* panel = window_->findChild<ui::GuidancePanel*>();
  QTRY_VERIFY_WITH_TIMEOUT(panel->pictures_shown() > 0, 20000);  // the registered frame
  const QString file = QString::fromStdString((folder_->path() / "live.mkv").string());
  press("start_tracking");
  QTRY_VERIFY(window_->engine().snapshot()->tracking);
  panel->record_to(file);
  const auto line = [&] {
    QString all;
    for (const QLabel* label : panel->view()->findChildren<QLabel*>())
      all += label->text() + QLatin1Char('\n');
    return all;
  };
  QTRY_VERIFY(line().contains(QStringLiteral("LIVE")) && line().contains(QStringLiteral("age")));
  // The video ends: tracking stops, the picture says that it is not live, the recording is closed.
  QTRY_VERIFY_WITH_TIMEOUT(!window_->engine().snapshot()->tracking, 20000);
  QTRY_VERIFY(line().contains(QStringLiteral("not live")));
  QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(file), 20000);
  stereo::StereoVideo recorded(file.toStdString());
  QVERIFY(recorded.frame_count() > 5);
  QCOMPARE(recorded.height(), operation_->rig.left.height);
}

void WindowTest::WholePathByMouse() {
  open_ct();
  auto* segmentation_panel = window_->findChild<ui::SegmentationPanel*>();
  QTest::mouseClick(segmentation_panel->findChild<QPushButton*>(QStringLiteral("seed_parenchyma")),
                    Qt::LeftButton);
  click(slice(scene::Plane::axial),
        Point<CtFrame>(0, 0, slice(scene::Plane::axial).geometry_in_ct().origin.z()));
  QVERIFY(settle());
  press("segment");
  QVERIFY(settle());
  const auto go_to = [&](int step) {
    QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("step_%1").arg(step)), Qt::LeftButton);
    QCOMPARE(window_->step(), step);
  };
  go_to(MainWindow::model);
  press("build_model");
  QVERIFY(settle());
  go_to(MainWindow::atlas);
  QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("accept_landmarks")), Qt::LeftButton);
  QVERIFY(settle());
  QCOMPARE(stage(part::landmarks), StageState::current);
  go_to(MainWindow::stereo);
  operation_->film(folder_->path() / "scope.mkv", 10);
  window_->open("/scope/calibration.yml");  // as a drop of the file
  window_->open(operation_->video);
  QVERIFY(settle());
  press("reconstruct");
  QVERIFY(settle());
  go_to(MainWindow::guidance);
  press("register");
  QVERIFY(settle());
  for (int step = 0; step < 5; ++step) QCOMPARE(window_->panel(step).step_state(), ui::StepState::done);
  auto* guidance = window_->findChild<ui::GuidancePanel*>();
  QTRY_VERIFY_WITH_TIMEOUT(!guidance->picture().picture().empty(), 20000);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::WindowTest>(argc, argv); }
#include "window_test.moc"
