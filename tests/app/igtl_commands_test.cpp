// SPDX-License-Identifier: GPL-3.0-or-later
// What 'glisson track --igtl-send' tells a peer made with the library, against what it writes itself.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <cmath>

#include "../openigtlink/peer_process.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/stereo/calibration_io.h"
#include "program.h"

using namespace glisson;
using test::ball;
using test::bent;

namespace {

/// camera_from_model of each frame in frames.jsonl, millimetres.
std::map<int, Eigen::Matrix4d> poses_in(const std::string& lines) {
  std::map<int, Eigen::Matrix4d> poses;
  for (const QByteArray& line : QByteArray::fromStdString(lines).split('\n')) {
    const QJsonObject frame = QJsonDocument::fromJson(line).object();
    const QJsonArray rows = frame["camera_from_model"].toArray();
    if (rows.size() != 4) continue;
    Eigen::Matrix4d pose;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column) pose(row, column) = rows[row].toArray()[column].toDouble();
    poses[frame["frame"].toInt()] = pose;
  }
  return poses;
}

}  // namespace

class IgtlCommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void init() { make_folder(); }
  void cleanup() { remove_folder(); }

  void TrackTellsAPeerWhatItWrites();
  void WithoutTheOptionNothingListens();
  void WhatCannotBeListenedAtIsRefused();
  void CheckOpensALiveSourceOnce();

 private:
  /// A bent ball in clouds 3 to 5, and the words that follow them.
  QStringList track_words() const;
};

QStringList IgtlCommandsTest::track_words() const {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  for (int frame = 3; frame < 6; ++frame) {
    TriangleMesh surface = boundary_surface(mesh).mesh;
    surface.vertices = bent(surface.vertices, 0.002 * (frame - 2));
    LabelledCloud cloud;
    cloud.points = sample_surface(surface, 600, static_cast<unsigned>(frame));
    write_cloud(at(("cloud_0" + std::to_string(frame) + ".ply").c_str()), cloud);
  }
  return {"track",    "--model",        "m.vtu",         "--start", "m.vtu",
          "--clouds", "cloud_%02d.ply", "--homogeneous", "--out",   "tracked"};
}

void IgtlCommandsTest::TrackTellsAPeerWhatItWrites() {
  const auto process = start(track_words() << "--igtl-send"
                                           << "127.0.0.1:0"
                                           << "--igtl-wait",
                             QStringLiteral("C.UTF-8"));
  QRegularExpressionMatch port;
  QByteArray said;
  while (!port.hasMatch() && (process->canReadLine() || process->waitForReadyRead(60000))) {
    said += process->readLine();
    port = QRegularExpression("listening at 127\\.0\\.0\\.1:(\\d+)\\.").match(said);
  }
  QVERIFY2(port.hasMatch(), said.constData());
  PeerProcess peer({"listen", port.captured(1)});
  const QList<Words> lines = peer.all();  // until it ends
  QVERIFY(process->waitForFinished(60000));
  QVERIFY2(process->exitCode() == 0, process->readAllStandardError().constData());

  const std::map<int, Eigen::Matrix4d> poses = poses_in(read_file(at("tracked/frames.jsonl")));
  QCOMPARE(poses.size(), std::size_t{3});
  int frame = -1, compared = 0, surfaces = 0;
  for (const Words& words : lines) {
    if (words.value(0) == "STRING") frame = words.value(5).section('=', 1).toInt();
    surfaces += words.value(0) == "POLYDATA" && words.value(3).toInt() > 100;
    if (words.value(0) != "TRANSFORM") continue;
    Eigen::Matrix4d told;
    for (int i = 0; i < 16; ++i) told(i / 4, i % 4) = words.value(3 + i).toDouble();
    Eigen::Matrix4d expected = poses.at(frame).inverse();
    expected.topRows<2>() *= -1.0;
    QVERIFY2((told - expected).cwiseAbs().maxCoeff() < 1e-3, qPrintable(words.join(' ')));
    ++compared;
  }
  QVERIFY(compared >= 1 && surfaces >= 1);
  QCOMPARE(lines.back().value(0), QString("POLYDATA"));  // nothing is left on the screen
  QCOMPARE(lines.back().value(3).toInt(), 0);
}

void IgtlCommandsTest::WithoutTheOptionNothingListens() {
  const test::Ran ran = run(track_words());
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY(!ran.out.contains("OpenIGTLink"));
}

void IgtlCommandsTest::WhatCannotBeListenedAtIsRefused() {
  const QStringList words = track_words();
  refused(words + QStringList{"--igtl-send", "plus.example.org:18944"}, "numeric address");
  refused(words + QStringList{"--igtl-send", "192.0.2.1:18944"}, "192.0.2.1");  // of no computer
  refused(words + QStringList{"--igtl-wait"}, "--igtl-send", 2);
}

/// A camera can be opened by one program, once.
void IgtlCommandsTest::CheckOpensALiveSourceOnce() {
  PeerProcess server({"serve", "brief"});
  const QString port = server.wait_for([](const Words& words) { return words.value(0) == "port"; }).value(1);
  const std::string source = "igtl:127.0.0.1:" + port.toStdString() + "/Left,Right";
  std::filesystem::create_directories(state());
  test::write_text(state() / "known_sources", source + "\n");
  test::write_text(at("cut.json"), R"({"left": ")" + source + R"(", "crop": [2, 2, 60, 44]})");
  StereoRig rig;
  rig.left.width = 64, rig.left.height = 48;
  rig.left.matrix << 60, 0, 32, 0, 60, 24, 0, 0, 1;
  rig.right = rig.left;
  rig.right_from_left.translation = {-0.005, 0.0, 0.0};
  stereo::write_calibration(at("c.yaml"), rig);
  const test::Ran ran = run({"check", "--video", "cut.json", "--calibration", "c.yaml"});
  QVERIFY2(ran.out.contains("frames "), qPrintable(ran.error + ran.out));
  int clients = 0;
  while (!server.look_for([](const Words& words) { return words.value(0) == "client"; }).isEmpty()) ++clients;
  QCOMPARE(clients, 1);
}

QTEST_GUILESS_MAIN(IgtlCommandsTest)
#include "igtl_commands_test.moc"
