// SPDX-License-Identifier: GPL-3.0-or-later
// What one door decides of a registration: where it starts, and what it rests on.
#include "glisson/registration/register_model.h"
#include "glisson/registration/error_model.h"

#include <QTest>
#include <cmath>
#include <random>

#include "elastic.h"
#include "glisson/core/error.h"
#include "glisson/patient/label_map.h"
#include "glisson/registration/examined_registration.h"
#include "phantom.h"
#include "rigid.h"

using namespace glisson;
using namespace glisson::registration;

namespace {

RegisterOptions brief() {
  RegisterOptions options;
  options.start = RegisterOptions::Start::given;
  options.given = phantom::view();
  options.elastic.emplace().max_steps = 30;
  options.operation.operations = 40;
  options.operation.gravity = 1.0;
  options.operation.gas_pa = 80.0;
  options.operation.bed_m = 0.005;
  return options;
}

/// The phantom, pulled outwards at one place of its dome.
struct Pulled {
  Points truth;         ///< nodes, camera's frame
  LabelledCloud cloud;  ///< from all sides: the dome alone is so round that shapes and poses are confused
  double motion = 0.0;  ///< mean, mm

  static Eigen::Vector3d place() { return phantom::shape(0.2, -0.3, 1.0); }

  explicit Pulled(const PatientModel& model) {
    fem::ElasticBody body(model.mesh, {});
    body.set_material({fem::BodyLaw::linear, 0.45});
    Points pull = Points::Zero(body.node_count(), 3);
    for (const int node : model.surface.node_of_vertex)
      if ((model.mesh.vertex(node) - place()).norm() < 0.025) pull.row(node) << 0.0, 0.0, 0.01;
    body.factorise(body.rest(), 100.0 * body.node_volumes());
    Points moved = body.solve(pull);
    moved *= 0.03 / moved.rowwise().norm().maxCoeff();
    motion = 1e3 * moved.rowwise().norm().mean();
    truth = phantom::view().apply(Points(body.rest() + moved));
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, 0.5e-3);
    cloud.points = truth(model.surface.node_of_vertex, Eigen::all);
    for (double& coordinate : cloud.points.reshaped()) coordinate += noise(random);
  }

  /// Mean error of the nodes, mm.
  double off(const Registered& made) const {
    return 1e3 * (made.registration.nodes_in_camera - truth).rowwise().norm().mean();
  }
};

}  // namespace

class RegisterModelTest : public QObject {
  Q_OBJECT
 private slots:
  void LandmarksAloneAreRefused();
  void RestsOnSimulatedOperations();
  void KnownOperationsAreTakenWhereTheyAreThoseAskedFor();
  void WithoutOperationsItIsElasticityFromTheStart();
  void AToolIsFoundTogetherWithWhatOperationsDo();
  void ManyToolsAreDoubted();
  void NoToolIsSeenWhereNoneActs();
  void ShapesAreFoundWithoutAVenaCava();
  void AHeldNodeOrAPriorOfTheCallersLeavesNoneToSimulate();
  void AutomaticStartIsTheRigidOne();
  void NothingIsJudgedByAPlaceThatNobodyHasGiven();
  void WhatIsNoPointOfTheCloudChangesNothing();
  void MarksOfALandmarkThatTheModelLacksAreSurface();
  void HeldNodesAreNoKnownPlaceWhereThePoseIsSought();
  void ALesionIsAsUncertainAsTheTissueAroundIt();
  void OptionsThatAreUsedAreChecked();
  void ABareMeshIsTakenForHomogeneous();
  void WhatIsLeftEmptyTheModelDecides();
  void OneThreadGivesTheBitsOfTwo_data();
  void OneThreadGivesTheBitsOfTwo();
  void CancelGivesNothing();
  void CancelEndsTheControlBesideTheRest();

