// SPDX-License-Identifier: GPL-3.0-or-later
// What is the case's stays the case's: while it is saved, when another CT or video comes, when a frame loads.
#include <QAbstractButton>
#include <QApplication>
#include <QCoreApplication>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>
#include <chrono>
#include <thread>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/import_cloud.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/load_video_frame.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/commands/set_regions.h"
#include "glisson/engine/commands/set_seeds.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/regions.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/regions.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/ui/stereo/stereo_panel.h"
#include "run_in_window.h"

namespace glisson {

using engine::Part;
using ui::MainWindow;

class CaseKeepingTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void WhatIsDoneWhileTheCaseIsSavedIsNotSaved();
  void ACancelledSaveDoesNotCloseTheWindowLater();
  void OneOfSeveralSeriesIsAskedFor();
  void WhereAFileDoesNotSayCtOrMriIsAsked();
  void WhatIsAskedIsOfTheImageThatCame();
  void AnotherCtIsAskedWhoseItIs();
  void ACtBesideACaseThatIsBeingOpenedIsAskedAbout();
  void WhatASaveTellsIsReadBeforeTheWindowCloses();
  void WhatCannotBeReadIsNobodys_data();
  void WhatCannotBeReadIsNobodys();
  void WhatSaysNoUnitIsAskedForIt();
  void AVideoThatCannotBeOpenedLeavesTheFrame();
  void RegionsAreOfTheFrameThatWasDrawnOn();

 private:
  ui::EngineBridge& engine() { return window_->engine(); }
  QMessageBox* whose() { return window_->findChild<QMessageBox*>(QStringLiteral("whose_image")); }
  bool settle() {
    return QTest::qWaitFor([this] { return engine().tasks().empty(); }, 20000);
  }
  bool open_and_save() {
    window_->open("ct.nii");
    if (!settle()) return false;
    engine().post(engine::SaveCase{folder_->path() / "patient.glisson"});
    return settle() && QTest::qWaitFor([this] { return !window_->isWindowModified(); });
  }
  /// Closes the window and answers its question. @return whether it asked.
  bool close_and_answer(QMessageBox::StandardButton answer) {
    bool asked = false;
    QTimer answers;
    connect(&answers, &QTimer::timeout, this, [&] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (question == nullptr) return;
      asked = true;
      answers.stop();
      question->button(answer)->click();
    });
    answers.start(10);
    window_->close();
    return asked;
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::atomic<bool> save_waits_{false}, open_waits_{false}, save_tells_{false};
  std::optional<LengthUnit> cloud_unit_;  ///< of the last cloud that was imported
  std::unique_ptr<MainWindow> window_;
};

void CaseKeepingTest::init() {
  folder_ = std::make_unique<TemporaryFolder>();
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  save_waits_ = open_waits_ = save_tells_ = false;
  cloud_unit_.reset();
  engine::Engine::Options options = operation_->options();
  options.apply = [this, fake = options.apply](
                      const engine::CaseState& state, const engine::Command& command,
                      const RunContext& context,
                      const engine::Services& services) -> Cancellable<engine::Applied> {
    if (command.as<engine::SaveCase>() != nullptr)
      while (save_waits_) {
        if (context.cancelled()) return {};
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    if (const auto* open = command.as<engine::OpenCase>()) {
      while (open_waits_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      engine::Applied applied{engine::CaseState()};
      Image former = operation_->ct;
      former.description = "of the former patient";
      applied.state[part::image] = std::make_shared<const Image>(std::move(former));
      applied.state.path = open->path;
      return applied;
    }
    if (const auto* cloud = command.as<engine::ImportCloud>()) {
      cloud_unit_ = cloud->unit;
      return engine::Applied{state};
    }
    const auto* video = command.as<engine::SetVideo>();
    if (video && video->left.filename() == "broken.mkv")
      throw InputError(video->left.string(), "", "is no video", "Give another");
    auto applied = fake(state, command, context, services);
    if (video && applied) applied->figures["video_frames"] = 10.0;
    if (command.as<engine::SaveCase>() && applied && save_tells_)
      applied->notes = {"case.kept_changed a.json"};
    return applied;
  };
  window_ = std::make_unique<MainWindow>(options);
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void CaseKeepingTest::cleanup() {
  save_waits_ = false;
  window_.reset();
  operation_.reset();
  folder_.reset();
}

void CaseKeepingTest::WhatIsDoneWhileTheCaseIsSavedIsNotSaved() {
  QVERIFY(open_and_save());
  save_waits_ = true;
  QSignalSpy ended(&engine(), &ui::EngineBridge::finished);
  engine().post(engine::SaveCase{});
  engine().post(engine::SetSeeds{});
  QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, 20000);  // the seeds do not wait
  save_waits_ = false;
  QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 2, 20000);
  QVERIFY(settle());
  QVERIFY(window_->isWindowModified());
  engine().post(engine::SaveCase{});
  QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 3, 20000);
  QTRY_VERIFY(!window_->isWindowModified());
}

