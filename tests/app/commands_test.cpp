// SPDX-License-Identifier: GPL-3.0-or-later
// The command line as a person meets it: help, language, wrong usage, places that cannot be written.
#include <QProcess>
#include <QTest>

#include <cmath>

#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "program.h"

using namespace glisson;
using test::ball;
using test::Ran;
using test::write_text;
namespace fs = std::filesystem;

class CommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void init() { make_folder(); }
  void cleanup() { remove_folder(); }

  void EveryCommandHelps();
  void HelpIsInThePersonsLanguage();
  void WrongUsageIsToldInThePersonsLanguage();
  void NumbersInFilesAreTheSameInEveryLanguage();
  void WrongUsageIsRefusedWithCodeTwo();
  void WhatWouldBeLeftUnreadIsRefused();
  void MissingInputIsNamed();
  void APlaceThatCannotBeWrittenIsRefusedBeforeTheWork();
  void AnEmptyFolderIsRefused();
  void WhatIsReadOrWrittenTwiceIsNotWrittenOver();
};

/// A run that takes no notice of an option looks like one that does.
void CommandsTest::WhatWouldBeLeftUnreadIsRefused() {
  const auto idle = [this](const QStringList& command, const char* option) {
    refused(command, QString("--") + option + ": means nothing", 2);
  };
  idle({"calibrate", "--text", "t", "--size", "640x480", "--out", "c.yaml", "--coverage", "c.png"},
       "coverage");
  idle({"calibrate", "--pairs", "p", "--unit", "cm", "--out", "c.yaml"}, "unit");
  idle({"calibrate", "--pairs", "p", "--marker-mm", "2", "--out", "c.yaml"}, "marker-mm");
  idle({"track", "--model", "m.vtu", "--start", "m.vtu", "--out", "t", "--clouds", "c_%02d.ply", "--mask",
        "m.png"},
       "mask");
  idle({"track", "--model", "m.vtu", "--start", "m.vtu", "--out", "t", "--video", "v.mkv", "--method",
        "springs"},
       "method");
  idle({"track", "--model", "m.vtu", "--start", "m.vtu", "--out", "t", "--video", "v.mkv", "--mask-every",
        "2"},
       "mask-every");
  idle({"atlas", "transfer", "--case", "a.glisson", "--out", "b"}, "out");
  idle({"atlas", "evaluate", "a.glisson", "--out", "b"}, "out");
  idle({"atlas", "build", "a.glisson", "--out", "b", "--accept", "vena_cava"}, "accept");
  idle({"figure", "5", "--case", "a.glisson", "--out", "f"}, "case");
  idle({"import", "ct", "--list", "--case", "a.glisson"}, "case");
  idle({"reconstruct", "--left", "l.png", "--right", "r.png", "--calibration", "c.yaml", "--out", "c.ply",
        "--dense", "--method", "sparse"},
       "method");
  refused({"atlas", "transfer", "a.glisson", "--case", "b.glisson"}, "2 arguments were given", 2);
}

/// Under another spelling of the path, and through a link, too.
void CommandsTest::WhatIsReadOrWrittenTwiceIsNotWrittenOver() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  fs::create_symlink("m.vtu", at("link.vtu"));
  const std::string before = read_file(at("m.vtu"));
  for (const char* out : {"m.vtu", "./m.vtu", "link.vtu"})
    refused({"register", "--model", "m.vtu", "--cloud", "c.ply", "--out", out}, "--model is the same file",
            2);
  refused({"reconstruct", "--left", "l.png", "--right", "r.png", "--calibration", "c.yaml", "--out", "c.ply",
           "--json", "c.ply"},
          "is the same file", 2);
  refused({"import", "ct.nrrd", "--case", "a.glisson", "--json", "ct.nrrd"}, "ct.nrrd is the same file", 2);
  QVERIFY(read_file(at("m.vtu")) == before);
}

