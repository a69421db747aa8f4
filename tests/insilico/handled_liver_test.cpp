// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/insilico/handled_liver.h"

#include <Eigen/Geometry>
#include <QTest>

#include "glisson/core/error.h"
#include "glisson/geometry/rigid.h"
#include "glisson/insilico/ray_caster.h"
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
  void ASwollenOneIsLargerAndAnEmptiedOneSmaller();
  void OfAResectedOneAPieceIsGone();
  void SameSeedGivesTheSameBits();
  void ThePatchIsOfItsSurface();
  void ALaparoscopeThatGoesRoundShowsOnlyWhatItSees();
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

void HandledLiverTest::ASwollenOneIsLargerAndAnEmptiedOneSmaller() {
  const TriangleMesh ct = insilico::test::liver_surface(36);
  for (const auto& [handling, least, most] : {std::tuple(Handling::swollen, 1.03, 1.15),
                                              {Handling::pulled, 0.97, 1.03},
                                              {Handling::emptied, 0.80, 0.96}}) {
    const auto handled = HandledLiver::build(patient_, small(handling), RunContext());
    const double grown = volume(TriangleMesh{handled->carry(ct.vertices), ct.triangles}) / volume(ct);
    QVERIFY2(grown > least && grown < most, qPrintable(QString::number(grown)));
  }
}

void HandledLiverTest::OfAResectedOneAPieceIsGone() {
  PatchOptions all;
  all.share = 1.0;
  all.noise_mm = 0.0;
  const auto farthest = [&](Handling handling) {
    const auto handled = HandledLiver::build(patient_, small(handling), RunContext());
    const Points there = handled->carry(insilico::test::liver_surface(36).vertices),
                 seen = handled->patch(all).cloud.points;
    double most = 0.0;
    for (Eigen::Index v = 0; v < there.rows(); ++v)
      most = std::max(most, (seen.rowwise() - there.row(v)).rowwise().norm().minCoeff());
    return most;
  };
  QVERIFY(farthest(Handling::resected) > 15e-3);
  QVERIFY(farthest(Handling::pulled) < 10e-3);
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

/// Of half the surface one camera sees but a part; each point of a look lies before it and nothing lies
/// between.
void HandledLiverTest::ALaparoscopeThatGoesRoundShowsOnlyWhatItSees() {
  HandlingOptions options = small(Handling::turned);
  options.surface_error_mm = 0.0;
  const auto handled = HandledLiver::build(patient_, options, RunContext());
  TriangleMesh surface = patient_.surfaces.front().mesh;
  surface.vertices = handled->carry(surface.vertices);
  const Eigen::Vector3d middle = surface.vertices.colwise().mean().transpose();
  std::vector<Rigid<CameraFrame, CameraFrame>> scopes(1);
  for (const auto& axis : {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()})
    for (const double turn : {-0.6, 0.6}) {
      Rigid<CameraFrame, CameraFrame> scope;
      scope.rotation = Eigen::AngleAxisd(turn, Eigen::Vector3d(axis)).toRotationMatrix();
      scope.translation = middle - scope.rotation * middle;
      scopes.push_back(scope);
    }
  PatchOptions sampling;
  sampling.noise_mm = 0.0;
  sampling.share = 0.5;
  // Within 3 mm: the truth's mesh is another than the patient's surface.
  const auto seen_share = [&](const Points& points, const Rigid<CameraFrame, CameraFrame>& scope) {
    const RayCaster caster({scope.apply(surface.vertices), surface.triangles});
    int seen = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      seen += caster.sees(Eigen::Vector3d::Zero(), points.row(i).transpose(), 3e-3) ? 1 : 0;
    return seen / static_cast<double>(points.rows());
  };
  QVERIFY(seen_share(handled->patch(sampling).cloud.points, {}) < 0.9);
  const std::vector<Patch> looks = handled->looks(sampling, scopes);
  QCOMPARE(looks.size(), scopes.size());
  int taken = 0;
  double sum = 0.0;
  for (std::size_t k = 0; k < looks.size(); ++k) {
    if (looks[k].cloud.size() == 0) continue;
    ++taken;
    sum += looks[k].share;
    const double share = seen_share(looks[k].cloud.points, scopes[k]);
    QVERIFY2(share > 0.97, qPrintable(QString("look %1: %2").arg(k).arg(share)));
  }
  QVERIFY(taken > 1 && looks[0].share > 0.25 && looks[0].share < 0.5 && sum > 0.5);
  // What one look shows alone is the plain patch.
  sampling.share = 0.2;
  QCOMPARE(handled->looks(sampling, {{}}).front().cloud.points, handled->patch(sampling).cloud.points);
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
