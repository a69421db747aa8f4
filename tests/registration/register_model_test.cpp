// SPDX-License-Identifier: GPL-3.0-or-later
// What one door decides of a registration: where it starts, and what it rests on.
#include "glisson/registration/register_model.h"

#include <QtTest>

#include "glisson/core/error.h"
#include "phantom.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

RegisterOptions brief() {
  RegisterOptions options;
  options.start = RegisterOptions::Start::given;
  options.given = phantom::view();
  options.elastic.max_steps = 30;
  options.operation.operations = 40;
  options.operation.gravity = 1.0;
  options.operation.gas_pa = 80.0;
  options.operation.bed_m = 0.005;
  return options;
}

}  // namespace

class RegisterModelTest : public QObject {
  Q_OBJECT
 private slots:
  void RestsOnSimulatedOperations();
  void KnownOperationsAreTakenWhereTheyAreThoseAskedFor();
  void WithoutOperationsItIsElasticityFromTheStart();
  void AToolIsFoundTogetherWithWhatOperationsDo();
  void AHeldNodeOrAPriorOfTheCallersLeavesNoneToSimulate();
  void AutomaticStartIsTheRigidOne();
  void OptionsThatAreUsedAreChecked();
  void ABareMeshIsTakenForHomogeneous();
  void CancelGivesNothing();

 private:
  Registered registered(const RegisterOptions& options, const KnownOperations& known = {}) const {
    return register_model(model_, cloud_, options, RunContext(), known).value();
  }

  PatientModel model_ = phantom::model(6, 5, 3);
  LabelledCloud cloud_ =
      phantom::patch(model_, phantom::view().apply(phantom::model(6, 5, 3).mesh.vertices), {});
};

void RegisterModelTest::RestsOnSimulatedOperations() {
  const Registered made = registered(brief());
  QVERIFY(made.operations && made.operations->operations >= 30);
  QVERIFY(!made.rigid_residual);
  QVERIFY(made.displacement.count == model_.mesh.vertex_count());
  QVERIFY(made.displacement.mean <= made.displacement.maximum);
}

void RegisterModelTest::KnownOperationsAreTakenWhereTheyAreThoseAskedFor() {
  const RegisterOptions options = brief();
  const Registered first = registered(options);
  const Registered again = registered(options, {options.operation, first.operations});
  QVERIFY(again.operations == first.operations);
  QVERIFY(again.registration.nodes_in_camera == first.registration.nodes_in_camera);
  RegisterOptions harder = options;
  harder.operation.gas_pa *= 1.5;
  QVERIFY(registered(harder, {options.operation, first.operations}).operations != first.operations);
}

void RegisterModelTest::WithoutOperationsItIsElasticityFromTheStart() {
  RegisterOptions options = brief();
  options.operations = false;
  const Registered made = registered(options);
  QVERIFY(!made.operations);
  const auto alone = register_elastic(model_, cloud_, options.given, options.elastic, RunContext());
  QVERIFY(made.registration.nodes_in_camera == alone->nodes_in_camera);
  QVERIFY(made.registration.doubts == alone->doubts);
}