void CommandsTest::EveryCommandHelps() {
  for (const char* command : {"demo", "import", "segment", "edit", "model", "calibrate", "check", "prove",
                              "reconstruct", "register", "track", "render", "overlay", "simulate"}) {
    const Ran ran = run({command, "--help"});
    QCOMPARE(ran.code, 0);
    QVERIFY2(ran.out.contains("--seed") && ran.out.contains("--json") &&
                 ran.out.contains(QString("glisson ") + command),
             qPrintable(ran.out));
  }
  const Ran ran = run({"--help"});
  QCOMPARE(ran.code, 0);
  QVERIFY(ran.out.contains("reconstruct"));
  QVERIFY(run({"demo", "--help"}).out.contains("--standing-scope"));  // a hand holds it otherwise
}

void CommandsTest::HelpIsInThePersonsLanguage() {
  QVERIFY(run({"simulate", "--help"}).out.contains("Time step, s."));
  QVERIFY(run({"simulate", "--help"}, "de_DE.UTF-8").out.contains("Zeitschritt, s."));
  QVERIFY(run({"simulate", "--help"}, "fr_FR.UTF-8").out.contains("Pas de temps, s."));
  QVERIFY(run({"--help"}, "de_DE.UTF-8").out.contains("nicht für den klinischen Gebrauch"));
  // The names and titles are those that the experiments give their proofs.
  const QString proofs = run({"prove", "--help"}, "de_DE.UTF-8").out.simplified();
  QVERIFY2(proofs.contains("pulled, atlas.") && proofs.contains("atlas: Landmarken, die die CT nicht zeigt."),
           qPrintable(proofs));
}

void CommandsTest::WrongUsageIsToldInThePersonsLanguage() {
  const auto told = [this](const QStringList& command) {
    const Ran ran = run(command, "de_DE.UTF-8");
    return ran.code == 2 ? ran.error : QString::number(ran.code);
  };
  const QString range = told({"demo", "--distance", "12"}), option = told({"--no-such-option"});
  QVERIFY2(range.contains("--distance 12: muss eine Zahl von 80 bis 160 sein."), qPrintable(range));
  QVERIFY2(option.contains("--no-such-option: unbekannte Option. Siehe "), qPrintable(option));
}

void CommandsTest::NumbersInFilesAreTheSameInEveryLanguage() {
  // Germany writes 0,5. The system may lack that locale: it is made here.
  fs::create_directory(at("locales"));
  if (QProcess::execute("localedef", {"-i", "de_DE", "-f", "UTF-8", text_of("locales/de_DE.UTF-8")}) != 0)
    QSKIP("localedef or its sources are not installed");
  TriangleMesh mesh = boundary_surface(ball()).mesh;
  const Eigen::Index liver = mesh.vertices.rows(), triangles = mesh.triangles.rows();
  mesh.vertices.conservativeResize(2 * liver, 3);
  mesh.vertices.bottomRows(liver) =
      (0.1 * mesh.vertices.topRows(liver)).rowwise() + Eigen::RowVector3d(0.2, 0, 0);
  mesh.triangles.conservativeResize(2 * triangles, 3);
  mesh.triangles.bottomRows(triangles) = mesh.triangles.topRows(triangles).array() + static_cast<int>(liver);
  write_triangle_mesh(at("liver.vtp"), mesh, LengthUnit::millimetre);
  const auto case_file = [&](const char* name, const QString& locale) {
    const Ran ran = run({"model", "--surfaces", "liver.vtp", "--case", name}, locale);
    return ran.code == 0 ? QString::fromStdString(read_file(at(name) / "case.json")) : ran.error;
  };
  const QString here = case_file("a.glisson", "C.UTF-8");
  QVERIFY2(here.contains("liver.piece_dropped"), qPrintable(here));
  QCOMPARE(case_file("b.glisson", "de_DE.UTF-8"), here);
}