void CaseKeepingTest::ACancelledSaveDoesNotCloseTheWindowLater() {
  QVERIFY(open_and_save());
  engine().post(engine::SetSeeds{});
  QVERIFY(settle());
  save_waits_ = true;
  QVERIFY(close_and_answer(QMessageBox::Save));
  QTRY_VERIFY(!engine().tasks().empty());
  engine().cancel(engine().tasks().front().id);
  QVERIFY(settle());
  QVERIFY(window_->isVisible() && window_->isWindowModified());
  save_waits_ = false;
  engine().post(engine::SaveCase{});  // a save of its own does not close
  QVERIFY(settle());
  QTRY_VERIFY(!window_->isWindowModified());
  QVERIFY(window_->isVisible());
  engine().post(engine::SetSeeds{});
  QVERIFY(settle());
  QVERIFY(close_and_answer(QMessageBox::Cancel));  // asks again
  QVERIFY(window_->isVisible());
  QVERIFY(close_and_answer(QMessageBox::Save));
  QTRY_VERIFY(!window_->isVisible());
}

void CaseKeepingTest::OneOfSeveralSeriesIsAskedFor() {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "one_series");
  std::filesystem::create_directories(folder.path() / "two_series");
  window_->open(folder.path() / "one_series");
  QTRY_VERIFY(window_->engine().state()[part::image] != nullptr);
  QVERIFY(window_->engine().state()[part::image]->description.empty());
  QVERIFY(window_->findChild<QDialog*>(QStringLiteral("choose_series")) == nullptr);

  window_->open(folder.path() / "two_series");
  QTRY_VERIFY(window_->findChild<QDialog*>(QStringLiteral("choose_series")) != nullptr);
  auto* dialog = window_->findChild<QDialog*>(QStringLiteral("choose_series"));
  auto* list = dialog->findChild<QTreeWidget*>();
  QCOMPARE(list->topLevelItemCount(), 2);
  QCOMPARE(list->currentItem(), list->topLevelItem(0));  // the likeliest
  QVERIFY(list->topLevelItem(1)->text(0).contains(QStringLiteral("arterial")));
  list->setCurrentItem(list->topLevelItem(1));
  QVERIFY(whose() == nullptr);
  QTest::keyClick(dialog, Qt::Key_Return);
  QTRY_VERIFY(whose() != nullptr);
  QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("same_patient")), Qt::LeftButton);
  QTRY_COMPARE(window_->engine().state()[part::image]->description, std::string("1.2.4"));
}

void CaseKeepingTest::WhereAFileDoesNotSayCtOrMriIsAsked() {
  const TemporaryFolder folder;
  auto* table = window_->findChild<QTreeWidget*>(QStringLiteral("label_table"));
  QVERIFY(table != nullptr);
  constexpr int kIntensity = 5;  // column
  QCOMPARE(table->headerItem()->text(kIntensity), QStringLiteral("HU"));
  write_file_atomically(folder.path() / "unknown.nii", "");
  window_->open(folder.path() / "unknown.nii");
  QTRY_VERIFY(window_->findChild<QPushButton*>(QStringLiteral("modality_mr")) != nullptr);
  QCOMPARE(window_->engine().state()[part::image]->modality, Modality::other);
  QTest::mouseClick(window_->findChild<QPushButton*>(QStringLiteral("modality_mr")), Qt::LeftButton);
  QTRY_COMPARE(window_->engine().state()[part::image]->modality, Modality::mr);
  // Intensities of an MRI have no unit.
  QTRY_COMPARE(table->headerItem()->text(kIntensity), QStringLiteral("Grey"));
  for (const char* box : {"editable_low", "threshold_low"})
    QCOMPARE(window_->findChild<QDoubleSpinBox*>(QLatin1String(box))->suffix(), QString());
}

