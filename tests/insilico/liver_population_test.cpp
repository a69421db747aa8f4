// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <algorithm>

#include "glisson/core/error.h"
#include "glisson/geometry/distance.h"
#include "glisson/geometry/topology.h"
#include "glisson/insilico/liver_population.h"

using namespace glisson;
using namespace glisson::insilico;

class LiverPopulationTest : public QObject {
  Q_OBJECT
 private slots:
  void structuresLieOnTheClosedSurface() {
    for (const std::uint64_t seed : {3, 4}) {
      const PopulationLiver liver = population_liver(seed, 2.0);
      QVERIFY(is_closed(liver.surface));
      QVERIFY(volume(liver.surface) > 1.35e-3 && volume(liver.surface) < 1.85e-3);
      for (const Points* points :
           {&liver.umbilical_notch, &liver.anterior_margin, &liver.falciform_line, &liver.portal_entrance}) {
        QVERIFY(points->rows() > 0);
        const auto distances = distances_to_surface(*points, liver.surface);
        // Sharp edges are cut by the samples.
        QVERIFY(*std::max_element(distances.begin(), distances.end()) < 2.5e-3);
      }
      QVERIFY(liver.vena_cava.rows() > 100 && liver.gallbladder_bed.rows() > 100);
    }
  }
  void theLinesRunWhereTheyShould() {
    const PopulationLiver liver = population_liver(3, 2.0);
    const auto to = [](const Points& line, const Eigen::RowVector3d& p) {
      return (line.rowwise() - p).rowwise().norm().minCoeff();
    };
    QVERIFY(to(liver.anterior_margin, liver.umbilical_notch.row(0)) < 2e-3);
    QVERIFY((liver.falciform_line.row(0) - liver.umbilical_notch.row(0)).norm() < 1e-9);
    // From the front to the back, and up.
    const Eigen::RowVector3d end = liver.falciform_line.row(liver.falciform_line.rows() - 1);
    QVERIFY(end.y() > liver.umbilical_notch(0, 1) + 0.04 && end.z() > liver.umbilical_notch(0, 2));
    // The margin begins on the right, which is -x.
    QVERIFY(liver.anterior_margin(0, 0) < liver.anterior_margin(liver.anterior_margin.rows() - 1, 0));
  }
  void aSeedIsALiver() {
    const PopulationLiver once = population_liver(9, 4.0), again = population_liver(9, 4.0),
                          other = population_liver(10, 4.0);
    QCOMPARE(once.surface.vertices, again.surface.vertices);
    QVERIFY((once.umbilical_notch - other.umbilical_notch).norm() > 1e-4);
  }
  /// Tracing the margin went on for ever where a step over an edge led back, for one of these.
  void everyMarginComesToAnEnd() {
    for (std::uint64_t seed = 6001; seed <= 6024; ++seed)
      QVERIFY(population_liver(seed, 20.0).anterior_margin.rows() > 50);
  }
  void spacingsOutOfRangeAreRefused() {
    QVERIFY_THROWS_EXCEPTION(InputError, population_liver(1, 0.1));
    QVERIFY_THROWS_EXCEPTION(InputError, population_liver(1, 50.0));
  }
};

QTEST_APPLESS_MAIN(LiverPopulationTest)
#include "liver_population_test.moc"
