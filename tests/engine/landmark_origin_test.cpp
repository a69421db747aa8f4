// SPDX-License-Identifier: GPL-3.0-or-later
// The table of decisions: where a case's landmarks come from and what a person made of the proposals.
#include <QTest>

#include "atlas_cases.h"
#include "glisson/core/error.h"
#include "glisson/engine/commands/propose_landmarks.h"
#include "glisson/engine/commands/review_proposal.h"
#include "glisson/engine/landmark_origin.h"

using namespace glisson;
using namespace glisson::engine;
using atlas::Decision;
using atlas::Source;
using atlas::Structure;

namespace {

LandmarkOrigin origin_of(const CaseState& state, Structure structure) {
  const auto all = landmark_origins(state);
  return *std::find_if(all.begin(), all.end(),
                       [&](const LandmarkOrigin& one) { return one.structure == structure; });
}

}  // namespace

class LandmarkOriginTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    const auto known = test::built_in_atlas();
    placed_ = test::atlas_case(*known, 1);
    CaseState bare = placed_;
    bare[part::landmarks] = nullptr;
    proposed_ = ProposeLandmarks{known}.apply(bare, RunContext())->state;
  }

  void whatAPersonPlacedIsThePersons() {
    const LandmarkOrigin notch = origin_of(placed_, Structure::umbilical_notch);
    QVERIFY(notch.source == Source::person && notch.is_used);
    QVERIFY(!notch.deviation && !notch.decision);
    const LandmarkOrigin cava = origin_of(placed_, Structure::vena_cava);
    QVERIFY(!cava.source && !cava.is_used);
    QCOMPARE(landmark_origins(placed_).size(), atlas::kStructures.size());
  }

  void whatTheModelShowsIsTheImages() {
    CaseState state = placed_;
    auto built = std::make_shared<model::BuiltModel>(*state[part::model]);
    built->model.landmarks.vena_cava = Points::Constant(3, 3, 0.01);
    state[part::model] = built;
    QVERIFY(origin_of(state, Structure::vena_cava).source == Source::image);
  }

  void aProposalTellsItsSourceAndItsDecision() {
    const LandmarkOrigin asked = origin_of(proposed_, Structure::umbilical_notch);
    QVERIFY(asked.source == Source::statistics && asked.decision == Decision::proposed && !asked.is_used);
    QVERIFY(*asked.deviation > 0.002);
    const CaseState accepted =
        ReviewProposal{Structure::umbilical_notch, Decision::accepted}.apply(proposed_, RunContext())->state;
    const LandmarkOrigin taken = origin_of(accepted, Structure::umbilical_notch);
    QVERIFY(taken.source == Source::statistics && taken.decision == Decision::accepted && taken.is_used);
    const CaseState refused = ReviewProposal{Structure::umbilical_notch, Decision::not_visible}
                                  .apply(proposed_, RunContext())
                                  ->state;
    const LandmarkOrigin left = origin_of(refused, Structure::umbilical_notch);
    QVERIFY(left.decision == Decision::not_visible && !left.is_used);
  }

  void thereMustBeAModel() { QVERIFY_THROWS_EXCEPTION(PreconditionError, landmark_origins(CaseState())); }

 private:
  CaseState placed_, proposed_;
};

QTEST_APPLESS_MAIN(LandmarkOriginTest)
#include "landmark_origin_test.moc"