void CaseKeepingTest::WhatIsAskedIsOfTheImageThatCame() {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "two_series");
  write_file_atomically(folder.path() / "unknown.nii", "");
  window_->open(folder.path() / "unknown.nii");
  window_->open(folder.path() / "two_series");  // before the first one has come
  const auto question = [this] {
    return window_->findChild<QMessageBox*>(QStringLiteral("modality_question"));
  };
  QTRY_VERIFY(question() != nullptr);
  QVERIFY2(question()->text().startsWith(QStringLiteral("unknown.nii")), qPrintable(question()->text()));
}

void CaseKeepingTest::AnotherCtIsAskedWhoseItIs() {
  QVERIFY(open_and_save());
  engine().post(engine::SetSeeds{});
  QVERIFY(settle());
  const auto open_and_answer = [this](const char* answer) {
    const auto before = engine().state()[part::image];
    window_->open("other.nii");
    if (!QTest::qWaitFor([this] { return whose() != nullptr; })) return false;
    const QPointer<QMessageBox> question = whose();
    if (!question->isVisible() || !engine().tasks().empty()) return false;
    if (engine().state()[part::image] != before) return false;  // read, and not taken yet
    QTest::mouseClick(answer == nullptr ? question->button(QMessageBox::Cancel)
                                        : window_->findChild<QAbstractButton*>(QLatin1String(answer)),
                      Qt::LeftButton);
    if (!QTest::qWaitFor([&] { return question.isNull(); }) || !settle()) return false;
    return QTest::qWaitFor([&] { return (engine().state()[part::image] != before) == (answer != nullptr); });
  };
  QVERIFY(open_and_answer(nullptr));
  QVERIFY(open_and_answer("same_patient"));
  QVERIFY(engine().state()[part::seeds] && !engine().state().path.empty());
  QVERIFY(open_and_answer("new_case"));
  QVERIFY(!engine().state()[part::seeds] && engine().state().path.empty());
  QVERIFY(window_->isWindowModified());
}

/// Two patients would be one case, under the first one's name.
void CaseKeepingTest::ACtBesideACaseThatIsBeingOpenedIsAskedAbout() {
  open_waits_ = true;
  window_->open("former.glisson/case.json");
  window_->open("ct.nii");
  open_waits_ = false;
  QTRY_VERIFY(whose() != nullptr);
  QVERIFY(settle());
  QCOMPARE(engine().state()[part::image]->description, std::string("of the former patient"));
  QTest::mouseClick(whose()->button(QMessageBox::Cancel), Qt::LeftButton);
  QVERIFY(settle());
  QCOMPARE(engine().state()[part::image]->description, std::string("of the former patient"));
}

void CaseKeepingTest::WhatASaveTellsIsReadBeforeTheWindowCloses() {
  QVERIFY(open_and_save());
  engine().post(engine::SetSeeds{});
  QVERIFY(settle());
  QTRY_VERIFY(window_->isWindowModified());
  save_tells_ = true;
  QVERIFY(close_and_answer(QMessageBox::Save));
  QVERIFY(settle());
  const auto problem = [this] { return window_->findChild<QMessageBox*>(QStringLiteral("problem")); };
  QTRY_VERIFY(problem() != nullptr && problem()->isVisible());
  QVERIFY(window_->isVisible());
  QVERIFY(problem()->text().contains(QStringLiteral("a.json")));
  QTest::mouseClick(problem()->button(QMessageBox::Ok), Qt::LeftButton);
  QTRY_VERIFY(!window_->isVisible());
}

void CaseKeepingTest::WhatCannotBeReadIsNobodys_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("is_folder");
  QTest::addColumn<bool>("is_dropped");
  for (const bool dropped : {false, true}) {
    const char* how = dropped ? "dropped" : "opened";
    QTest::addRow("volume %s", how) << "broken.nii" << false << dropped;
    QTest::addRow("folder without DICOM %s", how) << "no_series" << true << dropped;
    QTest::addRow("folder with a slice missing %s", how) << "broken" << true << dropped;
  }
}

