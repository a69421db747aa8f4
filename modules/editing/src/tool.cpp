// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/editing/tool.h"

#include <sstream>

#include "glisson/core/error.h"
#include "glisson/editing/edit.h"
#include "glisson/editing/tools/paint.h"
#include "region_fields.h"

namespace glisson::editing {
namespace {

std::string in_brackets(const std::string& text, const std::vector<std::string>& remarks) {
  std::string all;
  for (const std::string& remark : remarks) all += (all.empty() ? "" : "; ") + remark;
  return all.empty() ? text : text + " (" + all + ")";
}

std::string listed(const std::vector<ToolField>& fields);

/// "radius_mm (at most 100)", "[erase]", "normal_axis (0, 1, 2; for a disc)".
std::string listed(const ToolField& field) {
  std::vector<std::string> remarks;
  std::string choices;
  for (const std::string& choice : field.choices) choices += (choices.empty() ? "`" : ", `") + choice + "`";
  if (!choices.empty()) remarks.push_back(choices);
  if (!field.note.empty()) remarks.push_back(field.note);
  if (field.most) {
    std::ostringstream most;
    most << "at most " << *field.most;
    remarks.push_back(most.str());
  }
  if (!field.parts.empty()) remarks.push_back("with " + listed(field.parts));
  if (!field.needed.empty()) remarks.push_back(field.needed);
  const std::string text = in_brackets(field.code, remarks);
  return field.has_default ? "[" + text + "]" : text;
}

std::string listed(const std::vector<ToolField>& fields) {
  std::string text;
  for (const ToolField& field : fields) text += (text.empty() ? "" : ", ") + listed(field);
  return text;
}

}  // namespace

Tool::Tool() : Tool(Paint()) {}

void Tool::refuse(const ToolKind& wanted) const {
  throw PreconditionError("a tool is taken for " + wanted.code() + " and is " + kind_->code());
}

const ToolKind* tool_called(std::string_view code) {
  for (const ToolKind* kind : tools())
    if (kind->code() == code) return kind;
  return nullptr;
}

std::string script_table(const std::vector<const ToolKind*>& kinds) {
  std::string table = "| tool | fields (those in square brackets have defaults) |\n|---|---|\n";
  for (const ToolKind* kind : kinds) table += "| `" + kind->code() + "` | " + listed(kind->fields()) + " |\n";
  return table + "| `region` of any | " + listed(about(region_fields())) + " |\n";
}

}  // namespace glisson::editing
