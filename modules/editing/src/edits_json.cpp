// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "region_fields.h"

namespace glisson::editing {
namespace {

using nlohmann::json;

Fields<EditableRegion> describe_region() {
  using Area = EditableRegion::Area;
  const Names<Area> areas = {{"everywhere", Area::everywhere},
                             {"labelled", Area::labelled},
                             {"unlabelled", Area::unlabelled},
                             {"inside_label", Area::inside_label},
                             {"inside_liver", Area::inside_liver}};
  const auto in_label = [](const EditableRegion& r) { return r.area == Area::inside_label; };
  Field<EditableRegion> intensity{field_of("intensity_hu", ToolField::Kind::matrix, "HU"),
                                  [](ScriptEntry& e, EditableRegion& r) {
                                    const std::vector<double> range = e.row("intensity_hu", 2);
                                    r.intensity = {range[0], range[1]};
                                  },
                                  [](json& object, const EditableRegion& r) {
                                    if (r.intensity) object["intensity_hu"] = *r.intensity;
                                  }};
  return {
      choice_field("area", &EditableRegion::area, areas).with_default(),
      label_field("label", &EditableRegion::label)
          .needed("for `inside_label`", in_label)
          .written([=](const EditableRegion& r) { return r.label != structure::kBackground || in_label(r); }),
      std::move(intensity).noted("low, high").with_default(),
      labels_field("locked", &EditableRegion::locked).with_default().written([](const EditableRegion& r) {
        return !r.locked.empty();
      })};
}

const ToolKind& kind_wanted(ScriptEntry& e, const std::vector<const ToolKind*>& kinds) {
  const std::string wanted = e.text("tool");
  std::vector<std::string> codes;
  for (const ToolKind* kind : kinds) {
    if (kind->code() == wanted) return *kind;
    codes.push_back(kind->code());
  }
  e.refuse_choice("tool", wanted, codes);
}

Edit read_edit(const json& object, const std::string& file, const std::string& where,
               const std::vector<const ToolKind*>& kinds) {
  ScriptEntry e(object, file, where);
  Edit edit{kind_wanted(e, kinds).read(e), {}};
  if (e.has("region")) {
    ScriptEntry region = e.object("region");
    read_fields(region_fields(), region, edit.region);
    region.finish();
  }
  e.finish();
  try {
    check_edit(edit);
  } catch (const InputError& error) {
    throw InputError(file, where + ", " + error.field(), error.problem(), error.remedy());
  }
  return edit;
}

}  // namespace

const Fields<EditableRegion>& region_fields() {
  static const Fields<EditableRegion> kFields = describe_region();
  return kFields;
}

std::vector<Edit> read_edits(const std::filesystem::path& path, const std::vector<const ToolKind*>& kinds) {
  const json document = read_json(path);
  const std::string file = path.string();
  if (!document.is_object() || document.size() != 1 || !document.contains("edits") ||
      !document["edits"].is_array())
    throw InputError(file, "edits", "are not the one list of the file",
                     R"(Write {"edits": [{"tool": ...}, ...]})");
  std::vector<Edit> edits;
  for (const json& object : document["edits"])
    edits.push_back(read_edit(object, file, "edit " + std::to_string(edits.size() + 1), kinds));
  return edits;
}

void write_edits(const std::filesystem::path& path, const std::vector<Edit>& edits) {
  json list = json::array();
  for (const Edit& edit : edits) {
    ScriptFields fields;
    edit.tool.kind().write(edit.tool, fields);
    fields.object["tool"] = edit.tool.kind().code();
    if (!(edit.region == EditableRegion())) fields.object["region"] = written(region_fields(), edit.region);
    list.push_back(std::move(fields.object));
  }
  write_json(path, {{"edits", std::move(list)}});
}

}  // namespace glisson::editing
