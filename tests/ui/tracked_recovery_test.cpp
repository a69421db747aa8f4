// SPDX-License-Identifier: GPL-3.0-or-later
// While the video is followed what is not saved is kept as well, and frames do not wait for it.
#include <QCoreApplication>
#include <QMainWindow>
#include <QProcess>
#include <QSignalSpy>
#include <QTest>

#include <algorithm>
#include <cstdio>

#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/live.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/recovery.h"
#include "glisson/ui/shell/autosaver.h"
#include "run_in_window.h"
#include "tracked_case.h"

namespace glisson {
namespace {

namespace fs = std::filesystem;

/// A window whose registration nobody has saved, and what keeps copies of it.
struct Unsaved {
  TrackedCase<LivePart> operated;
  QMainWindow window;
  std::unique_ptr<ui::Autosaver> autosaver;
  int copies = 0;  ///< that are whole

  explicit Unsaved(const fs::path& root) {
    operated.register_it();
    if (QTest::currentTestFailed()) return;
    window.setWindowModified(true);
    autosaver = std::make_unique<ui::Autosaver>(engine(), window, root);
    autosaver->set_period(std::chrono::hours(1));
    QObject::connect(&engine(), &ui::EngineBridge::finished, &window, [this](const engine::Outcome& outcome) {
      copies += outcome.command == "keep_copy" && outcome.status == engine::Status::done;
    });
  }
  ui::EngineBridge& engine() const { return *operated.engine; }
  int frames() const {
    const auto& live = engine().state()[part::live];
    return live ? live->frames : 0;
  }
  bool is_copying() const {
    const auto& tasks = engine().tasks();
    return std::any_of(tasks.begin(), tasks.end(),
                       [](const ui::Task& task) { return task.traits.code == "keep_copy"; });
  }
};

}  // namespace

/// The window that is going to be killed: tells when a copy was kept while it followed, and goes on.
class KilledWindow : public QObject {
  Q_OBJECT
 public:
  static inline fs::path root;
 private slots:
  void FollowsUntilItIsKilled();
};

void KilledWindow::FollowsUntilItIsKilled() {
  Unsaved unsaved(root);
  unsaved.operated.begin_tracking();
  QTRY_VERIFY_WITH_TIMEOUT(unsaved.copies > 0, 20000);
  QVERIFY(unsaved.engine().snapshot()->tracking);
  std::puts("kept");
  std::fflush(stdout);
  QTest::qWait(60000);
}

class TrackedRecoveryTest : public QObject {
  Q_OBJECT
 private slots:
  void init() { folder_ = std::make_unique<TemporaryFolder>(); }
  void cleanup() { folder_.reset(); }
  void ACopyIsMadeBeforeTheVideoIsFollowed();
  void TheClockKeepsWhatChangesMeanwhile();
  void FramesDoNotWaitForACopy();
  void AWindowThatIsKilledMeanwhileLosesNothing();

 private:
  fs::path root() const { return folder_->path() / "recovery"; }
  static Points nodes_of(const engine::CaseState& state) {
    return state[part::registration]->nodes_in_camera;
  }
  /// The nodes of the one copy that lies there.
  Points kept_nodes() const {
    for (const auto& entry : fs::recursive_directory_iterator(root()))
      if (entry.path().filename() == "case.json")
        return nodes_of(*engine::open_case(entry.path().parent_path(), RunContext()));
    return {};
  }
  std::unique_ptr<TemporaryFolder> folder_;
};

void TrackedRecoveryTest::ACopyIsMadeBeforeTheVideoIsFollowed() {
  Unsaved unsaved(root());
  QCOMPARE(unsaved.copies, 0);
  unsaved.operated.begin_tracking();
  QTRY_COMPARE_WITH_TIMEOUT(unsaved.copies, 1, 20000);
  QVERIFY(unsaved.engine().snapshot()->tracking);
  const Points now = nodes_of(unsaved.engine().state()), kept = kept_nodes();
  QVERIFY(kept.rows() == now.rows() && (kept - now).cwiseAbs().maxCoeff() < 1e-6);
}

void TrackedRecoveryTest::TheClockKeepsWhatChangesMeanwhile() {
  Unsaved unsaved(root());
  unsaved.operated.begin_tracking();
  QTRY_COMPARE_WITH_TIMEOUT(unsaved.copies, 1, 20000);
  const Points before = nodes_of(unsaved.engine().state());
  QTest::keyClick(&unsaved.operated.guidance->view, Qt::Key_R);  // registers again, 3 mm from there
  QTRY_VERIFY_WITH_TIMEOUT((nodes_of(unsaved.engine().state()) - before).cwiseAbs().maxCoeff() > 2e-3, 20000);
  QCOMPARE(unsaved.copies, 1);  // a person waits for it: the copy does not come first
  unsaved.autosaver->set_period(std::chrono::milliseconds(50));
  QTRY_COMPARE_WITH_TIMEOUT(unsaved.copies, 2, 20000);
  QVERIFY(unsaved.engine().snapshot()->tracking);
  QVERIFY((kept_nodes() - nodes_of(unsaved.engine().state())).cwiseAbs().maxCoeff() < 1e-6);
}

void TrackedRecoveryTest::FramesDoNotWaitForACopy() {
  Unsaved unsaved(root());
  unsaved.operated.operation->hold = true;  // the copy takes as long as that
  unsaved.operated.begin_tracking();
  QVERIFY(unsaved.is_copying());
  const int before = unsaved.frames();
  unsaved.operated.guidance->playback.pause(false);
  QTRY_VERIFY_WITH_TIMEOUT(unsaved.frames() >= before + 5, 20000);
  QVERIFY(unsaved.is_copying());
  unsaved.operated.operation->hold = false;
  QTRY_COMPARE_WITH_TIMEOUT(unsaved.copies, 1, 20000);
}

void TrackedRecoveryTest::AWindowThatIsKilledMeanwhileLosesNothing() {
  QProcess window;
  window.start(QCoreApplication::applicationFilePath(),
               {"be-killed", QString::fromStdString(root().string())});
  QVERIFY(window.waitForStarted());
  QByteArray said;
  while (!said.endsWith("\nkept\n") && window.waitForReadyRead(60000)) said += window.readAll();
  QVERIFY2(said.endsWith("\nkept\n"), said.constData());
  QVERIFY(engine::find_recoverable(root()).empty());  // it still runs
  window.kill();                                      // SIGKILL
  QVERIFY(window.waitForFinished());
  const auto found = engine::find_recoverable(root());
  QCOMPARE(found.size(), std::size_t{1});
  const auto state = engine::open_case(found[0].copy, RunContext());
  QVERIFY(state && state->has(part::registration) && state->has(part::model) && state->has(part::video));
}

}  // namespace glisson

int main(int argc, char** argv) {
  if (argc != 3 || std::string(argv[1]) != "be-killed")
    return glisson::run_in_window<glisson::TrackedRecoveryTest>(argc, argv);
  glisson::KilledWindow::root = argv[2];
  return glisson::run_in_window<glisson::KilledWindow>(1, argv);
}
#include "tracked_recovery_test.moc"
