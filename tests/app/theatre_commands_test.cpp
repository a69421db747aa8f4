// SPDX-License-Identifier: GPL-3.0-or-later
// A model in the theatre on the command line: register, track, simulate.
#include <QJsonObject>
#include <QRegularExpression>
#include <QTest>

#include <cmath>
#include <random>

#include "glisson/core/random.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/mesh_io.h"
#include "glisson/geometry/topology.h"
#include "glisson/patient/labelled_cloud.h"
#include "glisson/stereo/calibration_io.h"
#include "glisson/stereo/picture_io.h"
#include "program.h"

using namespace glisson;
using test::ball;
using test::bent;
using test::Ran;
using test::rig;
using test::write_text;
namespace fs = std::filesystem;

class TheatreCommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void init() { make_folder(); }
  void cleanup() { remove_folder(); }

  void ACloudWithNanIsRefused();
  void AMeshDamagedOnItsWayIsRefusedInOneSentence();
  void AMeshWithInvertedTetrahedraIsRefused();
  void ALiverOfAHundredMetresIsRefusedWithTheUnit();
  void ACloudInAnotherUnitIsRefusedWithTheUnit();
  void AVideoThatEndsEarlyIsRecognised();
  void RegisterFindsAKnownDeformationAndKeepsTheNodeOrder();
  void ARefusedRegistrationWritesNothingUnlessItIsAccepted();
  void AnotherPlaceIsTakenWhereAPersonSaysSo();
  void ASurfaceComesBackAsThatSurface();
  void TrackWritesOneMeshACloud();
  void ATruthThatCannotBeComparedTakesNothingAlong();
  void SimulateWritesItsSteps();
  void StiffnessTravelsWithTheCaseAndIsSaidAnew();
};

void TheatreCommandsTest::ACloudWithNanIsRefused() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  write_text(at("c.ply"),
             "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float "
             "z\nend_header\n1 2 3\n1 nan 3\n");
  refused({"register", "--model", "m.vtu", "--cloud", "c.ply", "--out", "r.vtu"}, "c.ply");
}

void TheatreCommandsTest::AMeshDamagedOnItsWayIsRefusedInOneSentence() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  std::string content = read_file(at("m.vtu"));
  const std::size_t type = content.find("Float64");
  QVERIFY(type != std::string::npos);
  content.replace(type, 7, "Flout64");  // VTK has much to say on that
  write_text(at("m.vtu"), content);
  refused({"register", "--model", "m.vtu", "--cloud", "c.ply", "--out", "r.vtu"}, "m.vtu");
}

void TheatreCommandsTest::AMeshWithInvertedTetrahedraIsRefused() {
  TetMesh mesh = ball(2);
  std::string vtk = "# vtk DataFile Version 3.0\nmesh\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                    std::to_string(mesh.vertex_count()) + " double\n";
  for (int i = 0; i < mesh.vertex_count(); ++i)
    vtk += std::to_string(1e3 * mesh.vertices(i, 0)) + " " + std::to_string(1e3 * mesh.vertices(i, 1)) + " " +
           std::to_string(1e3 * mesh.vertices(i, 2)) + "\n";
  std::swap(mesh.tetrahedra(3, 0), mesh.tetrahedra(3, 1));
  vtk += "CELLS " + std::to_string(mesh.tetrahedron_count()) + " " +
         std::to_string(5 * mesh.tetrahedron_count()) + "\n";
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
    vtk += "4";
    for (int k = 0; k < 4; ++k) vtk += " " + std::to_string(mesh.tetrahedra(t, k));
    vtk += "\n";
  }
  vtk += "CELL_TYPES " + std::to_string(mesh.tetrahedron_count()) + "\n";
  for (int t = 0; t < mesh.tetrahedron_count(); ++t) vtk += "10\n";
  write_text(at("m.vtk"), vtk);
  refused({"register", "--model", "m.vtk", "--cloud", "c.ply", "--out", "r.vtu"}, "tetrahedron 3");
}

