// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/case_io.h"

#include <QtTest>

#include <fstream>
#include <nlohmann/json.hpp>

#include "complaint.h"
#include "full_disk.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/landmarks.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/video.h"
#include "killed_child.h"

using namespace glisson;
using namespace glisson::engine;
namespace fs = std::filesystem;

namespace {

/// Two tetrahedra, 0.2 m long: small, but with everything that a case can hold.
CaseState small_case(double scale = 1.0) {
  CaseState state;
  VolumeGrid grid;
  grid.size = {20, 18, 16};
  grid.spacing_mm = {1.5, 1.5, 2.0};
  grid.origin_mm = {-10.0, 20.0, -30.0};
  auto voxels = std::make_shared<std::vector<std::int16_t>>(static_cast<std::size_t>(grid.voxel_count()));
  for (std::size_t i = 0; i < voxels->size(); ++i) (*voxels)[i] = static_cast<std::int16_t>(i % 700) - 100;
  auto image = std::make_shared<Image>();
  image->grid = grid;
  image->voxels = voxels;
  state[part::image] = image;
  auto labels = std::make_shared<LabelMap>();
  labels->voxels = LabelVolume(grid);
  for (int i = 4; i < 12; ++i) labels->voxels.set({i, 5, 6}, structure::kParenchyma);
  labels->infos.push_back(
      {structure::kParenchyma, "parenchyma", "", structure_colour(structure::kParenchyma)});
  state[part::labels] = labels;
  auto built = std::make_shared<model::BuiltModel>();
  built->model.mesh.vertices.resize(5, 3);
  built->model.mesh.vertices << 0, 0, 0, 0.2, 0, 0, 0, 0.2, 0, 0, 0, 0.2, 0.2, 0.2, 0.2;
  built->model.mesh.vertices *= scale;
  built->model.mesh.tetrahedra.resize(2, 4);
  built->model.mesh.tetrahedra << 0, 1, 2, 3, 1, 4, 2, 3;
  built->model.mesh.labels = {structure::kParenchyma, structure::kFirstLesion};
  built->model.surface = boundary_surface(built->model.mesh);
  built->model.surfaces.push_back({structure::kParenchyma, "liver", built->model.surface.mesh});
  VesselTree tree;
  tree.structure = structure::kPortalVein;
  tree.nodes.resize(3, 3);
  tree.nodes << 0.01, 0.01, 0.01, 0.02, 0.02, 0.02, 0.03, 0.02, 0.02;
  tree.radii = {0.005, 0.004, 0.003};
  tree.beams = {{0, 1}, {1, 2}};
  tree.root = 0;
  built->model.vessels.push_back(tree);
  built->model.landmarks.anterior_margin = built->model.mesh.vertices.topRows(3);
  built->report.notes = {"a note"};
  // As a person left the trees: what was built had a longer one.
  built->trees_as_built = built->model.vessels;
  built->tree_edits = {{model::TreeEdit::Kind::prune, {0.02, 0.02, 0.02}}};
  state[part::model] = built;
  state[part::check] = std::make_shared<const ModelCheck>(ModelCheck{true});
  auto landmarks = std::make_shared<Landmarks>();
  landmarks->umbilical_notch = built->model.mesh.vertices.topRows(1);
  state[part::landmarks] = landmarks;
  auto cloud = std::make_shared<LabelledCloud>();
  cloud->points = built->model.mesh.vertices;
  cloud->features = {Feature::surface, Feature::surface, Feature::anterior_margin, Feature::surface,
                     Feature::umbilical_notch};
  state[part::cloud] = cloud;
  auto registration = std::make_shared<Registration>();
  registration->camera_from_ct.translation = {0.0, 0.0, 0.1};
  registration->nodes_in_camera = registration->camera_from_ct.apply(built->model.mesh.vertices);
  registration->termination = Termination::converged;
  registration->steps = 12;
  registration->doubts = {"few_margin_points"};
  state[part::registration] = registration;
  std::uint64_t revision = 0;
  for (const Part part : all_parts())
    if (state.has(part)) state.stamp(part).revision = ++revision;
  state.stamp(part::model).made_from[part::labels] = state.stamp(part::labels).revision;
  state.stamp(part::check).made_from[part::model] = state.stamp(part::model).revision;
  return state;
}

std::string error_of(const std::function<void()>& action) { return test::complaint<Error>(action); }

}  // namespace

