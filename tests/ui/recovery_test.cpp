// SPDX-License-Identifier: GPL-3.0-or-later
// The window is killed and started again: what was not saved is offered.
#include <signal.h>

#include <QApplication>
#include <QCoreApplication>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <algorithm>
#include <cstdio>

#include "glisson/core/files.h"
#include "glisson/engine/commands/build_model.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/recovery.h"
#include "glisson/ui/shell/autosaver.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/ui/shell/run_window.h"
#include "glisson/volume/io.h"
#include "plain_ct.h"
#include "run_in_window.h"
#include "seeded_case.h"

namespace glisson {

using ui::Autosaver;
using ui::MainWindow;
namespace fs = std::filesystem;

/// The window that is going to be killed: tells when a copy has been kept, and waits.
int be_killed(int argc, char** argv) {
  ui::prepare_application();
  QApplication application(argc, argv);
  ui::dress_application(application);
  MainWindow window;
  auto* autosaver = new Autosaver(window.engine(), window, argv[2]);
  autosaver->set_period(std::chrono::milliseconds(50));
  QObject::connect(&window.engine(), &ui::EngineBridge::finished, &window,
                   [&](const engine::Outcome& outcome) {
                     if (outcome.command == "import_image") window.engine().post(test::seeds(0.25));
                     if (outcome.command != "keep_copy" || !window.engine().state()[part::seeds]) return;
                     static int kept = 0;
                     if (++kept == 1) return;  // may be of the time before the seeds
                     std::puts("kept");
                     std::fflush(stdout);
                   });
  // One more edit after the first copy, so that there is a second one.
  QObject::connect(&window.engine(), &ui::EngineBridge::finished, &window,
                   [&](const engine::Outcome& outcome) {
                     if (outcome.command == "keep_copy" && window.engine().state()[part::seeds])
                       window.engine().post(test::seeds(0.25));
                   });
  window.engine().post(engine::ImportImage{argv[3], {}, true});
  return QApplication::exec();
}

class RecoveryTest : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<TemporaryFolder>();
    test::write_plain_ct(folder_->path() / "ct.nrrd");
  }
  void cleanup() { folder_.reset(); }
  void AKilledWindowsWorkIsOffered();
  void ThrownAwayItIsGone();
  void WhatCannotBeOpenedStays();
  void NothingIsKeptOfWhatIsSavedOrThrownAway();
  void LongWorkIsPrecededByACopy();

 private:
  fs::path root() const { return folder_->path() / "recovery"; }
  void kill_a_window() const {
    QProcess window;
    window.start(QCoreApplication::applicationFilePath(),
                 {"be-killed", QString::fromStdString(root().string()),
                  QString::fromStdString((folder_->path() / "ct.nrrd").string())});
    QVERIFY(window.waitForStarted());
    while (window.waitForReadyRead(20000) && !window.canReadLine()) continue;
    QCOMPARE(window.readLine().trimmed(), QByteArray("kept"));
    window.kill();  // SIGKILL
    QVERIFY(window.waitForFinished());
  }
  template <class Window>
  static QPushButton* button_of(Window& window, const char* name) {
    const bool asked = QTest::qWaitFor(
        [&] { return window.template findChild<QPushButton*>(QLatin1String(name)) != nullptr; }, 5000);
    return asked ? window.template findChild<QPushButton*>(QLatin1String(name)) : nullptr;
  }
  std::unique_ptr<TemporaryFolder> folder_;
};

