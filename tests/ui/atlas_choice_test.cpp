// SPDX-License-Identifier: GPL-3.0-or-later
// The person's own atlas: chosen, remembered, said when it is damaged, used for proposals and modes, and
// built in the window.
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include <fstream>

#include "atlas_cases.h"
#include "glisson/core/files.h"
#include "glisson/engine/commands/import_surfaces.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/ui/atlas/atlas_box.h"
#include "glisson/ui/atlas/build_atlas_dialog.h"
#include "glisson/ui/common/user_settings.h"
#include "glisson/ui/shell/main_window.h"
#include "run_in_window.h"

namespace glisson {

using ui::AtlasChoice;
using ui::MainWindow;

class AtlasChoiceTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void init() { ui::user_settings()->clear(); }
  void cleanup() { window_.reset(); }
  void ItIsRememberedAndSaidWhenItIsGone();
  void AFolderThatIsNoneLeavesTheChoice();
  void ProposalsAndModesComeFromIt();
  void AMissingOneIsNotReplacedUnasked();
  void OnesOwnIsBuiltInTheWindow();

 private:
  template <class Widget>
  Widget* find(const char* name) {
    return window_->findChild<Widget*>(QString::fromLatin1(name));
  }
  ui::AtlasBox& box() { return *find<ui::AtlasBox>("atlas_box"); }
  QPushButton* propose() { return find<QWidget>("propose_landmarks")->findChild<QPushButton*>(); }
  bool settle() {
    return QTest::qWaitFor([this] { return window_->engine().tasks().empty(); }, 120000);
  }
  void open_window();

  TemporaryFolder folder_;
  std::filesystem::path own_;
  std::unique_ptr<MainWindow> window_;
};

void AtlasChoiceTest::initTestCase() {
  own_ = folder_.path() / "own";
  atlas::Atlas mine = *test::built_in_atlas();
  mine.name = "mine";
  atlas::write_atlas(own_, mine);
}

void AtlasChoiceTest::open_window() {
  window_ = std::make_unique<MainWindow>();
  window_->resize(1280, 800);
  window_->show();
  QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  const auto file = folder_.path() / "liver.ply";
  write_triangle_mesh(file, test::built_in_atlas()->mean(), LengthUnit::millimetre);
  model::ModelOptions options;
  options.mesh.target_vertices = 300;
  window_->engine().post(engine::ImportSurfaces{file, LengthUnit::millimetre, options});
  QVERIFY(settle());
  window_->show_step(MainWindow::atlas);
}

void AtlasChoiceTest::ItIsRememberedAndSaidWhenItIsGone() {
  {
    AtlasChoice choice;
    QVERIFY(choice.is_built_in() && choice.atlas());
    QString problem;
    QVERIFY(choice.choose(own_, problem));
    QCOMPARE(choice.atlas()->name, std::string("mine"));
  }
  QCOMPARE(AtlasChoice().atlas()->name, std::string("mine"));
  std::filesystem::rename(own_, folder_.path() / "elsewhere");
  AtlasChoice gone;
  QVERIFY(!gone.atlas() && !gone.is_built_in() && !gone.problem().isEmpty());
  std::filesystem::rename(folder_.path() / "elsewhere", own_);
  gone.choose_built_in();
  QVERIFY(gone.atlas() && gone.problem().isEmpty());
  QVERIFY(AtlasChoice().is_built_in());
}

void AtlasChoiceTest::AFolderThatIsNoneLeavesTheChoice() {
  AtlasChoice choice;
  QString problem;
  QVERIFY(choice.choose(own_, problem));
  const auto damaged = folder_.path() / "damaged";
  atlas::write_atlas(damaged, *test::built_in_atlas());
  std::ofstream(damaged / "atlas.json") << "{";
  QVERIFY(!choice.choose(damaged, problem));
  QVERIFY(!problem.isEmpty());
  QCOMPARE(choice.atlas()->name, std::string("mine"));
  choice.choose_built_in();
}