class CaseIoTest : public QObject {
  Q_OBJECT
 private slots:
  void ACaseComesBackAsItWas();
  void ALiveDeviceIsNoFile();
  void SavingAgainReplacesTheCase();
  void ASaveKilledAtAnyMomentLeavesTheOldCaseOrTheNewOne();
  void ADiskThatFillsUpLeavesTheOldCase();
  void ACancelledSaveLeavesTheOldCase();
  void RefusesWhatIsNotACase();
  void RefusesANewerFormat();
  void ARegistrationOfAFormerModelIsLeftOut();
  void NamesTheMalformedPart();
  void LandmarksNameTheirMistakes();
  void ARegistrationOfAnotherModelIsRefused();
  void ARegistrationThatTurnsAnElementInsideOutIsKept();
  void ARegistrationsDoubtsTravelWithItsFile();
  void WhereARegistrationMayBeWrongTravelsWithItsFile();
  void ARigidPartIsReadHoweverItsNumbersStand();
  void WhatIsNoErrorAndNoProbabilityIsRefused();
  void WhatIsNoCovarianceIsRefused();
  void CasesOfBeforeSayByNumberHowARegistrationEnded();
  void NumbersBeyondTheirRangeAreRefused_data();
  void NumbersBeyondTheirRangeAreRefused();
};

void CaseIoTest::ACaseComesBackAsItWas() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  QVERIFY(save_case(folder.path() / "a.glisson", state, RunContext()));
  const auto read = open_case(folder.path() / "a.glisson", RunContext());
  QVERIFY(read.has_value());
  for (const Part part : all_parts()) QCOMPARE(read->has(part), state.has(part));
  QCOMPARE(*(*read)[part::image]->voxels, *state[part::image]->voxels);
  QVERIFY((*read)[part::labels]->voxels == state[part::labels]->voxels);
  QVERIFY(((*read)[part::model]->model.mesh.vertices - state[part::model]->model.mesh.vertices).norm() <
          1e-9);
  QCOMPARE((*read)[part::model]->model.mesh.labels, state[part::model]->model.mesh.labels);
  QCOMPARE((*read)[part::model]->model.vessels.size(), std::size_t{1});
  QCOMPARE((*read)[part::model]->model.vessels[0].beams, state[part::model]->model.vessels[0].beams);
  QVERIFY(std::abs((*read)[part::model]->model.vessels[0].radii[2] - 0.003) < 1e-12);
  QCOMPARE((*read)[part::cloud]->features, state[part::cloud]->features);
  QCOMPARE((*read)[part::registration]->doubts, state[part::registration]->doubts);
  QVERIFY(((*read)[part::registration]->camera_from_ct.translation - Eigen::Vector3d(0, 0, 0.1)).norm() <
          1e-9);
  QCOMPARE(stage_state(*read, part::model), StageState::current);
  QCOMPARE(read->stamp(part::model).made_from, state.stamp(part::model).made_from);
  QVERIFY(is_model_checked(*read));
  const auto& [kind, at, to] = (*read)[part::model]->tree_edits.at(0);
  QVERIFY(kind == model::TreeEdit::Kind::prune && (at - Eigen::Vector3d(0.02, 0.02, 0.02)).norm() < 1e-9);
  QCOMPARE((*read)[part::model]->trees_as_built.at(0).beams, state[part::model]->trees_as_built.at(0).beams);
}

void CaseIoTest::ALiveDeviceIsNoFile() {
  const TemporaryFolder folder;
  CaseState state = small_case();
  state[part::video] = std::make_shared<VideoSource>(VideoSource{"device:0", "device:1"});
  QVERIFY(save_case(folder.path() / "a.glisson", state, RunContext()));
  const auto read = open_case(folder.path() / "a.glisson", RunContext());
  QCOMPARE((*read)[part::video]->left.string(), std::string("device:0"));
  QCOMPARE((*read)[part::video]->right.string(), std::string("device:1"));
}

