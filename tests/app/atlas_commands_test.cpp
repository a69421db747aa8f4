// SPDX-License-Identifier: GPL-3.0-or-later
// The atlas on the command line: show, transfer, and what is refused.
#include <sys/stat.h>

#include <QJsonObject>
#include <QTest>
#include <filesystem>

#include "glisson/geometry/mesh_io.h"
#include "program.h"
#include "shapes.h"

using namespace glisson;
using test::Ran;

class AtlasCommandsTest : public QObject, private test::Program {
  Q_OBJECT
 private slots:
  void init() { make_folder(); }
  void cleanup() { remove_folder(); }

  void theBuiltInAtlasTellsWhatItKnows() {
    const Ran ran = run({"atlas", "show", "--json", "f.json"});
    QVERIFY2(ran.code == 0, qPrintable(ran.error));
    const QJsonObject shown = figures("f.json");
    QVERIFY(shown["atlas_members"].toDouble() >= 5);
    QVERIFY(shown["atlas_vena_cava_deviation_mm"].toDouble() > 1.0);
    QVERIFY2(ran.out.contains("; follows: Umbilical notch, Anterior margin"), qPrintable(ran.out));
  }

  /// The atlas' own mean is a liver: proposed and accepted, its vena cava is a landmark of the case.
  void whatIsAcceptedBecomesALandmark() {
    const auto source = qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString();
    const TriangleMesh mean =
        read_triangle_mesh(source + "/resources/atlas/mean.vtp", LengthUnit::millimetre);
    write_triangle_mesh(at("liver.ply"), mean, LengthUnit::millimetre);
    const Ran built = run({"model", "--surfaces", "liver.ply", "--vertices", "300", "--case", "a.glisson"});
    QVERIFY2(built.code == 0, qPrintable(built.error));
    QVERIFY(!std::filesystem::exists(at("a.glisson/landmarks.json")));
    const Ran ran = run({"atlas", "transfer", "--case", "a.glisson", "--accept", "vena_cava,portal_entrance",
                         "--json", "f.json"});
    QVERIFY2(ran.code == 0, qPrintable(ran.error));
    QVERIFY(figures("f.json")["atlas_fit_mean_mm"].toDouble() < 1.5);
    QCOMPARE(figures("f.json")["atlas_umbilical_notch_source"].toString(), QStringLiteral("statistics"));
    QVERIFY(std::filesystem::exists(at("a.glisson/atlas.json")));
    const std::string landmarks = read_file(at("a.glisson/landmarks.json"));
    QVERIFY(landmarks.find("vena_cava") != std::string::npos);
    QVERIFY(landmarks.find("umbilical_notch") == std::string::npos);
    // The table of decisions.
    const Ran shown = run({"atlas", "show", "--case", "a.glisson", "--json", "t.json"});
    QVERIFY2(shown.code == 0, qPrintable(shown.error));
    const QJsonObject table = figures("t.json");
    QCOMPARE(table["landmark_vena_cava_decision"].toString(), QStringLiteral("accepted"));
    QCOMPARE(table["landmark_vena_cava_source"].toString(), QStringLiteral("statistics"));
    QVERIFY(table["landmark_vena_cava_deviation_mm"].toDouble() > 1.0);
    QCOMPARE(table["landmark_umbilical_notch_decision"].toString(), QStringLiteral("proposed"));
  }

  /// What is built is an atlas; what is evaluated is foretold by the others, and nothing is kept of it.
  void anAtlasIsBuiltAndEvaluated() {
    const auto source = qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString();
    std::filesystem::copy(source + "/resources/atlas", at("own"));
    struct stat former = {}, standing = {};
    QCOMPARE(::stat(at("own").c_str(), &former), 0);
    const QStringList livers = {"--synthetic", "5", "--seed", "31"};
    const Ran built =
        run(QStringList{"atlas", "build", "--out", "own", "--name", "mine", "--json", "b.json"} + livers);
    QVERIFY2(built.code == 0, qPrintable(built.error));
    QVERIFY(std::filesystem::exists(at("own/atlas.json")) && std::filesystem::exists(at("own/mean.vtp")));
    // The atlas that was there gave way whole: another folder stands in its place.
    QCOMPARE(::stat(at("own").c_str(), &standing), 0);
    QVERIFY(standing.st_ino != former.st_ino);
    const Ran shown = run({"atlas", "show", "--atlas", "own", "--json", "s.json"});
    QCOMPARE(shown.code, 0);
    QVERIFY(shown.out.contains("mine"));
    QCOMPARE(figures("s.json")["atlas_members"].toInt(), 5);
    const Ran judged = run(QStringList{"atlas", "evaluate", "--json", "e.json"} + livers);
    QVERIFY2(judged.code == 0, qPrintable(judged.error));
    const QJsonObject a = figures("b.json"), b = figures("e.json");
    int compared = 0;
    for (const QString& key : b.keys())
      if (key.endsWith(QStringLiteral("_mean_mm"))) {
        QCOMPARE(a[key].toDouble(), b[key].toDouble());
        ++compared;
      }
    QVERIFY(compared > 3);
    QVERIFY(judged.out.contains("synthetic_33"));
  }