/// No operation pulls at one place alone.
void RegisterModelTest::AToolIsFoundTogetherWithWhatOperationsDo() {
  std::vector<int> held;
  for (int i = 0; i < model_.mesh.vertex_count(); ++i)
    if (model_.mesh.vertices(i, 1) > 0.055) held.push_back(i);
  fem::ElasticBody body(model_.mesh, held);
  body.set_material({fem::BodyLaw::linear, 0.45});
  Points pull = Points::Zero(body.node_count(), 3);
  for (const int node : model_.surface.node_of_vertex)
    if ((model_.mesh.vertex(node) - phantom::shape(0.2, -0.3, 1.0)).norm() < 0.025)
      pull.row(node) << 0.0, 0.0, 0.01;
  body.factorise(body.rest(), {});
  Points moved = body.solve(pull);
  moved *= 0.025 / moved.rowwise().norm().maxCoeff();
  const Points truth = phantom::view().apply(Points(body.rest() + moved));
  const LabelledCloud cloud = phantom::patch(model_, truth, {});
  RegisterOptions options = brief();
  const auto together = register_model(model_, cloud, options, RunContext());
  options.method = Method::springs;
  const auto springs = register_model(model_, cloud, options, RunContext());
  QVERIFY(together->forces && !springs->forces);
  QVERIFY(together->forces->amplitudes.size() > 0 && !together->forces->forces.empty());
  const double motion = 1e3 * moved.rowwise().norm().mean();
  const double error = 1e3 * (together->registration.nodes_in_camera - truth).rowwise().norm().mean();
  QVERIFY2(error < motion, qPrintable(QString("%1 of %2 mm").arg(error).arg(motion)));
}

void RegisterModelTest::AHeldNodeOrAPriorOfTheCallersLeavesNoneToSimulate() {
  RegisterOptions held = brief();
  held.elastic.fixed_nodes = {0};
  QVERIFY(!registered(held).operations);
  RegisterOptions given = brief();
  given.elastic.prior = registered(brief()).operations;
  QVERIFY(!registered(given).operations);
  PatientModel unknown = model_;
  unknown.landmarks.vena_cava.resize(0, 3);
  if (!can_simulate_operations(unknown))
    QVERIFY(!register_model(unknown, cloud_, brief(), RunContext())->operations);
}

void RegisterModelTest::AutomaticStartIsTheRigidOne() {
  RegisterOptions options = brief();
  options.start = RegisterOptions::Start::automatic;
  options.operations = false;
  options.rigid.starts = 40;
  const Registered made = registered(options);
  const auto start = align_rigid(model_, cloud_, options.rigid, RunContext());
  QCOMPARE(made.rigid_residual.value(), start->residual);
  QVERIFY(made.registration.camera_from_ct.translation == start->camera_from_ct.translation);
  // Its doubts come first.
  QVERIFY(made.registration.doubts.size() >= start->doubts.size());
  QVERIFY(std::equal(start->doubts.begin(), start->doubts.end(), made.registration.doubts.begin()));
}

void RegisterModelTest::OptionsThatAreUsedAreChecked() {
  RegisterOptions options = brief();
  options.operation.operations = 1;
  QVERIFY_EXCEPTION_THROWN(registered(options), InputError);
  options.operations = false;
  options.rigid.starts = 0;
  options.validate();  // neither is used
  options.start = RegisterOptions::Start::automatic;
  QVERIFY_EXCEPTION_THROWN(registered(options), InputError);
  options = brief();
  options.elastic.max_steps = 0;
  QVERIFY_EXCEPTION_THROWN(registered(options), InputError);
}

void RegisterModelTest::ABareMeshIsTakenForHomogeneous() {
  PatientModel model = model_;
  model.vessels.clear();
  QVERIFY(options_for(model).materials.with_capsule);
  QVERIFY(!options_for(model, false).materials.with_capsule);  // its landmarks were only detected
  model.landmarks = {};
  QVERIFY(!options_for(model).materials.with_capsule);
  QCOMPARE(options_for(model).final_stiffening, 1.0);
  model.vessels.emplace_back();
  QVERIFY(options_for(model, false).materials.with_capsule);
}

void RegisterModelTest::CancelGivesNothing() {
  const auto cancel = std::make_shared<CancelFlag>();
  cancel->request();
  for (const auto start : {RegisterOptions::Start::given, RegisterOptions::Start::automatic})
    for (const bool operations : {true, false}) {
      RegisterOptions options = brief();
      options.start = start;
      options.operations = operations;
      QVERIFY(!register_model(model_, cloud_, options, RunContext({}, cancel, 1)));
    }
}

QTEST_APPLESS_MAIN(RegisterModelTest)
#include "register_model_test.moc"
