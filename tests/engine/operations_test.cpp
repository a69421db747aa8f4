// SPDX-License-Identifier: GPL-3.0-or-later
// Operations that were simulated ahead: registrations rest on them, and they are kept with the case.
#include "glisson/engine/parts/operations.h"

#include <QTest>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/parts/registration.h"
#include "phantom_case.h"

using namespace glisson;
using namespace glisson::engine;
using test::after;
using test::few_operations;
using test::phantom_case;
using test::register_on_few;

class OperationsTest : public QObject {
  Q_OBJECT
 private slots:
  void RegistrationRestsOnWhatWasSimulatedAhead();
  void DoneAheadTheyChangeNoBit();
  void AnotherSeedHasOthers();
  void TheyAreWantedOnceAModelIsThere();
  void WithoutAVenaCavaTheRemedyIsNamed();
  void TheyComeBackWithTheCase();
  void ThoseOfAFormerModelAreNotSaved();
  void ADamagedFileCostsNothingButTime();
  void WhatIsOutOfRangeInTheCaseIsNamed();
};

void OperationsTest::RegistrationRestsOnWhatWasSimulatedAhead() {
  const CaseState ahead = after(phantom_case(), few_operations());
  QVERIFY(has_operations(ahead));
  QVERIFY(after(ahead, few_operations())[part::operations] ==
          ahead[part::operations]);  // nothing is done twice
  QVERIFY(after(ahead, register_on_few())[part::operations] == ahead[part::operations]);
}

void OperationsTest::DoneAheadTheyChangeNoBit() {
  const CaseState ahead = after(after(phantom_case(), few_operations()), register_on_few()),
                  together = after(phantom_case(), register_on_few());
  QVERIFY(ahead[part::registration]->nodes_in_camera == together[part::registration]->nodes_in_camera);
  QVERIFY(ahead[part::operations]->prior->modes == together[part::operations]->prior->modes);
}

void OperationsTest::AnotherSeedHasOthers() {
  const CaseState ahead = after(phantom_case(), few_operations());
  QVERIFY(!known_operations(ahead, 2).prior);
  const CaseState other = after(ahead, register_on_few(), 2);
  QVERIFY(other[part::operations] != ahead[part::operations]);
  QVERIFY(other[part::operations]->prior->modes != ahead[part::operations]->prior->modes);
}

void OperationsTest::TheyAreWantedOnceAModelIsThere() {
  QVERIFY(!lacks_operations({}));
  CaseState state = phantom_case();
  QVERIFY(lacks_operations(state));
  const CaseState ahead = after(state, few_operations());
  QVERIFY(!lacks_operations(ahead));
  CaseState marked = ahead;
  marked[part::landmarks] = std::make_shared<const Landmarks>(*ahead[part::landmarks]);
  QVERIFY(lacks_operations(marked));
  // Landmarks of a former model: to be looked at first.
  marked.stamp(part::model).revision = 5;
  marked.stamp(part::landmarks) = {4, {{part::model, 3}}};
  QVERIFY(!lacks_operations(marked));
  auto bare = std::make_shared<model::BuiltModel>(*state[part::model]);
  bare->model.landmarks.vena_cava.resize(0, 3);
  state[part::model] = bare;
  state[part::landmarks] = nullptr;
  QVERIFY(!lacks_operations(state));
}

void OperationsTest::WithoutAVenaCavaTheRemedyIsNamed() {
  CaseState state = phantom_case();
  auto bare = std::make_shared<model::BuiltModel>(*state[part::model]);
  bare->model.landmarks.vena_cava.resize(0, 3);
  state[part::model] = bare;
  state[part::landmarks] = nullptr;
  const std::string said = test::complaint([&] { after(state, few_operations()); });
  QVERIFY2(said.find("vena cava") != std::string::npos && said.find("landmarks") != std::string::npos,
           said.c_str());
}

void OperationsTest::TheyComeBackWithTheCase() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  const CaseState ahead = after(phantom_case(), few_operations(), 7);
  save_case(path, ahead, RunContext());
  const auto read = open_case(path, RunContext());
  QVERIFY(read.has_value() && has_operations(*read));
  const SimulatedOperations &was = *ahead[part::operations], &is = *(*read)[part::operations];
  QVERIFY(is.prior->modes == was.prior->modes);
  QCOMPARE(is.prior->operations, was.prior->operations);
  QVERIFY(is.options == was.options && is.seed == 7);
  QVERIFY(after(*read, few_operations(), 7)[part::operations] == (*read)[part::operations]);
  QVERIFY(after(*read, few_operations(), 8)[part::operations] != (*read)[part::operations]);
}

void OperationsTest::ThoseOfAFormerModelAreNotSaved() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  CaseState state = after(phantom_case(), few_operations());
  state[part::landmarks] = nullptr;
  save_case(path, state, RunContext());
  QVERIFY(!std::filesystem::exists(path / "operations.vtu"));
  QVERIFY(!(*open_case(path, RunContext()))[part::operations]);
}

void OperationsTest::ADamagedFileCostsNothingButTime() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  save_case(path, after(phantom_case(), few_operations()), RunContext());
  // Another liver's, and half a file.
  CaseState other = phantom_case();
  auto shifted = std::make_shared<model::BuiltModel>(*other[part::model]);
  shifted->model.mesh.vertices.rowwise() += Eigen::RowVector3d(0.01, 0, 0);
  other[part::model] = shifted;
  const std::filesystem::path theirs = folder.filePath("b.glisson").toStdString();
  save_case(theirs, after(other, few_operations()), RunContext());
  const std::string whole = read_file(path / "operations.vtu");
  for (const std::string& damaged :
       {read_file(theirs / "operations.vtu"), whole.substr(0, whole.size() / 2)}) {
    write_file_atomically(path / "operations.vtu", damaged);
    std::vector<std::string> lost;
    const auto read = open_case(path, RunContext(), &lost);
    QVERIFY(read.has_value() && (*read)[part::model] && !(*read)[part::operations]);
    QVERIFY(std::any_of(lost.begin(), lost.end(),
                        [](const std::string& note) { return note.starts_with("case.operations_lost "); }));
    const std::string said = test::complaint([&] { open_case(path, RunContext()); });
    QVERIFY2(said.find("operations.vtu") != std::string::npos, said.c_str());
  }
}

void OperationsTest::WhatIsOutOfRangeInTheCaseIsNamed() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  save_case(path, after(phantom_case(), few_operations()), RunContext());
  const std::string text = read_file(path / "case.json");
  for (const auto& [field, was, wrong] : {std::tuple{"gas_pa", "\"gas_pa\": 80.0", "\"gas_pa\": 1e300"},
                                          std::tuple{"seed", "\"seed\": 1", "\"seed\": -1"},
                                          std::tuple{"modes", "\"modes\": 60", "\"modes\": \"many\""}}) {
    std::string changed = text;
    QVERIFY2(text.find(was) != std::string::npos, was);
    changed.replace(text.find(was), std::string(was).size(), wrong);
    write_file_atomically(path / "case.json", changed);
    const std::string said = test::complaint([&] { open_case(path, RunContext()); });
    QVERIFY2(said.find(field) != std::string::npos, said.c_str());
  }
}

QTEST_APPLESS_MAIN(OperationsTest)
#include "operations_test.moc"
