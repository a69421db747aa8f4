// SPDX-License-Identifier: GPL-3.0-or-later
// Every tool of the list follows from its description: scripts, refusals, names of steps, the manual's table;
// and so does a tool that only this file knows.
#include <QDir>
#include <QTest>
#include <algorithm>
#include <set>

#include "describe.h"
#include "edit_applied.h"
#include "edit_random.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"

using namespace glisson;
using namespace glisson::editing;
using namespace glisson::test;

namespace {

/// Everything within a distance of the volume's middle becomes the label.
struct Bead {
  static const ToolKind& kind();
  Label label = structure::kFirstLesion;
  double radius = 4e-3;
  bool operator==(const Bead&) const = default;
};

Cancellable<Canvas> apply_bead(const Bead& bead, Task& task) {
  const VoxelBox box = whole_box(task.grid());
  Canvas canvas = task.canvas(box);
  const Eigen::Vector3d c = middle_of(task.grid());
  const bool done = canvas.rewrite(box, task.context, [&](int i, int j, int k, Label old) {
    return (place_of(task.grid(), {i, j, k}) - c).norm() < 1e3 * bead.radius ? bead.label : old;
  });
  if (!done) return std::nullopt;
  return canvas;
}

const ToolKind& Bead::kind() {
  static const Described<Bead> kKind(
      {"bead",
       1000,
       {label_field("label", &Bead::label), length_field("radius_mm", &Bead::radius, 8e-3).with_default()},
       {"bead"},
       [](const Bead& t) {
         return StepName{"bead", t.label, t.radius};
       },
       apply_bead});
  return kKind;
}

}  // namespace

class ToolsTest : public QObject {
  Q_OBJECT
 private slots:
  void CodesAreUnique();
  void EveryToolKnowsItsOwnKind();
  void EveryFieldIsWritten();
  void EveryStepIsListed();
  void TheManualHasTheTable();
  void AToolOfThisFileIsReadWrittenCheckedNamedAndApplied();
  void AToolIsNotTakenForAnother();
};

void ToolsTest::CodesAreUnique() {
  std::set<std::string> codes, steps;
  for (const ToolKind* kind : tools()) {
    QVERIFY2(codes.insert(kind->code()).second, kind->code().c_str());
    QCOMPARE(tool_called(kind->code()), kind);
    QVERIFY(!kind->steps().empty());
    for (const std::string& step : kind->steps()) QVERIFY2(steps.insert(step).second, step.c_str());
    std::set<std::string> fields;
    for (const ToolField& field : kind->fields())
      QVERIFY2(fields.insert(field.code).second, field.code.c_str());
  }
  const QDir room(qEnvironmentVariable("GLISSON_SOURCE_DIR") + "/modules/editing");
  const auto files = [&](const char* folder, const char* names) {
    return static_cast<std::size_t>(QDir(room.filePath(folder)).entryList({names}, QDir::Files).size());
  };
  QVERIFY(!codes.empty());
  QCOMPARE(codes.size(), files("src", "tool_*.cpp"));
  QCOMPARE(codes.size(), files("include/glisson/editing/tools", "*.h"));
  QVERIFY(tool_called("no such tool") == nullptr);
}

void ToolsTest::EveryToolKnowsItsOwnKind() {
  for (const ToolKind* kind : tools()) {
    const Tool tool = kind->with_defaults();
    QCOMPARE(&tool.kind(), kind);
    QVERIFY(tool == kind->with_defaults());
    for (const ToolKind* other : tools()) QCOMPARE(other->with_defaults() == tool, other == kind);
  }
}

void ToolsTest::EveryFieldIsWritten() {
  for (const ToolKind* kind : tools()) {
    ScriptFields written;
    kind->write(kind->with_defaults(), written);
    for (const ToolField& field : kind->fields()) {
      // An object is written where there is one.
      const bool is_there = written.object.contains(field.code);
      QVERIFY2(is_there || field.kind == ToolField::Kind::object, (kind->code() + ", " + field.code).c_str());
      if (is_there && field.kind == ToolField::Kind::choice)
        QVERIFY(std::ranges::count(field.choices, written.object[field.code].get<std::string>()) == 1);
    }
  }
}

void ToolsTest::EveryStepIsListed() {
  const VolumeGrid grid = awkward_grids()[0];
  RandomEdits random(grid, 1);
  for (int n = 0; n < 300; ++n) {
    const Edit edit = random.next();
    QVERIFY2(std::ranges::count(edit.tool.kind().steps(), step_name(edit).code) == 1,
             step_name(edit).code.c_str());
  }
  for (const ToolKind* kind : tools())
    QVERIFY(std::ranges::count(kind->steps(), step_name({kind->with_defaults(), {}}).code) == 1);
}

void ToolsTest::TheManualHasTheTable() {
  const QString source = qEnvironmentVariable("GLISSON_SOURCE_DIR");
  const std::string manual = read_file((source + "/packaging/manual/manual.md").toStdString());
  QVERIFY2(manual.find(script_table()) != std::string::npos,
           ("packaging/manual/manual.md must hold, word for word:\n" + script_table()).c_str());
}

void ToolsTest::AToolOfThisFileIsReadWrittenCheckedNamedAndApplied() {
  auto kinds = tools();
  kinds.push_back(&Bead::kind());
  const TemporaryFolder folder;
  const auto file = folder.path() / "edits.json";
  const Edit edit{Bead{structure::kPortalVein, 2.5e-3}, {}};
  write_edits(file, {edit});
  QVERIFY(read_edits(file, kinds) == std::vector<Edit>{edit});
  QVERIFY_THROWS_EXCEPTION(InputError, read_edits(file));
  write_file_atomically(file, R"({"edits": [{"tool": "bead", "label": "artery", "radius_mm": 9}]})");
  try {
    (void)read_edits(file, kinds);
    QFAIL("9 mm are too many");
  } catch (const InputError& error) {
    QCOMPARE(error.field(), std::string("edit 1, radius"));
  }
  QVERIFY(step_name(edit) == (StepName{"bead", structure::kPortalVein, 2.5e-3}));
  const VolumeGrid grid = awkward_grids()[0];
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  const LabelMap labels{LabelVolume(grid), {}};
  const Edited edited = applied(labels, image, edit.tool);
  QVERIFY(edited.voxels_changed > 0);
  QVERIFY(script_table(kinds).find("| `bead` | label, [radius_mm (at most 8)] |") != std::string::npos);
}

void ToolsTest::AToolIsNotTakenForAnother() {
  const Tool tool = FillHoles{};
  QVERIFY(tool.get_if<Paint>() == nullptr && tool.get_if<FillHoles>() != nullptr);
  QVERIFY_THROWS_EXCEPTION(PreconditionError, (void)tool.as<Paint>());
}

QTEST_APPLESS_MAIN(ToolsTest)
#include "tools_test.moc"
