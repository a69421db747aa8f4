// SPDX-License-Identifier: GPL-3.0-or-later
// What a track's lines hold comes back as it was.
#include "glisson/patient/overlay_record.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>
#include <cmath>
#include <limits>

#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/patient/label_map.h"
#include "glisson/patient/told_overlay.h"

using namespace glisson;

namespace {

LesionVerdict verdict(int number, Level level, LesionReason reason) {
  LesionVerdict verdict;
  verdict.lesion = static_cast<Label>(structure::kFirstLesion + number);
  verdict.level = level;
  verdict.reason = reason;
  verdict.centre = {0.0123 + number, -0.0456, 0.1201};
  verdict.radius = 7.1e-3;
  verdict.covariance << 4e-6, 1e-6, 0.0, 1e-6, 3e-6, -2e-7, 0.0, -2e-7, 9e-6;
  verdict.expected = 3.3e-3;
  verdict.reach = 8.4e-3;
  verdict.support = 11.7e-3;
  verdict.unseen = 0.4;
  return verdict;
}

OverlayLine line(LengthUnit unit = LengthUnit::millimetre) {
  OverlayLine line;
  line.number = 42;
  line.unit = unit;
  line.mesh = "registered_00042.vtu";
  line.camera_from_model = Eigen::Matrix4d::Identity();
  line.camera_from_model->topRightCorner<3, 1>() << 0.01, -0.02, 0.12;
  line.overlay.validity = Validity::partly_covered;
  line.overlay.seconds = 1.4;
  line.overlay.doubtful = true;
  line.overlay.residual = 0.7e-3;
  line.overlay.lesions = {verdict(0, Level::valid, LesionReason::known),
                          verdict(1, Level::degraded, LesionReason::far_from_points),
                          verdict(2, Level::withdrawn, LesionReason::error_unknown)};
  LesionVerdict& unknown = line.overlay.lesions.back();
  unknown.covariance.setZero();
  unknown.expected = unknown.reach = 0.0;
  unknown.support = std::numeric_limits<double>::infinity();
  return line;
}

bool is_near(double a, double b) { return a == b || std::abs(a - b) < 1e-14; }

QJsonObject object_of(const OverlayLine& line) {
  return QJsonDocument::fromJson(QByteArray::fromStdString(overlay_line(line))).object();
}

}  // namespace

class OverlayRecordTest : public QObject {
  Q_OBJECT
 private slots:
  void ARegistrationMadeMeanwhileIsALineOfItsOwn();
  void TheEvidenceBehindALevelComesBack();
  void EvidenceThatIsNoNumberIsLeftOut();
  void WhetherAPictureIsACopyNeedNotBeKnown();
  void NodesInTheLineComeBack();
  void NodesThatAreNoPointsAreRefused();
  void WhatIsToldIsFlat();
  void ALesionsVerdictIsWrittenInTheUnitOfItsLine_data() {
    QTest::addColumn<int>("unit");
    QTest::addColumn<double>("per_metre");
    QTest::newRow("mm") << static_cast<int>(LengthUnit::millimetre) << 1e3;
    QTest::newRow("m") << static_cast<int>(LengthUnit::metre) << 1.0;
  }
  void ALesionsVerdictIsWrittenInTheUnitOfItsLine() {
    QFETCH(int, unit);
    QFETCH(double, per_metre);
    const QJsonObject object = object_of(line(static_cast<LengthUnit>(unit)));
    QCOMPARE(object["level"].toString(), QString("degraded"));
    QCOMPARE(object["reason"].toString(), QString("partly_covered"));
    const QJsonArray lesions = object["lesions"].toArray();
    QCOMPARE(lesions.size(), 3);
    const QJsonObject second = lesions[1].toObject();
    QCOMPARE(second["lesion"].toString(), QString("lesion_2"));
    QCOMPARE(second["level"].toString(), QString("degraded"));
    QCOMPARE(second["reason"].toString(), QString("far_from_points"));
    QCOMPARE(second["reach_95"].toDouble(), 8.4e-3 * per_metre);
    QCOMPARE(second["expected_error"].toDouble(), 3.3e-3 * per_metre);
    QCOMPARE(second["nearest_points"].toDouble(), 11.7e-3 * per_metre);
    QCOMPARE(second["radius"].toDouble(), 7.1e-3 * per_metre);
    QCOMPARE(second["centre"].toArray()[1].toDouble(), -0.0456 * per_metre);
    QCOMPARE(second["covariance"].toArray()[0].toArray()[1].toDouble(), 1e-6 * per_metre * per_metre);
    QCOMPARE(second["unseen_seconds"].toDouble(), 0.4);
    // What is not known is not written as a number.
    const QJsonObject third = lesions[2].toObject();
    for (const char* field : {"reach_95", "expected_error", "covariance", "nearest_points"})
      QVERIFY2(!third.contains(field), field);
    QCOMPARE(third["level"].toString(), QString("withdrawn"));
  }

