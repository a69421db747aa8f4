// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glisson/ui/segmentation/edit_settings.h"
#include "glisson/volume/grid.h"

/// @file
/// What the window adds to a tool of the editor: one description for each, in a source of its own, from which
/// button, key, page, texts, undo names and the manual's table follow. No widgets. Texts are for translators:
/// `says` in context EditTexts, `page` in context glisson::ui::ToolPages.

namespace glisson::ui {

struct WindowTool;
/// Null: no tool. Descriptions live as long as the program.
using EditTool = const WindowTool*;

/// A widget of a tool's page, coupled to the settings.
struct PageField {
  enum class Kind { number, slider, choice, check, label, button };
  using Get = std::function<double(const EditSettings&)>;
  using Set = std::function<void(EditSettings&, double)>;
  struct Range {
    double low = 0.0, high = 0.0, step = 1.0;
    int decimals = 0;
    std::string unit = {};  ///< "mm", "HU", "ml"
  };

  Kind kind = Kind::number;
  const char* object = "";  ///< the widget's name
  const char* text = "";
  Get get = {};
  Set set = {};  ///< of a button: what its click sets (its number is 0)
  Range range = {};
  std::vector<const char*> choices = {};  ///< by number
  const char* tip = nullptr;
  /// A number counts when it is entered, not with each of its digits.
  bool whole_numbers = false;
  /// The tool that a button's click chooses.
  const char* then = nullptr;
};

/// The settings themselves, or those of one tool among them.
template <class Owner>
auto& settings_of(auto& settings) {
  if constexpr (std::is_same_v<Owner, EditSettings>)
    return settings;
  else
    return settings.template of<Owner>();
}
/// A member of the settings, or of a tool's own (`&editing::Smooth::radius`), as the number of a page's
/// field.
template <class Owner, class Member>
PageField coupled(Member Owner::*which, double factor = 1.0) {
  PageField field;
  field.get = [=](const EditSettings& s) {
    return factor * static_cast<double>(settings_of<Owner>(s).*which);
  };
  field.set = [=](EditSettings& s, double value) {
    if constexpr (std::is_same_v<Member, double>)
      settings_of<Owner>(s).*which = value / factor;
    else
      settings_of<Owner>(s).*which = static_cast<Member>(static_cast<int>(value));
  };
  return field;
}
template <class Owner, class Member>
PageField number_box(const char* object, const char* text, const PageField::Range& range,
                     Member Owner::*which, double factor = 1.0) {
  PageField field = coupled(which, factor);
  field.object = object;
  field.text = text;
  field.range = range;
  return field;
}
template <class Owner, class Member>
PageField choice_box(const char* object, const char* text, std::vector<const char*> choices,
                     Member Owner::*which) {
  PageField field = coupled(which);
  field.kind = PageField::Kind::choice;
  field.object = object;
  field.text = text;
  field.choices = std::move(choices);
  return field;
}
template <class Owner>
PageField check_box(const char* object, const char* text, bool Owner::*which) {
  PageField field = coupled(which);
  field.kind = PageField::Kind::check;
  field.object = object;
  field.text = text;
  return field;
}

/// A range that ends where scripts end it. Unit and largest value are those of `field` of the editor's tool
/// `tool`.
/// @throws PreconditionError there is no such tool or field, or the field has no largest value.
PageField::Range range_of(std::string_view tool, std::string_view field, double low, double step,
                          int decimals);

/// Where a tool is clicked. @param clicked label at the place.
struct ToolClick {
  const VolumeGrid& grid;
  scene::Plane plane;
  Point<CtFrame> p;
  Label clicked = 0;
  bool invert = false;
};
/// What a tool works on that is applied to the whole volume. @param present labels that have voxels.
struct WholeVolume {
  const VolumeGrid& grid;
  const std::vector<Label>& present;
};

/// What a click would do, in words: a sentence for translators in context EditTexts, where %1 is the volume
/// that changes in ml, and %2 and so on are the names of `labels`.
struct Foretold {
  const char* text = "";
  std::vector<Label> labels = {};
};

/// @param after the labels that the click that is `shown` makes of `before`.
using StandsFor = std::function<bool(const editing::Tool& shown, const editing::Tool& click,
                                     const LabelMap& before, const LabelMap& after)>;

/// A tool of the window: its button, its page, and what the mouse does with it. One a file (tools/NAME.cpp).
struct WindowTool {
  /// What shows at the pointer before it clicks.
  enum class AtPointer { nothing, outline, branch, way };
  struct Step {
    const char* code;  ///< of editing::ToolKind::steps()
    const char* text;
  };

  std::string code;         ///< for names of widgets and icons: "level_tracing"
  int place;                ///< tools are listed by rising place; those that are there stand 10 apart
  char key;                 ///< chooses it
  const char* name;         ///< for translators, like the hint and the steps
  std::vector<Step> steps;  ///< names of what it did, for undo and redo
  /// What to do with the mouse, in one line.
  std::function<const char*(const EditSettings&)> hint;
  /// What the manual says of it. Empty: its row is that of the tool before.
  const char* manual;
  std::vector<PageField> page = {};
  /// The tool whose page it has; null: its own.
  const char* page_of = nullptr;

  /// What the mouse does while it is chosen.
  std::function<Hand(const EditSettings&)> hand = [](const EditSettings&) { return Hand::crosshair; };
  bool erases = false;  ///< a brush that takes away
  AtPointer at_pointer = AtPointer::nothing;
  /// Takes its time: its preview waits to be asked for.
  bool is_slow = false;
  /// Whether it works on the chosen label, which must not be locked then.
  std::function<bool(const EditSettings&)> works_on_label = [](const EditSettings&) { return true; };
  /// What else is missing.
  std::function<EditObstacle(const EditSettings&, const std::vector<Label>& present)> obstacle =
      [](const EditSettings&, const std::vector<Label>&) { return EditObstacle::none; };
  /// What a click does; nothing: nothing there. Empty function: it is not clicked.
  std::function<std::optional<editing::Tool>(const EditSettings&, const ToolClick&)> click = {};
  /// What a row of clicks does; path: CT frame, metres, two points or more. Ctrl adds a point, a click
  /// without it is the last. Empty function: each click stands alone.
  std::function<editing::Tool(const EditSettings&, const Points& path)> chain = {};
  /// What is said of a click whose outcome is shown before it happens. Empty function: the tool shows none.
  std::function<Foretold(const editing::Tool& click)> foretells = {};
  /// Whether what is shown of one click may stay in sight until it is known what another would do. Empty
  /// function: always; it is drawn again as the pointer moves.
  StandsFor stands_for = {};
  /// What it does to the whole volume. Empty function: it works where the mouse is.
  std::function<editing::Tool(const EditSettings&, const WholeVolume&)> whole = {};
};

using EditTools = std::vector<EditTool>;
/// All tools, in the order of their buttons and of the manual.
const EditTools& edit_tools();
/// @throws PreconditionError there is none.
EditTool edit_tool(std::string_view code, const EditTools& tools = edit_tools());
/// The manual's table of the window's tools: name, key, what it does.
std::string tool_table(const EditTools& tools = edit_tools());

/// The voxel axis across slices of a plane.
int voxel_axis_across(const VolumeGrid& grid, scene::Plane plane);
bool is_among(const std::vector<Label>& labels, Label label);
/// The obstacle of tools that need something to work on.
EditObstacle empty_label(const EditSettings& settings, const std::vector<Label>& present);

}  // namespace glisson::ui