void CommandsTest::WrongUsageIsRefusedWithCodeTwo() {
  refused({"register", "--no-such-option"}, "no-such-option", 2);
  refused({"register", "--model", "m.vtu"}, "--out", 2);
  refused({"import", "--case", "a.glisson"}, "arguments", 2);
  refused({"--no-such-option"}, "unknown option", 2);
  refused({"demo", "--distance", "12"}, "from 80 to 160", 2);
  refused({"demo", "--headless", "headles"}, "headles: is no option", 2);
  refused({"segment", "--case", "a.glisson", "--seeds", "s.json", "--labels-out", "l.txt"}, ".nrrd", 2);
  refused({"segment", "--case", "a.glisson", "--seeds", "s.json", "--region", "nan,0,0,9,9,9"}, "--region",
          2);
  refused({"model", "--case", "a.glisson", "--mesh-out", "m.stl"}, "must end in .vtu", 2);
  refused({"model", "--case", "a.glisson", "--edge", "0.5"}, "--edge", 2);
  refused({"model", "--case", "a.glisson", "--vessel-refinement", "2"}, "--vessel-refinement", 2);
  refused({"render", "--case", "a.glisson", "--out", "p.txt"}, ".png", 2);
  refused({"render", "--case", "a.glisson", "--out", "p.png", "--lesion", "tumour"}, "--lesion", 2);
  refused({"render", "--case", "a.glisson", "--out", "p.png", "--mark", "3;4"}, "--mark", 2);
  refused({"reconstruct", "--out", "c.xyz"}, ".ply", 2);
  // The second one would have been taken, and the next option for a value.
  refused({"reconstruct", "--out", "a.ply", "--out", "b.ply"}, "--out: is given twice", 2);
  refused({"simulate", "--model", "m.vtu", "--load", "l.json", "--out", "--static"}, "--out: has no value",
          2);
  refused({"import", "", "--case", "a.glisson"}, "an argument is empty", 2);
  // Before the volume, which is missing, too, is read.
  refused({"import", "ct.nrrd", "--case", "a.case"}, "must end in .glisson", 2);
  refused({"import", "ct.nrrd", "--case", "nowhere/a.glisson"}, "nowhere/a.glisson: its folder");
  refused({"model", "--surfaces", "s", "--case", "nowhere/a.glisson"}, "nowhere/a.glisson: its folder");
  refused({"check", "--video", "v.mkv", "--calibration", ""}, "--calibration: has no value", 2);
  // What would be left unread.
  refused({"simulate", "--static", "--steps", "9", "--model", "m.vtu", "--load", "l.json", "--out", "o"},
          "--steps: means nothing with --static", 2);
  refused({"prove", "live", "--out", "o", "--quick"}, "--quick: means nothing with glisson prove live", 2);
  refused({"prove", "live", "--out", "o", "--real-only", "--long"},
          "--long: means nothing with glisson prove live --real-only", 2);
  refused({"demo", "--patient", ".", "--shape", "2"}, "--shape: means nothing with --patient", 2);
}

void CommandsTest::MissingInputIsNamed() {
  refused({"import", "nothing.nii.gz", "--case", "a.glisson"}, "nothing.nii.gz");
  refused({"register", "--model", "nothing.vtu", "--cloud", "c.ply", "--out", "r.vtu"}, "nothing.vtu");
  refused({"segment", "--case", "nothing.glisson", "--seeds", "nothing.json"}, "nothing");
  refused({"demo", "--patient", "nothing"}, "nothing");
}

void CommandsTest::APlaceThatCannotBeWrittenIsRefusedBeforeTheWork() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  const QStringList command = {"register", "--model", "m.vtu", "--cloud", "c.ply", "--out"};
  // The cloud is missing too: that the place is named shows that it is looked at first.
  refused(command + QStringList{"nowhere/r.vtu"}, "nowhere/r.vtu: its folder does not exist");
  refused(command + QStringList{"."}, "is a folder");
  refused(command + QStringList{"r.vtu", "--json", "nowhere/r.json"}, "nowhere/r.json");
  refused({"segment", "--case", "a.glisson", "--seeds", "s.json", "--labels-out", "nowhere/l.nrrd"},
          "nowhere");
  refused(command + QStringList{"r.vtu", "--truth", "no_truth.xyz"}, "no_truth.xyz");
}

void CommandsTest::AnEmptyFolderIsRefused() {
  fs::create_directory(at("empty"));
  refused({"import", "empty", "--case", "a.glisson"}, "empty");
  refused({"model", "--surfaces", "empty", "--case", "a.glisson"}, "empty");
}

QTEST_GUILESS_MAIN(CommandsTest)
#include "commands_test.moc"