void CaseKeepingTest::WhatCannotBeReadIsNobodys() {
  QFETCH(QString, name);
  QFETCH(bool, is_folder);
  QFETCH(bool, is_dropped);
  QVERIFY(open_and_save());
  const auto before = engine().state()[part::image];
  const std::filesystem::path path = folder_->path() / name.toStdString();
  if (is_folder) std::filesystem::create_directories(path);
  bool asked = false;
  QTimer looks;
  connect(&looks, &QTimer::timeout, this, [&] { asked = asked || whose() != nullptr; });
  looks.start(1);
  if (is_dropped) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(path.string()))});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &enter);  // without it no drop arrives
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &drop);
  } else {
    window_->open(path);
  }
  QVERIFY(whose() == nullptr);
  QVERIFY(settle());
  QTest::qWait(20);
  QVERIFY(!asked && whose() == nullptr);
  // What is wrong is told.
  const auto* problem = window_->findChild<QMessageBox*>();
  QVERIFY2(problem != nullptr && problem->text().contains(name),
           problem == nullptr ? "nothing is told" : qPrintable(problem->text()));
  QVERIFY(engine().state()[part::image] == before);
}

void CaseKeepingTest::WhatSaysNoUnitIsAskedForIt() {
  const auto dropped_and_told = [this](const char* answer) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QStringLiteral("/scope/cloud.ply"))});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &enter);  // without it no drop arrives
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window_.get(), &drop);
    const QPointer<QMessageBox> question = window_->findChild<QMessageBox*>(QStringLiteral("unit_question"));
    if (question.isNull() || !question->text().contains(QStringLiteral("cloud.ply"))) return false;
    QTest::mouseClick(answer == nullptr ? question->button(QMessageBox::Cancel)
                                        : question->findChild<QAbstractButton*>(QLatin1String(answer)),
                      Qt::LeftButton);
    return QTest::qWaitFor([&] { return question.isNull(); }) && settle();
  };
  QVERIFY(dropped_and_told(nullptr));
  QVERIFY(!cloud_unit_);
  QVERIFY(dropped_and_told("unit_cm"));
  QVERIFY(cloud_unit_ == LengthUnit::centimetre);
  QVERIFY(dropped_and_told("unit_mm"));
  QVERIFY(cloud_unit_ == LengthUnit::millimetre);
}

void CaseKeepingTest::AVideoThatCannotBeOpenedLeavesTheFrame() {
  auto* panel = window_->findChild<ui::StereoPanel*>();
  panel->open_source({folder_->path() / "scope.mkv", {}});
  QTRY_VERIFY(engine().state()[part::frame] != nullptr);
  QCOMPARE(engine().state()[part::frame]->frame.index, 0);
  engine().post(engine::LoadVideoFrame{7});
  QTRY_COMPARE(engine().state()[part::frame]->frame.index, 7);
  const auto* number = panel->findChild<QSpinBox*>();
  QTRY_COMPARE(number->maximum(), 9);
  const auto frame = engine().state()[part::frame];
  QSignalSpy ended(&engine(), &ui::EngineBridge::finished);
  window_->open(folder_->path() / "broken.mkv");
  QTRY_COMPARE(ended.count(), 1);
  QVERIFY(settle());
  QTest::qWait(50);
  QCOMPARE(ended.count(), 1);
  QVERIFY(engine().state()[part::frame] == frame);
  engine().post(engine::ImportImage{"other.nii", {}, true});
  QTRY_VERIFY(!engine().state()[part::video]);
  QVERIFY(number->maximum() > 1000);  // how many frames the next video has is not known
}

void CaseKeepingTest::RegionsAreOfTheFrameThatWasDrawnOn() {
  auto* panel = window_->findChild<ui::StereoPanel*>();
  window_->show_step(MainWindow::stereo);
  panel->open_source({folder_->path() / "scope.mkv", {}});
  QTRY_VERIFY(engine().state()[part::frame] != nullptr);
  stereo::Region region;
  region.polygon = {{20, 20}, {80, 20}, {50, 70}};
  stereo::Regions drawn;
  drawn.regions = {region};
  engine().post(engine::SetRegions{drawn});
  auto* clear = panel->findChild<QPushButton*>(QStringLiteral("clear_regions"));
  QTRY_VERIFY(clear->isEnabled());
  QTest::mouseClick(clear, Qt::LeftButton);
  QTRY_VERIFY(engine().state()[part::regions] && engine().state()[part::regions]->regions.empty());
  const StereoFrame& frame = engine().state()[part::frame]->frame;
  QCOMPARE(engine().state()[part::regions]->identity, stereo::frame_identity(frame.left, frame.right));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::CaseKeepingTest>(argc, argv); }
#include "case_keeping_test.moc"