void TheatreCommandsTest::ALiverOfAHundredMetresIsRefusedWithTheUnit() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  refused({"register", "--model", "m.vtu", "--unit", "m", "--cloud", "c.ply", "--out", "r.vtu"}, "mm");
}

void TheatreCommandsTest::ACloudInAnotherUnitIsRefusedWithTheUnit() {
  write_tet_mesh(at("m.vtu"), ball(), LengthUnit::millimetre);
  LabelledCloud cloud;
  cloud.points = sample_surface(boundary_surface(ball()).mesh, 100, 4);
  write_cloud(at("c.ply"), cloud);
  refused({"register", "--model", "m.vtu", "--cloud", "c.ply", "--cloud-unit", "m", "--out", "r.vtu"},
          "Read it in mm");
  write_cloud(at("c.ply"), cloud, LengthUnit::metre);
  refused({"register", "--model", "m.vtu", "--cloud", "c.ply", "--out", "r.vtu"}, "Read it in m.");
}

void TheatreCommandsTest::AVideoThatEndsEarlyIsRecognised() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  TetMesh placed = mesh;
  placed.vertices.rowwise() += Eigen::RowVector3d(0.0, 0.0, 0.15);
  write_tet_mesh(at("start.vtu"), placed, LengthUnit::millimetre);
  stereo::write_calibration(at("c.yaml"), rig());
  {
    stereo::VideoWriter writer(at("whole.mkv"), 640, 240, 30.0);
    Picture picture{640, 240, 3, nullptr};
    for (int i = 0; i < 60; ++i) {
      auto bytes = std::make_shared<std::vector<std::uint8_t>>(640UL * 240 * 3);
      for (std::size_t b = 0; b < bytes->size(); ++b)
        (*bytes)[b] =
            static_cast<std::uint8_t>((b * 2654435761UL + static_cast<std::size_t>(i) * 40503UL) >> 13);
      picture.bytes = bytes;
      writer.write(picture);
    }
    writer.close();
  }
  const QStringList track = {"track",     "--model",       "m.vtu",  "--start", "start.vtu", "--video",
                             "whole.mkv", "--calibration", "c.yaml", "--out",   "tracked"};
  refused(track + QStringList{"--mask", "none.png"}, "none.png");
  stereo::write_picture(
      at("small.png"),
      {160, 120, 1, std::make_shared<std::vector<std::uint8_t>>(19200UL, std::uint8_t{255})});
  refused(track + QStringList{"--mask", "small.png"}, "160x120");
  refused(track + QStringList{"--correct", "none.jsonl"}, "none.jsonl");
  write_text(at("late.jsonl"), R"({"frame": 60, "correct": "undo"})");
  refused(track + QStringList{"--correct", "late.jsonl"}, "frame 60");
  refused(track + QStringList{"--register-again", "0.2"}, "--register-again", 2);
  refused(track + QStringList{"--cloud", "c.ply"}, "without --register-again", 2);
  refused(track + QStringList{"--register-again", "5", "--cloud", "none.ply"}, "none.ply");
  refused({"track", "--model", "m.vtu", "--start", "start.vtu", "--clouds", "c%d.ply", "--register-again",
           "5", "--out", "tracked"},
          "needs pictures", 2);
  const std::string whole = read_file(at("whole.mkv"));
  write_text(at("cut.mkv"), whole.substr(0, whole.size() * 3 / 5));
  fs::remove(at("whole.mkv"));
  const Ran cut = run({"track", "--model", "m.vtu", "--start", "start.vtu", "--video", "cut.mkv",
                       "--calibration", "c.yaml", "--out", "tracked"});
  QCOMPARE(cut.code, 1);
  QVERIFY2(cut.error.contains("cut.mkv"), qPrintable(cut.error));
  QVERIFY(fs::exists(at("tracked/INCOMPLETE")));  // what was finished stays, and says so
}

