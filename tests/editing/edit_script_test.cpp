// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>
#include <nlohmann/json.hpp>

#include "edit_naive.h"
#include "glisson/core/error.h"
#include "glisson/core/files.h"
#include "glisson/core/json_file.h"

using namespace glisson;
using namespace glisson::editing;
using namespace glisson::test;
using nlohmann::json;

namespace {

/// One edit with each tool, with settings that are not the defaults.
std::vector<Edit> one_of_each() {
  Points path(3, 3);
  path << 0.0123, -0.0456, 0.789, 0.1, 0.2, 0.3, 1e-4, -7e-5, 0.0;
  Scissors scissors;
  scissors.label = structure::kArtery;
  scissors.operation = Scissors::Operation::erase_outside;
  scissors.view_from_ct << 1.5, 0.25, 0.0, -0.02, 0.1, 1.0, 0.3, 0.04, 0.0, 0.01, 1.0, 0.7;
  scissors.outline.resize(4, 2);
  scissors.outline << 0.1, 0.2, 0.5, 0.25, 0.6, 0.9, 1.0 / 3.0, 0.7;
  Scissors slice = scissors;
  slice.slab = Scissors::Slab{Eigen::Vector3d(0.6, 0.0, 0.8), -0.0125, 0.4e-3};
  EditableRegion region;
  region.area = EditableRegion::Area::inside_label;
  region.label = structure::kParenchyma;
  region.intensity = std::array<double, 2>{-12.5, 240.0};
  region.locked = {structure::kVenaCava, structure::kFirstLesion + 3};
  EditableRegion liver;
  liver.area = EditableRegion::Area::inside_liver;
  const Eigen::Vector3d p(0.011, -0.022, 0.033);
  return {{Paint{structure::kPortalVein, false, Paint::Brush::ball, 3.25e-3, 2, path}, region},
          {Paint{structure::kBackground, true, Paint::Brush::disc, 7e-3, 1, path.topRows(1)}, {}},
          {Threshold{structure::kFirstLesion, -20.5, 75.25, true}, liver},
          {scissors, {}},
          {slice, region},
          {GrowFromSeeds{{1, 2, 17}, 12e-3, {7, 8}}, {}},
          {LevelTracing{structure::kGallbladder, true, 0, p}, {}},
          {Islands{structure::kHepaticVeins, Islands::Operation::keep_clicked, 0.25, p}, {}},
          {FillHoles{structure::kGallbladder, true}, {}},
          {Smooth{structure::kHepaticVeins, Smooth::Method::closing, 1.7e-3}, {}},
          {Margin{structure::kFirstLesion, -2.3e-3}, {}},
          {InterpolateSlices{structure::kFirstLesion, 0}, {}},
          {Logical{structure::kArtery, Logical::Operation::intersect, structure::kHepaticVeins}, {}},
          {ReassignBranch{structure::kHepaticVeins, structure::kPortalVein, p}, {}}};
}

/// The refusal of a script, or "".
std::pair<std::string, std::string> refusal_of(const json& script) {
  const TemporaryFolder folder;
  write_json(folder.path() / "edits.json", script);
  try {
    (void)read_edits(folder.path() / "edits.json");
  } catch (const InputError& error) {
    return {error.field(), error.what()};
  }
  return {};
}

/// The tool and setting that an edit is refused for, "tool, setting"; "" when it is not.
std::string refused_setting(const Tool& tool, const EditableRegion& region = {}) {
  const VolumeGrid grid = awkward_grids()[0];
  const Image image = image_of(grid, [](const Eigen::Vector3i&) { return 0.0; });
  const LabelMap labels = small_anatomy(grid, 1);
  try {
    (void)apply_edit(labels, image, {tool, region}, RunContext());
  } catch (const InputError& error) {
    return error.remedy().empty() ? "no remedy" : error.file() + ", " + error.field();
  }
  return "";
}

template <class T, class Change>
Tool changed(T tool, Change&& change) {
  change(tool);
  return tool;
}

Points middle() {
  const VolumeGrid grid = awkward_grids()[0];
  Points path(1, 3);
  path.row(0) = p_at(grid, middle_of(grid)).transpose();
  return path;
}

}  // namespace

