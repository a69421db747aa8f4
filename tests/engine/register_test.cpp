// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/accept_registration.h"
#include "glisson/engine/commands/choose_rival.h"
#include "glisson/engine/commands/undo_registration.h"
#include "glisson/engine/parts/former_registration.h"
#include "glisson/engine/parts/operations.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/registration/examined_registration.h"
#include "glisson/registration/next_look.h"
#include "glisson/registration/refusal.h"
#include "phantom_case.h"

using namespace glisson;
using namespace glisson::engine;
using test::after;
using test::phantom_case;
using test::register_on_few;

class RegisterTest : public QObject {
  Q_OBJECT
 private slots:
  void OperationsAreSimulatedOnceForAModel();
  void ProgressNeverGoesBack();
  void WhereALookHelpsIsToldOfEachLesion();
  void ANotchThatIsNotMarkedIsNotedAndNoDoubt();
  void TheMirrorImageIsRefusedUntilSomebodyAcceptsIt();
  void TheExpectedErrorGoesWithTheRegistration();
  void AnotherPlaceIsTakenAndGivenBack();
  void TheFormerRegistrationIsHadBackAndForth();
  void AnotherPlaceLeavesTheFormerOne();
  void OfOtherPointsThereIsNoFormerOne();
  void TheFormerRegistrationIsKeptWithTheCase();
  void ABareMeshIsRegisteredAsWhatItIs();
  void AModelThatEndsWithTheImageIsDoubted();
};

void RegisterTest::AModelThatEndsWithTheImageIsDoubted() {
  const auto doubts_with = [](const std::string& note) {
    CaseState state = phantom_case();
    auto cut = std::make_shared<model::BuiltModel>(*state[part::model]);
    cut->report.notes.push_back(note);
    state[part::model] = std::move(cut);
    return after(state, register_on_few())[part::registration]->doubts;
  };
  const auto told = doubts_with("liver.cut_off 166"), untold = doubts_with("liver.cut_off 3");
  QCOMPARE(std::count(told.begin(), told.end(), std::string("organ_cut 166")), 1);
  QCOMPARE(told.size(), untold.size() + 1);
}

void RegisterTest::OperationsAreSimulatedOnceForAModel() {
  const CaseState first = after(phantom_case(), register_on_few());
  QVERIFY(first[part::operations] != nullptr);
  const CaseState again = after(first, register_on_few());
  QVERIFY(again[part::operations] == first[part::operations]);
  QVERIFY(again[part::registration]->nodes_in_camera == first[part::registration]->nodes_in_camera);

  CaseState marked = first;
  marked[part::landmarks] = std::make_shared<const Landmarks>(*first[part::landmarks]);
  QVERIFY(after(marked, register_on_few())[part::operations] != first[part::operations]);
  CaseState rebuilt = first;
  rebuilt[part::model] = std::make_shared<const model::BuiltModel>(*first[part::model]);
  QVERIFY(after(rebuilt, register_on_few())[part::operations] != first[part::operations]);
  Register harder = register_on_few();
  harder.operation.gas_pa *= 1.5;
  QVERIFY(after(first, harder)[part::operations] != first[part::operations]);
}

void RegisterTest::ProgressNeverGoesBack() {
  for (const bool operations : {true, false}) {
    Register command = register_on_few();
    command.start = Register::Start::automatic;
    command.operations = operations;
    double last = 0.0;
    bool forward = true;
    const RunContext context(
        [&](double fraction, std::string_view) {
          forward = forward && fraction >= last;
          last = fraction;
        },
        {}, 1);
    QVERIFY(apply(phantom_case(), command, context).has_value());
    QVERIFY(forward);
    QVERIFY(last > 0.7);
  }
}

void RegisterTest::WhereALookHelpsIsToldOfEachLesion() {
  const auto applied = apply(phantom_case(), register_on_few(), RunContext());
  QVERIFY(applied.has_value());
  const Registration& registration = *applied->state[part::registration];
  QCOMPARE(registration.looks.size(), std::size_t{1});
  QCOMPARE(registration.looks[0].lesion, structure::kFirstLesion);
  const auto best = registration::best_look(registration.looks[0]);
  QVERIFY(best.has_value());
  QCOMPARE(applied->figures.at("lesion_1_expected_error_after_look_mm"), 1e3 * best->after);
  const auto tells_of_looks = [](const std::vector<std::string>& notes) {
    return std::any_of(notes.begin(), notes.end(),
                       [](const std::string& note) { return note.starts_with("look."); });
  };
  QVERIFY(tells_of_looks(applied->notes));
  QVERIFY(tells_of_looks(registration.notes));  // told with the registration, however long it is kept
}