void CaseIoTest::SavingAgainReplacesTheCase() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, small_case(1.0), RunContext()));
  CaseState without_image = small_case(2.0);
  without_image[part::image] = nullptr;
  QVERIFY(save_case(path, without_image, RunContext()));
  const auto read = open_case(path, RunContext());
  QVERIFY(!(*read)[part::image]);
  QVERIFY(std::abs((*read)[part::model]->model.mesh.vertices(1, 0) - 0.4) < 1e-9);
  int entries = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder.path())) ++entries;
  QCOMPARE(entries, 1);  // nothing was left beside it
}

void CaseIoTest::ASaveKilledAtAnyMomentLeavesTheOldCaseOrTheNewOne() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, small_case(1.0), RunContext()));
  const CaseState next = small_case(2.0);
  // A child saves and is killed when its progress has been told the n-th time, until one comes through.
  bool completed = false;
  int survivors = 0;
  for (int moment = 1; !completed && moment < 100; ++moment) {
    completed =
        test::comes_through(moment, [&](const RunContext& context) { save_case(path, next, context); });
    const auto read = open_case(path, RunContext());
    const double edge = (*read)[part::model]->model.mesh.vertices(1, 0);
    QVERIFY(std::abs(edge - 0.2) < 1e-9 || std::abs(edge - 0.4) < 1e-9);
    survivors += std::abs(edge - 0.2) < 1e-9;
  }
  QVERIFY(completed);
  QVERIFY(survivors >= 3);  // it was really killed on the way
  QVERIFY(std::abs((*open_case(path, RunContext()))[part::model]->model.mesh.vertices(1, 0) - 0.4) < 1e-9);
}

void CaseIoTest::ADiskThatFillsUpLeavesTheOldCase() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, small_case(), RunContext()));
  std::uintmax_t largest = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path))
    if (entry.is_regular_file()) largest = std::max(largest, entry.file_size());
  const std::string before = read_file(path / "case.json");
  // However far the save gets: each kind of file is, at some size, the first that does not fit.
  for (std::uintmax_t bytes = 1; bytes < largest; bytes = bytes * 5 / 4 + 1) {
    bool refused = false;
    try {
      const test::FullDisk disk(bytes);
      save_case(path, small_case(2.0), RunContext());
    } catch (const FileError&) {
      refused = true;
    }
    QVERIFY2(refused, std::to_string(bytes).c_str());
    QCOMPARE(read_file(path / "case.json"), before);
    QCOMPARE(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1L);
  }
  const auto back = open_case(path, RunContext());
  QVERIFY(
      ((*back)[part::model]->model.mesh.vertices - small_case()[part::model]->model.mesh.vertices).norm() <
      1e-9);
}

void CaseIoTest::ACancelledSaveLeavesTheOldCase() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, small_case(1.0), RunContext()));
  auto cancel = std::make_shared<CancelFlag>();
  const RunContext context(
      [&](double fraction, std::string_view) {
        if (fraction > 0.3) cancel->request();
      },
      cancel, 1);
  QVERIFY(!save_case(path, small_case(2.0), context));
  QVERIFY(std::abs((*open_case(path, RunContext()))[part::model]->model.mesh.vertices(1, 0) - 0.2) < 1e-9);
}

void CaseIoTest::RefusesWhatIsNotACase() {
  const TemporaryFolder folder;
  QVERIFY(error_of([&] { save_case(folder.path() / "a", small_case(), RunContext()); }).find(".glisson") !=
          std::string::npos);
  fs::create_directory(folder.path() / "b.glisson");
  write_file_atomically(folder.path() / "b.glisson/precious.txt", "do not lose me");
  QVERIFY(!error_of([&] { save_case(folder.path() / "b.glisson", small_case(), RunContext()); }).empty());
  QCOMPARE(read_file(folder.path() / "b.glisson/precious.txt"), std::string("do not lose me"));
  QVERIFY(error_of([&] { open_case(folder.path() / "b.glisson", RunContext()); }).find("case.json") !=
          std::string::npos);
  QVERIFY(error_of([&] { open_case(folder.path() / "none.glisson", RunContext()); }).find("does not exist") !=
          std::string::npos);
}

