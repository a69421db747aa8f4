// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json.hpp>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/model/tree_edits.h"

namespace glisson::model {
namespace {

using nlohmann::json;

constexpr const char* kRemedy = "Write {\"edit\": \"prune\", \"at\": [x, y, z]} in millimetres (LPS)";

TreeEdit edit_of(const json& entry, const std::string& file, const std::string& field) {
  const auto refuse = [&](const std::string& problem) { throw InputError(file, field, problem, kRemedy); };
  const auto point = [&](const char* name) -> Eigen::Vector3d {
    if (!entry.contains(name)) refuse(std::string("has no \"") + name + "\"");
    const json& triple = entry[name];
    if (!triple.is_array() || triple.size() != 3 || !triple[0].is_number() || !triple[1].is_number() ||
        !triple[2].is_number())
      refuse(std::string("\"") + name + "\" is not three numbers");
    return 1e-3 * Eigen::Vector3d(triple[0].get<double>(), triple[1].get<double>(), triple[2].get<double>());
  };
  if (!entry.is_object()) refuse("is not an object");
  TreeEdit edit;
  const std::string code = entry.contains("edit") && entry["edit"].is_string() ? entry["edit"] : json("");
  if (code == "set_root")
    edit.kind = TreeEdit::Kind::set_root;
  else if (code == "prune")
    edit.kind = TreeEdit::Kind::prune;
  else if (code == "join")
    edit.kind = TreeEdit::Kind::join;
  else
    refuse("\"edit\" is none of set_root, prune, join");
  edit.at = point("at");
  if (edit.kind == TreeEdit::Kind::join) edit.to = point("to");
  return edit;
}

json in_mm(const Eigen::Vector3d& p) { return {1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z()}; }

}  // namespace

std::vector<TreeEdit> read_tree_edits(const std::filesystem::path& path) {
  const json document = read_json(path);
  const std::string file = path.string();
  if (!document.is_object() || !document.contains("edits") || !document["edits"].is_array())
    throw InputError(file, "edits", "there is no such list", "Write {\"edits\": [...]}");
  const auto other = [&](const char* key, const char* than) {
    return document.contains(key) && document[key] != than;
  };
  if (other("frame", "LPS") || other("unit", "mm"))
    throw InputError(file, "frame, unit", "edits are read in LPS millimetres only",
                     "Convert them, or correct the two fields");
  std::vector<TreeEdit> edits;
  for (std::size_t i = 0; i < document["edits"].size(); ++i)
    edits.push_back(edit_of(document["edits"][i], file, "edits[" + std::to_string(i) + "]"));
  return edits;
}

void write_tree_edits(const std::filesystem::path& path, const std::vector<TreeEdit>& edits) {
  json list = json::array();
  for (const TreeEdit& edit : edits) {
    json entry = {{"edit", edit_code(edit.kind)}, {"at", in_mm(edit.at)}};
    if (edit.kind == TreeEdit::Kind::join) entry["to"] = in_mm(edit.to);
    list.push_back(entry);
  }
  write_json(path, {{"frame", "LPS"}, {"unit", "mm"}, {"edits", list}});
}

}  // namespace glisson::model