class EditScriptTest : public QObject {
  Q_OBJECT
 private slots:
  void ScriptsReadBackAsWritten();
  void ScriptsOfPeopleMayLeaveDefaultsOut();
  void EveryMissingOrSpoiltFieldIsNamed();
  void UnknownFieldsAreRefused();
  void FilesThatAreNoScriptsAreRefused();
  void SettingsOutOfRangeAreRefused_data();
  void SettingsOutOfRangeAreRefused();
  void AnotherGridIsRefused();
};

void EditScriptTest::ScriptsReadBackAsWritten() {
  const TemporaryFolder folder;
  const std::vector<Edit> edits = one_of_each();
  write_edits(folder.path() / "a.json", edits);
  const std::vector<Edit> back = read_edits(folder.path() / "a.json");
  QCOMPARE(back.size(), edits.size());
  for (std::size_t n = 0; n < edits.size(); ++n)
    QVERIFY2(back[n] == edits[n], qPrintable(QString::number(n + 1)));
  QVERIFY(!(back[0] == back[1]) && !(back[3] == back[4]));
  write_edits(folder.path() / "b.json", back);
  QCOMPARE(read_file(folder.path() / "b.json"), read_file(folder.path() / "a.json"));
}

void EditScriptTest::ScriptsOfPeopleMayLeaveDefaultsOut() {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "a.json", R"({"edits": [
    {"tool": "paint", "label": "portal_vein", "brush": "ball", "radius_mm": 3, "path_mm": [[1, 2, 3], [4, 5, 6]]},
    {"tool": "islands", "label": "lesion_2", "operation": "keep_largest"},
    {"tool": "grow_from_seeds", "labels": ["parenchyma", "other_1"], "rivals": ["other_1"]},
    {"tool": "smooth", "method": "joint", "radius_mm": 2, "region": {"locked": ["artery"]}}]})");
  const std::vector<Edit> edits = read_edits(folder.path() / "a.json");
  QCOMPARE(edits.size(), std::size_t(4));
  const auto& paint = edits[0].tool.as<Paint>();
  QVERIFY(!paint.erase && paint.brush == Paint::Brush::ball);
  QCOMPARE(paint.radius, 3e-3);
  QCOMPARE(paint.path.row(1), Eigen::RowVector3d(0.004, 0.005, 0.006));
  QCOMPARE(edits[1].tool.as<Islands>().label, Label{17});
  QCOMPARE(edits[2].tool.as<GrowFromSeeds>().reach, GrowFromSeeds().reach);
  QCOMPARE(edits[3].region.locked, std::vector<Label>{structure::kArtery});
}

void EditScriptTest::EveryMissingOrSpoiltFieldIsNamed() {
  const TemporaryFolder folder;
  write_edits(folder.path() / "a.json", one_of_each());
  const json good = read_json(folder.path() / "a.json");
  const std::vector<json> spoilt = {nullptr, "no such thing", -123456.5, json::array({"x"}),
                                    json::object({{"x", 1}})};
  int missing = 0, wrong = 0;
  for (std::size_t n = 0; n < good["edits"].size(); ++n)
    for (const auto& [key, value] : good["edits"][n].items()) {
      const std::string entry = "edit " + std::to_string(n + 1);
      json script = good;
      script["edits"][n].erase(key);
      const std::string field = refusal_of(script).first;
      // Some have defaults; what is refused names the entry and the field.
      if (!field.empty()) {
        ++missing;
        // The background cannot be painted: without "erase" it is the label that is wrong.
        QVERIFY2(field == entry + ", " + (key == "erase" ? "label" : key), field.c_str());
      }
      for (const json& nonsense : spoilt) {
        // As good as any, or not looked at by a click.
        if ((key == "low_hu" || key == "smallest_ml") && nonsense.is_number()) continue;
        script["edits"][n][key] = nonsense;
        const auto [named, sentence] = refusal_of(script);
        QVERIFY2(named.starts_with(entry + ", "), (key + " " + nonsense.dump() + ": " + sentence).c_str());
        // A number may be out of range instead: then the setting is named as the tool calls it.
        const std::string stem = key.substr(0, key.find('_'));
        if (key == "high_hu" && named == entry + ", low") continue;  // below the low
        QVERIFY2(named.find(stem) != std::string::npos, (key + ": " + sentence).c_str());
        ++wrong;
      }
    }
  QVERIFY2(missing > 40 && wrong > 300, qPrintable(QString("%1 %2").arg(missing).arg(wrong)));
}

