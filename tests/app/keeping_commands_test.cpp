// SPDX-License-Identifier: GPL-3.0-or-later
// What the program writes harms nothing, what is cut short is kept and marked, and messages name files.
#include <sys/stat.h>

#include <QCoreApplication>
#include <QJsonDocument>
#include <QTest>

#include <QJsonArray>
#include <algorithm>

#include "glisson/engine/commands/open_case.h"
#include "glisson/engine/script.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "glisson/volume/io.h"
#include "program.h"

using namespace glisson;
using test::ball;
using test::Ran;
using test::rig;
using test::write_text;
namespace fs = std::filesystem;

class KeepingCommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void init() { make_folder(); }
  void cleanup() { remove_folder(); }

  void FiguresAreNotWrittenOverADevice();
  void FiguresGoThroughALink();
  void ALoopOfLinksIsNamed();
  void ACaseThatAnotherHasOpenIsNotEdited();
  void ForeignFilesInAnOutputFolderStay();
  void AnOutputFolderReplacesNoDeviceAndNoLink();
  void ReconstructNamesThePictures();
  void EachFrameOfATrackIsMarked();
  void ATrackThatIsCutShortKeepsWhatWasDone();
  void ATerminalThatIsClosedCutsATrackShortToo();

 private:
  void make_case() {
    Image image;
    image.grid.size = {12, 12, 12};
    image.grid.spacing_mm = {1.0, 1.0, 1.0};
    image.voxels = std::make_shared<std::vector<std::int16_t>>(12UL * 12 * 12, std::int16_t{50});
    write_image(at("ct.nrrd"), image);
    const Ran ran = run({"import", "ct.nrrd", "--case", "a.glisson"});
    QVERIFY2(ran.code == 0, qPrintable(ran.error));
  }
  void make_clouds(int count, unsigned points) {
    write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
    for (int frame = 0; frame < count; ++frame) {
      LabelledCloud cloud;
      cloud.points = sample_surface(boundary_surface(ball()).mesh, points, static_cast<unsigned>(frame));
      write_cloud(at(qPrintable(QString("cloud_%1.ply").arg(frame, 3, 10, QChar('0')))), cloud);
    }
  }
  std::vector<QJsonObject> lines(const char* name) const {
    std::vector<QJsonObject> all;
    for (const QByteArray& line : QByteArray::fromStdString(read_file(at(name))).split('\n'))
      if (!line.isEmpty()) all.push_back(QJsonDocument::fromJson(line).object());
    return all;
  }
  /// Wherever it is made.
  bool third_mesh_is_there() const {
    for (const auto& entry : fs::recursive_directory_iterator(at(".")))
      if (entry.path().filename() == "registered_002.vtu") return true;
    return false;
  }
  const QStringList track_ = {"track",          "--model",       "m.vtu", "--start", "m.vtu",  "--clouds",
                              "cloud_%03d.ply", "--homogeneous", "--out", "tracked", "--json", "t.json"};
};

void KeepingCommandsTest::FiguresAreNotWrittenOverADevice() {
  make_case();
  const QStringList command = {"import", "ct.nrrd", "--case", "a.glisson", "--json"};
  refused(command + QStringList{"/dev/full"}, "/dev/full: is a device");
  QCOMPARE(::mkfifo(at("pipe").c_str(), 0600), 0);
  refused(command + QStringList{"pipe"}, "pipe: is a device or a pipe");
  QVERIFY(fs::is_character_file("/dev/full") && fs::is_fifo(at("pipe")));
}

