// SPDX-License-Identifier: GPL-3.0-or-later
// What the atlas proposes is a part of the case, and nothing of it is a landmark before a person says so.
#include <QTest>

#include <Eigen/Eigenvalues>
#include <cstdlib>
#include <functional>

#include "../support/portal_trees.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/propose_landmarks.h"
#include "glisson/engine/commands/restore_review.h"
#include "glisson/engine/commands/review_proposal.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/proposals.h"

using namespace glisson;
using namespace glisson::engine;
using atlas::Decision;
using atlas::Source;
using atlas::Structure;

namespace {

std::shared_ptr<const atlas::Atlas> built_in() {
  const char* source = std::getenv("GLISSON_SOURCE_DIR");
  return std::make_shared<const atlas::Atlas>(
      atlas::read_atlas(std::filesystem::path(source != nullptr ? source : ".") / "resources/atlas"));
}

/// A patient whose liver is the atlas' mean, larger and elsewhere, without vena cava or margin.
CaseState patient(const atlas::Atlas& known) {
  auto built = std::make_shared<model::BuiltModel>();
  built->model.mesh.vertices.resize(4, 3);
  built->model.mesh.vertices << 0, 0, 0, 0.2, 0, 0, 0, 0.2, 0, 0, 0, 0.2;
  built->model.mesh.tetrahedra.resize(1, 4);
  built->model.mesh.tetrahedra << 0, 1, 2, 3;
  built->model.mesh.labels = {structure::kParenchyma};
  built->model.surface = boundary_surface(built->model.mesh);
  TriangleMesh liver = known.mean();
  liver.vertices = (1.05 * liver.vertices).rowwise() + Eigen::RowVector3d(0.03, -0.1, 0.2);
  built->model.surfaces.push_back({structure::kParenchyma, "liver", liver});
  CaseState state;
  state[part::model] = built;
  return state;
}

double apart(const Points& a, const Points& b) {
  return a.rows() == b.rows() ? (a - b).rowwise().norm().maxCoeff() : 1.0;
}

bool has(const std::vector<std::string>& notes, const char* wanted) {
  return std::find(notes.begin(), notes.end(), wanted) != notes.end();
}

}  // namespace

class ProposalsTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase() {
    atlas_ = built_in();
    auto applied = ProposeLandmarks{atlas_}.apply(patient(*atlas_), RunContext());
    QVERIFY(applied);
    state_ = applied->state;
    figures_ = applied->figures;
  }

  void everyStructureIsProposedWhereTheAtlasHasIt() {
    QVERIFY(figures_.at("atlas_fit_mean_mm") < 1.0);
    for (const Structure structure : atlas::kStructures) {
      const atlas::Proposal* one = proposal_of(state_, structure);
      QVERIFY(one != nullptr);
      QVERIFY(one->decision == Decision::proposed && one->source() == Source::statistics);
      const Points expected =
          (1.05 * atlas_->find(structure)->mean).rowwise() + Eigen::RowVector3d(0.03, -0.1, 0.2);
      // Means of curves and areas lie a little off the surface, proposals on it.
      QVERIFY2((one->points - expected).rowwise().norm().mean() < 0.012, atlas::structure_code(structure));
      for (const Eigen::Matrix3d& spread : one->covariances)
        QVERIFY(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues()[0] > 0.0);
    }
  }

  void nothingIsALandmarkBeforeAPersonSaysSo() {
    QVERIFY(state_[part::landmarks] == nullptr);
    QCOMPARE(effective_landmarks(state_).vena_cava.rows(), 0);
    QCOMPARE(landmark_notes(state_),
             (std::vector<std::string>{"landmarks.no_vena_cava", "landmarks.not_reviewed umbilical_notch",
                                       "landmarks.not_reviewed anterior_margin",
                                       "landmarks.not_reviewed vena_cava"}));
    QVERIFY(landmark_review(state_).is_open && !landmark_review(state_).from_statistics);
  }

  void anAcceptedCavaIsUsedAndSaidToBeStatistics() {
    const auto applied = ReviewProposal{Structure::vena_cava, Decision::accepted}.apply(state_, RunContext());
    const Points cava = effective_landmarks(applied->state).vena_cava;
    QVERIFY(cava.rows() >= 3);
    const auto notes = landmark_notes(applied->state);
    QCOMPARE(notes.size(), std::size_t{3});
    QVERIFY(notes[0].starts_with("atlas.cava_from_statistics "));
    QCOMPARE(notes[1], std::string("landmarks.not_reviewed umbilical_notch"));
    QVERIFY(landmark_review(applied->state).is_open && landmark_review(applied->state).from_statistics);
    // The notch was not asked for.
    QCOMPARE(effective_landmarks(applied->state).umbilical_notch.rows(), 0);
    // Taken back, nothing remains.
    const auto back =
        ReviewProposal{Structure::vena_cava, Decision::not_visible}.apply(applied->state, RunContext());
    QVERIFY(back->state[part::landmarks] == nullptr);
    QVERIFY(proposal_of(back->state, Structure::vena_cava)->decision == Decision::not_visible);
  }

  void aMovedPointIsThePersons() {
    Points to = proposal_of(state_, Structure::umbilical_notch)->points;
    to.row(0) += Eigen::RowVector3d(0.004, 0.0, 0.0);
    const auto applied =
        ReviewProposal{Structure::umbilical_notch, Decision::moved, to}.apply(state_, RunContext());
    QVERIFY(apart(effective_landmarks(applied->state).umbilical_notch, to) < 1e-12);
    const atlas::Proposal* notch = proposal_of(applied->state, Structure::umbilical_notch);
    QVERIFY(notch->source() == Source::person && notch->decision == Decision::moved);
    QVERIFY(notch->deviation() < proposal_of(state_, Structure::umbilical_notch)->deviation());
  }

  /// The model's portal vein is evidence, is kept as that, and the notch counts as no guess of statistics
  /// alone.
  void aPortalVeinIsEvidence() {
    CaseState now = patient(*atlas_);
    auto built = std::make_shared<model::BuiltModel>(*now[part::model]);
    VesselTree portal = test::portal_vein(test::LeftBranch::whole);
    const Points notch = proposal_of(state_, Structure::umbilical_notch)->points;
    portal.nodes.rowwise() += notch.row(0) + Eigen::RowVector3d(0.007, 0.028, 0.022);
    built->model.vessels = {portal};
    now[part::model] = built;
    const auto made = ProposeLandmarks{atlas_}.apply(now, RunContext());
    const atlas::Proposal* drawn = proposal_of(made->state, Structure::umbilical_notch);
    QVERIFY(drawn->source() == Source::both);
    QVERIFY(made->figures.at("atlas_umbilical_notch_deviation_mm") <
            0.7 * figures_.at("atlas_umbilical_notch_deviation_mm"));
    QVERIFY(made->notes.empty());
    const auto accepted =
        ReviewProposal{Structure::umbilical_notch, Decision::accepted}.apply(made->state, RunContext());
    QVERIFY(!landmark_review(accepted->state).from_statistics);
    const TemporaryFolder folder;
    QVERIFY(save_case(folder.path() / "a.glisson", accepted->state, RunContext()));
    const auto opened = open_case(folder.path() / "a.glisson", RunContext());
    QVERIFY(opened && proposal_of(*opened, Structure::umbilical_notch)->source() == Source::both);
    // One without its left branch is told.
    built = std::make_shared<model::BuiltModel>(*built);
    built->model.vessels = {test::portal_vein(test::LeftBranch::none)};
    now[part::model] = built;
    const auto told = ProposeLandmarks{atlas_}.apply(now, RunContext());
    QCOMPARE(told->notes, std::vector<std::string>{"atlas.no_umbilical_part"});
    QVERIFY(proposal_of(told->state, Structure::umbilical_notch)->source() == Source::statistics);
  }

  /// Falciform line and margin go with the notch that is moved, at once, after opening, too, and back again.
  void theOthersFollowAtOnceAndBack() {
    const Points line = proposal_of(state_, Structure::falciform_line)->points;
    Points to = proposal_of(state_, Structure::umbilical_notch)->points;
    to.row(0) = proposal_of(state_, Structure::anterior_margin)->points.row(23);
    const RestoreReview undo{*proposal_of(state_, Structure::umbilical_notch), Points(0, 3)};
    const ReviewProposal move{Structure::umbilical_notch, Decision::moved, to};
    const CaseState moved = move.apply(state_, RunContext())->state;
    const atlas::Proposal* followed = proposal_of(moved, Structure::falciform_line);
    QVERIFY((followed->points - line).row(0).norm() > 0.01);
    QVERIFY((followed->points.row(0) - to.row(0)).norm() < 0.005);
    QVERIFY(followed->decision == Decision::proposed && followed->follows.size() == 1);
    QVERIFY(followed->deviation() < proposal_of(state_, Structure::falciform_line)->deviation());
    QVERIFY(!proposal_of(moved, Structure::anterior_margin)->follows.empty());
    QVERIFY(proposal_of(moved, Structure::vena_cava)->follows.empty());  // of other livers
    QVERIFY(moved[part::landmarks]->anterior_margin.rows() == 0);        // still nobody's word
    const TemporaryFolder folder;
    QVERIFY(save_case(folder.path() / "a.glisson", moved, RunContext()));
    const auto opened = open_case(folder.path() / "a.glisson", RunContext());
    QVERIFY(opened && proposal_of(*opened, Structure::falciform_line)->follows == followed->follows);
    for (const CaseState& now : {moved, *opened}) {
      const CaseState back = undo.apply(now, RunContext())->state;
      for (const Structure one : atlas::kStructures) {
        QVERIFY(apart(proposal_of(back, one)->points, proposal_of(state_, one)->points) < 1e-6);
        QVERIFY(proposal_of(back, one)->follows.empty());
      }
      QVERIFY(back[part::landmarks] == nullptr);
    }
    // What is moved stays with its proposal, and tells the next transfer, as a mark does that is there
    // before.
    CaseState marked = state_;
    marked[part::proposals] = nullptr;
    auto marks = std::make_shared<Landmarks>();
    marks->umbilical_notch = to;
    marked[part::landmarks] = marks;
    for (const CaseState& now : {moved, marked}) {
      const auto again = ProposeLandmarks{atlas_}.apply(now, RunContext());
      QVERIFY(apart(proposal_of(again->state, Structure::falciform_line)->points, followed->points) < 0.002);
      QVERIFY(again->figures.at("atlas_falciform_line_deviation_mm") <
              figures_.at("atlas_falciform_line_deviation_mm"));
    }
  }

  /// One of a former edition: what has been proposed stays as it is.
  void aCaseThatDoesNotKnowWhatFollowsOpens() {
    auto old = std::make_shared<atlas::Transfer>(*state_[part::proposals]);
    old->basis = {};
    CaseState now = state_;
    now[part::proposals] = old;
    const TemporaryFolder folder;
    QVERIFY(save_case(folder.path() / "a.glisson", now, RunContext()));
    QVERIFY(read_file(folder.path() / "a.glisson/atlas.json").find("basis") == std::string::npos);
    now = *open_case(folder.path() / "a.glisson", RunContext());
    Points to = proposal_of(now, Structure::umbilical_notch)->points;
    to.row(0) += Eigen::RowVector3d(0.015, 0.0, 0.01);
    const auto moved =
        ReviewProposal{Structure::umbilical_notch, Decision::moved, to}.apply(now, RunContext());
    QVERIFY(apart(proposal_of(moved->state, Structure::falciform_line)->points,
                  proposal_of(now, Structure::falciform_line)->points) == 0.0);
  }

  /// Where nothing but statistics says where it runs it stays out, and that is said.
  void ofAMarginOnlyWhatIsShownIsUsed() {
    const auto accepted =
        ReviewProposal{Structure::anterior_margin, Decision::accepted}.apply(state_, RunContext());
    QCOMPARE(effective_landmarks(accepted->state).anterior_margin.rows(), 0);
    QVERIFY(has(landmark_notes(accepted->state), "atlas.margin_left_out 100"));
    Points to = proposal_of(state_, Structure::anterior_margin)->points;
    to.topRows(10).col(2).array() += 0.004;
    const auto moved =
        ReviewProposal{Structure::anterior_margin, Decision::moved, to}.apply(state_, RunContext());
    QVERIFY(apart(effective_landmarks(moved->state).anterior_margin, to.topRows(10)) < 1e-12);
    const atlas::Proposal* margin = proposal_of(moved->state, Structure::anterior_margin);
    QVERIFY(margin->sources[9] == Source::person && margin->sources[10] == Source::statistics);
    QVERIFY(margin->covariances[0].trace() < margin->covariances[20].trace());
    QVERIFY(has(landmark_notes(moved->state), "atlas.margin_left_out 75"));
  }

  /// A point that is dragged makes the landmark no shorter: pieces of statistics between what the CT shows
  /// are bridged where they are short, and where the atlas is sure.
  void aDraggedMarginIsNoShorterThanBefore() {
    const auto length = [](const Points& line) {
      return (line.bottomRows(line.rows() - 1) - line.topRows(line.rows() - 1)).rowwise().norm().sum();
    };
    auto transfer = std::make_shared<atlas::Transfer>(*state_[part::proposals]);
    atlas::Proposal& margin = transfer->proposals[index_of(Structure::anterior_margin)];
    std::fill(margin.sources.begin(), margin.sources.end(), Source::both);
    margin.sources[12] = margin.sources[13] = Source::statistics;  // short
    for (std::size_t k = 24; k < 34; ++k) {                        // long, and sure
      margin.sources[k] = Source::statistics;
      margin.covariances[k] = 25e-6 * Eigen::Matrix3d::Identity();
    }
    CaseState now = state_;
    now[part::proposals] = transfer;
    const auto accepted =
        ReviewProposal{Structure::anterior_margin, Decision::accepted}.apply(now, RunContext());
    const double before = length(effective_landmarks(accepted->state).anterior_margin);
    QVERIFY(std::abs(before - length(margin.points)) < 1e-9);
    Points to = margin.points;
    to.row(20) += Eigen::RowVector3d(0.0, 0.0, 0.006);
    const auto moved =
        ReviewProposal{Structure::anterior_margin, Decision::moved, to}.apply(accepted->state, RunContext());
    QVERIFY(length(effective_landmarks(moved->state).anterior_margin) >= before);
    // A long piece that nobody is sure of still parts it.
    for (std::size_t k = 24; k < 34; ++k) margin.covariances[k] = 9e-4 * Eigen::Matrix3d::Identity();
    const auto parted =
        ReviewProposal{Structure::anterior_margin, Decision::moved, to}.apply(now, RunContext());
    QVERIFY(apart(effective_landmarks(parted->state).anterior_margin, to.topRows(24)) < 1e-12);
  }

  void theReviewIsClosedWhenEachHasBeenDecided() {
    CaseState now = state_;
    for (const Structure one :
         {Structure::umbilical_notch, Structure::anterior_margin, Structure::vena_cava}) {
      QVERIFY(landmark_review(now).is_open);
      now = ReviewProposal{one, Decision::not_visible}.apply(now, RunContext())->state;
    }
    QVERIFY(!landmark_review(now).is_open && !landmark_review(now).from_statistics);
    for (const std::string& note : landmark_notes(now)) QVERIFY(!note.starts_with("landmarks.not_reviewed"));
    // Nobody was asked, and nobody has placed anything.
    now[part::proposals] = nullptr;
    QVERIFY(landmark_review(now).is_open);
  }

  /// What was done to another structure meanwhile stays.
  void undoTakesBackOneStructure() {
    const Points before = placed_points(state_, Structure::umbilical_notch);
    const atlas::Proposal proposed = *proposal_of(state_, Structure::umbilical_notch);
    CaseState now =
        ReviewProposal{Structure::umbilical_notch, Decision::accepted}.apply(state_, RunContext())->state;
    Landmarks by_hand = *now[part::landmarks];
    by_hand.vena_cava = Points::Constant(3, 3, 0.01);
    now[part::landmarks] = std::make_shared<const Landmarks>(by_hand);
    const auto back = RestoreReview{proposed, before}.apply(now, RunContext());
    QCOMPARE(back->state[part::landmarks]->umbilical_notch.rows(), 0);
    QCOMPARE(back->state[part::landmarks]->vena_cava.rows(), 3);
    QVERIFY(proposal_of(back->state, Structure::umbilical_notch)->decision == Decision::proposed);
  }

  /// Only what the step itself has left is taken back: a person's mark is nobody's but theirs.
  void undoLeavesALandmarkThatWasPlacedSince() {
    const RestoreReview undo{*proposal_of(state_, Structure::umbilical_notch),
                             placed_points(state_, Structure::umbilical_notch),
                             placed_deviations(state_, Structure::umbilical_notch)};
    CaseState now =
        ReviewProposal{Structure::umbilical_notch, Decision::accepted}.apply(state_, RunContext())->state;
    Landmarks by_hand = *now[part::landmarks];
    by_hand.umbilical_notch = Points::Constant(1, 3, 0.02);
    by_hand.notch_deviation = 0.0;
    now[part::landmarks] = std::make_shared<const Landmarks>(by_hand);
    const auto back = undo.apply(now, RunContext());
    QVERIFY(back->state[part::landmarks]);
    QVERIFY(apart(back->state[part::landmarks]->umbilical_notch, by_hand.umbilical_notch) == 0.0);
    QCOMPARE(back->state[part::landmarks]->notch_deviation, 0.0);
    QVERIFY(proposal_of(back->state, Structure::umbilical_notch)->decision == Decision::proposed);
  }

  /// "Accept landmarks" stores the model's own where nothing is placed: that is no mark of a person.
  void undoSeesThroughTheModelsOwnLandmarks() {
    CaseState now = state_;
    auto built = std::make_shared<model::BuiltModel>(*now[part::model]);
    built->model.landmarks.umbilical_notch = Points::Constant(1, 3, 0.01);
    now[part::model] = built;
    now = ReviewProposal{Structure::umbilical_notch, Decision::accepted}.apply(now, RunContext())->state;
    const Points accepted = placed_points(now, Structure::umbilical_notch);
    const RestoreReview undo{*proposal_of(now, Structure::umbilical_notch), accepted,
                             placed_deviations(now, Structure::umbilical_notch)};
    now = ReviewProposal{Structure::umbilical_notch, Decision::not_visible}.apply(now, RunContext())->state;
    now[part::landmarks] = std::make_shared<const Landmarks>(effective_landmarks(now));
    const auto back = undo.apply(now, RunContext());
    QVERIFY(apart(back->state[part::landmarks]->umbilical_notch, accepted) == 0.0);
  }

  /// Of landmarks that no proposal of now has put there, too.
  void undoBringsBackHowSureALandmarkWas() {
    Landmarks before;
    before.anterior_margin = proposal_of(state_, Structure::anterior_margin)->points.topRows(4);
    before.anterior_margin.array() += 0.002;
    before.margin_deviation = Eigen::Vector4d(0.0, 0.003, 0.005, 0.004);
    before.umbilical_notch = Points::Constant(1, 3, 0.02);
    before.notch_deviation = 0.007;
    CaseState then = state_;
    then[part::landmarks] = std::make_shared<const Landmarks>(before);
    QCOMPARE(placed_deviations(then, Structure::vena_cava).size(), 0);
    for (const Structure one : {Structure::anterior_margin, Structure::umbilical_notch}) {
      const RestoreReview undo{*proposal_of(then, one), placed_points(then, one),
                               placed_deviations(then, one)};
      const auto reviewed = ReviewProposal{one, Decision::not_visible}.apply(then, RunContext());
      QCOMPARE(placed_deviations(reviewed->state, one).size(), 0);
      const auto back = undo.apply(reviewed->state, RunContext());
      const Landmarks& found = *back->state[part::landmarks];
      QVERIFY(found.margin_deviation == before.margin_deviation);
      QCOMPARE(found.notch_deviation, before.notch_deviation);
      QVERIFY(apart(found.anterior_margin, before.anterior_margin) == 0.0);
      QVERIFY(apart(found.umbilical_notch, before.umbilical_notch) == 0.0);
    }
  }

  void wrongReviewsAreRefused() {
    const Points two = Points::Zero(2, 3);
    QVERIFY_THROWS_EXCEPTION(
        InputError,
        (ReviewProposal{Structure::umbilical_notch, Decision::moved, two}.apply(state_, RunContext())));
    CaseState bare = state_;
    bare[part::proposals] = std::make_shared<const atlas::Transfer>();
    QVERIFY_THROWS_EXCEPTION(InputError, (ReviewProposal{Structure::vena_cava}.apply(bare, RunContext())));
    const auto first = obstacle(patient(*atlas_), ReviewProposal{Structure::vena_cava});
    QVERIFY(first && first->part == part::proposals);
    const auto without_model = obstacle(CaseState(), ProposeLandmarks{atlas_});
    QVERIFY(without_model && without_model->part == part::model);
  }

  void proposalsAreKeptWithTheCase() {
    const auto reviewed =
        ReviewProposal{Structure::vena_cava, Decision::accepted}.apply(state_, RunContext());
    const TemporaryFolder folder;
    QVERIFY(save_case(folder.path() / "a.glisson", reviewed->state, RunContext()));
    const auto opened = open_case(folder.path() / "a.glisson", RunContext());
    QVERIFY(opened && (*opened)[part::proposals]);
    const atlas::Transfer &a = *reviewed->state[part::proposals], &b = *(*opened)[part::proposals];
    QCOMPARE(b.proposals.size(), a.proposals.size());
    for (std::size_t i = 0; i < a.proposals.size(); ++i) {
      QVERIFY(apart(a.proposals[i].points, b.proposals[i].points) < 1e-8);
      QVERIFY(a.proposals[i].decision == b.proposals[i].decision);
      QVERIFY(a.proposals[i].sources == b.proposals[i].sources);
      QVERIFY((a.proposals[i].covariances[0] - b.proposals[i].covariances[0]).norm() < 1e-12);
    }
    QVERIFY((a.modes - b.modes).norm() < 1e-9);
    QCOMPARE(landmark_notes(*opened), landmark_notes(reviewed->state));
  }

  /// A save that lost any of it is not taken for saved.
  void whatDiffersIsSeen() {
    const auto same = [](const CaseState& a, const CaseState& b) {
      return Part(part::proposals).type().spec().same(a, b);
    };
    QVERIFY(same(state_, state_));
    const std::vector<std::function<void(atlas::Transfer&, atlas::Proposal&)>> changes = {
        [](auto&, auto& cava) { cava.covariances[2](1, 1) *= 1.001; },
        [](auto&, auto& cava) { cava.covariances.pop_back(); },
        [](auto&, auto& cava) { cava.sources[1] = Source::image; },
        [](auto&, auto& cava) { cava.area.row(0).array() += 1e-4; },
        [](auto&, auto& cava) { cava.origin = "another"; },
        [](auto&, auto& cava) { ++cava.members; },
        [](auto& all, auto&) { all.doubts.emplace_back("atlas.open_surface"); },
        [](auto& all, auto&) { all.modes[0] += 0.01; },
        [](auto& all, auto&) { all.unusual += 0.01; },
        [](auto&, auto& cava) {
          cava.follows = {{Structure::umbilical_notch, Source::person, 2}};
        },
        [](auto& all, auto&) { all.basis.foretold[1].points(0, 0) += 1e-4; },
        [](auto& all, auto&) { all.basis.dependences[0].gains[0](0, 1) += 0.01; },
        [](auto& all, auto&) { all.basis.dependences[0].covariances[0] *= 1.01; },
        [](auto& all, auto&) { all.basis.upright(0, 1) += 0.01; },
        [](auto& all, auto&) { all.basis.sides_known = !all.basis.sides_known; },
        [](auto& all, auto&) { all.atlas = "another"; }};
    for (const auto& change : changes) {
      auto other = std::make_shared<atlas::Transfer>(*state_[part::proposals]);
      change(*other, other->proposals[index_of(Structure::vena_cava)]);
      CaseState lost = state_;
      lost[part::proposals] = other;
      QVERIFY(!same(state_, lost));
    }
  }

  void cancelLeavesNothing() {
    auto flag = std::make_shared<CancelFlag>();
    flag->request();
    QVERIFY(!ProposeLandmarks{atlas_}.apply(patient(*atlas_), RunContext({}, flag, 1)));
  }

 private:
  static std::size_t index_of(Structure structure) {
    return static_cast<std::size_t>(
        std::find(atlas::kStructures.begin(), atlas::kStructures.end(), structure) -
        atlas::kStructures.begin());
  }

  std::shared_ptr<const atlas::Atlas> atlas_;
  CaseState state_;
  Figures figures_;
};

QTEST_APPLESS_MAIN(ProposalsTest)
#include "proposals_test.moc"