  void NegativeLengthsAreRefused_data() {
    QTest::addColumn<QByteArray>("field");
    for (const char* field : {"expected_error", "reach_95", "radius", "nearest_points", "unseen_seconds"})
      QTest::newRow(field) << QByteArray(field);
  }
  void NegativeLengthsAreRefused() {
    QFETCH(QByteArray, field);
    const TemporaryFolder folder;
    QJsonObject object = object_of(line());
    QJsonArray lesions = object["lesions"].toArray();
    QJsonObject second = lesions[1].toObject();
    QVERIFY(second.contains(field));
    second[field] = -second[field].toDouble();
    lesions[1] = second;
    object["lesions"] = lesions;
    const QByteArray text = QJsonDocument(object).toJson(QJsonDocument::Compact);
    write_file_atomically(folder.path() / "frames.jsonl", text.toStdString() + "\n");
    try {
      (void)read_overlay_record(folder.path() / "frames.jsonl");
      QFAIL("was read");
    } catch (const InputError& error) {
      QVERIFY2(QByteArray(error.what()).contains(field + " is negative"), error.what());
    }
  }

  void ALineComesBackAsItWas() {
    const TemporaryFolder folder;
    const OverlayLine written = line();
    OverlayLine lost;
    lost.number = 43;
    lost.overlay.validity = Validity::not_started;
    write_file_atomically(folder.path() / "frames.jsonl", overlay_line(written) + "\n" + overlay_line(lost) +
                                                              "\n" + overlay_record_end(true, 2) + "\n");
    const OverlayRecord record = read_overlay_record(folder.path() / "frames.jsonl");
    QVERIFY(record.complete);
    QCOMPARE(record.frames.size(), std::size_t{2});
    const OverlayLine& read = record.frames[0];
    QCOMPARE(read.number, 42);
    QCOMPARE(read.overlay.index, 42);
    QCOMPARE(read.mesh, written.mesh);
    QVERIFY(read.overlay.validity == Validity::partly_covered && read.overlay.doubtful);
    QVERIFY(is_near(read.overlay.seconds, 1.4) && is_near(read.overlay.residual, 0.7e-3));
    QVERIFY(read.camera_from_model->isApprox(*written.camera_from_model, 1e-14));
    QCOMPARE(read.overlay.lesions.size(), std::size_t{3});
    for (std::size_t i = 0; i < 3; ++i) {
      const LesionVerdict &there = read.overlay.lesions[i], &here = written.overlay.lesions[i];
      QCOMPARE(there.lesion, here.lesion);
      QVERIFY(there.level == here.level && there.reason == here.reason);
      QVERIFY(there.centre.isApprox(here.centre, 1e-14));
      QVERIFY(there.covariance.isApprox(here.covariance, 1e-12));
      QVERIFY(is_near(there.radius, here.radius) && is_near(there.expected, here.expected) &&
              is_near(there.reach, here.reach) && is_near(there.support, here.support) &&
              is_near(there.unseen, here.unseen));
    }
    QVERIFY(record.frames[1].mesh.empty() && record.frames[1].overlay.level() == Level::withdrawn);
  }

  void ARecordThatWasCutShortIsNotWhole() {
    const TemporaryFolder folder;
    write_file_atomically(folder.path() / "a.jsonl", overlay_line(line()) + "\n");
    QVERIFY(!read_overlay_record(folder.path() / "a.jsonl").complete);
    write_file_atomically(folder.path() / "a.jsonl", overlay_record_end(false, 0) + "\n");
    QVERIFY(!read_overlay_record(folder.path() / "a.jsonl").complete);
  }

