// SPDX-License-Identifier: GPL-3.0-or-later
// What is said of stiffness is a part of the case: it makes things out of date and travels along.
#include "glisson/engine/parts/tissue.h"

#include <QTest>

#include "complaint.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/engine/case_io.h"
#include "glisson/engine/commands/set_tissue.h"
#include "glisson/engine/parts/operations.h"
#include "glisson/engine/parts/registration.h"
#include "phantom_case.h"

using namespace glisson;
using namespace glisson::engine;
using test::after;
using test::few_operations;
using test::phantom_case;
using test::register_on_few;

class TissueTest : public QObject {
  Q_OBJECT
 private slots:
  void ARegistrationMadeBeforeIsOutOfDate();
  void OperationsOfOtherTissueAreSimulatedAnew();
  void ItTravelsWithTheCase();
  void WhatIsSaidToAnOldCaseMakesItsRegistrationOutOfDate();
  void WhatCannotBeIsRefused();
  void MaterialsOfACommandHoldOverTheParenchyma();
};

namespace {

SetTissue say(const char* list) { return {fem::tissue_from(list)}; }

}  // namespace

void TissueTest::ARegistrationMadeBeforeIsOutOfDate() {
  CaseState state = phantom_case();
  state[part::registration] = std::make_shared<const Registration>();
  state.stamp(part::model).revision = 1;
  state.stamp(part::registration) = {2, {{part::model, 1}, {part::tissue, 0}}};
  QVERIFY(stage_state(state, part::registration) == StageState::current);
  QVERIFY(Register{}.traits().reads.has(part::tissue));
  state[part::tissue] = std::make_shared<const fem::Tissue>(fem::tissue_from("lesion_1=20"));
  state.stamp(part::tissue).revision = 3;
  QVERIFY(stage_state(state, part::registration) == StageState::stale);
  QVERIFY(stage_state(state, part::model) == StageState::current);
  const CaseState back = after(state, say("lesion_1=as_liver"));
  QVERIFY(!back[part::tissue]);
}

void TissueTest::OperationsOfOtherTissueAreSimulatedAnew() {
  const CaseState plain = after(phantom_case(), few_operations());
  const CaseState said = after(plain, say("lesion_1=20"));
  QVERIFY(has_operations(plain) && !has_operations(said));
  QVERIFY(lacks_operations(said));
  const CaseState ahead = after(said, few_operations());
  QVERIFY(has_operations(ahead));
  QVERIFY(ahead[part::operations]->prior->modes != plain[part::operations]->prior->modes);
  // A registration rests on them, and makes the same by itself.
  QVERIFY(after(ahead, register_on_few())[part::operations] == ahead[part::operations]);
  const CaseState together = after(said, register_on_few());
  QVERIFY(has_operations(together));
  QVERIFY(together[part::operations]->prior->modes == ahead[part::operations]->prior->modes);
  QVERIFY(together[part::registration]->nodes_in_camera !=
          after(plain, register_on_few())[part::registration]->nodes_in_camera);
}

void TissueTest::ItTravelsWithTheCase() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  const CaseState state =
      after(after(phantom_case(), say("parenchyma=cirrhotic,lesion_1=20.3")), few_operations());
  save_case(path, state, RunContext());
  const CaseState read = open_case(path, RunContext()).value();
  QVERIFY(*read[part::tissue] == *state[part::tissue]);
  QVERIFY(has_operations(read));  // of this tissue
  QVERIFY(read[part::operations]->options == state[part::operations]->options);
  std::string text = read_file(path / "case.json");
  const std::string was = "lesion_1=20.3";
  QVERIFY(text.find(was) != std::string::npos);
  text.replace(text.find(was), was.size(), "lesion_1=hard");
  write_file_atomically(path / "case.json", text);
  const std::string said = test::complaint([&] { open_case(path, RunContext()); });
  QVERIFY2(said.find("case.json") != std::string::npos && said.find("lesion_1") != std::string::npos,
           said.c_str());
}

void TissueTest::WhatIsSaidToAnOldCaseMakesItsRegistrationOutOfDate() {
  const QTemporaryDir folder;
  const std::filesystem::path path = folder.filePath("a.glisson").toStdString();
  CaseState state = phantom_case();
  auto lying = std::make_shared<Registration>();
  lying->nodes_in_camera = state[part::model]->model.mesh.vertices;
  state[part::registration] = lying;
  state.stamp(part::model).revision = 1;
  state.stamp(part::landmarks) = {2, {{part::model, 1}}};
  state.stamp(part::cloud).revision = 3;
  state.stamp(part::registration) = {4, {{part::model, 1}, {part::landmarks, 2}, {part::cloud, 3}}};
  save_case(path, state, RunContext());
  QVERIFY(read_file(path / "case.json").find("tissue") == std::string::npos);
  CaseState read = open_case(path, RunContext()).value();
  QVERIFY(stage_state(read, part::registration) == StageState::current);
  read[part::tissue] = std::make_shared<const fem::Tissue>(fem::tissue_from("lesion_1=20"));
  read.stamp(part::tissue).revision = 9;
  QVERIFY(stage_state(read, part::registration) == StageState::stale);
}

void TissueTest::WhatCannotBeIsRefused() {
  const std::string said = test::complaint([] { after(phantom_case(), say("lesion_2=20")); });
  QVERIFY2(said.find("lesion_2") != std::string::npos && said.find("lesion_1") != std::string::npos,
           said.c_str());
  SetTissue thin;
  thin.tissue.parenchyma = 1.0;
  QVERIFY_THROWS_EXCEPTION(InputError, after(phantom_case(), thin));
}

void TissueTest::MaterialsOfACommandHoldOverTheParenchyma() {
  CaseState state = after(phantom_case(), say("parenchyma=cirrhotic,lesion_1=20"));
  QVERIFY(!tissue_of(state, false).parenchyma);
  QVERIFY(tissue_of(state).parenchyma == 30e3);
  QVERIFY(tissue_of(state, false).lesions == tissue_of(state).lesions);
}

QTEST_APPLESS_MAIN(TissueTest)
#include "tissue_test.moc"
