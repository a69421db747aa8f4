// SPDX-License-Identifier: GPL-3.0-or-later
// Whose case is open stands on the screen in every step.
#include <QLabel>
#include <QTest>

#include "../volume/dicom_bytes.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/parts/image.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

namespace fs = std::filesystem;

class IdentityTest : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<TemporaryFolder>();
    window_ = std::make_unique<ui::MainWindow>();
    window_->resize(1280, 800);
    window_->show();
  }
  void cleanup() { window_.reset(); }
  void ItStandsInEveryStepAndInTheCase();
  void WithoutOneItSaysSo();
  void WhatAFileSaysIsNoMarkup();

 private:
  fs::path series(const std::string& name) const {
    const fs::path folder = folder_->path() / "series";
    fs::create_directory(folder);
    for (int k = 0; k < 4; ++k) {
      test::HandSlice slice;
      if (!name.empty())
        slice.other = {{"0010|0010", name}, {"0010|0020", "4711"}, {"0010|0030", "19600131"}};
      write_file_atomically(folder / std::to_string(k), test::dicom_of(k, slice));
    }
    return folder;
  }
  const QLabel* label() const { return window_->findChild<QLabel*>("patient_identity"); }
  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<ui::MainWindow> window_;
};

void IdentityTest::ItStandsInEveryStepAndInTheCase() {
  QVERIFY(label()->text().isEmpty());
  window_->engine().post(engine::ImportImage{series("Doe^Jane")});
  const QString said("Doe Jane  ·  ID 4711  ·  born 1960-01-31");
  QTRY_COMPARE_WITH_TIMEOUT(label()->text(), said, 20000);
  for (int step = 0; step <= ui::MainWindow::guidance; ++step) {
    window_->show_step(step);
    QTRY_VERIFY(label()->isVisible());
    const QRect place(label()->mapTo(window_.get(), QPoint()), label()->size());
    QVERIFY(window_->rect().contains(place));
    QVERIFY(place.width() >= label()->fontMetrics().horizontalAdvance(said));
  }
  window_->engine().post(engine::SaveCase{folder_->path() / "a.glisson"});
  QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), 20000);
  window_ = std::make_unique<ui::MainWindow>();
  window_->open(folder_->path() / "a.glisson");
  QTRY_COMPARE_WITH_TIMEOUT(label()->text(), said, 20000);
}

void IdentityTest::WithoutOneItSaysSo() {
  window_->engine().post(engine::ImportImage{series("Doe^Jane")});
  QTRY_VERIFY_WITH_TIMEOUT(label()->text().startsWith("Doe Jane"), 20000);
  window_->engine().post(engine::ImportImage{series("")});  // another CT into the same case
  QTRY_COMPARE_WITH_TIMEOUT(label()->text(), QString("Anonymous"), 20000);
}

void IdentityTest::WhatAFileSaysIsNoMarkup() {
  window_->engine().post(engine::ImportImage{series("<b>Doe^Jane</b> " + std::string(150, 'x'))});
  QTRY_VERIFY_WITH_TIMEOUT(label()->text().startsWith("<b>Doe"), 20000);
  QCOMPARE(label()->textFormat(), Qt::PlainText);
  QVERIFY(label()->width() < 720);
  QVERIFY(label()->toolTip().contains("&lt;b&gt;"));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::IdentityTest>(argc, argv); }
#include "identity_test.moc"