  void WhatIsNotALineIsRefusedWithItsNumber_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::newRow("no JSON") << "{"
                             << "";
    QTest::newRow("unknown reason") << "\"partly_covered\""
                                    << "\"sunshine\"";
    QTest::newRow("level of another reason") << "\"level\":\"degraded\",\"mesh\""
                                             << "\"level\":\"valid\",\"mesh\"";
    QTest::newRow("no lesion") << "\"lesion_2\""
                               << "\"parenchyma\"";
    QTest::newRow("unknown unit") << "\"unit\":\"mm\""
                                  << "\"unit\":\"inch\"";
    QTest::newRow("a mesh elsewhere") << "registered_00042"
                                      << "../registered";
    QTest::newRow("a text for a number") << "\"unseen_seconds\":0.4"
                                         << "\"unseen_seconds\":\"long\"";
    QTest::newRow("half a frame") << "\"frame\":42"
                                  << "\"frame\":42.5";
    QTest::newRow("a frame of no film") << "\"frame\":42"
                                        << "\"frame\":4294967338";
    QTest::newRow("half a pair") << "\"pairs\":0"
                                 << "\"pairs\":0.5";
    QTest::newRow("a matrix of another size") << "\"covariance\":[["
                                              << "\"covariance\":[[1.0],[";
  }
  void WhatIsNotALineIsRefusedWithItsNumber() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    const TemporaryFolder folder;
    QString text = QString::fromStdString(overlay_line(line()));
    const qsizetype at = text.indexOf(from);
    QVERIFY2(at >= 0, qPrintable(text));
    text.replace(at, from.size(), to);
    write_file_atomically(folder.path() / "frames.jsonl",
                          overlay_line(line()) + "\n" + text.toStdString() + "\n");
    try {
      read_overlay_record(folder.path() / "frames.jsonl");
      QFAIL("was read");
    } catch (const InputError& problem) {
      QVERIFY2(QString(problem.what()).contains("frames.jsonl") && problem.field() == "line 2",
               problem.what());
    }
  }
};

void OverlayRecordTest::ARegistrationMadeMeanwhileIsALineOfItsOwn() {
  const std::string again = again_line({90, 3.0, true, 1.5e-3, 0.4e-3, 8.2e-3});
  const QJsonObject object = QJsonDocument::fromJson(QByteArray::fromStdString(again)).object();
  QCOMPARE(object["frame"].toInt(), 90);
  const QJsonObject said = object["registered_again"].toObject();
  QVERIFY(said["taken"].toBool() && is_near(said["gap_mm"].toDouble(), 0.4));
  QVERIFY(is_near(said["former_gap_mm"].toDouble(), 1.5) && is_near(said["moved_mean_mm"].toDouble(), 8.2));
  // What draws the film again goes on without it.
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "again.jsonl";
  write_file_atomically(path,
                        overlay_line(line()) + "\n" + again + "\n" + overlay_record_end(true, 1) + "\n");
  const OverlayRecord record = read_overlay_record(path);
  QCOMPARE(record.frames.size(), std::size_t{1});
  QVERIFY(record.complete);
}

namespace {

OverlayLine read_back(const OverlayLine& line) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "frames.jsonl", overlay_line(line) + "\n");
  return read_overlay_record(folder.path() / "frames.jsonl").frames.at(0);
}

}  // namespace

void OverlayRecordTest::TheEvidenceBehindALevelComesBack() {
  OverlayLine written = line();
  written.overlay.tracked_left = 181;
  written.overlay.tracked_right = 174;
  written.overlay.pairs = 160;
  written.overlay.milliseconds = 9.5;
  Evidence& said = written.overlay.evidence;
  said.judged = true;
  int n = 0;
  for (double* value : {&said.supported, &said.missing, &said.gap, &said.local, &said.behind, &said.before,
                        &said.lifted, &said.pull_sigma, &said.contrast, &said.motion, &said.fresh})
    *value = 0.1 * ++n;
  said.pull = 2.1e-3;
  said.rows = 0.4;
  written.remedy = "Take away what covers it.";
  const QJsonObject object = object_of(written), evidence = object["evidence"].toObject();
  QCOMPARE(evidence.size(), 13);
  QVERIFY(is_near(evidence["pull_mm"].toDouble(), 2.1) && is_near(evidence["rows_px"].toDouble(), 0.4));
  QCOMPARE(object["points"].toObject()["pairs"].toInt(), 160);
  QCOMPARE(object["remedy"].toString(), QString("Take away what covers it."));
  const OverlayLine read = read_back(written);
  const Evidence &there = read.overlay.evidence, &here = written.overlay.evidence;
  QVERIFY(there.judged && is_near(there.supported, here.supported) && is_near(there.gap, here.gap) &&
          is_near(there.missing, here.missing) && is_near(there.behind, here.behind) &&
          is_near(there.pull, here.pull) && is_near(there.pull_sigma, here.pull_sigma) &&
          is_near(there.contrast, here.contrast) && is_near(there.motion, here.motion) &&
          is_near(there.rows, here.rows) && is_near(there.local, here.local) &&
          is_near(there.before, here.before) && is_near(there.lifted, here.lifted) &&
          is_near(there.fresh, here.fresh));
  QVERIFY(read.overlay.tracked_left == 181 && read.overlay.tracked_right == 174 && read.overlay.pairs == 160);
  QVERIFY(is_near(read.overlay.milliseconds, 9.5) && read.remedy == written.remedy);
  // Before anything was judged nothing is said of it.
  QVERIFY(!object_of(line()).contains("evidence"));
  QVERIFY(!read_back(line()).overlay.evidence.judged);
}