void CaseIoTest::RefusesANewerFormat() {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "a.glisson");
  write_file_atomically(folder.path() / "a.glisson/case.json",
                        R"({"format": "glisson-case", "version": 99, "parts": {}})");
  QVERIFY(error_of([&] { open_case(folder.path() / "a.glisson", RunContext()); }).find("newer Glisson") !=
          std::string::npos);
}

void CaseIoTest::ARegistrationOfAFormerModelIsLeftOut() {
  const TemporaryFolder folder;
  for (const Eigen::Index nodes : {3, 9}) {  // fewer than the model has now, and more
    CaseState state = small_case();
    auto former = std::make_shared<Registration>(*state[part::registration]);
    former->nodes_in_camera = Points::Random(nodes, 3);
    state[part::registration] = former;
    const fs::path path = folder.path() / (std::to_string(nodes) + ".glisson");
    QVERIFY(save_case(path, state, RunContext()));
    const auto back = open_case(path, RunContext());
    QVERIFY(back && (*back)[part::model] && (*back)[part::cloud] && !(*back)[part::registration]);
  }
}

void CaseIoTest::NamesTheMalformedPart() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  QVERIFY(save_case(path, small_case(), RunContext()));
  write_file_atomically(path / "model/vessels.vtp", "this is not XML");
  QVERIFY(error_of([&] { open_case(path, RunContext()); }).find("vessels.vtp") != std::string::npos);
  write_file_atomically(path / "case.json",
                        R"({"format": "glisson-case", "version": 1, "parts": {"model": {}}})");
  QVERIFY(error_of([&] { open_case(path, RunContext()); }).find(path.string()) != std::string::npos);
}

void CaseIoTest::LandmarksNameTheirMistakes() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "landmarks.json";
  write_file_atomically(path, R"({"umbilical_notch": [[1, 2]]})");
  QVERIFY(error_of([&] { read_landmarks(path); }).find("umbilical_notch: entry 0") != std::string::npos);
  write_file_atomically(path, R"({"umbilical_notch": [[1, 2, 3], [1e300, 2, 3]]})");
  QVERIFY(error_of([&] { read_landmarks(path); }).find("entry 1 is nowhere near a patient") !=
          std::string::npos);
  write_file_atomically(path, R"({"frame": "RAS", "umbilical_notch": [[1, 2, 3]]})");
  QVERIFY(error_of([&] { read_landmarks(path); }).find("LPS") != std::string::npos);
  write_file_atomically(path, "{}");
  QVERIFY(error_of([&] { read_landmarks(path); }).find("holds no landmark") != std::string::npos);
  write_file_atomically(path, "{\n  \"umbilical_notch\": [[1, 2, 3]\n}");
  QVERIFY(error_of([&] { read_landmarks(path); }).find("line 3") != std::string::npos);
}

void CaseIoTest::ARegistrationOfAnotherModelIsRefused() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  write_registration(folder.path() / "r.vtu", state[part::model]->model, *state[part::registration],
                     LengthUnit::millimetre);
  PatientModel other = state[part::model]->model;
  other.mesh.tetrahedra.row(0).swap(other.mesh.tetrahedra.row(1));
  QVERIFY(error_of([&] {
            read_registration(folder.path() / "r.vtu", other, LengthUnit::millimetre);
          }).find("is not this model's") != std::string::npos);
  const Registration same =
      read_registration(folder.path() / "r.vtu", state[part::model]->model, LengthUnit::millimetre);
  QVERIFY((same.nodes_in_camera - state[part::registration]->nodes_in_camera).norm() < 1e-9);
}

