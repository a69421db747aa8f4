// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/window_tool.h"

#include <algorithm>

#include "glisson/core/error.h"
#include "glisson/volume/axes.h"

namespace glisson::ui {

EditTool edit_tool(std::string_view code, const EditTools& tools) {
  for (const EditTool tool : tools)
    if (tool->code == code) return tool;
  throw PreconditionError("the window has no tool \"" + std::string(code) + "\"");
}

PageField::Range range_of(std::string_view tool, std::string_view field, double low, double step,
                          int decimals) {
  const editing::ToolKind* kind = editing::tool_called(tool);
  require(kind != nullptr, "a page's range is that of a tool");
  for (const editing::ToolField& each : kind->fields())
    if (each.code == field && each.most) return {low, *each.most, step, decimals, each.unit};
  throw PreconditionError("no field \"" + std::string(field) + "\" with a largest value");
}

std::string tool_table(const EditTools& tools) {
  struct Row {
    std::string names, keys, manual;
  };
  std::vector<Row> rows;
  for (const EditTool tool : tools) {
    if (*tool->manual != '\0' || rows.empty()) {
      rows.push_back({tool->name, std::string(1, tool->key), tool->manual});
    } else {
      rows.back().names += std::string(", ") + tool->name;
      rows.back().keys += std::string(", ") + tool->key;
    }
  }
  std::string table = "| tool | key | what |\n|---|---|---|\n";
  for (const Row& row : rows) table += "| " + row.names + " | " + row.keys + " | " + row.manual + " |\n";
  return table;
}

int voxel_axis_across(const VolumeGrid& grid, scene::Plane plane) {
  return axis_along(grid, scene::normal_axis(plane));
}

bool is_among(const std::vector<Label>& labels, Label label) {
  return std::find(labels.begin(), labels.end(), label) != labels.end();
}

EditObstacle empty_label(const EditSettings& settings, const std::vector<Label>& present) {
  return is_among(present, settings.label) ? EditObstacle::none : EditObstacle::label_empty;
}

}  // namespace glisson::ui
