// SPDX-License-Identifier: GPL-3.0-or-later
// What the program tells of the machine and of itself: doctor, log, crash report, soak.
#include <QJsonObject>
#include <QTest>

#include "glisson/core/claim.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/volume/io.h"
#include "plain_ct.h"
#include "program.h"

using namespace glisson;
using test::ball;
using test::Ran;
namespace fs = std::filesystem;

class DoctorCommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void init() { make_folder(); }
  void cleanup() { remove_folder(); }

  void DoctorTriesOutWhatThereIs();
  void ACrashLeavesAReport();
  void TheLogNamesNobody();
  void SoakLooksAtOpeningAndSaving();
  void AShortSoakIsNotCalledFlat();
  void ABrokenInstallationIsToldWhole();
  void ErrorsAreToldInThePersonsLanguage();
  void WhatAKilledRunUnpackedGoesAtTheNextStart();

 private:
  std::vector<fs::path> reports() const {
    std::vector<fs::path> all;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(state() / "crashes", none)) all.push_back(entry.path());
    return all;
  }
};

void DoctorCommandsTest::DoctorTriesOutWhatThereIs() {
  const Ran ran = run({"doctor", "--json", "d.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error + ran.out));
  const QJsonObject found = figures("d.json");
  for (const char* key :
       {"works_readers", "works_locks", "works_volumes", "works_recording", "works_drawing"})
    QVERIFY2(found[key].toInt() == 1, key);
  for (const char* key :
       {"version_glisson", "version_qt", "version_vtk", "built_with_itk", "built_with_opencv",
        "built_with_cgal", "built_with_embree", "built_with_openigtlink", "opengl_renderer", "system"})
    QVERIFY2(!found[key].toString().isEmpty(), key);
  QVERIFY2(found["video_codecs"].toString().contains("mpeg4"), qPrintable(found["video_codecs"].toString()));
  QCOMPARE(found["version_qt"].toString(), QString(qVersion()));
  QVERIFY(found["cores"].toInt() >= 1 && found["memory_gb"].toDouble() > 0.1);
  // Without a display the window cannot open: said, and no failure.
  QCOMPARE(found["display"].toInt(-1), 0);
  QVERIFY2(ran.out.contains("missing: There is no display"), qPrintable(ran.out));
}

/// Without the programs that read foreign files beside it.
void DoctorCommandsTest::ABrokenInstallationIsToldWhole() {
  const fs::path alone = at("glisson-alone");
  fs::copy_file(GLISSON_EXECUTABLE, alone);
  const auto process = prepared({"doctor", "--json", "d.json"}, QStringLiteral("C.UTF-8"));
  process->setProgram(QString::fromStdString(alone.string()));
  process->start();
  const Ran ran = end_of(*process);
  QVERIFY(ran.code != 0);
  QVERIFY2(ran.out.contains("missing: ") && ran.out.contains("Install Glisson again"), qPrintable(ran.out));
  const QJsonObject found = figures("d.json");
  QCOMPARE(found["works_readers"].toInt(-1), 0);
  QVERIFY(!found["version_qt"].toString().isEmpty() && found["works_locks"].toInt() == 1);
}

void DoctorCommandsTest::ACrashLeavesAReport() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  LabelledCloud cloud;
  cloud.points = sample_surface(boundary_surface(ball()).mesh, 400, 1);
  for (int frame = 0; frame < 200; ++frame)
    write_cloud(at(qPrintable(QString("cloud_%1.ply").arg(frame, 3, 10, QChar('0')))), cloud);
  const Ran ran = interrupted_when(
      {"track", "--model", "m.vtu", "--start", "m.vtu", "--clouds", "cloud_%03d.ply", "--homogeneous",
       "--out", "tracked"},
      [this] {
        for (const auto& entry : fs::recursive_directory_iterator(at(".")))
          if (entry.path().filename() == "registered_001.vtu") return true;
        return false;
      },
      SIGSEGV);
  QCOMPARE(ran.code, -2);  // it still ends by the signal
  QCOMPARE(reports().size(), std::size_t{1});
  QCOMPARE(static_cast<int>(fs::status(reports()[0]).permissions()), 0600);
  const QString report = QString::fromStdString(read_file(reports()[0]));
  QVERIFY2(report.contains("signal SIGSEGV") && report.contains("doing track"), qPrintable(report));
  QVERIFY2(report.count("[0x") >= 5, qPrintable(report));  // the stack
  QVERIFY2(!report.contains("m.vtu") && !report.contains("cloud"), qPrintable(report));
  QVERIFY2(ran.error.contains(QString::fromStdString(reports()[0].string())), qPrintable(ran.error));
}

void DoctorCommandsTest::TheLogNamesNobody() {
  test::write_plain_ct(at("Anna Smith 1970.nrrd"));
  QCOMPARE(run({"import", "Anna Smith 1970.nrrd", "--case", "anna.glisson"}).code, 0);
  test::write_text(at("anna smith.nrrd"), "no volume");
  QCOMPARE(run({"import", "anna smith.nrrd", "--replace", "--case", "anna.glisson"}).code, 1);
  const QString log = QString::fromStdString(read_file(state() / "log/glisson.log"));
  QVERIFY2(log.contains("import_image done") && log.contains("save_case done"), qPrintable(log));
  QVERIFY2(log.contains("error import_image"), qPrintable(log));
  QVERIFY2(!log.contains("anna", Qt::CaseInsensitive) && !log.contains("smith", Qt::CaseInsensitive) &&
               !log.contains("1970"),
           qPrintable(log));
}

void DoctorCommandsTest::SoakLooksAtOpeningAndSaving() {
  // AddressSanitizer keeps what is freed, up to this much: nothing would be flat.
  qputenv("ASAN_OPTIONS", qgetenv("ASAN_OPTIONS") + ":quarantine_size_mb=0");
  test::write_plain_ct(at("ct.nrrd"));
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
  const Ran ran = run({"soak", "--case", "a.glisson", "--frames", "0", "--edits", "0", "--opens", "12",
                       "--kills", "6", "--json", "s.json", "--page", "soak.md"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error + ran.out));
  const QJsonObject found = figures("s.json");
  QCOMPARE(found["soak_opens_and_saves"].toInt(), 12);
  QCOMPARE(found["soak_opens_and_saves_flat"].toInt(), 1);
  QCOMPARE(found["kill_times"].toInt(), 6);
  QCOMPARE(found["kill_broken"].toInt(-1), 0);
  QCOMPARE(found["kill_left"].toInt(-1), 0);
  QVERIFY(read_file(at("soak.md")).find("| opens_and_saves | 12 |") != std::string::npos);
}

void DoctorCommandsTest::AShortSoakIsNotCalledFlat() {
  test::write_plain_ct(at("ct.nrrd"));
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
  const Ran ran = run({"soak", "--case", "a.glisson", "--frames", "0", "--edits", "0", "--opens", "2",
                       "--json", "s.json", "--page", "soak.md"});
  QCOMPARE(ran.code, 1);
  const QJsonObject found = figures("s.json");
  QCOMPARE(found["soak_opens_and_saves_long_enough"].toInt(-1), 0);
  QCOMPARE(found["soak_opens_and_saves_flat"].toInt(-1), 0);
  QVERIFY(read_file(at("soak.md")).find("too short to say") != std::string::npos);
}

void DoctorCommandsTest::ErrorsAreToldInThePersonsLanguage() {
  const Ran german = run({"import", "none.nrrd", "--case", "a.glisson"}, "de_DE.UTF-8");
  QCOMPARE(german.code, 1);
  QVERIFY2(german.error.contains("none.nrrd: gibt es nicht. Prüfen Sie den Pfad."), qPrintable(german.error));
  const Ran french = run({"import", "none.nrrd", "--case", "a.glisson"}, "fr_FR.UTF-8");
  QVERIFY2(french.error.contains("none.nrrd : n’existe pas. Vérifiez le chemin."), qPrintable(french.error));
}

void DoctorCommandsTest::WhatAKilledRunUnpackedGoesAtTheNextStart() {
  test::write_plain_ct(at("ct.nrrd"));
  // As a killed run leaves them: nobody holds them.
  const fs::path work = work_folder();
  fs::path left;
  {
    Claim claim;
    left = Claim::make_folder(work, claim);
    test::write_text(left / "slice.dcm", "a patient's");
  }
  const TemporaryFolder used;  // by a program that runs
  QCOMPARE(run({"import", "ct.nrrd", "--case", "a.glisson"}).code, 0);
  QVERIFY(!fs::exists(left));
  QVERIFY(fs::exists(used.path()));
}

QTEST_GUILESS_MAIN(DoctorCommandsTest)
#include "doctor_commands_test.moc"
