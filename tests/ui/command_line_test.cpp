// SPDX-License-Identifier: GPL-3.0-or-later
// The same seeds give the same labels, to the voxel, in the window and on the command line.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include "../app/program.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/segmentation/segment.h"
#include "segmentation_window.h"

namespace glisson {

/// The program, without a display.
class CommandLine : public test::Program {
 public:
  CommandLine() { make_folder(); }
  using test::Program::at;
  using test::Program::run;
};

class CommandLineTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void initTestCase() { make_ct(); }
  void init() { show_window(); }
  void cleanup() { window_.reset(); }
  void SameSeedsGiveTheSameLabels_data();
  void SameSeedsGiveTheSameLabels();
  void SurfacesLeaveBothAlike();
  void SurfacesThatLieThereAreNotReplacedUnasked();

 private:
  /// By the menu, as PLY. @param name typed into the dialog. @param answer the button of the question whether
  /// what lies there may be replaced. @return what was asked; empty: nothing.
  QString export_surfaces(const std::filesystem::path& name, const QString& answer);
  void click(const char* structure, const Eigen::Vector3d& p) {
    press(structure);
    QTest::mouseClick(&slice(scene::Plane::axial), Qt::LeftButton, {},
                      slice(scene::Plane::axial).widget_point(Point<CtFrame>(p)).toPoint());
    QVERIFY(settle());
  }
};

void CommandLineTest::SameSeedsGiveTheSameLabels_data() {
  QTest::addColumn<bool>("is_told");
  QTest::newRow("the file says what it is") << false;
  QTest::newRow("the person says that it is a CT") << true;
}

void CommandLineTest::SameSeedsGiveTheSameLabels() {
  QFETCH(bool, is_told);
  open_ct();
  seed_liver();
  click("seed_portal_vein", {-0.02, -0.015, 0});
  click("seed_lesion_1", {0.03, 0.0, 0});
  click("seed_background", {-0.06, 0.05, 0});
  QTest::keyClick(window_.get(), Qt::Key_Escape);
  grow();
  QVERIFY(window_->engine().state()[part::labels] != nullptr);

  const CommandLine program;
  segmentation::write_seeds(program.at("seeds.json"), *window_->engine().state()[part::seeds]);
  std::filesystem::copy_file(folder_->path() / "ct.nrrd", program.at("ct.nrrd"));
  QCOMPARE(program.run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
  QStringList segment{"segment",    "--case",       "a.glisson", "--seeds",
                      "seeds.json", "--labels-out", "a.seg.nrrd"};
  if (is_told)
    segment << "--modality"
            << "ct";
  const test::Ran ran = program.run(segment);
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY(read_labels(program.at("a.seg.nrrd")).voxels == labels());
  QVERIFY(count(structure::kParenchyma) > 1000 && count(structure::kPortalVein) > 10);
}

QString CommandLineTest::export_surfaces(const std::filesystem::path& name, const QString& answer) {
  QString asked;
  QTimer answers;
  connect(&answers, &QTimer::timeout, this, [&] {
    if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget())) {
      dialog->selectNameFilter(QStringLiteral("PLY (*.ply)"));
      auto* typed = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      typed->setText(QString::fromStdString(name.string()));
      QTest::keyClick(typed, Qt::Key_Return);
    } else if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      asked = box->text();
      for (QAbstractButton* one : box->buttons())
        if (one->text().remove(QLatin1Char('&')) == answer) one->click();
    }
  });
  answers.start(20);
  for (QAction* action : window_->findChildren<QAction*>())
    if (action->text().remove(QLatin1Char('&')).startsWith(QStringLiteral("Export surfaces"))) {
      if (!action->isEnabled()) return QStringLiteral("not enabled");
      action->trigger();
    }
  return settle() ? asked : QStringLiteral("does not settle");
}

void CommandLineTest::SurfacesThatLieThereAreNotReplacedUnasked() {
  open_labels();
  const TemporaryFolder place;
  const std::filesystem::path folder = place.path() / "window", liver = folder / "liver.ply";
  QVERIFY(export_surfaces(folder, {}).isEmpty());
  write_file_atomically(liver, std::string("of another patient"));
  // The ending names the format: the folder is the one that is there already.
  const QString asked = export_surfaces(place.path() / "window.ply", QStringLiteral("Cancel"));
  QVERIFY2(asked.contains(QStringLiteral("lesion_1.ply, liver.ply, portal_vein.ply")), qPrintable(asked));
  QCOMPARE(read_file(liver), std::string("of another patient"));
  QVERIFY(!export_surfaces(place.path() / "window.ply", QStringLiteral("Replace")).isEmpty());
  QVERIFY(read_triangle_mesh(liver, LengthUnit::millimetre).triangle_count() > 0);
}

void CommandLineTest::SurfacesLeaveBothAlike() {
  open_labels();
  const CommandLine program;
  QVERIFY(export_surfaces(program.at("window"), {}).isEmpty());  // nothing to ask about
  QVERIFY(settle());
  std::filesystem::copy_file(folder_->path() / "labels.seg.nrrd", program.at("labels.seg.nrrd"));
  const test::Ran ran = program.run({"model", "--case", "a.glisson", "--labels", "labels.seg.nrrd",
                                     "--surfaces-out", "program", "--format", "ply"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  // Those of the labels here, those of the model there.
  for (const char* name : {"liver.ply", "portal_vein.ply", "lesion_1.ply"}) {
    const TriangleMesh a = read_triangle_mesh(program.at("window") / name, LengthUnit::millimetre),
                       b = read_triangle_mesh(program.at("program") / name, LengthUnit::millimetre);
    QVERIFY(volume(a) > 0.0 && std::abs(volume(a) - volume(b)) < 0.005 * volume(a));
    QVERIFY((centroid(a) - centroid(b)).norm() < 1e-4);
  }
  const test::Ran wrong = program.run({"model", "--case", "a.glisson", "--format", "step"});
  QVERIFY(wrong.code != 0 && wrong.error.contains("stl, ply, obj or vtp"));
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::CommandLineTest>(argc, argv); }
#include "command_line_test.moc"