 private:
  Registered registered(const RegisterOptions& options, const KnownOperations& known = {}) const {
    return register_model(model_, cloud_, options, RunContext(), known).value().registered;
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
  const auto alone = register_elastic(model_, cloud_, options.given, *options.elastic, RunContext());
  QVERIFY(made.registration.nodes_in_camera == alone->nodes_in_camera);
  QVERIFY(made.registration.doubts == alone->doubts);
}

/// No operation pulls at one place alone.
void RegisterModelTest::AToolIsFoundTogetherWithWhatOperationsDo() {
  const Pulled pulled(model_);
  const auto registered_by = [&](Method method) {
    RegisterOptions options = brief();
    options.method = method;
    return register_model(model_, pulled.cloud, options, RunContext()).value().registered;
  };
  const Registered both = registered_by(Method::automatic), springs = registered_by(Method::springs);
  qInfo("moved by %.2f mm; springs %.2f, with forces of tools %.2f mm (in silico)", pulled.motion,
        pulled.off(springs), pulled.off(both));
  QVERIFY(both.forces && !both.forces->forces.empty() && !springs.forces);
  QVERIFY(pulled.off(both) < 0.5 * pulled.off(springs));
  // The force acts where it was applied, outwards.
  const ContactForce& strongest = both.forces->forces.front();
  QVERIFY((model_.mesh.vertex(strongest.node) - Pulled::place()).norm() < 0.03);
  QVERIFY(strongest.force.normalized().z() > 0.7);
}

/// A rough stone of the organ's size: nearly anything is explained by enough forces, and that is said.
void RegisterModelTest::ManyToolsAreDoubted() {
  LabelledCloud stone;
  stone.points = Pulled(model_).truth(model_.surface.node_of_vertex, Eigen::all);
  const Eigen::RowVector3d middle = stone.points.colwise().mean();
  for (Eigen::Index i = 0; i < stone.points.rows(); ++i) {
    const Eigen::RowVector3d p = 130.0 * (stone.points.row(i) - middle);
    stone.points.row(i) += 0.03 * std::sin(p.x()) * std::sin(p.y() + 1.0) * std::sin(p.z() + 2.0) *
                           (stone.points.row(i) - middle).normalized();
  }
  const Registered made = register_model(model_, stone, brief(), RunContext()).value().registered;
  const auto is_many = [](const std::string& doubt) { return doubt.starts_with("forces_many "); };
  const auto& doubts = made.registration.doubts;
  QVERIFY(std::any_of(doubts.begin(), doubts.end(), is_many));
  const Registered pulled =
      register_model(model_, Pulled(model_).cloud, brief(), RunContext()).value().registered;
  QVERIFY(std::none_of(pulled.registration.doubts.begin(), pulled.registration.doubts.end(), is_many));
}

/// Where what was simulated explains the cloud no force is worth its price.
void RegisterModelTest::NoToolIsSeenWhereNoneActs() {
  const RegisterOptions options = brief();
  const Registered made = registered(options);
  QVERIFY(!made.forces);
  RegisterOptions springs = options;
  springs.method = Method::springs;
  QVERIFY(made.registration.nodes_in_camera == registered(springs).registration.nodes_in_camera);
}

/// Without a vena cava unforeseen forces are all that is known.
void RegisterModelTest::ShapesAreFoundWithoutAVenaCava() {
  PatientModel unknown = model_;
  unknown.landmarks.vena_cava.resize(0, 3);
  unknown.surfaces.clear();
  QVERIFY(!can_simulate_operations(unknown));
  const Pulled pulled(model_);
  RegisterOptions options = brief();
  const Registered made = register_model(unknown, pulled.cloud, options, RunContext()).value().registered;
  QVERIFY(!made.operations);
  options.operations = false;
  const Registered alone = register_model(unknown, pulled.cloud, options, RunContext()).value().registered;
  qInfo("unforeseen forces %.2f mm, elasticity alone %.2f mm (in silico)", pulled.off(made),
        pulled.off(alone));
  QVERIFY(pulled.off(made) < 0.9 * pulled.off(alone));
}

void RegisterModelTest::AHeldNodeOrAPriorOfTheCallersLeavesNoneToSimulate() {
  RegisterOptions held = brief();
  held.fixed_nodes = {0};
  QVERIFY(!registered(held).operations);
  RegisterOptions given = brief();
  given.elastic->prior = registered(brief()).operations;
  QVERIFY(!registered(given).operations);
  PatientModel unknown = model_;
  unknown.landmarks.vena_cava.resize(0, 3);
  if (!can_simulate_operations(unknown))
    QVERIFY(!register_model(unknown, cloud_, brief(), RunContext())->registered.operations);
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

/// A sequence in the model's own frame, as foreign ones are: its origin lies in the organ, and half of the
/// cloud would show its back to a camera there.
void RegisterModelTest::NothingIsJudgedByAPlaceThatNobodyHasGiven() {
  PatientModel bare = model_;
  bare.vessels.clear();
  bare.landmarks = {};
  LabelledCloud cloud;
  cloud.points = bare.mesh.vertices(bare.surface.node_of_vertex, Eigen::all);
  RegisterOptions options = brief();
  options.landmarks_are_placed = false;
  options.fixed_nodes = {bare.surface.node_of_vertex.front()};
  const auto examined = [&](RegisterOptions::Start start) {
    options.start = start;
    options.given = {};
    return *register_model(bare, cloud, options, RunContext());
  };
  const auto doubts_turned = [](const ExaminedRegistration& made) {
    const auto& doubts = made.registered.registration.doubts;
    return std::any_of(doubts.begin(), doubts.end(),
                       [](const std::string& doubt) { return doubt.starts_with("points_turned"); });
  };
  // A camera in the origin could not have seen it.
  QVERIFY(doubts_turned(examined(RegisterOptions::Start::given)));
  const ExaminedRegistration none = examined(RegisterOptions::Start::none);
  QVERIFY(!doubts_turned(none));
  QVERIFY(std::isnan(none.findings.hidden) && std::isnan(none.findings.turned));
  // Normals of the cloud's own need no camera.
  cloud.normals = -vertex_normals(bare.surface.mesh);
  QVERIFY(doubts_turned(examined(RegisterOptions::Start::none)));
}

void RegisterModelTest::WhatIsNoPointOfTheCloudChangesNothing() {
  RegisterOptions options = brief();
  options.operations = false;
  const auto made = register_model(model_, cloud_, options, RunContext()).value();
  QVERIFY(made.cloud_faults.notes().empty());
  LabelledCloud spoilt = cloud_;  // each point twenty times, and as many zeros
  const Eigen::Index n = cloud_.points.rows();
  spoilt.points = Points::Zero(21 * n, 3);
  spoilt.points.topRows(20 * n) = cloud_.points.replicate(20, 1);
  spoilt.normals.resize(0, 3);
  spoilt.sigma.clear();
  LabelledCloud bare = cloud_;
  bare.normals.resize(0, 3);
  bare.sigma.clear();
  if (!cloud_.features.empty())
    for (Eigen::Index i = n; i < 21 * n; ++i)
      spoilt.features.push_back(i < 20 * n ? cloud_.feature(static_cast<int>(i % n)) : Feature::surface);
  const auto expected = register_model(model_, bare, options, RunContext()).value();
  const auto found = register_model(model_, spoilt, options, RunContext()).value();
  QVERIFY(found.registered.registration.nodes_in_camera == expected.registered.registration.nodes_in_camera);
  QCOMPARE(found.cloud_faults.repeated, static_cast<int>(19 * n));
  QCOMPARE(found.cloud_faults.without_depth, static_cast<int>(n));
}

/// In every stage, the rigid start and the springs among them.
void RegisterModelTest::MarksOfALandmarkThatTheModelLacksAreSurface() {
  PatientModel bare = model_;
  bare.landmarks.anterior_margin.resize(0, 3);
  bare.landmarks.umbilical_notch.resize(0, 3);
  LabelledCloud marked = cloud_, plain = cloud_;
  plain.features.clear();
  marked.features.assign(static_cast<std::size_t>(marked.size()), Feature::surface);
  for (int i = 0; i < marked.size(); ++i)
    marked.features[static_cast<std::size_t>(i)] = i % 5 == 0   ? Feature::umbilical_notch
                                                   : i % 5 == 1 ? Feature::anterior_margin
                                                                : Feature::surface;
  RegisterOptions options = brief();
  options.start = RegisterOptions::Start::automatic;
  options.operations = false;
  options.rigid.starts = 40;
  const auto nodes = [&](const LabelledCloud& cloud) {
    return register_model(bare, cloud, options, RunContext())->registered.registration.nodes_in_camera;
  };
  QVERIFY(nodes(marked) == nodes(plain));
  QVERIFY(register_model(model_, marked, options, RunContext())->registered.registration.nodes_in_camera !=
          nodes(marked));
}

/// They are held where the start puts them, which is millimetres off.
void RegisterModelTest::HeldNodesAreNoKnownPlaceWhereThePoseIsSought() {
  RegisterOptions options = brief();
  options.fixed_nodes = {0, 1, 2, 3, 4, 5};
  options.rigid.starts = 40;
  const auto expected_there = [&](RegisterOptions::Start start) {
    options.start = start;
    return register_model(model_, cloud_, options, RunContext())
        ->registered.registration.expected.head(6)
        .maxCoeff();
  };
  const double given = expected_there(RegisterOptions::Start::given),
               sought = expected_there(RegisterOptions::Start::automatic);
  qInfo("expected at held nodes: %.3f mm where the pose is given, %.3f mm where it is sought", 1e3 * given,
        1e3 * sought);
  QVERIFY(given < 1e-4);
  QVERIFY(sought > 5e-4);
}

/// Of a bare mesh with held nodes the forces' own posterior, which knows that laws differ, gives both.
void RegisterModelTest::ALesionIsAsUncertainAsTheTissueAroundIt() {
  PatientModel bare = model_;
  bare.vessels.clear();
  bare.landmarks = {};
  bare.mesh.labels[200] = structure::kFirstLesion;
  RegisterOptions options = brief();
  options.landmarks_are_placed = false;
  options.fixed_nodes = {bare.surface.node_of_vertex.front(), bare.surface.node_of_vertex.back()};
  const auto made = register_model(bare, Pulled(model_).cloud, options, RunContext()).value();
  const Registration& registration = made.registered.registration;
  QVERIFY(made.registered.forces && registration.lesions.size() == 1);
  double around = 0.0;
  for (int k = 0; k < 4; ++k) around += 0.25 * registration.expected[bare.mesh.tetrahedra(200, k)];
  const double own = mean_error(registration.lesions.front().covariance);
  QVERIFY2(std::abs(own / around - 1.0) < 0.01, qPrintable(QString("%1 of %2").arg(own).arg(around)));
}

void RegisterModelTest::OptionsThatAreUsedAreChecked() {
  RegisterOptions options = brief();
  options.operation.operations = 1;
  QVERIFY_THROWS_EXCEPTION(InputError, registered(options));
  options.operations = false;
  options.rigid.starts = 0;
  options.validate();  // neither is used
  options.start = RegisterOptions::Start::automatic;
  QVERIFY_THROWS_EXCEPTION(InputError, registered(options));
  options = brief();
  options.elastic->max_steps = 0;
  QVERIFY_THROWS_EXCEPTION(InputError, registered(options));
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

/// What nobody says the model decides, and the paper's method is one name.
void RegisterModelTest::WhatIsLeftEmptyTheModelDecides() {
  PatientModel bare = model_;
  bare.vessels.clear();
  bare.landmarks = {};
  RegisterOptions options;
  options.landmarks_are_placed = false;
  const ElasticOptions decided = elastic_of(options, bare), expected = options_for(bare, false);
  QVERIFY(!decided.materials.with_capsule);
  QCOMPARE(decided.final_stiffening, expected.final_stiffening);
  QCOMPARE(decided.tangential, expected.tangential);
  options.materials.emplace();  // with a capsule
  options.fixed_nodes = {3};
  const ElasticOptions given = elastic_of(options, bare);
  QVERIFY(given.materials.with_capsule);
  QVERIFY((given.fixed_nodes == std::vector<int>{3}));
  QCOMPARE(given.final_stiffening, expected.final_stiffening);

  RegisterOptions paper = brief(), springs = brief();
  paper.method = Method::paper;
  springs.method = Method::springs;
  springs.operations = false;
  const Registered published = registered(paper);
  QVERIFY(!published.operations);
  QVERIFY(published.registration.nodes_in_camera == registered(springs).registration.nodes_in_camera);
}

void RegisterModelTest::OneThreadGivesTheBitsOfTwo_data() {
  QTest::addColumn<bool>("joined");
  QTest::newRow("one look: the control runs beside the rest") << false;
  QTest::newRow("two looks: it comes after it") << true;
}

/// From the rigid start to what is expected of the error.
void RegisterModelTest::OneThreadGivesTheBitsOfTwo() {
  QFETCH(bool, joined);
  PatientModel model = model_;
  model.mesh.labels[200] = structure::kFirstLesion;
  const Pulled pulled(model);
  const auto made_on = [&](int threads) {
    RegisterOptions options = brief();
    options.start = RegisterOptions::Start::automatic;
    if (joined)
      options.looks = {phantom::patch(model, phantom::view(0.3).apply(model.mesh.vertices), {.seed = 2})};
    options.threads = threads;
    return register_model(model, pulled.cloud, options, RunContext()).value();
  };
  const ExaminedRegistration one = made_on(1), two = made_on(2);
  const Registration &a = one.registered.registration, &b = two.registered.registration;
  QVERIFY(a.nodes_in_camera == b.nodes_in_camera);
  QVERIFY(a.expected == b.expected);
  QCOMPARE(a.doubts, b.doubts);
  QVERIFY(one.registered.operations->modes == two.registered.operations->modes);
  QVERIFY(one.lesions.front().covariance == two.lesions.front().covariance);
  QCOMPARE(a.rivals.size(), b.rivals.size());
  for (std::size_t k = 0; k < a.rivals.size(); ++k) {
    QVERIFY(a.rivals[k].nodes_in_camera == b.rivals[k].nodes_in_camera);
    QCOMPARE(a.rivals[k].probability, b.rivals[k].probability);
  }
  QVERIFY(std::isfinite(one.findings.mirror_odds));
  QVERIFY(one.findings.mirror_odds == two.findings.mirror_odds);
  // Two operations of one kind are the same, whoever has simulated them.
  OperationOptions slow;
  slow.threads = 1;
  QVERIFY(slow == OperationOptions());
  RegisterOptions three = brief();
  three.threads = 3;
  QVERIFY_THROWS_EXCEPTION(InputError, registered(three));
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

void RegisterModelTest::CancelEndsTheControlBesideTheRest() {
  const auto cancel = std::make_shared<CancelFlag>();
  int told_after = 0;
  const RunContext context(
      [&](double, std::string_view stage) {
        told_after += cancel->requested();
        if (stage == "registration.forces" || stage == "registration.elastic") cancel->request();
      },
      cancel, 1);
  RegisterOptions options = brief();
  options.start = RegisterOptions::Start::automatic;
  QVERIFY(!register_model(model_, cloud_, options, context));
  QVERIFY(cancel->requested());
  QVERIFY2(told_after < 20, qPrintable(QString::number(told_after)));  // it did not go on to the end
}

void RegisterModelTest::LandmarksAloneAreRefused() {
  const PatientModel model = phantom::model(6, 5, 3);
  LabelledCloud cloud = phantom::patch(model, phantom::view().apply(model.mesh.vertices), {});
  cloud.features.assign(static_cast<std::size_t>(cloud.size()), Feature::anterior_margin);
  for (const Method method : {Method::automatic, Method::springs, Method::forces}) {
    RegisterOptions options = brief();
    options.method = method;
    QVERIFY_THROWS_EXCEPTION(InputError, register_model(model, cloud, options, RunContext()));
  }
}

QTEST_APPLESS_MAIN(RegisterModelTest)
#include "register_model_test.moc"