void TheatreCommandsTest::RegisterFindsAKnownDeformationAndKeepsTheNodeOrder() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  const Points truth = bent(mesh.vertices, 0.012);
  write_node_list(at("truth.xyz"), truth, LengthUnit::millimetre);
  TriangleMesh deformed = boundary_surface(mesh).mesh;
  deformed.vertices = bent(deformed.vertices, 0.012);
  LabelledCloud cloud;
  cloud.points = sample_surface(deformed, 900, 4);
  write_cloud(at("c.ply"), cloud);
  const Ran ran = run({"register", "--model", "m.vtu", "--cloud", "c.ply", "--rigid", "none", "--homogeneous",
                       "--truth", "truth.xyz", "--report", "r.html", "--out", "r.vtu", "--json", "r.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  const std::string page = read_file(at("r.html"));
  for (const char* said : {"m.vtu, c.ply", "Expected error", "All nodes, mean", "expected_error_mean_mm"})
    QVERIFY2(page.find(said) != std::string::npos, said);
  const QJsonObject json = figures("r.json");
  for (const char* key : {"tre_volume_mean_mm", "tre_volume_max_mm", "tre_surface_mean_mm",
                          "tre_target_mean_mm", "displacement_mean_mm", "seconds"})
    QVERIFY2(json.contains(key), key);
  QVERIFY(json["tre_target_mean_mm"].isNull());  // no lesions: unknown, not zero
  const double before = 1e3 * point_errors(mesh.vertices, truth).mean;
  QVERIFY2(
      json["tre_volume_mean_mm"].toDouble() < 0.4 * before,
      qPrintable(QString::number(json["tre_volume_mean_mm"].toDouble()) + " of " + QString::number(before)));
  const TetFile result = read_tet_file(at("r.vtu"), LengthUnit::millimetre);
  QVERIFY(result.mesh.tetrahedra == mesh.tetrahedra);
  const double error = 1e3 * point_errors(result.mesh.vertices, truth).mean;
  QVERIFY(std::abs(error - json["tre_volume_mean_mm"].toDouble()) < 1e-3);
  QVERIFY(result.field_data.at("cloud_from_model").isApprox(Eigen::MatrixXd::Identity(4, 4)));
}

void TheatreCommandsTest::ARefusedRegistrationWritesNothingUnlessItIsAccepted() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  LabelledCloud cloud;
  cloud.points = sample_surface(boundary_surface(mesh).mesh, 900, 4);
  std::mt19937_64 random(5);
  for (Eigen::Index i = 0; i < cloud.points.size(); ++i)
    cloud.points.data()[i] += 12e-3 * standard_normal(random);
  write_cloud(at("noisy.ply"), cloud);
  refused({"register", "--model", "m.vtu", "--vertices", "300", "--cloud", "noisy.ply", "--out", "r.vtu"},
          "--vertices", 2);
  refused({"model", "--surfaces", "s", "--edge", "12", "--vertices", "900", "--case", "a.glisson"},
          "--vertices", 2);
  const QStringList command = {"register", "--model", "m.vtu", "--cloud",    "noisy.ply",
                               "--rigid",  "none",    "--out", "refused.vtu"};
  const Ran ran = run(command);
  QCOMPARE(ran.code, 3);
  QVERIFY(!fs::exists(at("refused.vtu")));
  QVERIFY2(ran.out.contains("--accept-doubts"), qPrintable(ran.out));
  const Ran accepted = run(command + QStringList{"--accept-doubts", "--json", "accepted.json"});
  QVERIFY2(accepted.code == 0, qPrintable(accepted.error));
  const QJsonObject json = figures("accepted.json");
  QCOMPARE(json["registration_ended"].toString(), QString("converged"));
  QCOMPARE(json["registration_refused"].toDouble(), 0.0);
  QStringList notes = accepted.out.split('\n').filter(QRegularExpression("^note: "));
  QVERIFY(!notes.isEmpty());
  QCOMPARE(notes.removeDuplicates(), qsizetype{0});
  // So much noise turns elements inside out.
  QVERIFY(tetrahedron_volumes(read_tet_mesh(at("refused.vtu"), LengthUnit::millimetre, MeshShape::deformed))
              .minCoeff() < 0.0);
  const std::string written = read_file(at("refused.vtu"));
  QVERIFY(written.find("doubt_refusal_accepted") != std::string::npos);
  QVERIFY(written.find("doubt_cloud_noisy") != std::string::npos);
}