void OverlayRecordTest::EvidenceThatIsNoNumberIsLeftOut() {
  OverlayLine written = line();
  written.overlay.evidence.judged = true;
  written.overlay.evidence.gap = std::numeric_limits<double>::infinity();
  const QJsonObject evidence = object_of(written)["evidence"].toObject();
  QVERIFY(!evidence.contains("gap") && evidence.contains("behind"));
  QVERIFY(read_back(written).overlay.evidence.judged);
}

void OverlayRecordTest::WhetherAPictureIsACopyNeedNotBeKnown() {
  OverlayLine written = line();
  written.overlay.evidence.judged = true;
  QVERIFY(!object_of(written)["evidence"].toObject().contains("fresh"));
  QVERIFY(read_back(written).overlay.evidence.fresh < 0.0);
  written.overlay.evidence.fresh = 0.0;  // it is one
  QVERIFY(object_of(written)["evidence"].toObject().contains("fresh"));
  QCOMPARE(read_back(written).overlay.evidence.fresh, 0.0);
}

void OverlayRecordTest::NodesInTheLineComeBack() {
  OverlayLine written = line();
  written.mesh.clear();
  written.nodes_here = true;
  written.film_frame = 17;
  written.age = 0.034;
  Points& nodes = written.overlay.nodes_in_camera;
  nodes.resize(3, 3);
  nodes << 0.0123456789, -0.02, 0.11, 0.01, 0.02, 0.12, -1e-5, 0.0, 0.13;
  const OverlayLine read = read_back(written);
  QVERIFY(read.nodes_here && read.mesh.empty());
  QVERIFY(read.film_frame == 17 && is_near(*read.age, 0.034));
  QCOMPARE(read.overlay.nodes_in_camera.rows(), Eigen::Index{3});
  QVERIFY((read.overlay.nodes_in_camera - nodes).cwiseAbs().maxCoeff() < 0.6e-7);
  QVERIFY(read.camera_from_model.has_value() && read.overlay.lesions.size() == 3);
  QVERIFY(read_back(line()).film_frame == std::nullopt);
}

void OverlayRecordTest::NodesThatAreNoPointsAreRefused() {
  OverlayLine written = line();
  written.mesh.clear();
  written.nodes_here = true;
  written.overlay.nodes_in_camera = Points::Constant(2, 3, 0.1);
  QJsonObject object = object_of(written);
  QJsonArray nodes;
  nodes.append(QJsonArray{1.0, 2.0});
  object["nodes"] = nodes;
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "frames.jsonl",
                        QJsonDocument(object).toJson(QJsonDocument::Compact).toStdString() + "\n");
  QVERIFY_THROWS_EXCEPTION(InputError, read_overlay_record(folder.path() / "frames.jsonl"));
}

void OverlayRecordTest::WhatIsToldIsFlat() {
  OverlayFrame overlay;
  overlay.validity = Validity::partly_covered;
  overlay.lesions = {verdict(0, Level::degraded, LesionReason::far_from_points),
                     verdict(1, Level::withdrawn, LesionReason::error_unknown)};
  overlay.lesions[1].reach = 0.0;  // unknown
  const ToldOverlay all = told(overlay);
  QCOMPARE(all.texts, (std::map<std::string, std::string>{{"level", "degraded"},
                                                          {"validity", "partly_covered"},
                                                          {"lesion_1_level", "degraded"},
                                                          {"lesion_1_reason", "far_from_points"},
                                                          {"lesion_2_level", "withdrawn"},
                                                          {"lesion_2_reason", "error_unknown"}}));
  QCOMPARE(all.figures, (Figures{{"lesion_1_expected_error_mm", 1e3 * overlay.lesions[0].expected},
                                 {"lesion_1_reach_95_mm", 1e3 * overlay.lesions[0].reach}}));
}

QTEST_APPLESS_MAIN(OverlayRecordTest)
#include "overlay_record_test.moc"
