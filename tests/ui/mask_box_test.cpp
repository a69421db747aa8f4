// SPDX-License-Identifier: GPL-3.0-or-later
// A person's own mask network is chosen, kept for the next start, told of and removed.
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "fake_operation.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/register.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/common/user_settings.h"
#include "glisson/ui/guidance/mask_box.h"
#include "live_part.h"
#include "run_in_window.h"

namespace glisson {

class MaskBoxTest : public QObject {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void ItIsKeptForTheNextStart();
  void ASheetThatCannotBeUsedIsToldAndNotTaken();
  void WhatItDoesIsTold_data();
  void WhatItDoesIsTold();
  void NothingIsToldOfOneThatIsGone();

 private:
  template <class Widget>
  Widget* part(const char* name) const {
    return box_->findChild<Widget*>(QString::fromLatin1(name));
  }
  QString button() const { return part<QPushButton>("choose_mask_network")->text(); }
  QString said() const { return part<QLabel>("mask_said")->text(); }
  std::filesystem::path network(const std::string& sheet) const {
    write_file_atomically(folder_->path() / "tools.json", sheet);
    return folder_->path() / "tools.onnx";
  }
  void follow(int frames);
  static constexpr const char* kSheet = R"({"channels": ["liver", "tool"], "liver": ["liver"]})";
  void make() {
    model_ = std::make_unique<ui::MaskModel>(*engine_, live_->playback);
    box_ = std::make_unique<ui::MaskBox>(*model_);
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<FakeOperation> operation_;
  std::unique_ptr<ui::EngineBridge> engine_;
  std::unique_ptr<LivePart> live_;
  std::unique_ptr<ui::MaskModel> model_;
  std::unique_ptr<ui::MaskBox> box_;
};

void MaskBoxTest::init() {
  ui::user_settings()->clear();
  folder_ = std::make_unique<TemporaryFolder>();
  operation_ = std::make_unique<FakeOperation>();
  make_box_operation(*operation_);
  engine_ = std::make_unique<ui::EngineBridge>(operation_->options());
  live_ = std::make_unique<LivePart>(*engine_);
  make();
}

void MaskBoxTest::cleanup() {
  box_.reset();
  model_.reset();
  live_.reset();
  engine_.reset();
  operation_.reset();
  folder_.reset();
}

void MaskBoxTest::follow(int frames) {
  for (const engine::Command& step : operation_->steps_to_cloud(folder_->path() / "scope.mkv", frames))
    engine_->post(step);
  engine_->post(engine::Register{});
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty() && live_->drawables.drawable(); }, 20000));
  live_->playback.repeats = true;
  live_->playing.findChild<ui::TaskButton*>("start_tracking")->trigger();
}

void MaskBoxTest::ItIsKeptForTheNextStart() {
  QVERIFY(button() == QStringLiteral("Mask network…") && model_->name.value().isEmpty());
  QVERIFY(part<QPushButton>("remove_mask_network")->isHidden());
  model_->choose(network(kSheet));
  QVERIFY2(button().contains(QStringLiteral("tools.onnx")), qPrintable(button()));
  QCOMPARE(live_->playback.command().mask.network, folder_->path() / "tools.onnx");
  box_.reset();
  model_.reset();
  live_->playback.mask_network = QString();
  make();
  QVERIFY2(button().contains(QStringLiteral("tools.onnx")), qPrintable(button()));
  QCOMPARE(live_->playback.command().mask.network, folder_->path() / "tools.onnx");
  part<QPushButton>("remove_mask_network")->click();
  QVERIFY(button() == QStringLiteral("Mask network…") && live_->playback.command().mask.network.empty());
  QVERIFY(!ui::user_settings()->contains(QStringLiteral("mask_network")));
}

void MaskBoxTest::ASheetThatCannotBeUsedIsToldAndNotTaken() {
  model_->choose(network(R"({"channels": ["liver", "tool"], "liver": ["lever"]})"));
  QVERIFY2(said().contains(QStringLiteral("lever")), qPrintable(said()));
  QVERIFY(model_->name.value().isEmpty() && live_->playback.command().mask.network.empty());
}

void MaskBoxTest::WhatItDoesIsTold_data() {
  QTest::addColumn<double>("age");
  QTest::addColumn<bool>("used");
  QTest::addColumn<QString>("problem");
  QTest::addColumn<QString>("words");
  QTest::newRow("none yet") << -1.0 << false << ""
                            << "has no mask yet";
  QTest::newRow("used") << 0.08 << true << ""
                        << "Masked of the organ in sight: 25 %. The mask is 80 ms old.";
  QTest::newRow("slow") << 1.24 << false << ""
                        << "too slow: its last mask is 1.2 s old and is not used";
  QTest::newRow("failed") << -1.0 << false << "tools.onnx: input: are 2, not one. Export it."
                          << "has failed; the organ is followed without it";
}

void MaskBoxTest::WhatItDoesIsTold() {
  QFETCH(double, age);
  QFETCH(bool, used);
  QFETCH(QString, problem);
  QFETCH(QString, words);
  engine::MaskStatus status;
  if (age >= 0.0) status.age = age;
  status.is_used = used;
  status.problem = problem.toStdString();
  operation_->mask = status;
  follow(60);
  QTRY_VERIFY2_WITH_TIMEOUT(said().contains(words), qPrintable(said()), 20000);
  live_->playback.stop();
  QTRY_VERIFY(said().isEmpty());
}

void MaskBoxTest::NothingIsToldOfOneThatIsGone() {
  operation_->mask = engine::MaskStatus{};
  operation_->mask->age = 0.08;
  operation_->mask->is_used = true;
  follow(600);  // the playing's end would take the words away, too
  QTRY_VERIFY2_WITH_TIMEOUT(said().contains("Masked of the organ"), qPrintable(said()), 20000);
  operation_->mask_is_removed = true;
  QTRY_VERIFY2(said().isEmpty(), qPrintable(said()));
  QVERIFY(live_->playback.is_tracking);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::MaskBoxTest>(argc, argv); }
#include "mask_box_test.moc"