/// Turned by half a turn about an axis, the ball explains its own points as well.
void TheatreCommandsTest::AnotherPlaceIsTakenWhereAPersonSaysSo() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  LabelledCloud cloud;
  cloud.points =
      sample_surface(boundary_surface(mesh).mesh, 900, 4).rowwise() + Eigen::RowVector3d(0, 0, 0.2);
  write_cloud(at("c.ply"), cloud);
  const QStringList command = {"register", "--model", "m.vtu", "--cloud", "c.ply", "--homogeneous"};
  refused(command + QStringList{"--out", "r.vtu", "--rival", "0"}, "--rival 0", 2);
  refused(command + QStringList{"--out", "r.vtu", "--rival", "9"}, "other places, not 9");
  const QStringList accepted = command + QStringList{"--accept-doubts"};
  const Ran first = run(accepted + QStringList{"--out", "first.vtu", "--json", "first.json"});
  QVERIFY2(first.code == 0, qPrintable(first.error));
  const QJsonObject told = figures("first.json");
  QVERIFY(told["rivals"].toInt() > 0 && told["rival_1_away_mm"].toDouble() > 20.0);
  const Ran other = run(accepted + QStringList{"--rival", "1", "--out", "other.vtu", "--json", "other.json"});
  QVERIFY2(other.code == 0, qPrintable(other.error));
  QVERIFY2(other.out.contains("A person has chosen this place") && !first.out.contains("A person has chosen"),
           qPrintable(other.out));
  // The mesh is where that place was said to be, and the first place is one of the others now.
  const auto nodes = [this](const char* name) {
    return read_tet_mesh(at(name), LengthUnit::millimetre, MeshShape::deformed).vertices;
  };
  const double away = 1e3 * point_errors(nodes("first.vtu"), nodes("other.vtu")).mean;
  QVERIFY2(std::abs(away - told["rival_1_away_mm"].toDouble()) < 1e-3, qPrintable(QString::number(away)));
  const QJsonObject then = figures("other.json");
  bool is_other = false;
  for (int k = 1; k <= then["rivals"].toInt(); ++k)
    is_other = is_other || std::abs(then[QString("rival_%1_away_mm").arg(k)].toDouble() - away) < 1e-3;
  QVERIFY(is_other);
}