void AtlasChoiceTest::ProposalsAndModesComeFromIt() {
  open_window();
  QVERIFY(find<QLabel>("atlas_name")->text().contains(QStringLiteral("Built-in")));
  box().choose(own_);
  QVERIFY(find<QLabel>("atlas_name")->text().contains(QStringLiteral("mine")));
  propose()->click();
  QVERIFY(settle());
  QCOMPARE(window_->engine().state()[part::proposals]->atlas, std::string("mine"));
  QVERIFY(!find<QLabel>("atlas_other")->isVisible());
  find<QPushButton>("show_modes")->click();
  QVERIFY(find<QLabel>("mode_caption")->text().contains(QStringLiteral("mine")));
  // Another one is chosen: the modes are its own at once, the proposals stay and are said to be another's.
  find<QAction>("built_in_atlas")->trigger();
  QVERIFY(!find<QLabel>("mode_caption")->text().contains(QStringLiteral("mine")));
  QVERIFY(find<QLabel>("atlas_other")->isVisible());
  QVERIFY(find<QLabel>("atlas_other")->text().contains(QStringLiteral("mine")));
  find<QPushButton>("show_modes")->click();
}

void AtlasChoiceTest::AMissingOneIsNotReplacedUnasked() {
  ui::user_settings()->setValue(QStringLiteral("atlas"),
                                QString::fromStdString((folder_.path() / "gone").string()));
  open_window();
  QVERIFY(find<QLabel>("atlas_problem")->isVisible());
  QVERIFY(!propose()->isEnabled());
  QVERIFY(!find<QPushButton>("show_modes")->isEnabled());
  find<QAction>("built_in_atlas")->trigger();
  QVERIFY(!find<QLabel>("atlas_problem")->isVisible());
  QVERIFY(propose()->isEnabled());
  QVERIFY(!ui::user_settings()->contains(QStringLiteral("atlas")));
}

void AtlasChoiceTest::OnesOwnIsBuiltInTheWindow() {
  open_window();
  const auto cases = folder_.path() / "cases";
  std::filesystem::create_directory(cases);
  test::write_atlas_cases(cases, 5);
  find<QAction>("build_own_atlas")->trigger();
  ui::BuildAtlasDialog* dialog = box().dialog();
  QVERIFY(dialog != nullptr && dialog->isVisible());
  QVERIFY(!dialog->task().button()->isEnabled());  // no cases, no folder
  dialog->add_cases(QString::fromStdString(cases.string()));
  dialog->add_cases(QString::fromStdString(cases.string()));
  QCOMPARE(find<QListWidget>("atlas_cases")->count(), 1);
  QVERIFY(!dialog->task().button()->isEnabled());
  const auto made = folder_.path() / "made";
  dialog->keep_in(QString::fromStdString(made.string()));
  find<QLineEdit>("atlas_new_name")->setText(QStringLiteral("theatre two"));
  QVERIFY(dialog->task().button()->isEnabled());
  QVERIFY(!dialog->command().options.keep_shape && !dialog->command().options.summed);
  for (const char* name : {"atlas_keep_shape", "atlas_summed"}) find<QCheckBox>(name)->setChecked(true);
  QVERIFY(dialog->command().options.keep_shape && dialog->command().options.summed);
  for (const char* name : {"atlas_keep_shape", "atlas_summed"}) find<QCheckBox>(name)->setChecked(false);
  dialog->task().button()->click();
  QVERIFY(dialog->task().is_running());
  dialog->task().cancel_button()->click();
  QVERIFY(settle());
  QVERIFY(!std::filesystem::exists(made));
  dialog->task().button()->click();
  QVERIFY(settle());
  QCOMPARE(atlas::read_atlas(made).name, std::string("theatre two"));
  // It is the chosen one from now on, and what it is worth is told.
  QVERIFY(find<QLabel>("atlas_name")->text().contains(QStringLiteral("theatre two")));
  QVERIFY(find<QLabel>("build_atlas_notes")->text().contains(QStringLiteral("Umbilical notch")));
  dialog->close();
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::AtlasChoiceTest>(argc, argv); }
#include "atlas_choice_test.moc"
