// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "edit_tools.h"
#include "glisson/core/error.h"
#include "glisson/core/json_file.h"

namespace glisson::editing {
namespace {

using nlohmann::json;

template <class E>
using Names = std::vector<std::pair<const char*, E>>;

const Names<Paint::Brush> kBrushes = {{"disc", Paint::Brush::disc}, {"ball", Paint::Brush::ball}};
const Names<Scissors::Operation> kCuts = {{"fill_inside", Scissors::Operation::fill_inside},
                                          {"erase_inside", Scissors::Operation::erase_inside},
                                          {"erase_outside", Scissors::Operation::erase_outside}};
const Names<Islands::Operation> kIslands = {{"keep_largest", Islands::Operation::keep_largest},
                                            {"remove_small", Islands::Operation::remove_small},
                                            {"keep_clicked", Islands::Operation::keep_clicked},
                                            {"remove_clicked", Islands::Operation::remove_clicked},
                                            {"split", Islands::Operation::split}};
const Names<Smooth::Method> kMethods = {{"median", Smooth::Method::median},
                                        {"closing", Smooth::Method::closing},
                                        {"opening", Smooth::Method::opening},
                                        {"joint", Smooth::Method::joint}};
const Names<Logical::Operation> kLogic = {
    {"copy", Logical::Operation::copy},         {"add", Logical::Operation::add},
    {"subtract", Logical::Operation::subtract}, {"intersect", Logical::Operation::intersect},
    {"invert", Logical::Operation::invert},     {"clear", Logical::Operation::clear},
    {"fill", Logical::Operation::fill}};
const Names<EditableRegion::Area> kAreas = {{"everywhere", EditableRegion::Area::everywhere},
                                            {"labelled", EditableRegion::Area::labelled},
                                            {"unlabelled", EditableRegion::Area::unlabelled},
                                            {"inside_label", EditableRegion::Area::inside_label},
                                            {"inside_liver", EditableRegion::Area::inside_liver}};

template <class E>
std::string name_of(const Names<E>& names, E value) {
  for (const auto& [name, each] : names)
    if (each == value) return name;
  return "";
}

/// Dividing is rounded rightly, so that 789 mm are the metres that a program calls 0.789.
double in_metres(double mm) { return mm / 1e3; }
/// A number of millimetres that reads back as the same number of metres where there is one.
double in_mm(double metres) {
  const double mm = 1e3 * metres;
  for (const double candidate :
       {std::round(mm * 1e6) / 1e6, mm, std::nextafter(mm, 1e300), std::nextafter(mm, -1e300)})
    if (in_metres(candidate) == metres) return candidate;
  return mm;
}
json in_mm(const Eigen::Vector3d& p) { return {in_mm(p.x()), in_mm(p.y()), in_mm(p.z())}; }

/// One object of a script. Every question names the field in its refusal; what was not asked for is refused.
class Entry {
 public:
  Entry(const json& object, std::string file, std::string where)
      : object_(object), file_(std::move(file)), where_(std::move(where)) {
    if (!object.is_object())
      throw InputError(file_, where_, "is not a JSON object", R"(Write {"tool": ..., ...})");
  }

  [[noreturn]] void refuse(const std::string& key, const std::string& problem,
                           const std::string& remedy) const {
    throw InputError(file_, where_ + ", " + key, problem, remedy);
  }
  bool has(const char* key) {
    known_.insert(key);
    return object_.contains(key);
  }
  const json& at(const char* key) {
    if (!has(key)) refuse(key, "is missing", "Add it");
    return object_.at(key);
  }
  Entry object(const char* key) { return {at(key), file_, where_ + ", " + key}; }