  void operationsComeWithTheModel() {
    put_liver_with_cava();
    const Ran ran = run({"model", "--surfaces", "surfaces", "--vertices", "150", "--case", "c.glisson",
                         "--operations", "--json", "f.json"});
    QVERIFY2(ran.code == 0, qPrintable(ran.error));
    QVERIFY(figures("f.json")["operations_simulated"].toInt() >= 30);
    QVERIFY(std::filesystem::exists(at("c.glisson/operations.vtu")));
  }

  /// The model is safe before they are simulated, and who presses Ctrl-C then is told so.
  void cancelledOperationsLeaveTheModel() {
    put_liver_with_cava();
    const Ran ran = interrupted_when(
        {"model", "--surfaces", "surfaces", "--vertices", "150", "--case", "c.glisson", "--operations"},
        [this] { return std::filesystem::exists(at("c.glisson/case.json")); });
    QVERIFY2(ran.code == 130, qPrintable(QString::number(ran.code) + ran.error + ran.out));
    QVERIFY2(!ran.error.contains("nothing was written") && ran.error.contains("c.glisson holds"),
             qPrintable(ran.error));
    QVERIFY(std::filesystem::exists(at("c.glisson/model/mesh.vtu")));
    QVERIFY(!std::filesystem::exists(at("c.glisson/operations.vtu")));
  }

  /// Without a vena cava they cannot be; the model that was built is kept, and the remedy named.
  void operationsNeedAVenaCava() {
    write_triangle_mesh(at("ball.ply"), test::sphere(0.08, 3), LengthUnit::millimetre);
    const Ran ran =
        run({"model", "--surfaces", "ball.ply", "--vertices", "200", "--case", "b.glisson", "--operations"});
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.error.contains("vena cava") && ran.error.contains("landmarks"), qPrintable(ran.error));
    QVERIFY(std::filesystem::exists(at("b.glisson/model/mesh.vtu")));
    QVERIFY(!std::filesystem::exists(at("b.glisson/operations.vtu")));
  }

  void whatCannotBeIsRefused() {
    refused({"atlas", "dance"}, "dance", 2);
    refused({"atlas", "show", "--atlas", "nowhere"}, "nowhere");
    refused({"atlas", "build", "--out", "a"}, "5 livers");
    refused({"atlas", "build"}, "--out", 2);
    std::filesystem::create_directory(at("letters"));
    test::write_text(at("letters/letter.txt"), "x");
    refused({"atlas", "build", "--out", "letters"}, "something else than an atlas");
    refused({"atlas", "build", "--out", "letters/letter.txt/a"}, "cannot be written to");
    refused({"atlas", "build", "none.glisson", "--out", "a"}, "none.glisson");
    refused({"atlas", "evaluate", "."}, "cases");
    refused({"atlas", "transfer", "--case", "a.glisson", "--accept", "navel"}, "navel", 2);
    refused({"atlas", "transfer", "--case", "none.glisson"}, "none.glisson");
  }

 private:
  /// A vein that enters behind is what holds the organ.
  void put_liver_with_cava() const {
    std::filesystem::create_directory(at("surfaces"));
    write_triangle_mesh(at("surfaces/liver.ply"), test::sphere(0.08, 3), LengthUnit::millimetre);
    TriangleMesh cava = test::sphere(0.02, 2);
    cava.vertices.rowwise() += Eigen::RowVector3d(0.0, 0.085, 0.0);
    write_triangle_mesh(at("surfaces/vena_cava.ply"), cava, LengthUnit::millimetre);
  }
};

QTEST_GUILESS_MAIN(AtlasCommandsTest)
#include "atlas_commands_test.moc"
