// SPDX-License-Identifier: GPL-3.0-or-later
#include "landmark_effect.h"

#include <QTest>
#include <algorithm>

#include "glisson/core/error.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::experiments;

class LandmarkEffectTest : public QObject {
  Q_OBJECT
 private slots:
  void AMistakenNotchLiesOnTheSurfaceAndWhereThePaperPutIt() {
    const PatientModel model = phantom::model(12, 10, 7);
    const Eigen::RowVector3d notch = model.landmarks.umbilical_notch.row(0);
    std::vector<Eigen::RowVector3d> places;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const Points place = mistaken_notch(model, std::mt19937_64(seed));
      QCOMPARE(static_cast<int>(place.rows()), 1);
      const double off = (place.row(0) - notch).norm();
      QVERIFY2(std::abs(off - 17.5e-3) < 3e-3, qPrintable(QString::number(1e3 * off)));
      const Points& surface = model.surface.mesh.vertices;
      QVERIFY((surface.rowwise() - place.row(0)).rowwise().norm().minCoeff() < 1e-12);
      places.emplace_back(place.row(0));
    }
    QVERIFY(std::any_of(places.begin(), places.end(),
                        [&](const Eigen::RowVector3d& one) { return (one - places.front()).norm() > 5e-3; }));
  }

  void EachSourceHasANameOfItsOwn() {
    std::vector<std::string> names;
    for (const LandmarkSource source : kLandmarkSources) names.emplace_back(landmark_source_code(source));
    std::sort(names.begin(), names.end());
    QVERIFY(std::adjacent_find(names.begin(), names.end()) == names.end());
  }

  void WhatCannotBeTriedIsRefused() {
    LandmarkEffectOptions options;
    QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
    options.atlas = std::make_shared<const atlas::Atlas>();
    options.validate();
    options.patients = 0;
    QVERIFY_THROWS_EXCEPTION(InputError, options.validate());
    options.patients = 1;
    options.share = 1.5;
    QVERIFY_THROWS_EXCEPTION(InputError, measure_landmark_effect(options, RunContext()));
  }
};

QTEST_GUILESS_MAIN(LandmarkEffectTest)
#include "landmark_effect_test.moc"
