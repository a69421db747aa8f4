// SPDX-License-Identifier: GPL-3.0-or-later
// File > Open recent, in a window.
#include <QAction>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QTest>

#include "../volume/phantom.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/engine/commands/save_case.h"
#include "glisson/engine/parts/image.h"
#include "glisson/ui/shell/main_window.h"
#include "glisson/volume/io.h"
#include "run_in_window.h"

namespace glisson {

namespace fs = std::filesystem;

class RecentCasesTest : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    folder_ = std::make_unique<TemporaryFolder>();
    qputenv("GLISSON_SETTINGS", QByteArray::fromStdString(folder_->path().string()));
    new_window();
  }
  void cleanup() { window_.reset(); }
  void TheLatestComesFirstAndOpens();
  void AtMostTenAreKept();
  void OneThatIsGoneIsSaidAndTakenOut();
  void TheListIsCleared();

 private:
  void new_window() {
    window_ = std::make_unique<ui::MainWindow>();
    window_->show();
  }
  QMenu* menu() const { return window_->findChild<QMenu*>("recent_cases"); }
  QStringList entries() const {
    QStringList names;
    emit menu()->aboutToShow();
    for (const QAction* action : menu()->actions())
      if (action->text().contains(".glisson")) names << action->text().section(' ', 0, 0);
    return names;
  }
  fs::path save(const std::string& name) {
    if (!window_->engine().state()[part::image]) {
      write_image(folder_->path() / "ct.nrrd", test::stored_world(0));
      window_->engine().post(engine::ImportImage{folder_->path() / "ct.nrrd"});
    }
    const fs::path path = folder_->path() / name;
    window_->engine().post(engine::SaveCase{path});
    [&] { QTRY_COMPARE_WITH_TIMEOUT(entries().value(0), QString::fromStdString(name), 20000); }();
    return path;
  }

  std::unique_ptr<TemporaryFolder> folder_;
  std::unique_ptr<ui::MainWindow> window_;
};

void RecentCasesTest::TheLatestComesFirstAndOpens() {
  QVERIFY(!menu()->menuAction()->isEnabled());
  const fs::path first = save("first.glisson");
  save("second.glisson");
  QCOMPARE(entries(), QStringList({"second.glisson", "first.glisson"}));
  new_window();  // the next session
  QCOMPARE(entries(), QStringList({"second.glisson", "first.glisson"}));
  menu()->actions().at(1)->trigger();
  QTRY_COMPARE_WITH_TIMEOUT(QString::fromStdString(window_->engine().state().path.string()),
                            QString::fromStdString(first.string()), 20000);
  QTRY_COMPARE(entries(), QStringList({"first.glisson", "second.glisson"}));
}

void RecentCasesTest::AtMostTenAreKept() {
  for (int n = 0; n < 12; ++n) save(std::to_string(n) + ".glisson");
  QCOMPARE(entries().size(), 10);
  QCOMPARE(entries().back(), QString("2.glisson"));
}

void RecentCasesTest::OneThatIsGoneIsSaidAndTakenOut() {
  fs::remove_all(save("first.glisson"));
  new_window();
  QCOMPARE(entries(), QStringList({"first.glisson"}));
  menu()->actions().at(0)->trigger();
  const auto* box = window_->findChild<QMessageBox*>();
  QVERIFY(box != nullptr);
  QVERIFY(box->text().contains("first.glisson"));
  QVERIFY(entries().isEmpty());
}

void RecentCasesTest::TheListIsCleared() {
  save("first.glisson");
  menu()->actions().back()->trigger();
  QVERIFY(entries().isEmpty());
  QVERIFY(!menu()->menuAction()->isEnabled());
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::RecentCasesTest>(argc, argv); }
#include "recent_cases_test.moc"
