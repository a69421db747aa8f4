// SPDX-License-Identifier: GPL-3.0-or-later
// Where a patient's margin is not known, a truth's is the one that is found: how far that lies from the ridge
// that the synthetic livers are made with.
#include <QTest>
#include <algorithm>
#include <limits>

#include "glisson/insilico/liver_population.h"
#include "glisson/model/build.h"

using namespace glisson;

namespace {

double distance_to(const Points& line, const Eigen::Vector3d& p) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i + 1 < line.rows(); ++i) {
    const Eigen::Vector3d from = line.row(i).transpose(), edge = line.row(i + 1).transpose() - from;
    const double t = std::clamp((p - from).dot(edge) / std::max(edge.squaredNorm(), 1e-18), 0.0, 1.0);
    least = std::min(least, (from + t * edge - p).norm());
  }
  return least;
}

/// Metres.
double mean_distance(const Points& points, const Points& line) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < points.rows(); ++i) sum += distance_to(line, points.row(i).transpose());
  return sum / static_cast<double>(points.rows());
}

}  // namespace

class InsilicoMarginTest : public QObject {
  Q_OBJECT
 private slots:
  void TheMarginThatIsFoundIsTheRidgeThatWasMade_data();
  void TheMarginThatIsFoundIsTheRidgeThatWasMade();
};

void InsilicoMarginTest::TheMarginThatIsFoundIsTheRidgeThatWasMade_data() {
  QTest::addColumn<quint64>("seed");
  for (const quint64 seed : {1U, 2U, 101U, 102U}) QTest::newRow(qPrintable(QString::number(seed))) << seed;
}

void InsilicoMarginTest::TheMarginThatIsFoundIsTheRidgeThatWasMade() {
  QFETCH(quint64, seed);
  const insilico::PopulationLiver liver = insilico::population_liver(seed, 2.5);
  const Points found = model::detect_anterior_margin(liver.surface, Eigen::Vector3d(0.0, -0.7, -0.7));
  QVERIFY(found.rows() > 20);
  const double beside = mean_distance(found, liver.anterior_margin),
               missed = mean_distance(liver.anterior_margin, found);
  qInfo("found to made %.1f mm, made to found %.1f mm", 1e3 * beside, 1e3 * missed);
  QVERIFY(missed < 5e-3);
  QVERIFY(beside < 8e-3);  // it goes on beyond the ends of the one that was made
}

QTEST_GUILESS_MAIN(InsilicoMarginTest)
#include "insilico_margin_test.moc"
