// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/handled_liver.h"

#include <QTest>

#include "glisson/core/error.h"
#include "glisson/geometry/rigid.h"
#include "shapes.h"
#include "theatre_patient.h"

using namespace glisson;
using namespace glisson::insilico;

namespace {

HandlingOptions small(Handling handling, std::uint64_t seed = 1) {
  HandlingOptions options;
  options.handling = handling;
  options.seed = seed;
  options.truth_vertices = 400;
  return options;
}

}  // namespace

class HandledLiverTest : public QObject {
  Q_OBJECT
 private slots:
  void IsBentAsFarAsIsWanted();
  void StaysWhereTheVenaCavaHoldsIt();
  void SameSeedGivesTheSameBits();
  void ThePatchIsOfItsSurface();
  void WhatHasNoMarginCannotBeLifted();
  void UnusableOptionsAreRefused();
  void CancelGivesNothing();

 private:
  PatientModel patient_ = insilico::test::small_patient();
};

void HandledLiverTest::IsBentAsFarAsIsWanted() {
  for (const Handling handling : kHandlings) {
    const auto handled = HandledLiver::build(patient_, small(handling), RunContext());
    QVERIFY(handled.has_value());
    const double bent = 1e3 * handled->elastic_motion();
    QVERIFY2(bent > 1.0 && bent < 6.3, handling_code(handling));
    QVERIFY(handled->largest_motion() > handled->elastic_motion());
  }
}

void HandledLiverTest::StaysWhereTheVenaCavaHoldsIt() {
  const auto handled = HandledLiver::build(patient_, small(Handling::lifted), RunContext());
  const Points cava = handled->landmarks().vena_cava;
  const Points moved = handled->camera_from_ct().inverse().apply(handled->carry(cava));
  QVERIFY((moved - cava).rowwise().norm().mean() < 2e-3);
}

void HandledLiverTest::SameSeedGivesTheSameBits() {
  const auto once = HandledLiver::build(patient_, small(Handling::pulled, 5), RunContext());
  const auto again = HandledLiver::build(patient_, small(Handling::pulled, 5), RunContext());
  const auto other = HandledLiver::build(patient_, small(Handling::pulled, 6), RunContext());
  QCOMPARE(once->patch({}).cloud.points, again->patch({}).cloud.points);
  QVERIFY(once->camera_from_ct().translation != other->camera_from_ct().translation);
}

void HandledLiverTest::ThePatchIsOfItsSurface() {
  HandlingOptions options = small(Handling::pressed);
  options.surface_error_mm = 0.0;
  const auto handled = HandledLiver::build(patient_, options, RunContext());
  PatchOptions sampling;
  sampling.noise_mm = 0.0;
  const Patch patch = handled->patch(sampling);
  QVERIFY(std::abs(patch.share - sampling.share) < 0.02);
  QVERIFY(patch.cloud.normals.rows() == 0);
  // In front of the camera, and all of the organ behind its nearest point.
  QVERIFY(patch.cloud.points.col(2).minCoeff() > 0.1);
}

void HandledLiverTest::WhatHasNoMarginCannotBeLifted() {
  PatientModel patient;
  patient.surfaces = {{structure::kParenchyma, "liver", glisson::test::sphere(0.06, 3)}};
  QVERIFY_THROWS_EXCEPTION(NumericalError,
                           HandledLiver::build(patient, small(Handling::lifted), RunContext()));
}

void HandledLiverTest::UnusableOptionsAreRefused() {
  HandlingOptions options;
  options.elastic_motion_mm = 0.0;
  QVERIFY_THROWS_EXCEPTION(InputError, HandledLiver::build(patient_, options, RunContext()));
}

void HandledLiverTest::CancelGivesNothing() {
  auto flag = std::make_shared<CancelFlag>();
  flag->request();
  QVERIFY(!HandledLiver::build(patient_, small(Handling::turned), RunContext({}, flag, 1)).has_value());
}

QTEST_APPLESS_MAIN(HandledLiverTest)
#include "handled_liver_test.moc"
