// SPDX-License-Identifier: GPL-3.0-or-later
// Drives the window by mouse and keyboard, from opening a CT to the recorded live view. The engine's
// scheduling is the real one; what its commands compute is made by FakeOperation.
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QTranslator>
#include <QWheelEvent>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/guidance/guidance_panel.h"
#include "glisson/ui/segmentation/seed_book.h"
#include "glisson/ui/segmentation/segmentation_panel.h"
#include "glisson/ui/shell/main_window.h"
#include "operated_window.h"

namespace glisson {

using engine::StageState;
using ui::MainWindow;

class WindowTest : public QObject, private OperatedWindow {
  Q_OBJECT
 private slots:
  void init() { open_window(); }
  void cleanup() { close_window(); }
  void WelcomesUntilSomethingIsOpen();
  void EveryPanelFitsItsColumnInEveryLanguage_data();
  void EveryPanelFitsItsColumnInEveryLanguage();
  void TheWheelScrollsAPanelAndTurnsNoSettingOnTheWay();
  void OpensWhatIsDropped();
  void ErrorsAreShownAndLeaveTheCase();
  void WhatIsOddAboutAFileIsTold();
  void UnsavedChangesAreNotLostUnasked();
  void CancelLeavesTheCaseAsItWas();
  void TheKeyThatBeginsWorkDoesNotCancelIt();
  void EditMakesLaterStepsStale();
  void RefusedRegistrationDoesNotLookDone();
  void LiveViewPlaysShowsAgeAndRecords();
  void ClosingBringsARecordingToItsEnd();
  void WholePathByMouse();
};

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

void WindowTest::TheWheelScrollsAPanelAndTurnsNoSettingOnTheWay() {
  window_ = std::make_unique<MainWindow>(operation_->options());
  window_->resize(1280, 800);
  window_->show();
  window_->show_step(MainWindow::guidance);
  auto* look = window_->panel(MainWindow::guidance).findChild<QComboBox*>(QStringLiteral("look"));
  QVERIFY(look->count() > 2 && look->isVisible());
  QApplication::setActiveWindow(window_.get());
  /// @return whether the setting took it; otherwise it goes on to the column, which scrolls.
  const auto turn = [&] {
    const QPointF middle = QRectF(look->rect()).center();
    QWheelEvent down(middle, look->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(look, &down);
    return down.isAccepted();
  };
  const int chosen = look->currentIndex();
  QVERIFY(!turn());
  QCOMPARE(look->currentIndex(), chosen);
  QVERIFY(!(look->focusPolicy() & (Qt::WheelFocus & ~Qt::StrongFocus)));  // nor would the wheel choose it
  look->setFocus();                                                       // a person does
  QTRY_VERIFY(look->hasFocus());
  QVERIFY(turn());
  QVERIFY(look->currentIndex() != chosen);
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
  QTRY_VERIFY(!window_->status_text().isEmpty());
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::image] == before);
  QVERIFY(window_->status_text().contains(QStringLiteral("cut off after 12 bytes")));
  QVERIFY(window_->status_text().contains(QStringLiteral("Copy the file again")));
}

void WindowTest::WhatIsOddAboutAFileIsTold() {
  open_ct();
  QVERIFY(window_->findChild<QMessageBox*>() == nullptr);
  window_->open("labels.seg.nrrd");  // is looked into first
  QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<QMessageBox*>() != nullptr, 20000);
  const auto* told = window_->findChild<QMessageBox*>();
  QVERIFY(told != nullptr && told->isVisible());
  QVERIFY2(told->text().contains(QStringLiteral("frame of reference")), qPrintable(told->text()));
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

/// Qt hands the keyboard on from what cannot be pressed any more, and Cancel is the next in the row.
void WindowTest::TheKeyThatBeginsWorkDoesNotCancelIt() {
  open_ct();
  segmentation::Seeds seeds;
  ui::add_seed(seeds, structure::kParenchyma, {0, 0, 0});
  window_->engine().post(engine::SetSeeds{seeds});
  QVERIFY(settle());
  press("segment");
  QVERIFY(settle());  // it has room below itself from now on, in which Cancel comes
  operation_->hold = true;
  QApplication::setActiveWindow(window_.get());
  ui::TaskButton* segment = task("segment");
  segment->button()->setFocus();
  QTRY_VERIFY(segment->button()->hasFocus());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  QTRY_VERIFY(segment->cancel_button()->isVisible());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);  // the same hand once more
  QVERIFY(!segment->cancel_button()->hasFocus() && segment->cancel_button()->isEnabled());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);  // who means it gets there
  QVERIFY(segment->cancel_button()->hasFocus());
  operation_->hold = false;
  QVERIFY(settle());
  QVERIFY(window_->engine().state()[part::labels] != nullptr);
  QVERIFY(segment->button()->hasFocus());
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

void WindowTest::RefusedRegistrationDoesNotLookDone() {
  operation_->doubts = {"refused", "cloud_noisy 6.3 6"};
  reach_registration();
  QCOMPARE(window_->panel(MainWindow::guidance).step_state(), ui::StepState::refused);
  window_->show_step(MainWindow::guidance);
  press("accept_registration");
  QVERIFY(settle());
  QCOMPARE(window_->panel(MainWindow::guidance).step_state(), ui::StepState::done);
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

/// A film that is cut short cannot be played.
void WindowTest::ClosingBringsARecordingToItsEnd() {
  reach_registration(600);
  window_->show_step(MainWindow::guidance);
  auto* panel = window_->findChild<ui::GuidancePanel*>();
  QTRY_VERIFY_WITH_TIMEOUT(panel->pictures_shown() > 0, 20000);
  const QString file = QString::fromStdString((folder_->path() / "live.mkv").string());
  press("start_tracking");
  QTRY_VERIFY(window_->engine().snapshot()->tracking);
  panel->record_to(file);
  const int before = panel->pictures_shown();
  QTRY_VERIFY_WITH_TIMEOUT(panel->pictures_shown() > before + 3, 20000);
  QTimer answers;
  connect(&answers, &QTimer::timeout, this, [&] {
    if (auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget()))
      if (auto* discard = question->button(QMessageBox::Discard)) discard->click();
  });
  answers.start(10);
  bool was_visible = false;
  connect(panel, &ui::Panel::wound_up, this, [&] { was_visible = window_->isVisible(); });
  window_->close();
  QTRY_VERIFY_WITH_TIMEOUT(!window_->isVisible(), 20000);
  QVERIFY(was_visible);  // until the film was there
  QVERIFY(stereo::StereoVideo(file.toStdString()).frame_count() > 0);
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
  for (int step = 0; step < 5; ++step)  // nobody has looked at the labels
    QCOMPARE(window_->panel(step).step_state(),
             step == MainWindow::segmentation ? ui::StepState::to_review : ui::StepState::done);
  auto* guidance = window_->findChild<ui::GuidancePanel*>();
  QTRY_VERIFY_WITH_TIMEOUT(!guidance->picture().picture().empty(), 20000);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::WindowTest>(argc, argv); }
#include "window_test.moc"