/// As linear elasticity does where a tool pulls hard.
void CaseIoTest::ARegistrationThatTurnsAnElementInsideOutIsKept() {
  const TemporaryFolder folder;
  CaseState state = small_case();
  Registration turned = *state[part::registration];
  const PatientModel& model = state[part::model]->model;
  TetMesh deformed = model.mesh;
  turned.nodes_in_camera.row(4) = -turned.nodes_in_camera.row(4);
  deformed.vertices = turned.nodes_in_camera;
  QVERIFY(tetrahedron_volumes(deformed).minCoeff() < 0.0 && tetrahedron_volumes(deformed).maxCoeff() > 0.0);
  state[part::registration] = std::make_shared<const Registration>(turned);
  write_registration(folder.path() / "r.vtu", model, turned, LengthUnit::millimetre);
  const Registration read = read_registration(folder.path() / "r.vtu", model, LengthUnit::millimetre);
  QVERIFY((read.nodes_in_camera - turned.nodes_in_camera).norm() < 1e-9);
  QVERIFY(save_case(folder.path() / "a.glisson", state, RunContext()));
  const auto opened = open_case(folder.path() / "a.glisson", RunContext());
  QVERIFY(((*opened)[part::registration]->nodes_in_camera - turned.nodes_in_camera).norm() < 1e-9);
}

void CaseIoTest::ARegistrationsDoubtsTravelWithItsFile() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  Registration doubted = *state[part::registration];
  doubted.doubts = {"cloud_noisy 6.25 3", "little_surface_seen"};
  doubted.termination = Termination::stalled;
  doubted.residual = 2.5e-3;
  doubted.seen_share = 0.125;
  Eigen::Matrix3d covariance;
  covariance << 4.0, 1.0, 0.5, 1.0, 9.0, -2.0, 0.5, -2.0, 16.0;
  doubted.lesions = {{structure::kFirstLesion, 1e-6 * covariance},
                     {static_cast<Label>(structure::kFirstLesion + 11), 2e-6 * covariance}};
  doubted.forks = {{structure::kPortalVein, 1, 5e-3, {0.01, 0.02, 0.1}, 3e-6 * covariance},
                   {structure::kPortalVein, 2, 2e-3, {0.03, 0.02, 0.1}, 1e-6 * covariance},
                   {structure::kHepaticVeins, 1, 4e-3, {0.0, 0.01, 0.12}, 2e-6 * covariance}};
  doubted.covariances.resize(doubted.nodes_in_camera.rows(), 6);
  for (Eigen::Index i = 0; i < doubted.covariances.rows(); ++i)
    doubted.covariances.row(i) = (1.0 + static_cast<double>(i)) * 1e-6 * symmetric_row(covariance);
  write_registration(folder.path() / "r.vtu", state[part::model]->model, doubted, LengthUnit::millimetre);
  const Registration read =
      read_registration(folder.path() / "r.vtu", state[part::model]->model, LengthUnit::millimetre);
  QCOMPARE(read.doubts, doubted.doubts);
  QVERIFY(read.termination == doubted.termination);
  QCOMPARE(read.residual, doubted.residual);
  QCOMPARE(read.seen_share, doubted.seen_share);
  QCOMPARE(read.lesions.size(), std::size_t{2});
  for (const LesionSpread& spread : read.lesions) {
    const double factor = spread.lesion == structure::kFirstLesion ? 1e-6 : 2e-6;
    QVERIFY(spread.covariance.isApprox(factor * covariance, 1e-9));
  }
  QCOMPARE(read.forks.size(), doubted.forks.size());
  for (std::size_t i = 0; i < read.forks.size(); ++i) {
    const ForkSpread &is = read.forks[i], &was = doubted.forks[i];
    QCOMPARE(fork_name(is), fork_name(was));
    QVERIFY(std::abs(is.radius - was.radius) < 1e-9 && (is.centre - was.centre).norm() < 1e-9);
    QVERIFY(is.covariance.isApprox(was.covariance, 1e-9));
  }
  QVERIFY(read.covariances.isApprox(doubted.covariances, 1e-9));
}

