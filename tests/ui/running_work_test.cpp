// SPDX-License-Identifier: GPL-3.0-or-later
// Closing, saving and opening while work runs say what becomes of its result, and do what the person chose.
#include <QAction>
#include <QApplication>
#include <QKeySequence>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QTimer>

#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/parts/labels.h"
#include "operated_window.h"

namespace glisson {

class RunningWorkTest : public QObject, private OperatedWindow {
  Q_OBJECT
 private slots:
  void init();
  void cleanup() { close_window(); }
  void TheQuestionNamesTheWorkAndDoesNothing_data();
  void TheQuestionNamesTheWorkAndDoesNothing();
  void StoppingDoesNotLetTheResultIn_data() { TheQuestionNamesTheWorkAndDoesNothing_data(); }
  void StoppingDoesNotLetTheResultIn();
  void WaitingSavesTheResult();
  void WaitingClosesAfterTheResultWasAskedFor();
  void WhatFailsOrIsCancelledKeepsTheWindow();
  void WorkThatEndsBeforeTheAnswerIsSaid();
  void AnotherCtIsReadAfterTheAnswer();
  void WorkThatDoesNotMatterIsNotAskedAbout();

 private:
  /// A case that is saved, on which *Segment* works.
  void work_on_saved_case();
  void wish(const QString& what);
  QMessageBox* question() { return window_->findChild<QMessageBox*>(QStringLiteral("running_work")); }
  void answer(const char* button) {
    const QPointer<QMessageBox> asked = question();
    QVERIFY(asked != nullptr && asked->isVisible());
    QTest::mouseClick(asked->findChild<QPushButton*>(QLatin1String(button)), Qt::LeftButton);
    QTRY_VERIFY(asked.isNull());
  }
  bool works() { return window_->engine().is_busy(work_); }
  bool has_labels() { return window_->engine().state()[part::labels] != nullptr; }

  engine::CommandId work_ = 0;
};

void RunningWorkTest::init() {
  open_window();
  QVERIFY(!QTest::currentTestFailed());
}

void RunningWorkTest::work_on_saved_case() {
  open_ct();
  segmentation::Seeds seeds;
  ui::add_seed(seeds, structure::kParenchyma, {0, 0, 0});
  window_->engine().post(engine::SetSeeds{seeds});
  window_->engine().post(engine::SaveCase{folder_->path() / "patient.glisson"});
  QVERIFY(settle());
  QTRY_VERIFY(!window_->isWindowModified());
  operation_->hold = true;
  work_ = window_->engine().post(engine::Segment{});
}

void RunningWorkTest::wish(const QString& what) {
  if (what == "close") {
    window_->close();
  } else if (what == "save") {
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->shortcut() == QKeySequence(QKeySequence::Save)) action->trigger();
  } else {
    window_->open(what == "case" ? folder_->path() / "other.glisson" / "case.json" : "other.nii");
  }
}

void RunningWorkTest::TheQuestionNamesTheWorkAndDoesNothing_data() {
  QTest::addColumn<QString>("what");
  for (const char* what : {"close", "save", "case", "ct"}) QTest::newRow(what) << QString(what);
}

void RunningWorkTest::TheQuestionNamesTheWorkAndDoesNothing() {
  QFETCH(QString, what);
  work_on_saved_case();
  QSignalSpy ended(&window_->engine(), &ui::EngineBridge::finished);
  wish(what);
  QVERIFY(question() != nullptr);
  QVERIFY2(question()->text().contains("Segmenting"), qPrintable(question()->text()));
  QVERIFY(!question()->informativeText().isEmpty());
  answer("leave_work");
  QVERIFY(window_->isVisible() && works());
  QCOMPARE(window_->engine().tasks().size(), std::size_t{1});  // nothing waits behind it
  operation_->hold = false;
  QVERIFY(settle());
  QCOMPARE(ended.count(), 1);
  QVERIFY(window_->isVisible() && has_labels());
}