void EditScriptTest::UnknownFieldsAreRefused() {
  json script = {
      {"edits", json::array({{{"tool", "fill_holes"}, {"label", "parenchyma"}, {"radius_mm", 3}}})}};
  QCOMPARE(refusal_of(script).first, std::string("edit 1, radius_mm"));
  script["edits"][0].erase("radius_mm");
  QCOMPARE(refusal_of(script).first, std::string());
  script["edits"][0]["region"] = {{"areas", "labelled"}};
  QCOMPARE(refusal_of(script).first, std::string("edit 1, region, areas"));
}

void EditScriptTest::FilesThatAreNoScriptsAreRefused() {
  for (const char* text : {"[]", "{}", "{\"edits\": {}}", "{\"edits\": [], \"more\": 1}", "3"})
    QVERIFY2(refusal_of(json::parse(text)).first == "edits", text);
  QCOMPARE(refusal_of(json::parse("{\"edits\": [3]}")).first, std::string("edit 1"));
  QCOMPARE(refusal_of(json::parse("{\"edits\": []}")).first, std::string());
  const TemporaryFolder folder;
  QVERIFY_THROWS_EXCEPTION(FileError, read_edits(folder.path() / "absent.json"));
}

void EditScriptTest::SettingsOutOfRangeAreRefused_data() {
  QTest::addColumn<QString>("is");
  QTest::addColumn<QString>("expected");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  auto row = [n = 0](const std::string& is, const char* expected) mutable {
    QTest::newRow(qPrintable(QString("%1 %2").arg(++n).arg(expected)))
        << QString::fromStdString(is) << QString(expected);
  };
  const Paint paint{structure::kPortalVein, false, Paint::Brush::ball, 3e-3, 2, middle()};
  row(refused_setting(paint), "");
  row(refused_setting(changed(paint, [](Paint& t) { t.label = 0; })), "paint, label");
  row(refused_setting(changed(paint, [](Paint& t) { t.label = 300; })), "paint, label");
  row(refused_setting(changed(paint, [](Paint& t) { t.radius = 0.0; })), "paint, radius");
  row(refused_setting(changed(paint, [](Paint& t) { t.radius = 3.0; })), "paint, radius");
  row(refused_setting(changed(paint, [&](Paint& t) { t.radius = nan; })), "paint, radius");
  row(refused_setting(changed(paint, [](Paint& t) { t.normal_axis = 3; })), "paint, normal_axis");
  row(refused_setting(changed(paint, [](Paint& t) { t.path.resize(0, 3); })), "paint, path");
  row(refused_setting(changed(paint, [&](Paint& t) { t.path(0, 1) = nan; })), "paint, path");
  row(refused_setting(changed(paint,
                              [](Paint& t) {
                                t.brush = Paint::Brush::disc;
                                t.path.conservativeResize(2, 3);
                                t.path.row(1) = t.path.row(0) + Eigen::RowVector3d(0, 0, 5e-3);
                              })),
      "paint, path");
  EditableRegion locked;
  locked.locked = {structure::kPortalVein};
  row(refused_setting(paint, locked), "paint, label");
  EditableRegion range;
  range.intensity = std::array<double, 2>{5.0, 4.0};
  row(refused_setting(paint, range), "paint, region.intensity");
  EditableRegion inside;
  inside.area = EditableRegion::Area::inside_label;
  inside.label = 300;
  row(refused_setting(paint, inside), "paint, region.label");
  row(refused_setting(Threshold{1, 5.0, 4.0, false}), "threshold, low");
  row(refused_setting(Threshold{0, 4.0, 5.0, false}), "threshold, label");
  Scissors cut;
  cut.view_from_ct << 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1;
  cut.outline = Eigen::Matrix<double, 3, 2, Eigen::RowMajor>::Identity();
  row(refused_setting(cut), "");
  row(refused_setting(changed(cut, [](Scissors& t) { t.outline.conservativeResize(2, 2); })),
      "scissors, outline");
  row(refused_setting(changed(cut, [&](Scissors& t) { t.outline(0, 0) = nan; })), "scissors, outline");
  row(refused_setting(changed(cut, [](Scissors& t) { t.view_from_ct.row(1).setZero(); })),
      "scissors, view_from_ct");
  row(refused_setting(changed(cut,
                              [](Scissors& t) {
                                t.slab = Scissors::Slab{{0, 0, 2}, 0, 1e-3};
                              })),
      "scissors, slab");
  row(refused_setting(changed(cut,
                              [](Scissors& t) {
                                t.slab = Scissors::Slab{{0, 0, 1}, 0, 0.0};
                              })),
      "scissors, slab");
  row(refused_setting(changed(cut,
                              [&](Scissors& t) {
                                t.slab = Scissors::Slab{{0, 0, 1}, nan, 1e-3};
                              })),
      "scissors, slab");
  row(refused_setting(GrowFromSeeds{{1}, 0.01, {}}), "grow_from_seeds, labels");
  row(refused_setting(GrowFromSeeds{{1, 2}, 0.01, {1, 2}}), "grow_from_seeds, labels");
  row(refused_setting(GrowFromSeeds{{1, 0}, 0.01, {}}), "grow_from_seeds, labels");
  row(refused_setting(GrowFromSeeds{{1}, 0.01, {0}}), "grow_from_seeds, rivals");
  row(refused_setting(GrowFromSeeds{{1, 2}, 1.0, {}}), "grow_from_seeds, reach");
  row(refused_setting(GrowFromSeeds{{1, 2}, 0.01, {}}, locked), "grow_from_seeds, labels");
  const Eigen::Vector3d p = middle().row(0).transpose(), away(9.0, 9.0, 9.0);
  row(refused_setting(LevelTracing{1, false, 2, away}), "level_tracing, p_in_ct");
  row(refused_setting(LevelTracing{1, false, -1, p}), "level_tracing, normal_axis");
  row(refused_setting(LevelTracing{0, false, 1, p}), "level_tracing, label");
  row(refused_setting(Islands{1, Islands::Operation::keep_clicked, 1.0, away}), "islands, p_in_ct");
  row(refused_setting(Islands{9, Islands::Operation::remove_clicked, 1.0, p}), "islands, p_in_ct");
  row(refused_setting(Islands{1, Islands::Operation::remove_small, 0.0, p}), "islands, smallest_ml");
  row(refused_setting(FillHoles{0, false}), "fill_holes, label");
  row(refused_setting(Smooth{1, Smooth::Method::median, 0.5}), "smooth, radius");
  row(refused_setting(Smooth{0, Smooth::Method::median, 2e-3}), "smooth, label");
  row(refused_setting(Margin{1, 0.0}), "margin, distance");
  row(refused_setting(Margin{1, -0.5}), "margin, distance");
  row(refused_setting(InterpolateSlices{1, 7}), "interpolate_slices, normal_axis");
  row(refused_setting(Logical{0, Logical::Operation::fill, 0}), "logical, label");
  row(refused_setting(Logical{1, Logical::Operation::add, structure::kPortalVein}, locked), "logical, other");
  row(refused_setting(Logical{1, Logical::Operation::subtract, 300}), "logical, other");
  row(refused_setting(ReassignBranch{2, 2, p}), "reassign_branch, to");
  row(refused_setting(ReassignBranch{2, 3, away}), "reassign_branch, p_in_ct");
  row(refused_setting(ReassignBranch{9, 3, p}), "reassign_branch, p_in_ct");
}

void EditScriptTest::SettingsOutOfRangeAreRefused() {
  QFETCH(QString, is);
  QFETCH(QString, expected);
  QCOMPARE(is, expected);
}

void EditScriptTest::AnotherGridIsRefused() {
  const std::vector<VolumeGrid> grids = awkward_grids();
  const Image image = image_of(grids[0], [](const Eigen::Vector3i&) { return 0.0; });
  const LabelMap labels{LabelVolume(grids[1]), {}};
  QVERIFY_THROWS_EXCEPTION(PreconditionError, apply_edit(labels, image, {FillHoles(), {}}, RunContext()));
}

QTEST_APPLESS_MAIN(EditScriptTest)
#include "edit_script_test.moc"