  double number(const char* key) { return number_in(at(key), key); }
  double metres(const char* key) { return in_metres(number(key)); }
  int integer(const char* key) {
    const json& value = at(key);
    if (!value.is_number_integer() || value < -1000 || value > 1000)
      refuse(key, "is " + value.dump() + ", which is no small whole number", "Write a whole number");
    return value;
  }
  bool flag(const char* key) {
    if (!has(key)) return false;
    const json& value = object_.at(key);
    if (!value.is_boolean()) refuse(key, "is " + value.dump(), "Write true or false");
    return value;
  }
  std::string text(const char* key) {
    const json& value = at(key);
    if (!value.is_string())
      refuse(key, "is " + value.dump() + ", which is no text", "Write a name in quotes");
    return value;
  }
  template <class E>
  E one_of(const char* key, const Names<E>& names) {
    const std::string wanted = text(key);
    std::string list;
    for (const auto& [name, value] : names) {
      if (wanted == name) return value;
      list += (list.empty() ? "" : ", ") + std::string(name);
    }
    refuse(key, "is \"" + wanted + "\"", "Use one of " + list);
  }
  Label label(const char* key) { return label_in(at(key), key); }
  std::vector<Label> labels(const char* key) {
    std::vector<Label> all;
    for (const json& value : list(key)) all.push_back(label_in(value, key));
    return all;
  }
  Eigen::Vector3d point(const char* key) { return Eigen::Vector3d(row(at(key), key, 3).data()) / 1e3; }
  /// A list of lists of `columns` numbers, row by row.
  std::vector<double> rows(const char* key, std::size_t columns) {
    std::vector<double> all;
    for (const json& value : list(key)) {
      const std::vector<double> numbers = row(value, key, columns);
      all.insert(all.end(), numbers.begin(), numbers.end());
    }
    return all;
  }
  std::vector<double> row(const json& value, const char* key, std::size_t columns) const {
    if (!value.is_array() || value.size() != columns)
      refuse(key, "is not made of " + std::to_string(columns) + " numbers each", "Write lists of numbers");
    std::vector<double> numbers;
    for (const json& each : value) numbers.push_back(number_in(each, key));
    return numbers;
  }
  void finish() const {
    for (const auto& [key, value] : object_.items())
      if (!known_.contains(key))
        refuse(key, "is no field that is known here", "Remove it, or correct its name");
  }

 private:
  const json& list(const char* key) {
    const json& value = at(key);
    if (!value.is_array()) refuse(key, "is not a list", "Write it in square brackets");
    return value;
  }
  double number_in(const json& value, const char* key) const {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      refuse(key, "is " + value.dump() + ", which is no number", "Write a number");
    return value;
  }
  Label label_in(const json& value, const char* key) const {
    const std::optional<Label> label =
        value.is_string() ? structure_named(value.get<std::string>()) : std::nullopt;
    if (!label)
      refuse(key, "is " + value.dump() + ", which is no structure",
             "Use background, parenchyma, portal_vein, hepatic_veins, vena_cava, artery, gallbladder, "
             "lesion_1, other_1 and so on");
    return *label;
  }

