// SPDX-License-Identifier: GPL-3.0-or-later
// Operations are simulated while nobody waits for anything, and make way for everything else.
#include "glisson/ui/shell/operations_ahead.h"

#include <QProgressBar>
#include <QTest>
#include <atomic>
#include <thread>

#include "../registration/phantom.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_landmarks.h"
#include "glisson/engine/commands/simulate_operations.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

using ui::MainWindow;
using ui::OperationsAhead;

/// A window over an engine whose model is there at once and whose simulation lasts as long as a test wants.
class OperationsAheadTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup() { window_.reset(); }
  void ANewModelGetsThem();
  void OtherWorkComesFirst();
  void ASavedCaseStaysUntouched();
  void WhatCannotBeDoneIsTriedOnce();
  void WhatAPersonCancelsIsLeftAlone();
  void ItIsSaidWhileItGoesOnAndNotAfterwards();

 private:
  Cancellable<engine::Applied> apply(const engine::CaseState& state, const engine::Command& command,
                                     const RunContext& context);
  void bring_a_model() {
    window_->engine().post(engine::ImportSurfaces{"liver.stl", LengthUnit::millimetre, {}});
  }
  bool has_them() const { return engine::has_operations(window_->engine().state()); }

  std::unique_ptr<MainWindow> window_;
  std::atomic<bool> hold_{false}, fail_{false};
  std::atomic<int> begun_{0}, cancelled_{0};
};

Cancellable<engine::Applied> OperationsAheadTest::apply(const engine::CaseState& state,
                                                        const engine::Command& command,
                                                        const RunContext& context) {
  engine::Applied applied{state};
  if (command.as<engine::ImportSurfaces>() != nullptr) {
    auto built = std::make_shared<model::BuiltModel>();
    built->model = phantom::model(6, 5, 3);
    applied.state[part::model] = built;
  } else if (command.as<engine::ImportCloud>() != nullptr) {
    applied.state[part::cloud] = std::make_shared<const LabelledCloud>();
  } else if (const auto* work = command.as<engine::SimulateOperations>()) {
    ++begun_;
    if (fail_) throw NumericalError("there is no equilibrium");
    while (hold_ && !context.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (context.cancelled()) {
      ++cancelled_;
      return {};
    }
    applied.state[part::operations] = std::make_shared<const engine::SimulatedOperations>(
        engine::SimulatedOperations{state[part::model], state[part::landmarks], *work, context.seed(),
                                    std::make_shared<const registration::OperationPrior>()});
  } else {
    return engine::apply(state, command, context);
  }
  return applied;
}

void OperationsAheadTest::init() {
  hold_ = fail_ = false;
  begun_ = cancelled_ = 0;
  engine::Engine::Options options;
  options.apply = [this](const engine::CaseState& state, const engine::Command& command,
                         const RunContext& context,
                         const engine::Services&) { return apply(state, command, context); };
  window_ = std::make_unique<MainWindow>(options);
  auto* ahead = new OperationsAhead(window_->engine(), *window_);
  ahead->set_pause(std::chrono::milliseconds(20));
}

void OperationsAheadTest::ANewModelGetsThem() {
  QTest::qWait(100);
  QCOMPARE(begun_.load(), 0);  // there is nothing to simulate them on
  bring_a_model();
  QTRY_VERIFY(has_them());
  QTest::qWait(100);
  QCOMPARE(begun_.load(), 1);
  bring_a_model();  // another one
  QTRY_COMPARE(begun_.load(), 2);
  QTRY_VERIFY(has_them());
}

void OperationsAheadTest::OtherWorkComesFirst() {
  hold_ = true;
  bring_a_model();
  QTRY_COMPARE(begun_.load(), 1);
  window_->engine().post(engine::ImportCloud{"cloud.ply", {}});
  QTRY_VERIFY(window_->engine().state()[part::cloud] != nullptr);  // it would wait for ever
  QCOMPARE(cancelled_.load(), 1);
  QTRY_COMPARE(begun_.load(), 2);
  window_->engine().post(engine::SetLandmarks{phantom::landmarks()});  // a quick edit of what they rest on
  QTRY_VERIFY(window_->engine().state()[part::landmarks] != nullptr);
  QTRY_COMPARE(cancelled_.load(), 2);  // the edit does not wait for it
  hold_ = false;
  QTRY_VERIFY(has_them());
}

void OperationsAheadTest::ASavedCaseStaysUntouched() {
  const QTemporaryDir folder;
  hold_ = true;
  bring_a_model();
  QTRY_COMPARE(begun_.load(), 1);
  window_->engine().cancel(window_->engine().tasks().front().id);
  window_->engine().post(engine::SaveCase{folder.filePath("a.glisson").toStdString()});
  QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified() && window_->engine().tasks().empty(), 20000);
  const int so_far = begun_;
  QTest::qWait(150);
  QCOMPARE(begun_.load(), so_far);
  QVERIFY(!window_->isWindowModified());
}

void OperationsAheadTest::WhatCannotBeDoneIsTriedOnce() {
  fail_ = true;
  bring_a_model();
  QTRY_COMPARE(begun_.load(), 1);
  QTest::qWait(150);
  QCOMPARE(begun_.load(), 1);
  fail_ = false;
  bring_a_model();
  QTRY_VERIFY(has_them());
}

void OperationsAheadTest::WhatAPersonCancelsIsLeftAlone() {
  hold_ = true;
  bring_a_model();
  QTRY_COMPARE(begun_.load(), 1);
  window_->engine().cancel(window_->engine().tasks().front().id);
  QTRY_COMPARE(cancelled_.load(), 1);
  QTest::qWait(150);
  QCOMPARE(begun_.load(), 1);
  window_->engine().post(engine::SetLandmarks{phantom::landmarks()});
  QTRY_COMPARE(begun_.load(), 2);  // other landmarks, other operations
}

/// In its bar: what the status line says of other work stays, and how it ends is nobody's concern.
void OperationsAheadTest::ItIsSaidWhileItGoesOnAndNotAfterwards() {
  const auto* bar = window_->findChild<QProgressBar*>(QStringLiteral("task_progress"));
  hold_ = true;
  bring_a_model();
  QTRY_VERIFY(bar->isVisibleTo(window_.get()) && bar->text() == QStringLiteral("Simulating operations"));
  const QString said = window_->status_text();
  QVERIFY(said.contains(QStringLiteral("done in")));  // of the model
  hold_ = false;
  QTRY_VERIFY(has_them());
  QTRY_VERIFY(!bar->isVisibleTo(window_.get()));
  QCOMPARE(window_->status_text(), said);
  fail_ = true;
  bring_a_model();
  QTRY_COMPARE(begun_.load(), 2);
  QTRY_VERIFY(window_->engine().tasks().empty());
  QVERIFY(!window_->status_text().contains(QStringLiteral("equilibrium")));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::OperationsAheadTest>(argc, argv); }
#include "operations_ahead_test.moc"
