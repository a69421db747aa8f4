// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tools/logical.h"

#include "describe.h"

namespace glisson::editing {
namespace {

Cancellable<Canvas> apply(const Logical& tool, Task& task) {
  using Operation = Logical::Operation;
  const LabelVolume& labels = task.labels.voxels;
  const Label mine = tool.label, other = tool.other;
  VoxelBox box;
  switch (tool.operation) {
    case Operation::invert:
    case Operation::fill:
      box = reachable(task);
      break;
    case Operation::copy:
      box = box_of(labels, {mine, other});
      break;
    case Operation::add:
      box = box_of(labels, {other});
      break;
    default:
      box = box_of(labels, {mine});
  }
  Canvas canvas = task.canvas(box);
  const bool done = canvas.rewrite(box, task.context, [&](int, int, int, Label old) -> Label {
    switch (tool.operation) {
      case Operation::copy:
        return old == other ? mine : old == mine ? structure::kBackground : old;
      case Operation::add:
        return old == other ? mine : old;
      case Operation::subtract:
        return old == mine && mine == other ? structure::kBackground : old;
      case Operation::intersect:
        return old == mine && mine != other ? structure::kBackground : old;
      case Operation::invert:
        return old == mine ? structure::kBackground : mine;
      case Operation::clear:
        return old == mine ? structure::kBackground : old;
      case Operation::fill:
        break;
    }
    return mine;
  });
  if (!done) return std::nullopt;
  return canvas;
}

using Operation = Logical::Operation;

const Names<Operation>& operations() {
  static const Names<Operation> kNames = {
      {"copy", Operation::copy},         {"add", Operation::add},
      {"subtract", Operation::subtract}, {"intersect", Operation::intersect},
      {"invert", Operation::invert},     {"clear", Operation::clear},
      {"fill", Operation::fill}};
  return kNames;
}

bool has_other(const Logical& t) {
  return t.operation == Operation::copy || t.operation == Operation::add ||
         t.operation == Operation::subtract || t.operation == Operation::intersect;
}

void check_other(const SettingsCheck& check, const Logical& t) {
  const bool moves = t.operation == Operation::copy || t.operation == Operation::add;
  if (moves)
    check.target(t.other, "other", true);  // it loses voxels
  else if (t.other > structure::kLastLesion)
    check.refuse("other", "is " + std::to_string(t.other) + ", which is no structure", "Choose a structure");
}

Description<Logical> description() {
  return {
      "logical",
      110,
      {label_field("label", &Logical::label), choice_field("operation", &Logical::operation, operations()),
       label_field("other", &Logical::other).needed("for the first four", has_other).checked(check_other)},
      steps_of("logical", operations()),
      [](const Logical& t) {
        return StepName{"logical." + name_of(operations(), t.operation), t.label, 0.0};
      },
      apply};
}

}  // namespace

const ToolKind& Logical::kind() {
  static const Described<Logical> kKind(description());
  return kKind;
}
const ToolKind& logical_tool() { return Logical::kind(); }

}  // namespace glisson::editing