void TheatreCommandsTest::ASurfaceComesBackAsThatSurface() {
  const TriangleMesh surface = boundary_surface(ball(8)).mesh;
  write_triangle_mesh(at("s.vtp"), surface, LengthUnit::millimetre);
  TriangleMesh deformed = surface;
  deformed.vertices = bent(surface.vertices, 0.010);
  LabelledCloud cloud;
  cloud.points = sample_surface(deformed, 900, 4);
  write_cloud(at("c.ply"), cloud);
  const Ran ran = run({"register", "--model", "s.vtp", "--vertices", "300", "--cloud", "c.ply", "--rigid",
                       "none", "--out", "r.vtp"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  const TriangleMesh back = read_triangle_mesh(at("r.vtp"), LengthUnit::millimetre);
  QVERIFY(back.triangles == surface.triangles);
  QVERIFY(point_errors(back.vertices, deformed.vertices).mean <
          0.6 * point_errors(surface.vertices, deformed.vertices).mean);
}

void TheatreCommandsTest::TrackWritesOneMeshACloud() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  for (const auto& [frame, bend] : {std::pair{3, 0.002}, {4, 0.004}, {6, 0.006}}) {  // 5 was lost
    TriangleMesh surface = boundary_surface(mesh).mesh;
    surface.vertices = bent(surface.vertices, bend);
    LabelledCloud cloud;
    cloud.points = sample_surface(surface, 600, static_cast<unsigned>(frame));
    cloud.points.row(1) = cloud.points.row(0);  // there twice
    const std::string number = "0" + std::to_string(frame);
    write_cloud(at(("cloud_" + number + ".ply").c_str()), cloud);
    write_node_list(at(("truth_" + number + ".xyz").c_str()), bent(mesh.vertices, bend),
                    LengthUnit::millimetre);
  }
  const Ran ran =
      run({"track", "--model", "m.vtu", "--start", "m.vtu", "--clouds", "cloud_%02d.ply", "--homogeneous",
           "--truth", "truth_%02d.xyz", "--out", "tracked", "--json", "tracked/t.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QCOMPARE(ran.error, QString());
  QVERIFY2(ran.out.contains(QLatin1String("there twice were left out: 3")), qPrintable(ran.out));
  for (const char* name :
       {"tracked/registered_03.vtu", "tracked/registered_04.vtu", "tracked/registered_06.vtu"})
    QVERIFY2(fs::exists(at(name)), name);
  const QJsonObject json = figures("tracked/t.json");
  QCOMPARE(json["frames"].toInt(), 3);
  QCOMPARE(json["clouds_missing"].toInt(), 1);
  for (const char* key : {"frames_late", "frame_p50_ms", "frame_p99_ms", "tre_volume_mean_mm"})
    QVERIFY2(json.contains(key), key);
  double sum = 0.0;
  for (const char* frame : {"frame_03", "frame_04", "frame_06"}) {
    const QJsonValue error = json[frame + QString("_tre_volume_mean_mm")];
    QVERIFY2(error.isDouble(), frame);
    sum += error.toDouble();
  }
  QVERIFY(std::abs(sum / 3.0 - json["tre_volume_mean_mm"].toDouble()) < 1e-9);
  QVERIFY(json["tre_target_max_mm"].isNull());  // no lesions: unknown, not zero
  const double moved = 1e3 * point_errors(bent(mesh.vertices, 0.004), mesh.vertices).mean;
  QVERIFY2(std::abs(json["displacement_mean_mm"].toDouble() - moved) < 0.5 * moved,
           qPrintable(QString::number(json["displacement_mean_mm"].toDouble())));
  QVERIFY(json["tre_volume_mean_mm"].toDouble() < json["tre_frozen_mean_mm"].toDouble());
}

/// It is read after everything else, as the help says.
void TheatreCommandsTest::ATruthThatCannotBeComparedTakesNothingAlong() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  const auto put_cloud = [&](const char* name, double bend) {
    TriangleMesh surface = boundary_surface(mesh).mesh;
    surface.vertices = bent(surface.vertices, bend);
    LabelledCloud cloud;
    cloud.points = sample_surface(surface, 900, 4);
    write_cloud(at(name), cloud);
  };
  put_cloud("cloud_01.ply", 0.002);
  put_cloud("cloud_02.ply", 0.004);
  write_node_list(at("truth_01.xyz"), bent(mesh.vertices, 0.002), LengthUnit::millimetre);
  write_text(at("truth_02.xyz"), "1 2\n");
  const Ran registered =
      run({"register", "--model", "m.vtu", "--cloud", "cloud_01.ply", "--rigid", "none", "--homogeneous",
           "--truth", "truth_02.xyz", "--out", "r.vtu", "--report", "r.html", "--json", "r.json"});
  QCOMPARE(registered.code, 1);
  QVERIFY(fs::exists(at("r.html")) && figures("r.json").contains("registration_residual_mm"));
  QVERIFY2(registered.error.contains("truth_02.xyz"), qPrintable(registered.error));
  QVERIFY(fs::exists(at("r.vtu")));

  const Ran tracked = run({"track", "--model", "m.vtu", "--start", "m.vtu", "--clouds", "cloud_%02d.ply",
                           "--homogeneous", "--truth", "truth_%02d.xyz", "--out", "tracked"});
  QCOMPARE(tracked.code, 1);
  QVERIFY2(tracked.error.contains("truth_02.xyz"), qPrintable(tracked.error));
  QVERIFY(fs::exists(at("tracked/registered_01.vtu")) && fs::exists(at("tracked/INCOMPLETE")));
  QVERIFY2(tracked.out.contains("marked as incomplete"), qPrintable(tracked.out));

  write_triangle_mesh(at("liver.stl"), boundary_surface(mesh).mesh, LengthUnit::millimetre);
  write_text(at("broken.stl"), "solid\n");
  const Ran built = run({"model", "--surfaces", "liver.stl", "--vertices", "150", "--case", "a.glisson",
                         "--truth", "broken.stl"});
  QCOMPARE(built.code, 1);
  QVERIFY2(built.error.contains("broken.stl"), qPrintable(built.error));
  QVERIFY(fs::exists(at("a.glisson/case.json")));
}

void TheatreCommandsTest::SimulateWritesItsSteps() {
  const TetMesh mesh = ball();
  write_tet_mesh(at("m.vtu"), mesh, LengthUnit::millimetre);
  write_text(at("load.json"),
             "{\"gravity\": {\"change\": [0, 0, -9.81]}, \"fixed\": {\"nodes\": [0, 1, 2, 3, 4, 5, 6]}}");
  const Ran ran = run({"simulate", "--model", "m.vtu", "--load", "load.json", "--steps", "5", "--out",
                       "steps", "--json", "s.json"});
  QVERIFY2(ran.code == 0, qPrintable(ran.error));
  QVERIFY(fs::exists(at("steps")));
  QVERIFY(figures("s.json").contains("displacement_max_mm"));
  refused({"simulate", "--model", "m.vtu", "--load", "nothing.json", "--steps", "5", "--out", "other"},
          "nothing.json");
}

void TheatreCommandsTest::StiffnessTravelsWithTheCaseAndIsSaidAnew() {
  TriangleMesh liver = boundary_surface(ball(8)).mesh, lesion = boundary_surface(ball(4)).mesh;
  lesion.vertices *= 0.4;
  write_triangle_mesh(at("liver.ply"), liver, LengthUnit::millimetre);
  write_triangle_mesh(at("lesion.ply"), lesion, LengthUnit::millimetre);
  write_text(at("list.json"), R"({"structures": {"liver": "liver.ply", "lesion_1": "lesion.ply"}})");
  const QStringList model = {"model",     "--surfaces", "list.json", "--case",
                             "a.glisson", "--vertices", "300",       "--stiffness"};
  refused(model + QStringList{"lesion_1=hard"}, "lesion_1");
  refused(model + QStringList{"lesion_2=20"}, "Take of lesion_1");
  const Ran built = run(model + QStringList{"lesion_1=200,parenchyma=3"});
  QVERIFY2(built.code == 0, qPrintable(built.error));
  QVERIFY(read_file(at("a.glisson/case.json")).find("parenchyma=3,lesion_1=200") != std::string::npos);
  LabelledCloud cloud;
  liver.vertices = bent(liver.vertices, 0.012);
  cloud.points = sample_surface(liver, 900, 4);
  write_cloud(at("c.ply"), cloud);
  const auto registered = [&](const QStringList& more) {
    const Ran ran = run(QStringList{"register", "--model", "a.glisson", "--cloud", "c.ply", "--rigid", "none",
                                    "--accept-doubts", "--out", "r.vtu"} +
                        more);
    return ran.code == 0 ? read_file(at("r.vtu")) : ran.error.toStdString();
  };
  const std::string stiff = registered({});
  QVERIFY2(stiff.starts_with("<"), stiff.c_str());
  // The same said once more changes nothing; the liver's own stiffness does.
  QVERIFY(registered({"--stiffness", "lesion_1=200"}) == stiff);
  const std::string soft = registered({"--stiffness", "lesions=as_liver"});
  QVERIFY(soft.starts_with("<") && soft != stiff);
  refused({"register", "--model", "a.glisson", "--cloud", "c.ply", "--out", "r2.vtu", "--young", "3000",
           "--stiffness", "parenchyma=3"},
          "said twice", 2);
}

QTEST_GUILESS_MAIN(TheatreCommandsTest)
#include "theatre_commands_test.moc"