void RegisterTest::ANotchThatIsNotMarkedIsNotedAndNoDoubt() {
  CaseState state = phantom_case();
  const auto told = [&state](const std::string& list) {
    const Registration made = *after(state, register_on_few())[part::registration];
    const std::vector<std::string>& all = list == "notes" ? made.notes : made.doubts;
    return std::count(all.begin(), all.end(), "no_notch");
  };
  QCOMPARE(told("notes"), 1);
  QCOMPARE(told("doubts"), 0);
  LabelledCloud marked = *state[part::cloud];
  marked.features.front() = Feature::umbilical_notch;
  state[part::cloud] = std::make_shared<const LabelledCloud>(std::move(marked));
  QCOMPARE(told("notes"), 0);
}

void RegisterTest::TheMirrorImageIsRefusedUntilSomebodyAcceptsIt() {
  CaseState state = phantom_case();
  LabelledCloud mirrored = *state[part::cloud];
  mirrored.points.col(0) *= -1.0;
  mirrored.normals.col(0) *= -1.0;
  state[part::cloud] = std::make_shared<const LabelledCloud>(std::move(mirrored));
  Register command = register_on_few();
  command.start = Register::Start::automatic;
  CaseState done = after(state, command);
  QVERIFY(registration::is_refused(*done[part::registration]));
  QVERIFY(done[part::registration]->looks.empty());
  QVERIFY(done[part::registration]->doubts.size() > 1);
  const Applied applied = apply(done, AcceptRegistration{}, RunContext()).value();
  const CaseState& accepted = applied.state;
  QCOMPARE(applied.figures.at("registration_refused"), 0.0);
  QCOMPARE(applied.figures.at("registration_doubts"),
           static_cast<double>(done[part::registration]->doubts.size()));
  QVERIFY(!registration::is_refused(*accepted[part::registration]));
  QCOMPARE(accepted[part::registration]->doubts.size(), done[part::registration]->doubts.size());
}

void RegisterTest::TheExpectedErrorGoesWithTheRegistration() {
  const CaseState state = phantom_case();
  const CaseState done = after(state, register_on_few());
  const Eigen::VectorXd& expected = done[part::registration]->expected;
  QCOMPARE(expected.size(), done[part::registration]->nodes_in_camera.rows());
  QVERIFY(expected.minCoeff() > 0.0);
  // What is seen is known better than what is not.
  double near = 0.0, far = 0.0;
  int near_count = 0, far_count = 0;
  for (Eigen::Index i = 0; i < expected.size(); ++i) {
    const double away =
        (state[part::cloud]->points.rowwise() - done[part::registration]->nodes_in_camera.row(i))
            .rowwise()
            .norm()
            .minCoeff();
    if (away < 0.01) near += expected[i], ++near_count;
    if (away > 0.06) far += expected[i], ++far_count;
  }
  QVERIFY(near_count > 5 && far_count > 5);
  QVERIFY(far / far_count > 1.2 * near / near_count);
}

void RegisterTest::AnotherPlaceIsTakenAndGivenBack() {
  CaseState done = after(phantom_case(), register_on_few());
  auto told = std::make_shared<Registration>(*done[part::registration]);
  told->rivals = {{told->nodes_in_camera.rowwise() + Eigen::RowVector3d(0.02, 0, 0), 0.1}};
  told->notes = {"landmarks.not_reviewed", "look.notch lesion_1 6.0 3.0"};
  done[part::registration] = told;
  const Applied applied = apply(done, ChooseRival{0}, RunContext()).value();
  const CaseState& taken = applied.state;
  // What holds of this place, too, is told again; where a look would help is another matter here.
  QCOMPARE(taken[part::registration]->notes, std::vector<std::string>{"landmarks.not_reviewed"});
  QCOMPARE(applied.notes.back(), std::string("landmarks.not_reviewed"));
  QCOMPARE(applied.notes.size(), taken[part::registration]->doubts.size() + 1);
  QVERIFY(taken[part::registration]->nodes_in_camera == told->rivals[0].nodes_in_camera);
  QVERIFY(taken[part::registration]->residual > told->residual);
  const CaseState back = apply(taken, ChooseRival{0}, RunContext()).value().state;
  QVERIFY(back[part::registration]->nodes_in_camera == told->nodes_in_camera);
  QVERIFY_THROWS_EXCEPTION(InputError, apply(done, ChooseRival{1}, RunContext()));
}

namespace {

/// By springs from two places: two registrations of one cloud.
CaseState registered_from(const CaseState& state, double aside) {
  Register command = register_on_few();
  command.method = registration::Method::paper;
  command.given.translation.x() += aside;
  return after(state, command);
}

}  // namespace