void CaseIoTest::CasesOfBeforeSayByNumberHowARegistrationEnded() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  save_case(path, small_case(), RunContext());
  const auto with = [&](const nlohmann::json& termination) {
    nlohmann::json document = read_json(path / "case.json");
    document["parts"]["registration"]["termination"] = termination;
    write_json(path / "case.json", document);
    return open_case(path, RunContext()).value()[part::registration]->termination;
  };
  QVERIFY(with(0) == Termination::converged);
  QVERIFY(with(1) == Termination::step_limit);
  QVERIFY(with("stalled") == Termination::stalled);
  QCOMPARE(test::refused_field([&] { (void)with(7); }), std::string("termination"));
  QCOMPARE(test::refused_field([&] { (void)with("well"); }), std::string("termination"));
}

void CaseIoTest::WhereARegistrationMayBeWrongTravelsWithItsFile() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  const PatientModel& model = state[part::model]->model;
  Registration registration = *state[part::registration];
  registration.expected = Eigen::VectorXd::LinSpaced(5, 1e-3, 9e-3);
  registration.forces = {{4, Eigen::Vector3d(0.0, 0.5, -1.0)}, {1, Eigen::Vector3d(0.25, 0.0, 0.0)}};
  registration.looks = {{static_cast<Label>(structure::kFirstLesion + 1), 6e-3,
                         Eigen::VectorXd::LinSpaced(5, 2e-3, 6e-3), 5e-3, 4e-3}};
  const Points there = registration.nodes_in_camera.rowwise() + Eigen::RowVector3d(0.01, -0.02, 0.03);
  registration.rivals = {{there, 0.25}, {2.0 * there, 0.01}};
  // Whatever the file's unit, what is said of the nodes is in millimetres.
  for (const LengthUnit unit : {LengthUnit::millimetre, LengthUnit::metre}) {
    write_registration(folder.path() / "r.vtu", model, registration, unit);
    const Registration read = read_registration(folder.path() / "r.vtu", model, unit);
    QVERIFY((read.expected - registration.expected).norm() < 1e-9);
    QCOMPARE(read.looks.size(), std::size_t{1});
    QCOMPARE(read.looks[0].lesion, registration.looks[0].lesion);
    QVERIFY((read.looks[0].seen - registration.looks[0].seen).norm() < 1e-9);
    QVERIFY(std::abs(read.looks[0].now - 6e-3) < 1e-9 && std::abs(read.looks[0].margin - 5e-3) < 1e-9 &&
            std::abs(read.looks[0].notch - 4e-3) < 1e-9);
    QCOMPARE(read.forces.size(), std::size_t{2});
    QCOMPARE(read.forces[0].node, 4);
    QVERIFY((read.forces[1].force - registration.forces[1].force).norm() < 1e-9);
    QCOMPARE(read.rivals.size(), std::size_t{2});
    QVERIFY((read.rivals[0].nodes_in_camera - there).norm() < 1e-9);
    QCOMPARE(read.rivals[1].probability, 0.01);
  }
}

void CaseIoTest::WhatIsNoErrorAndNoProbabilityIsRefused() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  const PatientModel& model = state[part::model]->model;
  const auto error_with = [&](auto spoil) {
    Registration registration = *state[part::registration];
    registration.expected = Eigen::VectorXd::Constant(5, 1e-3);
    registration.rivals = {{registration.nodes_in_camera, 0.5}};
    spoil(registration);
    write_registration(folder.path() / "r.vtu", model, registration, LengthUnit::millimetre);
    return error_of([&] { read_registration(folder.path() / "r.vtu", model, LengthUnit::millimetre); });
  };
  QVERIFY(error_with([](Registration&) {}).empty());
  QVERIFY(error_with([](Registration& r) { r.expected[2] = -1e-3; }).find("expected_error_mm") !=
          std::string::npos);
  QVERIFY(error_with([](Registration& r) { r.rivals[0].probability = 1.5; }).find("rival_1_probability") !=
          std::string::npos);
}

