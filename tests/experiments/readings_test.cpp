// SPDX-License-Identifier: GPL-3.0-or-later
// What two readers marked on real livers: the file, the middle between them, and whether it lies on the
// livers.
#include "readings.h"

#include <QTest>

#include "data_folder.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/experiments/atlas_livers.h"
#include "glisson/geometry/closest_point_tree.h"

using namespace glisson;
using namespace glisson::experiments;
using atlas::Structure;
namespace fs = std::filesystem;

namespace {

/// A straight margin from the right (-x) to the left and a line over the front, both shifted by dz mm.
std::string reading(int dz, const char* more = "") {
  std::string margin;
  for (int x = -100; x <= 100; x += 20)
    margin += (margin.empty() ? "[" : ",[") + std::to_string(x) + ",0," + std::to_string(dz) + "]";
  const std::string z = std::to_string(dz);
  return R"({"notch":[10,0,)" + z + R"(],"falciform":[[10,0,)" + z + "],[10,80," + z +
         R"(]],"umbilical_tip":null,"anterior_margin":[)" + margin + "]" + more + "}";
}

fs::path written(const TemporaryFolder& folder, const std::string& list) {
  const fs::path path = folder.path() / "readings.json";
  write_file_atomically(path,
                        R"({"format":"glisson-readings","version":1,"frame":"LPS","unit":"mm","livers":{)"
                        R"("0002":[)" +
                            list + "]}}");
  return path;
}

}  // namespace

class ReadingsTest : public QObject {
  Q_OBJECT
 private slots:
  void TheTruthIsTheMiddleBetweenTwo() {
    const TemporaryFolder folder;
    const Readings readings =
        read_readings(written(folder, reading(0, R"(,"notch_again":[10,3,4])") + "," + reading(6)));
    const auto truth = truth_of(readings.at("0002"));
    QCOMPARE(truth.at(Structure::umbilical_notch), Points(Eigen::RowVector3d(0.010, 0.0, 0.003)));
    for (const Structure line : {Structure::falciform_line, Structure::anterior_margin}) {
      QCOMPARE(truth.at(line).rows(), Eigen::Index{atlas::point_count(line)});
      QVERIFY((truth.at(line).col(2).array() - 0.003).abs().maxCoeff() < 1e-9);
    }
    const Figures found = apart(readings);
    QVERIFY(std::abs(found.at("readings_umbilical_notch_mean_mm") - 6.0) < 1e-9);
    QVERIFY(std::abs(found.at("readings_anterior_margin_worst_mm") - 6.0) < 1e-9);
    QVERIFY(std::abs(found.at("readings_again_mean_mm") - 5.0) < 1e-9);
  }

  void AMarginThatMissesTheNotchIsNotHalfATruth() {
    const TemporaryFolder folder;
    std::vector<Reading> both = read_readings(written(folder, reading(0) + "," + reading(6))).at("0002");
    both[1].margin = both[1].margin.topRows(2).eval();
    const auto truth = truth_of(both);
    QVERIFY(truth.at(Structure::anterior_margin).col(2).cwiseAbs().maxCoeff() < 1e-9);
    QVERIFY((truth.at(Structure::anterior_margin).row(0) - both[0].margin.row(0)).norm() < 1e-9);
    both[0].margin = both[1].margin;
    QVERIFY(!truth_of(both).contains(Structure::anterior_margin));
  }

  void WhatIsNoReadingIsNamed_data() {
    QTest::addColumn<QString>("list");
    QTest::addColumn<QString>("field");
    QTest::newRow("no notch") << R"({"falciform":[[0,0,0],[1,1,1]],"anterior_margin":[[0,0,0],[1,1,1]]})"
                              << "0002.notch";
    QTest::newRow("two numbers") << R"({"notch":[1,2]})"
                                 << "0002.notch";
    QTest::newRow("words") << R"({"notch":[1,2,"3"]})"
                           << "0002.notch";
    QTest::newRow("no line") << R"({"notch":[1,2,3],"falciform":[[1,2,3]]})"
                             << "0002.falciform";
    QTest::newRow("no object") << "7"
                               << "0002";
  }
  void WhatIsNoReadingIsNamed() {
    QFETCH(QString, list);
    QFETCH(QString, field);
    const TemporaryFolder folder;
    const fs::path path = written(folder, list.toStdString());
    try {
      read_readings(path);
      QFAIL("it was taken");
    } catch (const InputError& error) {
      const QString told = QString::fromStdString(error.what());
      QVERIFY2(told.contains(field) && told.contains("readings.json"), qPrintable(told));
    }
  }

  void AnotherFileIsRefused() {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "other.json";
    write_file_atomically(path, R"({"frame":"RAS"})");
    QVERIFY_THROWS_EXCEPTION(InputError, read_readings(path));
  }

  /// Real: two livers of development.
  void MarksLieOnTheRealLivers() {
    const fs::path data = test::data_folder();
    if (label_map_names(data).empty()) QSKIP("liver_labelmaps is not there");
    const char* source = std::getenv("GLISSON_SOURCE_DIR");
    QVERIFY(source != nullptr);
    const Readings readings = read_readings(fs::path(source) / "tests/data/liver_labelmaps_readings.json");
    QCOMPARE(readings.size(), std::size_t{20});
    for (const char* name : {"0004", "0030"}) {
      const auto member = label_map_member(data, name, RunContext());
      const ClosestPointTree tree(member->liver);
      for (const Reading& one : readings.at(name))
        for (const Points* points : {&one.notch, &one.falciform, &one.margin})
          for (Eigen::Index i = 0; i < points->rows(); ++i)
            QVERIFY(tree.closest(points->row(i).transpose()).distance < 4e-3);
    }
  }
};

QTEST_APPLESS_MAIN(ReadingsTest)
#include "readings_test.moc"