void RecoveryTest::AKilledWindowsWorkIsOffered() {
  kill_a_window();
  {
    MainWindow window;
    window.show();
    Autosaver autosaver(window.engine(), window, root());
    autosaver.offer_recovery();
    QPushButton* recover = button_of(window, "recover");
    QVERIFY(recover != nullptr);
    QTest::mouseClick(recover, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(window.engine().state()[part::seeds] != nullptr, 20000);
    QVERIFY(std::abs(window.engine().state()[part::seeds]->liver(0, 0) - 0.25) < 1e-6);
    QVERIFY(window.engine().state()[part::image] != nullptr);
    QTRY_VERIFY(window.isWindowModified());
    // Kept by this window now; the old copy has gone.
    QTRY_COMPARE_WITH_TIMEOUT(std::distance(fs::directory_iterator(root()), fs::directory_iterator()), 1L,
                              20000);
    QTRY_VERIFY(window.engine().tasks().empty());
  }
  QVERIFY(fs::is_empty(root()));
}

void RecoveryTest::ThrownAwayItIsGone() {
  kill_a_window();
  MainWindow window;
  window.show();
  Autosaver autosaver(window.engine(), window, root());
  autosaver.offer_recovery();
  QPushButton* drop = button_of(window, "discard");
  QVERIFY(drop != nullptr);
  QTest::mouseClick(drop, Qt::LeftButton);
  QTRY_COMPARE(std::distance(fs::directory_iterator(root()), fs::directory_iterator()), 1L);  // this window's
  QVERIFY(window.engine().state()[part::image] == nullptr);
}

void RecoveryTest::WhatCannotBeOpenedStays() {
  kill_a_window();
  MainWindow window;
  window.show();
  Autosaver autosaver(window.engine(), window, root());
  QVERIFY(autosaver.period() == std::chrono::minutes(2));
  autosaver.set_period(std::chrono::milliseconds(20));
  const auto left = engine::find_recoverable(root());
  QCOMPARE(left.size(), std::size_t{1});
  autosaver.offer_recovery();
  QPushButton* recover = button_of(window, "recover");
  QVERIFY(recover != nullptr);
  // A disk that fails for a while: nothing of the copy can be read.
  const fs::path away = folder_->path() / "away";
  fs::rename(left.front().copy, away);
  QSignalSpy ended(&window.engine(), &ui::EngineBridge::finished);
  QTest::mouseClick(recover, Qt::LeftButton);
  QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 20000);
  QVERIFY(ended.at(0).at(0).value<engine::Outcome>().status == engine::Status::failed);
  fs::rename(away, left.front().copy);
  // Other work is kept meanwhile, as it should be.
  window.engine().post(engine::ImportImage{folder_->path() / "ct.nrrd", {}, true});
  const auto is_kept = [&] {
    return std::any_of(ended.begin(), ended.end(), [](const QList<QVariant>& one) {
      const auto outcome = one.at(0).value<engine::Outcome>();
      return outcome.command == "keep_copy" && outcome.status == engine::Status::done;
    });
  };
  QTRY_VERIFY_WITH_TIMEOUT(is_kept(), 20000);
  QVERIFY(fs::exists(left.front().copy / "case.json"));
}

void RecoveryTest::NothingIsKeptOfWhatIsSavedOrThrownAway() {
  MainWindow window;
  window.show();
  Autosaver autosaver(window.engine(), window, root());
  autosaver.set_period(std::chrono::milliseconds(20));
  const auto copies = [&] {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root()))
      count += entry.path().filename() == "case.json";
    return count;
  };
  window.engine().post(engine::ImportImage{folder_->path() / "ct.nrrd", {}, true});
  QTRY_COMPARE_WITH_TIMEOUT(copies(), 1, 20000);
  window.engine().post(engine::SaveCase{folder_->path() / "a.glisson"});
  QTRY_VERIFY_WITH_TIMEOUT(!window.isWindowModified(), 20000);
  QTRY_COMPARE(copies(), 0);
  window.engine().post(test::seeds(0.1));
  QTRY_COMPARE_WITH_TIMEOUT(copies(), 1, 20000);
}

void RecoveryTest::LongWorkIsPrecededByACopy() {
  MainWindow window;
  window.show();
  Autosaver autosaver(window.engine(), window, root());
  QSignalSpy ended(&window.engine(), &ui::EngineBridge::finished);
  window.engine().post(engine::ImportImage{folder_->path() / "ct.nrrd", {}, true});
  QTRY_VERIFY_WITH_TIMEOUT(window.isWindowModified(), 20000);
  ended.clear();
  window.engine().post(
      engine::BuildModel{});  // is refused: there are no labels. The copy comes first all the same
  QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, 20000);
  QCOMPARE(ended.at(0).at(0).value<engine::Outcome>().command, std::string("keep_copy"));
  QCOMPARE(ended.at(1).at(0).value<engine::Outcome>().command, std::string("build_model"));
}

}  // namespace glisson

int main(int argc, char** argv) {
  if (argc == 4 && std::string(argv[1]) == "be-killed") return glisson::be_killed(argc, argv);
  return glisson::run_in_window<glisson::RecoveryTest>(argc, argv);
}
#include "recovery_test.moc"
