// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/engine/case_io.h"

#include <QTest>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "complaint.h"
#include "full_disk.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"
#include "glisson/engine/commands/import_mesh.h"
#include "glisson/engine/parts/check.h"
#include "glisson/engine/parts/cloud.h"
#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/model.h"
#include "glisson/engine/parts/registration.h"
#include "glisson/engine/parts/video.h"
#include "glisson/engine/script.h"
#include "glisson/geometry/mesh_io.h"
#include "killed_child.h"
#include "small_case.h"

using namespace glisson;
using namespace glisson::engine;
using test::small_case;
namespace fs = std::filesystem;

namespace {

std::string error_of(const std::function<void()>& action) { return test::complaint<Error>(action); }

}  // namespace

class CaseIoTest : public QObject {
  Q_OBJECT
 private slots:
  void ACaseComesBackAsItWas();
  void WhatWasMeasuredOnAMeshComesBackAndNothingElse();
  void AnImportedMeshHasNoFiguresOfAnOrgan();
  void ALiveDeviceIsNoFile();
  void SavingAgainReplacesTheCase();
  void CheckingAndReadingTellHowFarTheyAre();
  void ASaveKilledAtAnyMomentLeavesTheOldCaseOrTheNewOne();
  void ADiskThatFillsUpLeavesTheOldCase();
  void ACancelledSaveLeavesTheOldCase();
  void RefusesWhatIsNotACase();
  void RefusesANewerFormat();
  void ARegistrationOfAFormerModelIsLeftOut();
  void NamesTheMalformedPart();
  void LandmarksNameTheirMistakes();
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

void CaseIoTest::WhatWasMeasuredOnAMeshComesBackAndNothingElse() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  const auto came_back = [&](const std::optional<model::OrganFit>& fit) {
    CaseState state = small_case();
    auto built = std::make_shared<model::BuiltModel>(*state[part::model]);
    built->report.quality.organ_fit = fit;
    state[part::model] = built;
    save_case(path, state, RunContext());
    return (*open_case(path, RunContext()))[part::model]->report.quality.organ_fit;
  };
  const auto fit = came_back(model::OrganFit{-0.02, 0.1, 0.2, 0.3, 4.0});
  QVERIFY(fit);
  QCOMPARE(fit->volume_error, -0.02);
  QCOMPARE(fit->vertices_to_fine_mean_mm, 0.1);
  QCOMPARE(fit->mesh_to_fine_mean_mm, 0.2);
  QCOMPARE(fit->fine_to_mesh_mean_mm, 0.3);
  QCOMPARE(fit->fine_to_mesh_max_mm, 4.0);
  QVERIFY(!came_back(std::nullopt));
  QVERIFY(read_file(path / "case.json").find("volume_error") == std::string::npos);
  // Cases of before hold zeros there.
  QVERIFY(!came_back(model::OrganFit{}));
  QVERIFY(read_file(path / "case.json").find("volume_error") != std::string::npos);
}

void CaseIoTest::AnImportedMeshHasNoFiguresOfAnOrgan() {
  const TemporaryFolder folder;
  write_tet_mesh(folder.path() / "m.vtu", small_case()[part::model]->model.mesh, LengthUnit::millimetre);
  Script script{RunContext()};
  const auto outcome = script.run(ImportMesh{folder.path() / "m.vtu", LengthUnit::millimetre});
  QCOMPARE(outcome->figures.at("model_tetrahedra"), 2.0);
  QVERIFY(!outcome->figures.contains("model_lesion_volume_error_max"));  // it has no lesions
  for (const char* figure : {"model_volume_error", "model_vertices_to_fine_mean_mm",
                             "model_fine_to_mesh_mean_mm", "model_fine_to_mesh_max_mm"})
    QVERIFY2(!outcome->figures.contains(figure), figure);
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
  // What a save has left that was killed where two folders cannot be exchanged.
  std::filesystem::copy(path, folder.path() / ".a.glisson.former", std::filesystem::copy_options::recursive);
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

void CaseIoTest::CheckingAndReadingTellHowFarTheyAre() {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "a.glisson";
  double last = 0.0;
  std::set<double> checked;
  const auto told = [&](double fraction, std::string_view stage) {
    QVERIFY2(fraction >= last, std::string(stage).c_str());
    last = fraction;
    if (stage == "case.verify") checked.insert(fraction);
  };
  QVERIFY(save_case(path, small_case(), RunContext(told, nullptr, 1)));
  QVERIFY(checked.size() > 4);
  last = 0.0;
  QVERIFY(open_case(path, RunContext(told, nullptr, 1)));
  QVERIFY(last > 0.6);
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

QTEST_APPLESS_MAIN(CaseIoTest)
#include "case_io_test.moc"
