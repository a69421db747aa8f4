// SPDX-License-Identifier: GPL-3.0-or-later
// Which landmark is a person's mark, which one the atlas' guess, and that a mark wins over a guess.
#include <QTest>
#include <algorithm>

#include "atlas_cases.h"
#include "atlas_member.h"
#include "glisson/engine/commands/propose_landmarks.h"
#include "glisson/engine/commands/review_proposal.h"
#include "glisson/engine/landmark_origin.h"
#include "glisson/engine/parts/proposals.h"

using namespace glisson;
using namespace glisson::engine;
using atlas::Decision;
using atlas::Source;
using atlas::Structure;

namespace {

const RunContext kContext;
const Eigen::RowVector3d kElsewhere(0.0, 0.0, 0.02);  // metres

bool has(const std::vector<std::string>& notes, const std::string& begin) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const std::string& note) { return note.starts_with(begin); });
}

CaseState reviewed(const CaseState& state, Structure structure, Decision decision,
                   const Points& moved = Points(0, 3)) {
  return ReviewProposal{structure, decision, moved}.apply(state, kContext)->state;
}

CaseState with(CaseState state, const Landmarks& landmarks) {
  state[part::landmarks] = std::make_shared<const Landmarks>(landmarks);
  return state;
}

/// What the model is taken to have found of its margin.
CaseState with_crest(CaseState state, const Points& crest) {
  auto built = std::make_shared<model::BuiltModel>(*state[part::model]);
  built->model.landmarks.anterior_margin = crest;
  state[part::model] = built;
  return state;
}

Source source_of(const CaseState& state, Structure structure) {
  const auto all = landmark_origins(state);
  return *std::ranges::find(all, structure, &LandmarkOrigin::structure)->source;
}

const atlas::Proposal& proposed(const CaseState& state, Structure structure) {
  return *proposal_of(state, structure);
}

/// With the margin's points known from there.
CaseState with_margin_of(CaseState state, const std::vector<Source>& sources) {
  auto transfer = std::make_shared<atlas::Transfer>(*state[part::proposals]);
  std::ranges::find(transfer->proposals, Structure::anterior_margin, &atlas::Proposal::structure)->sources =
      sources;
  state[part::proposals] = transfer;
  return state;
}

bool knows_margin(const CaseState& state) {
  return atlas_member("a", state).structures.contains(Structure::anterior_margin);
}

}  // namespace

class HandMarksTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    atlas_ = test::built_in_atlas();
    bare_ = test::atlas_case(*atlas_, 1);
    bare_[part::landmarks] = nullptr;
    state_ = ProposeLandmarks{atlas_}.apply(bare_, kContext)->state;
    marks_.umbilical_notch = proposed(state_, Structure::umbilical_notch).points.rowwise() + kElsewhere;
    marks_.vena_cava = proposed(state_, Structure::vena_cava).area.topRows(4).rowwise() + kElsewhere;
  }

  void whatIsPlacedAfterAcceptIsThePersons() {
    CaseState now = reviewed(state_, Structure::umbilical_notch, Decision::accepted);
    now = reviewed(now, Structure::vena_cava, Decision::accepted);
    QVERIFY(landmark_review(now).from_statistics);
    QVERIFY(atlas_member("a", now).structures.empty());
    now = with(now, marks_);
    QVERIFY(!landmark_review(now).from_statistics);
    QVERIFY(!has(landmark_notes(now), "atlas."));
    const auto known = atlas_member("a", now).structures;
    QVERIFY(known.at(Structure::umbilical_notch) == marks_.umbilical_notch);
    QVERIFY(known.at(Structure::vena_cava) == marks_.vena_cava);
    for (const LandmarkOrigin& one : landmark_origins(now))
      if (one.is_used) QVERIFY(one.source == Source::person && !one.deviation);
  }

  void whatIsAddedToAGuessLeavesItOne() {
    const CaseState now = reviewed(state_, Structure::vena_cava, Decision::accepted);
    Landmarks more = *now[part::landmarks];
    more.vena_cava.conservativeResize(more.vena_cava.rows() + 1, 3);
    more.vena_cava.bottomRows(1) = marks_.vena_cava.topRows(1);
    QVERIFY(has(landmark_notes(with(now, more)), "atlas.cava_from_statistics"));
    QVERIFY(source_of(with(now, more), Structure::vena_cava) == Source::statistics);
    QCOMPARE(atlas_member("a", with(now, more)).structures.at(Structure::vena_cava).rows(), 1);
  }

  /// "Accept landmarks" stores the model's own: seen by a person, placed by none.
  void whatTheModelHasFoundIsNoMark() {
    const Points crest = proposed(state_, Structure::anterior_margin).points.topRows(20);
    Landmarks shown;
    shown.anterior_margin = crest;
    const CaseState now = with(with_crest(state_, crest), shown);
    QVERIFY(source_of(now, Structure::anterior_margin) == Source::image);
    QVERIFY(!knows_margin(now));
    shown.anterior_margin.rowwise() += kElsewhere;
    QVERIFY(source_of(with(now, shown), Structure::anterior_margin) == Source::person);
    QVERIFY(knows_margin(with(now, shown)));
  }

  /// One of a proposal that is gone, as from another program's file.
  void whatMayLieElsewhereIsNoMark() {
    Landmarks guess;
    guess.umbilical_notch = marks_.umbilical_notch;
    guess.notch_deviation = 0.007;
    QVERIFY(source_of(with(bare_, guess), Structure::umbilical_notch) == Source::statistics);
    QVERIFY(!mark_stands(with(state_, guess), Structure::umbilical_notch));
  }

  void marksOnAFormerModelAreNoTruth() {
    CaseState now = with(bare_, marks_);
    QCOMPARE(atlas_member("a", now).structures.size(), std::size_t{2});
    now.stamp(part::landmarks).made_from[part::model] = now.stamp(part::model).revision + 1;
    QVERIFY(atlas_member("a", now).structures.empty());
  }

  void aMarginIsTruthOnlyWhole() {
    Points to = proposed(state_, Structure::anterior_margin).points;
    const CaseState drawn =
        with_margin_of(state_, std::vector<Source>(static_cast<std::size_t>(to.rows()), Source::both));
    to.row(20) += kElsewhere;
    QVERIFY(!knows_margin(reviewed(drawn, Structure::anterior_margin, Decision::moved, to)));
    to.row(0) += kElsewhere;
    to.bottomRows(1) += kElsewhere;
    QVERIFY(knows_margin(reviewed(drawn, Structure::anterior_margin, Decision::moved, to)));
    // A piece of it, where the rest is statistics.
    QVERIFY(!knows_margin(reviewed(state_, Structure::anterior_margin, Decision::moved, to)));
    to = proposed(state_, Structure::anterior_margin).points;
    to.topRows(30).rowwise() += kElsewhere;
    QVERIFY(!knows_margin(reviewed(state_, Structure::anterior_margin, Decision::moved, to)));
  }

  void aBridgedPieceOfStatisticsIsTold() {
    Points to = proposed(state_, Structure::anterior_margin).points;
    std::vector<Source> sources(static_cast<std::size_t>(to.rows()), Source::both);
    sources[12] = sources[13] = Source::statistics;
    const CaseState drawn = with_margin_of(state_, sources);
    to.row(20) += kElsewhere;
    for (const CaseState& now : {reviewed(drawn, Structure::anterior_margin, Decision::accepted),
                                 reviewed(drawn, Structure::anterior_margin, Decision::moved, to)}) {
      QVERIFY(has(landmark_notes(now), "atlas.margin_from_statistics 4"));
      QVERIFY(landmark_review(now).from_statistics);
    }
    sources[12] = sources[13] = Source::both;
    const CaseState whole =
        reviewed(with_margin_of(state_, sources), Structure::anterior_margin, Decision::accepted);
    QVERIFY(!landmark_review(whole).from_statistics);
  }

  void acceptingAnotherPlaceLeavesTheMarkAndSaysSo() {
    const CaseState marked = with(state_, marks_);
    for (const Structure structure : {Structure::umbilical_notch, Structure::vena_cava}) {
      QVERIFY(mark_stands(marked, structure) && !mark_stands(state_, structure));
      const auto accepted = ReviewProposal{structure, Decision::accepted}.apply(marked, kContext);
      QVERIFY(placed_points(accepted->state, structure) == placed_points(marked, structure));
      QVERIFY(has(accepted->notes, std::string("landmarks.mark_stays ") + atlas::structure_code(structure)));
      QVERIFY(source_of(accepted->state, structure) == Source::person);
      const CaseState hidden = reviewed(marked, structure, Decision::not_visible);
      QVERIFY(placed_points(hidden, structure) == placed_points(marked, structure));
    }
    // Who moves it places it anew.
    const Points to = marks_.umbilical_notch.rowwise() + kElsewhere;
    const CaseState moved = reviewed(marked, Structure::umbilical_notch, Decision::moved, to);
    QVERIFY(placed_points(moved, Structure::umbilical_notch) == to);
  }

  /// Found in the CT beats the mean, a person's mark beats both.
  void whatAPersonHasPlacedIsProposed() {
    Landmarks on_liver = marks_;
    on_liver.vena_cava = proposed(state_, Structure::vena_cava).area.topRows(4);
    on_liver.umbilical_notch = proposed(state_, Structure::falciform_line).points.row(4);
    const auto made = ProposeLandmarks{atlas_}.apply(with(bare_, on_liver), kContext);
    const atlas::Proposal& notch = proposed(made->state, Structure::umbilical_notch);
    QVERIFY(notch.source() == Source::person && notch.decision == Decision::proposed);
    QVERIFY((notch.points - on_liver.umbilical_notch).norm() < 0.002 && notch.deviation() < 0.006);
    const atlas::Proposal& cava = proposed(made->state, Structure::vena_cava);
    QVERIFY(cava.source() == Source::person && cava.area == on_liver.vena_cava);
    QVERIFY(proposed(made->state, Structure::portal_entrance).source() == Source::statistics);
    for (const Structure structure : {Structure::umbilical_notch, Structure::vena_cava}) {
      QVERIFY(!mark_stands(made->state, structure));
      const auto accepted = ReviewProposal{structure, Decision::accepted}.apply(made->state, kContext);
      QVERIFY(placed_points(accepted->state, structure) == placed_points(made->state, structure));
      QVERIFY(accepted->notes.empty() && !landmark_review(accepted->state).from_statistics);
    }
  }

  /// What was merely accepted must not pass for a mark once another atlas has spoken.
  void proposingAgainKeepsWhatWasMovedAndAsksTheRestAgain() {
    CaseState now = reviewed(state_, Structure::umbilical_notch, Decision::accepted);
    const Points to = proposed(state_, Structure::vena_cava).area.topRows(9).rowwise() + kElsewhere;
    now = reviewed(now, Structure::vena_cava, Decision::moved, to);
    const Points cava = placed_points(now, Structure::vena_cava);
    const CaseState again = ProposeLandmarks{atlas_}.apply(now, kContext)->state;
    QCOMPARE(placed_points(again, Structure::umbilical_notch).rows(), 0);
    QVERIFY(proposed(again, Structure::umbilical_notch).decision == Decision::proposed);
    QVERIFY(has(landmark_notes(again), "landmarks.not_reviewed umbilical_notch"));
    QVERIFY(placed_points(again, Structure::vena_cava) == cava);
    QVERIFY(proposed(again, Structure::vena_cava).decision == Decision::moved);
    QVERIFY(proposed(again, Structure::vena_cava).area == to);
    // Of a guess with a mark beside it the mark stays.
    now = reviewed(state_, Structure::vena_cava, Decision::accepted);
    Landmarks more = *now[part::landmarks];
    more.vena_cava.conservativeResize(more.vena_cava.rows() + 1, 3);
    more.vena_cava.bottomRows(1) = marks_.vena_cava.topRows(1);
    const CaseState mixed = ProposeLandmarks{atlas_}.apply(with(now, more), kContext)->state;
    QVERIFY(placed_points(mixed, Structure::vena_cava) == marks_.vena_cava.topRows(1));
  }

 private:
  std::shared_ptr<const atlas::Atlas> atlas_;
  CaseState bare_, state_;  ///< without proposals; with them
  Landmarks marks_;         ///< 2 cm from what is proposed
};

QTEST_APPLESS_MAIN(HandMarksTest)
#include "hand_marks_test.moc"