void RunningWorkTest::StoppingDoesNotLetTheResultIn() {
  QFETCH(QString, what);
  work_on_saved_case();
  wish(what);
  answer("stop_work");
  QTRY_VERIFY(!works());
  QVERIFY(settle());
  QVERIFY(!has_labels());
  if (what == "close") QTRY_VERIFY(!window_->isVisible());
  if (what == "ct") QTRY_VERIFY(window_->findChild<QMessageBox*>(QStringLiteral("whose_image")) != nullptr);
  operation_->hold = false;
  QVERIFY(settle());
  QVERIFY(!has_labels());
}

void RunningWorkTest::WaitingSavesTheResult() {
  work_on_saved_case();
  wish("save");
  answer("wait_for_work");
  QTRY_VERIFY2(window_->status_text().contains("saved"), qPrintable(window_->status_text()));
  QVERIFY(works());
  operation_->hold = false;
  QTRY_VERIFY(has_labels());
  QTRY_VERIFY(!window_->isWindowModified());
  QVERIFY(window_->isVisible());
}

void RunningWorkTest::WaitingClosesAfterTheResultWasAskedFor() {
  work_on_saved_case();
  wish("close");
  answer("wait_for_work");
  QString told;
  QTimer poll;
  connect(&poll, &QTimer::timeout, this, [&] {
    auto* asks = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (asks == nullptr || asks->button(QMessageBox::Save) == nullptr) return;
    told = asks->text();
    asks->button(QMessageBox::Save)->click();
  });
  poll.start(10);
  operation_->hold = false;
  QTRY_VERIFY2(told.contains("not saved"), qPrintable(told));
  QTRY_VERIFY(!window_->isVisible());
  QVERIFY(has_labels() && !window_->isWindowModified());
}

void RunningWorkTest::WhatFailsOrIsCancelledKeepsTheWindow() {
  work_on_saved_case();
  wish("close");
  answer("wait_for_work");
  QTRY_VERIFY(window_->status_text().contains("closes"));
  window_->engine().cancel(work_);
  QVERIFY(settle());
  QTest::qWait(50);
  QVERIFY(window_->isVisible() && question() == nullptr);
  QVERIFY(!window_->status_text().contains("closes"));
}

void RunningWorkTest::WorkThatEndsBeforeTheAnswerIsSaid() {
  work_on_saved_case();
  wish("save");
  QVERIFY(question() != nullptr);
  operation_->hold = false;
  QVERIFY(settle());
  QVERIFY(!question()->text().contains("Segmenting"));
  QVERIFY(!question()->findChild<QPushButton*>(QStringLiteral("stop_work"))->isEnabled());
  QVERIFY(window_->isWindowModified());  // nothing is saved unasked
  answer("wait_for_work");
  QTRY_VERIFY(!window_->isWindowModified());
}

void RunningWorkTest::AnotherCtIsReadAfterTheAnswer() {
  work_on_saved_case();
  wish("ct");
  QVERIFY(window_->findChild<QMessageBox*>(QStringLiteral("whose_image")) == nullptr);
  answer("wait_for_work");
  operation_->hold = false;
  QTRY_VERIFY(window_->findChild<QMessageBox*>(QStringLiteral("whose_image")) != nullptr);
  QVERIFY(has_labels());  // and the question says that they are not saved
  const auto* whose = window_->findChild<QMessageBox*>(QStringLiteral("whose_image"));
  QVERIFY(whose->informativeText().contains("not saved"));
}

void RunningWorkTest::WorkThatDoesNotMatterIsNotAskedAbout() {
  work_on_saved_case();
  window_->open("scope.yml");  // a calibration: the segmentation has no part in it
  QVERIFY(question() == nullptr);
  operation_->hold = false;
  QVERIFY(settle());
  QVERIFY(has_labels());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::RunningWorkTest>(argc, argv); }
#include "running_work_test.moc"