void RegisterTest::TheFormerRegistrationIsHadBackAndForth() {
  const CaseState first = registered_from(phantom_case(), 0.0);
  QVERIFY(!has_former_registration(first));
  const CaseState second = registered_from(first, 0.004);
  QVERIFY(has_former_registration(second));
  QVERIFY(second[part::registration] != first[part::registration]);
  const CaseState back = after(second, UndoRegistration{});
  QVERIFY(back[part::registration] == first[part::registration]);
  const CaseState forth = after(back, UndoRegistration{});
  QVERIFY(forth[part::registration] == second[part::registration]);
}

void RegisterTest::AnotherPlaceLeavesTheFormerOne() {
  CaseState done = registered_from(phantom_case(), 0.0);
  auto told = std::make_shared<Registration>(*done[part::registration]);
  told->rivals = {{told->nodes_in_camera.rowwise() + Eigen::RowVector3d(0.02, 0, 0), 0.1}};
  done[part::registration] = told;
  const CaseState taken = after(done, ChooseRival{0});
  QVERIFY(after(taken, UndoRegistration{})[part::registration] == told);
}

void RegisterTest::OfOtherPointsThereIsNoFormerOne() {
  const CaseState both = registered_from(registered_from(phantom_case(), 0.0), 0.004);
  CaseState others = both;
  others[part::cloud] = std::make_shared<const LabelledCloud>(*both[part::cloud]);
  QVERIFY(!has_former_registration(others));
  QVERIFY_THROWS_EXCEPTION(InputError, after(others, UndoRegistration{}));
  // One that was out of date is none to go back to.
  CaseState stale = registered_from(phantom_case(), 0.0);
  stale.stamp(part::registration) = {2, {{part::model, 1}}};
  stale.stamp(part::model).revision = 3;
  QVERIFY(!registered_from(stale, 0.004)[part::former_registration]);
}

void RegisterTest::TheFormerRegistrationIsKeptWithTheCase() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  const CaseState both = registered_from(registered_from(phantom_case(), 0.0), 0.004);
  save_case(path, both, RunContext());
  const CaseState read = open_case(path, RunContext()).value();
  QVERIFY(has_former_registration(read));
  const CaseState back = after(read, UndoRegistration{});
  QVERIFY((back[part::registration]->nodes_in_camera -
           both[part::former_registration]->registration->nodes_in_camera)
              .norm() < 1e-9);
  QCOMPARE(back[part::registration]->doubts, both[part::former_registration]->registration->doubts);
  // What is malformed of it, or without its file, lets the case open, and says so.
  nlohmann::json document = read_json(path / "case.json");
  document["parts"]["former_registration"].erase("plateaus");
  write_json(path / "case.json", document);
  std::vector<std::string> malformed;
  QVERIFY(!open_case(path, RunContext(), &malformed).value()[part::former_registration]);
  QCOMPARE(malformed.size(), std::size_t{1});
  std::filesystem::remove(path / "former_registration.vtu");
  std::vector<std::string> lost;
  const CaseState without = open_case(path, RunContext(), &lost).value();
  QVERIFY(without[part::registration] && !without[part::former_registration]);
  QVERIFY(std::any_of(lost.begin(), lost.end(), [](const std::string& note) {
    return note.starts_with("case.former_registration_lost ");
  }));
}

/// The window posts Register with nothing said, the command line says materials where somebody has: one law.
void RegisterTest::ABareMeshIsRegisteredAsWhatItIs() {
  CaseState state = phantom_case();
  auto bare = std::make_shared<model::BuiltModel>(*state[part::model]);
  bare->model.vessels.clear();
  state[part::model] = bare;
  state[part::landmarks] = nullptr;  // those of the model were only detected
  Register said;
  said.start = Register::Start::given;
  said.given = phantom::view();
  said.method = registration::Method::paper;
  const Points silent = after(state, said)[part::registration]->nodes_in_camera;
  const PatientModel model = effective_model(state);
  registration::RegisterOptions bare_law = said;
  bare_law.elastic = registration::options_for(model, false);
  const auto alone = registration::register_model(model, *state[part::cloud], bare_law, RunContext());
  QVERIFY(silent == alone->registered.registration.nodes_in_camera);
  said.materials.emplace().with_capsule = false;
  QVERIFY(after(state, said)[part::registration]->nodes_in_camera == silent);
  said.materials.reset();
  state[part::landmarks] = std::make_shared<const Landmarks>(bare->model.landmarks);  // a person says so
  QVERIFY(after(state, said)[part::registration]->nodes_in_camera != silent);
}

QTEST_APPLESS_MAIN(RegisterTest)
#include "register_test.moc"
