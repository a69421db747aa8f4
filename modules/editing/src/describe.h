// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>

#include "edit_tools.h"
#include "glisson/geometry/mesh.h"
#include "script_entry.h"
#include "settings_check.h"

/// @file
/// How a tool is described, in its own source and once: its fields as members of its settings, its names, and
/// what it does. Reading, writing and checking follow.

namespace glisson::editing {

template <class T>
using When = std::function<bool(const T&)>;

/// A member of T as a field of scripts.
template <class T>
struct Field {
  using Check = std::function<void(const SettingsCheck&, const T&)>;

  ToolField about;
  std::function<void(ScriptEntry&, T&)> read;
  std::function<void(nlohmann::json&, const T&)> write;
  Check check = {};

  /// A script may leave the field out.
  Field&& with_default() && {
    about.has_default = true;
    read = [read = std::move(read), code = about.code](ScriptEntry& e, T& t) {
      if (e.has(code)) read(e, t);
    };
    return std::move(*this);
  }
  /// A script must give the field only where `when` says so of the fields before it.
  Field&& needed(const char* says_when, When<T> when) && {
    about.needed = says_when;
    read = [read = std::move(read), code = about.code, when = std::move(when)](ScriptEntry& e, T& t) {
      if (when(t) || e.has(code)) read(e, t);
    };
    return std::move(*this);
  }
  /// It is written only then.
  Field&& written(When<T> when) && {
    write = [write = std::move(write), when = std::move(when)](nlohmann::json& json, const T& t) {
      if (when(t)) write(json, t);
    };
    return std::move(*this);
  }
  Field&& checked(Check what) && {
    check = std::move(what);
    return std::move(*this);
  }
  Field&& noted(const char* note) && {
    about.note = note;
    return std::move(*this);
  }
};

template <class T>
using Fields = std::vector<Field<T>>;

template <class T>
void read_fields(const Fields<T>& fields, ScriptEntry& e, T& t) {
  for (const Field<T>& field : fields) field.read(e, t);
}
template <class T>
nlohmann::json written(const Fields<T>& fields, const T& t) {
  nlohmann::json object = nlohmann::json::object();
  for (const Field<T>& field : fields) field.write(object, t);
  return object;
}
template <class T>
std::vector<ToolField> about(const Fields<T>& fields) {
  std::vector<ToolField> list;
  for (const Field<T>& field : fields) list.push_back(field.about);
  return list;
}

inline ToolField field_of(const char* code, ToolField::Kind kind, const char* unit = "") {
  ToolField field;
  field.code = code;
  field.kind = kind;
  field.unit = unit;
  return field;
}

/// A label that the tool gives or takes. @param background when it may be the background.
template <class T>
Field<T> label_field(const char* code, Label T::*member, const When<T>& background = {}) {
  return {field_of(code, ToolField::Kind::label), [=](ScriptEntry& e, T& t) { t.*member = e.label(code); },
          [=](nlohmann::json& json, const T& t) { json[code] = structure_name(t.*member); },
          [=](const SettingsCheck& check, const T& t) {
            check.target(t.*member, code, background && background(t));
          }};
}
template <class T>
Field<T> labels_field(const char* code, std::vector<Label> T::*member) {
  return {field_of(code, ToolField::Kind::labels), [=](ScriptEntry& e, T& t) { t.*member = e.labels(code); },
          [=](nlohmann::json& json, const T& t) {
            nlohmann::json list = nlohmann::json::array();
            for (const Label label : t.*member) list.push_back(structure_name(label));
            json[code] = std::move(list);
          }};
}
/// Not set where it is not there.
template <class T>
Field<T> flag_field(const char* code, bool T::*member) {
  ToolField about = field_of(code, ToolField::Kind::flag);
  about.has_default = true;
  return {about, [=](ScriptEntry& e, T& t) { t.*member = e.flag(code); },
          [=](nlohmann::json& json, const T& t) { json[code] = t.*member; }};
}
template <class T, class E>
Field<T> choice_field(const char* code, E T::*member, const Names<E>& names) {
  ToolField about = field_of(code, ToolField::Kind::choice);
  about.choices = words_of(names);
  return {about, [=](ScriptEntry& e, T& t) { t.*member = e.one_of(code, names); },
          [=](nlohmann::json& json, const T& t) { json[code] = name_of(names, t.*member); }};
}
/// The voxel axis across slices.
template <class T>
Field<T> axis_field(int T::*member) {
  constexpr const char* kCode = "normal_axis";
  Field<T> field{field_of(kCode, ToolField::Kind::whole),
                 [=](ScriptEntry& e, T& t) { t.*member = e.integer(kCode); },
                 [=](nlohmann::json& json, const T& t) { json[kCode] = t.*member; },
                 [=](const SettingsCheck& check, const T& t) { check.axis(t.*member, kCode); }};
  field.about.note = "0, 1, 2";
  return field;
}
template <class T>
Field<T> number_field(const char* code, double T::*member, const char* unit) {
  return {field_of(code, ToolField::Kind::number, unit),
          [=](ScriptEntry& e, T& t) { t.*member = e.number(code); },
          [=](nlohmann::json& json, const T& t) { json[code] = t.*member; }};
}
/// Metres, which scripts write in millimetres. @param code ends with "_mm", which refusals leave out.
/// @param most metres, of more than 0; none: any length, of any sign.
template <class T>
Field<T> length_field(const char* code, double T::*member, const std::optional<double>& most = {}) {
  Field<T> field{field_of(code, ToolField::Kind::length, "mm"),
                 [=](ScriptEntry& e, T& t) { t.*member = e.metres(code); },
                 [=](nlohmann::json& json, const T& t) { json[code] = in_mm(t.*member); }};
  if (!most) return field;
  field.about.most = 1e3 * *most;
  field.check = [member, most, setting = std::string(code).substr(0, std::string(code).size() - 3)](
                    const SettingsCheck& check, const T& t) { check.length(t.*member, setting, *most); };
  return field;
}
/// A point of the CT's frame.
template <class T>
Field<T> point_field(Eigen::Vector3d T::*member) {
  constexpr const char *kCode = "p_mm", *kSetting = "p_in_ct";
  Field<T> field{field_of(kCode, ToolField::Kind::point, "mm"),
                 [=](ScriptEntry& e, T& t) { t.*member = e.point(kCode); },
                 [=](nlohmann::json& json, const T& t) { json[kCode] = in_mm(t.*member); },
                 [=](const SettingsCheck& check, const T& t) { check.point(t.*member, kSetting); }};
  return field;
}
/// Points of the CT's frame, a row each; one at least.
template <class T>
Field<T> path_field(PointsIn<CtFrame> T::*member) {
  constexpr const char *kCode = "path_mm", *kSetting = "path";
  return {field_of(kCode, ToolField::Kind::path, "mm"),
          [=](ScriptEntry& e, T& t) {
            const std::vector<double> path = e.rows(kCode, 3);
            t.*member =
                Eigen::Map<const Points>(path.data(), static_cast<Eigen::Index>(path.size() / 3), 3) / 1e3;
          },
          [=](nlohmann::json& json, const T& t) {
            nlohmann::json path = nlohmann::json::array();
            for (Eigen::Index n = 0; n < (t.*member).rows(); ++n)
              path.push_back(in_mm(Eigen::Vector3d((t.*member).row(n).transpose())));
            json[kCode] = std::move(path);
          },
          [=](const SettingsCheck& check, const T& t) {
            if ((t.*member).rows() == 0) check.refuse(kSetting, "has no point", "Give at least one");
            for (Eigen::Index n = 0; n < (t.*member).rows(); ++n)
              check.point((t.*member).row(n).transpose(), kSetting);
          }};
}
/// Rows of numbers as they are. @param rows 0: any number of them.
template <class T, class Matrix>
Field<T> matrix_field(const char* code, Matrix T::*member) {
  constexpr int kColumns = Matrix::ColsAtCompileTime, kRows = Matrix::RowsAtCompileTime;
  return {field_of(code, ToolField::Kind::matrix),
          [=](ScriptEntry& e, T& t) {
            const std::vector<double> numbers = e.rows(code, kColumns);
            const auto rows = static_cast<Eigen::Index>(numbers.size() / kColumns);
            if (kRows != Eigen::Dynamic && rows != kRows)
              e.refuse(code, "is not " + std::to_string(kRows) + " x " + std::to_string(kColumns),
                       "Write three lists of four numbers");
            t.*member = Eigen::Map<const Eigen::Matrix<double, kRows, kColumns, Eigen::RowMajor>>(
                numbers.data(), rows, kColumns);
          },
          [=](nlohmann::json& json, const T& t) {
            nlohmann::json list = nlohmann::json::array();
            for (Eigen::Index r = 0; r < (t.*member).rows(); ++r) {
              nlohmann::json row = nlohmann::json::array();
              for (Eigen::Index c = 0; c < kColumns; ++c) row.push_back((t.*member)(r, c));
              list.push_back(std::move(row));
            }
            json[code] = std::move(list);
          }};
}

/// "islands.split" for each word of a choice.
template <class E>
std::vector<std::string> steps_of(const char* code, const Names<E>& names) {
  std::vector<std::string> steps;
  for (const auto& [name, value] : names) steps.push_back(std::string(code) + "." + name);
  return steps;
}

template <class T>
struct Description {
  std::string code;
  int place = 0;  ///< among the kinds, see ToolKind::place
  Fields<T> fields;
  std::vector<std::string> steps;
  StepName (*step)(const T&);
  Cancellable<Canvas> (*apply)(const T&, Task&);
  /// Whether it works at once where the pointer is.
  When<T> is_local = [](const T&) { return false; };
};

template <class T>
class Described final : public ToolKind {
 public:
  explicit Described(Description<T> description) : d_(std::move(description)) {}

  const std::string& code() const override { return d_.code; }
  int place() const override { return d_.place; }
  std::vector<ToolField> fields() const override { return about(d_.fields); }
  const std::vector<std::string>& steps() const override { return d_.steps; }
  Tool with_defaults() const override { return T(); }
  bool same(const Tool& a, const Tool& b) const override { return a.as<T>() == b.as<T>(); }
  StepName step(const Tool& tool) const override { return d_.step(tool.as<T>()); }
  bool is_local(const Tool& tool) const override { return d_.is_local(tool.as<T>()); }
  void check(const Tool& tool, const EditableRegion& region) const override {
    const SettingsCheck check(d_.code, region);
    check.region();
    for (const Field<T>& field : d_.fields)
      if (field.check) field.check(check, tool.as<T>());
  }
  Cancellable<Canvas> apply(const Tool& tool, Task& task) const override {
    return d_.apply(tool.as<T>(), task);
  }
  Tool read(ScriptEntry& entry) const override {
    T settings;
    read_fields(d_.fields, entry, settings);
    return settings;
  }
  void write(const Tool& tool, ScriptFields& fields) const override {
    fields.object = written(d_.fields, tool.as<T>());
  }

 private:
  Description<T> d_;
};

}  // namespace glisson::editing