void CaseIoTest::ARigidPartIsReadHoweverItsNumbersStand() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  const PatientModel& model = state[part::model]->model;
  Registration registration = *state[part::registration];
  registration.camera_from_ct.rotation = rotation_by({0.1, -0.2, 0.3});
  registration.camera_from_ct.translation << 0.01, 0.02, 0.03;
  const auto file_path = folder.path() / "r.vtu";
  write_registration(file_path, model, registration, LengthUnit::millimetre);
  TetFile file = read_tet_file(file_path, LengthUnit::millimetre, MeshShape::deformed);
  const Eigen::MatrixXd square = file.field_data["cloud_from_model"];
  Eigen::MatrixXd row(1, 16);
  for (Eigen::Index n = 0; n < 16; ++n) row(0, n) = square(n / 4, n % 4);
  const auto read_with = [&](const Eigen::MatrixXd& table) {
    file.field_data["cloud_from_model"] = table;
    write_tet_mesh(file_path, file, LengthUnit::millimetre);
    return read_registration(file_path, model, LengthUnit::millimetre).camera_from_ct;
  };
  for (const Eigen::MatrixXd& table : {square, row, Eigen::MatrixXd(row.transpose())}) {
    const CameraFromCt read = read_with(table);
    QVERIFY((read.rotation - registration.camera_from_ct.rotation).norm() < 1e-12);
    QVERIFY((read.translation - registration.camera_from_ct.translation).norm() < 1e-12);
  }
  for (const Eigen::MatrixXd& table : {Eigen::MatrixXd(square.reshaped(2, 8)),
                                       Eigen::MatrixXd(square.reshaped(8, 2)), Eigen::MatrixXd(2.0 * square)})
    QVERIFY_THROWS_EXCEPTION(InputError, read_with(table));
}

void CaseIoTest::NumbersBeyondTheirRangeAreRefused_data() {
  QTest::addColumn<QByteArray>("place");
  QTest::addColumn<QByteArray>("value");
  QTest::addColumn<QByteArray>("field");
  QTest::newRow("structure") << QByteArray("/parts/model/surfaces/0/structure") << QByteArray("99999999999")
                             << QByteArray("structure");
  QTest::newRow("modality") << QByteArray("/parts/image/modality") << QByteArray("99999999999")
                            << QByteArray("modality");
  QTest::newRow("seconds") << QByteArray("/parts/frame/seconds") << QByteArray("1e300")
                           << QByteArray("seconds");
  QTest::newRow("index") << QByteArray("/parts/frame/index") << QByteArray("-7") << QByteArray("index");
  QTest::newRow("revision") << QByteArray("/parts/labels/revision") << QByteArray("-5")
                            << QByteArray("revision");
}

void CaseIoTest::NumbersBeyondTheirRangeAreRefused() {
  QFETCH(QByteArray, place);
  QFETCH(QByteArray, value);
  QFETCH(QByteArray, field);
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  save_case(path, small_case(), RunContext());
  nlohmann::json document = read_json(path / "case.json");
  nlohmann::json& parts = document["parts"];
  parts["frame"] = {{"index", 0}, {"seconds", 0.0}};
  parts["model"]["surfaces"].push_back({{"file", "model/surface_0.vtp"}, {"structure", 1}, {"name", "a"}});
  const nlohmann::json::json_pointer pointer(place.toStdString());
  QVERIFY(document.contains(pointer));
  document[pointer] = nlohmann::json::parse(value.toStdString());
  write_json(path / "case.json", document);
  QCOMPARE(test::refused_field([&] { (void)open_case(path, RunContext()); }), field.toStdString());
}

void CaseIoTest::WhatIsNoCovarianceIsRefused() {
  const TemporaryFolder folder;
  const CaseState state = small_case();
  Registration registration = *state[part::registration];
  registration.lesions = {
      {structure::kFirstLesion, 1e-6 * Eigen::Vector3d(4.0, -1.0, 1.0).asDiagonal().toDenseMatrix()}};
  write_registration(folder.path() / "r.vtu", state[part::model]->model, registration,
                     LengthUnit::millimetre);
  const std::string error = error_of(
      [&] { read_registration(folder.path() / "r.vtu", state[part::model]->model, LengthUnit::millimetre); });
  QVERIFY(error.find("lesion_1_covariance_mm2") != std::string::npos);
}

QTEST_APPLESS_MAIN(CaseIoTest)
#include "case_io_test.moc"