  const json& object_;
  std::string file_, where_;
  std::set<std::string> known_;
};

json names_of(const std::vector<Label>& labels) {
  json list = json::array();
  for (const Label label : labels) list.push_back(structure_name(label));
  return list;
}

template <class Matrix>
json rows_of(const Matrix& matrix) {
  json list = json::array();
  for (Eigen::Index r = 0; r < matrix.rows(); ++r) {
    json row = json::array();
    for (Eigen::Index c = 0; c < matrix.cols(); ++c) row.push_back(matrix(r, c));
    list.push_back(row);
  }
  return list;
}

// Each tool both ways, side by side. read() fills in, written() lists the fields beside "tool".

void read(Entry& e, Paint& t) {
  t.label = e.label("label");
  t.erase = e.flag("erase");
  t.brush = e.one_of("brush", kBrushes);
  t.radius = e.metres("radius_mm");
  if (t.brush == Paint::Brush::disc || e.has("normal_axis")) t.normal_axis = e.integer("normal_axis");
  const std::vector<double> path = e.rows("path_mm", 3);
  t.path = Eigen::Map<const Points>(path.data(), static_cast<Eigen::Index>(path.size() / 3), 3) / 1e3;
}
json written(const Paint& t) {
  json path = json::array();
  for (Eigen::Index n = 0; n < t.path.rows(); ++n)
    path.push_back(in_mm(Eigen::Vector3d(t.path.row(n).transpose())));
  return {{"label", structure_name(t.label)},    {"erase", t.erase},
          {"brush", name_of(kBrushes, t.brush)}, {"radius_mm", in_mm(t.radius)},
          {"normal_axis", t.normal_axis},        {"path_mm", path}};
}

void read(Entry& e, Threshold& t) {
  t.label = e.label("label");
  t.low = e.number("low_hu");
  t.high = e.number("high_hu");
  t.replace = e.flag("replace");
}
json written(const Threshold& t) {
  return {{"label", structure_name(t.label)}, {"low_hu", t.low}, {"high_hu", t.high}, {"replace", t.replace}};
}

void read(Entry& e, Scissors& t) {
  t.label = e.label("label");
  t.operation = e.one_of("operation", kCuts);
  const std::vector<double> view = e.rows("view_from_ct", 4);
  if (view.size() != 12) e.refuse("view_from_ct", "is not 3 x 4", "Write three lists of four numbers");
  t.view_from_ct = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(view.data());
  const std::vector<double> outline = e.rows("outline", 2);
  t.outline = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>>(
      outline.data(), static_cast<Eigen::Index>(outline.size() / 2), 2);
  if (!e.has("slab")) return;
  Entry slab = e.object("slab");
  t.slab = Scissors::Slab();
  t.slab->normal = Eigen::Vector3d(slab.row(slab.at("normal"), "normal", 3).data());
  t.slab->offset = slab.metres("offset_mm");
  t.slab->half_thickness = slab.metres("half_thickness_mm");
  slab.finish();
}
json written(const Scissors& t) {
  json fields = {{"label", structure_name(t.label)},
                 {"operation", name_of(kCuts, t.operation)},
                 {"view_from_ct", rows_of(t.view_from_ct)},
                 {"outline", rows_of(t.outline)}};
  if (t.slab)
    fields["slab"] = {{"normal", {t.slab->normal.x(), t.slab->normal.y(), t.slab->normal.z()}},
                      {"offset_mm", in_mm(t.slab->offset)},
                      {"half_thickness_mm", in_mm(t.slab->half_thickness)}};
  return fields;
}

void read(Entry& e, GrowFromSeeds& t) {
  t.labels = e.labels("labels");
  if (e.has("rivals")) t.rivals = e.labels("rivals");
  if (e.has("reach_mm")) t.reach = e.metres("reach_mm");
}
json written(const GrowFromSeeds& t) {
  return {{"labels", names_of(t.labels)}, {"rivals", names_of(t.rivals)}, {"reach_mm", in_mm(t.reach)}};
}

void read(Entry& e, LevelTracing& t) {
  t.label = e.label("label");
  t.erase = e.flag("erase");
  t.normal_axis = e.integer("normal_axis");
  t.p_in_ct = e.point("p_mm");
}
json written(const LevelTracing& t) {
  return {{"label", structure_name(t.label)},
          {"erase", t.erase},
          {"normal_axis", t.normal_axis},
          {"p_mm", in_mm(t.p_in_ct)}};
}

bool is_clicked(Islands::Operation operation) {
  return operation == Islands::Operation::keep_clicked || operation == Islands::Operation::remove_clicked;
}
void read(Entry& e, Islands& t) {
  t.label = e.label("label");
  t.operation = e.one_of("operation", kIslands);
  if (t.operation == Islands::Operation::remove_small || e.has("smallest_ml"))
    t.smallest_ml = e.number("smallest_ml");
  if (is_clicked(t.operation) || e.has("p_mm")) t.p_in_ct = e.point("p_mm");
}
json written(const Islands& t) {
  return {{"label", structure_name(t.label)},
          {"operation", name_of(kIslands, t.operation)},
          {"smallest_ml", t.smallest_ml},
          {"p_mm", in_mm(t.p_in_ct)}};
}

void read(Entry& e, FillHoles& t) {
  t.label = e.label("label");
  t.in_slices = e.flag("in_slices");
}
json written(const FillHoles& t) { return {{"label", structure_name(t.label)}, {"in_slices", t.in_slices}}; }

void read(Entry& e, Smooth& t) {
  t.method = e.one_of("method", kMethods);
  if (t.method != Smooth::Method::joint || e.has("label")) t.label = e.label("label");
  t.radius = e.metres("radius_mm");
}
json written(const Smooth& t) {
  return {{"label", structure_name(t.label)},
          {"method", name_of(kMethods, t.method)},
          {"radius_mm", in_mm(t.radius)}};
}

void read(Entry& e, Margin& t) {
  t.label = e.label("label");
  t.distance = e.metres("distance_mm");
}
json written(const Margin& t) {
  return {{"label", structure_name(t.label)}, {"distance_mm", in_mm(t.distance)}};
}

void read(Entry& e, InterpolateSlices& t) {
  t.label = e.label("label");
  t.normal_axis = e.integer("normal_axis");
}
json written(const InterpolateSlices& t) {
  return {{"label", structure_name(t.label)}, {"normal_axis", t.normal_axis}};
}

bool has_other(Logical::Operation operation) {
  return operation == Logical::Operation::copy || operation == Logical::Operation::add ||
         operation == Logical::Operation::subtract || operation == Logical::Operation::intersect;
}
void read(Entry& e, Logical& t) {
  t.label = e.label("label");
  t.operation = e.one_of("operation", kLogic);
  if (has_other(t.operation) || e.has("other")) t.other = e.label("other");
}
json written(const Logical& t) {
  return {{"label", structure_name(t.label)},
          {"operation", name_of(kLogic, t.operation)},
          {"other", structure_name(t.other)}};
}

void read(Entry& e, ReassignBranch& t) {
  t.label = e.label("label");
  t.to = e.label("to");
  t.p_in_ct = e.point("p_mm");
}
json written(const ReassignBranch& t) {
  return {{"label", structure_name(t.label)}, {"to", structure_name(t.to)}, {"p_mm", in_mm(t.p_in_ct)}};
}

EditableRegion read_region(Entry e) {
  EditableRegion region;
  if (e.has("area")) region.area = e.one_of("area", kAreas);
  if (region.area == EditableRegion::Area::inside_label || e.has("label")) region.label = e.label("label");
  if (e.has("intensity_hu")) {
    const std::vector<double> range = e.row(e.at("intensity_hu"), "intensity_hu", 2);
    region.intensity = {range[0], range[1]};
  }
  if (e.has("locked")) region.locked = e.labels("locked");
  e.finish();
  return region;
}
json written(const EditableRegion& region) {
  json fields = {{"area", name_of(kAreas, region.area)}};
  if (region.label != structure::kBackground || region.area == EditableRegion::Area::inside_label)
    fields["label"] = structure_name(region.label);
  if (region.intensity) fields["intensity_hu"] = *region.intensity;
  if (!region.locked.empty()) fields["locked"] = names_of(region.locked);
  return fields;
}

/// A tool of each kind with its defaults, by place in the variant.
template <std::size_t... I>
std::vector<Tool> tools(std::index_sequence<I...>) {
  return {Tool(std::in_place_index<I>)...};
}

Tool tool_called(Entry& e) {
  const std::string wanted = e.text("tool");
  std::string list;
  for (const Tool& tool : tools(std::make_index_sequence<std::variant_size_v<Tool>>())) {
    if (tool_name(tool) == wanted) return tool;
    list += (list.empty() ? "" : ", ") + tool_name(tool);
  }
  e.refuse("tool", "is \"" + wanted + "\"", "Use one of " + list);
}

Edit read_edit(const json& object, const std::string& file, const std::string& where) {
  Entry e(object, file, where);
  Edit edit{tool_called(e), {}};
  std::visit([&](auto& tool) { read(e, tool); }, edit.tool);
  if (e.has("region")) edit.region = read_region(e.object("region"));
  e.finish();
  try {
    check_edit(edit);
  } catch (const InputError& error) {
    throw InputError(file, where + ", " + error.field(), error.problem(), error.remedy());
  }
  return edit;
}

}  // namespace

std::vector<Edit> read_edits(const std::filesystem::path& path) {
  const json document = read_json(path);
  const std::string file = path.string();
  if (!document.is_object() || document.size() != 1 || !document.contains("edits") ||
      !document["edits"].is_array())
    throw InputError(file, "edits", "are not the one list of the file",
                     R"(Write {"edits": [{"tool": ...}, ...]})");
  std::vector<Edit> edits;
  for (const json& object : document["edits"])
    edits.push_back(read_edit(object, file, "edit " + std::to_string(edits.size() + 1)));
  return edits;
}

void write_edits(const std::filesystem::path& path, const std::vector<Edit>& edits) {
  json list = json::array();
  for (const Edit& edit : edits) {
    json object = std::visit([](const auto& tool) { return written(tool); }, edit.tool);
    object["tool"] = tool_name(edit.tool);
    if (!(edit.region == EditableRegion())) object["region"] = written(edit.region);
    list.push_back(std::move(object));
  }
  write_json(path, {{"edits", std::move(list)}});
}

}  // namespace glisson::editing