void KeepingCommandsTest::FiguresGoThroughALink() {
  make_case();
  fs::create_directory(at("figures"));
  fs::create_symlink("figures/f.json", at("link.json"));
  const Ran ran = run({"import", "ct.nrrd", "--replace", "--case", "a.glisson", "--json", "link.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY(fs::is_symlink(at("link.json")) && figures("figures/f.json").contains("seconds"));
}

void KeepingCommandsTest::ALoopOfLinksIsNamed() {
  fs::create_symlink("b.glisson", at("a.glisson"));
  fs::create_symlink("a.glisson", at("b.glisson"));
  for (const QStringList& command :
       {QStringList{"edit", "--case", "a.glisson", "--undo", "1"},
        {"import", "a.glisson", "--case", "c.glisson"},
        {"register", "--model", "a.glisson", "--cloud", "c.ply", "--out", "r.vtu"},
        {"reconstruct", "--left", "a.glisson", "--right", "b.glisson", "--calibration", "a.glisson", "--out",
         "c.ply"}}) {
    const Ran ran = run(command);
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.error.contains("a.glisson") && !ran.error.contains("filesystem error"),
             qPrintable(ran.error));
    QVERIFY2(ran.error.trimmed().count('\n') == 0, qPrintable(ran.error));
  }
}

void KeepingCommandsTest::ACaseThatAnotherHasOpenIsNotEdited() {
  make_case();
  engine::Script window{RunContext()};
  window.run(engine::OpenCase{at("a.glisson")});
  refused({"import", "ct.nrrd", "--case", "a.glisson"}, "is open for writing by", 1);
  refused({"edit", "--case", "a.glisson", "--undo", "1"},
          QString("process %1").arg(QCoreApplication::applicationPid()), 1);
}

void KeepingCommandsTest::ForeignFilesInAnOutputFolderStay() {
  make_clouds(1, 300);
  fs::create_directory(at("tracked"));
  write_text(at("tracked/letter.txt"), "Dear colleague");
  const Ran ran = run(track_);
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(read_file(at("tracked/letter.txt")), std::string("Dear colleague"));
  QVERIFY(fs::exists(at("tracked/registered_000.vtu")));
}

void KeepingCommandsTest::ReconstructNamesThePictures() {
  stereo::write_calibration(at("c.yaml"), rig());
  const Picture black{320, 240, 3, std::make_shared<std::vector<std::uint8_t>>(320UL * 240 * 3)};
  stereo::write_picture(at("l.png"), black);
  stereo::write_picture(at("r.png"), black);
  refused({"reconstruct", "--left", "l.png", "--right", "r.png", "--calibration", "c.yaml", "--out", "c.ply"},
          "l.png, r.png: ");
}

void KeepingCommandsTest::EachFrameOfATrackIsMarked() {
  make_clouds(3, 400);
  LabelledCloud elsewhere;  // half a metre away: it cannot be followed
  elsewhere.points = sample_surface(boundary_surface(ball()).mesh, 400, 7);
  elsewhere.points.rowwise() += Eigen::RowVector3d(0.5, 0.0, 0.0);
  write_cloud(at("cloud_002.ply"), elsewhere);
  const Ran ran = run(track_);
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  const std::vector<QJsonObject> frames = lines("tracked/frames.jsonl");
  QCOMPARE(frames.size(), std::size_t{4});
  QVERIFY(frames.back()["complete"].toBool() && frames.back()["frames"].toInt() == 3);
  QVERIFY(!fs::exists(at("tracked/INCOMPLETE")));
  int withdrawn = 0;
  for (int n = 0; n < 3; ++n) {
    const QJsonObject& frame = frames[static_cast<std::size_t>(n)];
    QCOMPARE(frame["frame"].toInt(), n);
    const std::string level = frame["level"].toString().toStdString(),
                      reason = frame["reason"].toString().toStdString();
    QVERIFY(!level.empty() && !reason.empty());
    withdrawn += level == "withdrawn";
    if (frame["mesh"].isNull()) continue;
    const TetFile mesh =
        read_tet_file(at("tracked") / frame["mesh"].toString().toStdString(), LengthUnit::millimetre);
    QCOMPARE(mesh.field_data.at("frame")(0, 0), static_cast<double>(n));
    QVERIFY(mesh.field_data.contains("level_" + level) && mesh.field_data.contains("reason_" + reason));
    const auto levels = std::count_if(mesh.field_data.begin(), mesh.field_data.end(),
                                      [](const auto& field) { return field.first.starts_with("level_"); });
    QCOMPARE(levels, std::ptrdiff_t{1});
    // The pose is that of the mesh: its nodes' centre is where the pose puts the model's.
    const QJsonArray rows = frame["camera_from_model"].toArray();
    const Eigen::RowVector3d centre = 1e3 * ball().vertices.colwise().mean(),
                             there = 1e3 * mesh.mesh.vertices.colwise().mean();
    for (int i = 0; i < 3; ++i) {
      const QJsonArray row = rows[i].toArray();
      double placed = row[3].toDouble();
      for (int k = 0; k < 3; ++k) placed += row[k].toDouble() * centre[k];
      QVERIFY2(std::abs(placed - there[i]) < 1e-3, qPrintable(QString::number(placed - there[i])));
    }
  }
  QCOMPARE(figures("t.json")["frames_withdrawn"].toInt(), withdrawn);
  QVERIFY(withdrawn > 0 && !frames[2]["mesh"].isNull());  // the last one is, and its mesh says so
  QVERIFY(figures("t.json")["complete"].toInt() == 1);
}

void KeepingCommandsTest::ATrackThatIsCutShortKeepsWhatWasDone() {
  make_clouds(200, 400);
  const Ran ran = interrupted_when(track_, [this] { return third_mesh_is_there(); });
  QCOMPARE(ran.code, 130);
  QVERIFY2(ran.error.contains("marked as incomplete"), qPrintable(ran.error));
  QVERIFY(fs::exists(at("tracked/INCOMPLETE")) && fs::exists(at("tracked/registered_002.vtu")));
  const std::vector<QJsonObject> frames = lines("tracked/frames.jsonl");
  QVERIFY(!frames.back()["complete"].toBool(true));
  const int done = frames.back()["frames"].toInt();
  QVERIFY(done >= 3 && done < 200);
  QCOMPARE(frames.size(), static_cast<std::size_t>(done) + 1);
  QCOMPARE(figures("t.json")["complete"].toInt(-1), 0);
  QCOMPARE(figures("t.json")["frames"].toInt(), done);
  // A whole run takes the mark away.
  for (int frame = 2; frame < 200; ++frame)
    fs::remove(at(qPrintable(QString("cloud_%1.ply").arg(frame, 3, 10, QChar('0')))));
  write_text(at("tracked/registered_900.vtu"), "another's");
  // Nor does a list that somebody has written remove what is no mesh of a frame.
  write_text(at("tracked/thesis.odt"), "another's");
  std::string list = read_file(at("tracked/frames.jsonl"));
  const std::string mesh = "registered_000.vtu";
  QVERIFY(list.find(mesh) != std::string::npos);
  write_text(at("tracked/frames.jsonl"), list.replace(list.find(mesh), mesh.size(), "thesis.odt").c_str());
  QCOMPARE(run(track_).code, 0);
  QCOMPARE(read_file(at("tracked/thesis.odt")), std::string("another's"));
  QVERIFY(!fs::exists(at("tracked/INCOMPLETE")));
  // So do meshes of frames that the new run has not got, and no others.
  QVERIFY(fs::exists(at("tracked/registered_001.vtu")) && !fs::exists(at("tracked/registered_002.vtu")));
  QCOMPARE(read_file(at("tracked/registered_900.vtu")), std::string("another's"));
}

/// But not where the person has said that it does not matter (nohup). The program inherits what is done here.
void KeepingCommandsTest::ATerminalThatIsClosedCutsATrackShortToo() {
  make_clouds(200, 400);
  const auto hung_up = [this] {
    return interrupted_when(
        track_, [this] { return third_mesh_is_there(); }, SIGHUP);
  };
  const auto before = std::signal(SIGHUP, SIG_DFL);
  const Ran closed = hung_up();
  QCOMPARE(closed.code, 130);
  QVERIFY2(closed.error.contains("marked as incomplete"), qPrintable(closed.error));
  QVERIFY(fs::exists(at("tracked/INCOMPLETE")) && fs::exists(at("tracked/registered_002.vtu")));
  const std::vector<QJsonObject> frames = lines("tracked/frames.jsonl");
  const int done = frames.back()["frames"].toInt();
  QVERIFY(!frames.back()["complete"].toBool(true));
  QVERIFY(done >= 3 && done < 200);
  QCOMPARE(frames.size(), static_cast<std::size_t>(done) + 1);

  fs::remove_all(at("tracked"));
  for (int frame = 12; frame < 200; ++frame)
    fs::remove(at(qPrintable(QString("cloud_%1.ply").arg(frame, 3, 10, QChar('0')))));
  std::signal(SIGHUP, SIG_IGN);
  const Ran detached = hung_up();
  std::signal(SIGHUP, before);
  QVERIFY2(detached.code == 0, qPrintable(detached.error));
  QVERIFY(!fs::exists(at("tracked/INCOMPLETE")) && fs::exists(at("tracked/registered_011.vtu")));
}

void KeepingCommandsTest::AnOutputFolderReplacesNoDeviceAndNoLink() {
  make_clouds(1, 300);
  fs::create_directory(at("tracked"));
  QCOMPARE(::mkfifo(at("tracked/frames.jsonl").c_str(), 0600), 0);
  refused(track_, "frames.jsonl: is a device or a pipe", 1);
  QVERIFY(fs::is_fifo(at("tracked/frames.jsonl")) && !fs::exists(at("tracked/registered_000.vtu")));
  fs::remove(at("tracked/frames.jsonl"));
  fs::create_symlink("../elsewhere.jsonl", at("tracked/frames.jsonl"));
  const Ran ran = run(track_);
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY(fs::is_symlink(at("tracked/frames.jsonl")) && fs::exists(at("elsewhere.jsonl")));
}

QTEST_GUILESS_MAIN(KeepingCommandsTest)
#include "keeping_commands_test.moc"
