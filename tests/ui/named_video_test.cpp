// SPDX-License-Identifier: GPL-3.0-or-later
// A case names pictures that lie elsewhere: the window opens them when a person here has chosen them, and
// asks otherwise.
#include <QMessageBox>
#include <QPushButton>
#include <QTest>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/frame.h"
#include "glisson/engine/parts/named_video.h"
#include "glisson/engine/parts/video.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/stereo/reach.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"
#include "state_folder.h"

namespace glisson {

namespace fs = std::filesystem;
using ui::MainWindow;

class NamedVideoTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void cleanupTestCase() { folder_.reset(); }
  void init();
  void cleanup();
  void WhoDoesNotSayYesLeavesThemOut_data();
  void WhoDoesNotSayYesLeavesThemOut();
  void WhoSaysYesOpensThemAndChangesNothingElse();
  void WhatWasChosenHereIsNotAskedFor();
  void OfPicturesThatAreNotThereTheNoteTells();

 private:
  fs::path film() const { return folder_->path() / "film.mkv"; }
  fs::path case_folder() const { return folder_->path() / "a.glisson"; }
  bool settle() const {
    return QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 30000);
  }
  const engine::CaseState& state() const { return window_->engine().state(); }
  QMessageBox* question() const {
    return window_->findChild<QMessageBox*>(QStringLiteral("named_video_question"));
  }
  /// Null: none.
  QMessageBox* told() const {
    for (QMessageBox* box : window_->findChildren<QMessageBox*>())
      if (box->objectName() != QLatin1String("named_video_question")) return box;
    return nullptr;
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<test::StateFolder> state_;  ///< nobody has chosen anything yet
  std::unique_ptr<MainWindow> window_;
};

void NamedVideoTest::initTestCase() {
  folder_ = std::make_unique<TemporaryFolder>();
  constexpr int kWidth = 160, kHeight = 120;
  const auto bytes = [](int width) {
    return std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(3 * width * kHeight),
                                                       std::uint8_t{90});
  };
  stereo::VideoWriter writer(film(), 2 * kWidth, kHeight, 30.0);
  writer.write({2 * kWidth, kHeight, 3, bytes(2 * kWidth)});
  writer.close();
  // Of another computer: what is remembered there is not known here.
  const test::StateFolder elsewhere;
  engine::CaseState made;
  made[part::video] = std::make_shared<const engine::VideoSource>(engine::VideoSource{film(), {}});
  engine::StereoInput pair;
  pair.frame.left = pair.frame.right = {kWidth, kHeight, 3, bytes(kWidth)};
  made[part::frame] = std::make_shared<const engine::StereoInput>(pair);
  made.stamp(part::video).revision = 1;
  made.stamp(part::frame) = {2, {{part::video, 1}}};
  QVERIFY(engine::save_case(case_folder(), made, RunContext()));
}

void NamedVideoTest::init() {
  state_ = std::make_unique<test::StateFolder>();
  window_ = std::make_unique<MainWindow>();
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
}

void NamedVideoTest::cleanup() {
  window_.reset();
  state_.reset();
}

void NamedVideoTest::WhoDoesNotSayYesLeavesThemOut_data() {
  QTest::addColumn<int>("key");
  QTest::newRow("Enter") << int(Qt::Key_Return);
  QTest::newRow("Escape") << int(Qt::Key_Escape);
}
void NamedVideoTest::WhoDoesNotSayYesLeavesThemOut() {
  QFETCH(int, key);
  window_->open(case_folder());
  QTRY_VERIFY_WITH_TIMEOUT(question() != nullptr && question()->isVisible(), 30000);
  const QString text = question()->text();
  QVERIFY2(text.contains(QString::fromStdString(film().string())), qPrintable(text));
  QTest::keyClick(question(), static_cast<Qt::Key>(key));
  QTRY_VERIFY(question() == nullptr);
  QVERIFY(settle());
  QVERIFY(!state()[part::video] && state()[part::named_video]);
  QVERIFY(!window_->isWindowModified());
  QVERIFY2(told() == nullptr, "the question has told it");
  QVERIFY(!stereo::is_entered(film().string()));
}

void NamedVideoTest::WhoSaysYesOpensThemAndChangesNothingElse() {
  window_->open(case_folder());
  QTRY_VERIFY_WITH_TIMEOUT(question() != nullptr && question()->isVisible(), 30000);
  const auto frame = state()[part::frame];
  QTest::mouseClick(question()->findChild<QPushButton*>(QStringLiteral("named_video_open")), Qt::LeftButton);
  QTRY_VERIFY_WITH_TIMEOUT(state()[part::video] != nullptr, 30000);
  QVERIFY(settle());
  QCOMPARE(state()[part::video]->left, film());
  QVERIFY(!state()[part::named_video]);
  QVERIFY(state()[part::frame] == frame);
  QCOMPARE(engine::stage_state(state(), part::frame), engine::StageState::current);
  QTRY_VERIFY(question() == nullptr);
  QVERIFY(told() == nullptr);
  QVERIFY(stereo::is_entered(film().string()));
}

void NamedVideoTest::WhatWasChosenHereIsNotAskedFor() {
  stereo::remember_sources({film().string()});
  window_->open(case_folder());
  QTRY_VERIFY_WITH_TIMEOUT(state()[part::video] != nullptr, 30000);
  QVERIFY(settle());
  QVERIFY(question() == nullptr && told() == nullptr);
  QVERIFY(!window_->isWindowModified());
}

void NamedVideoTest::OfPicturesThatAreNotThereTheNoteTells() {
  const fs::path away = folder_->path() / "away.mkv";
  fs::rename(film(), away);
  window_->open(case_folder());
  QTRY_VERIFY_WITH_TIMEOUT(told() != nullptr, 30000);
  fs::rename(away, film());
  QVERIFY(question() == nullptr);
  QVERIFY2(told()->text().contains(QString::fromStdString(film().string())), qPrintable(told()->text()));
  QVERIFY(!state()[part::video] && state()[part::named_video]);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::NamedVideoTest>(argc, argv); }
#include "named_video_test.moc"
