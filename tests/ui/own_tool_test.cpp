// SPDX-License-Identifier: GPL-3.0-or-later
// A tool that only this file knows is offered, set, applied, named and undone in the window: what the window
// asks of a tool is its two descriptions and nothing else.
#include <QDoubleSpinBox>
#include <QToolButton>

#include "describe.h"
#include "glisson/editing/history.h"
#include "glisson/editing/tools/smooth.h"
#include "glisson/engine/commands/import_image.h"
#include "glisson/ui/segmentation/edit_box.h"
#include "glisson/ui/segmentation/edit_texts.h"
#include "segmentation_window.h"

namespace glisson {
namespace {

using editing::Canvas;
using editing::Smooth;
using ui::EditSettings;
using ui::EditTools;

/// Everything within a distance of the origin becomes the label.
struct Bead {
  static const editing::ToolKind& kind();
  Label label = structure::kParenchyma;
  double radius = 4e-3;
  bool operator==(const Bead&) const = default;
};

Cancellable<Canvas> put_bead(const Bead& bead, editing::Task& task) {
  const VolumeGrid& grid = task.grid();
  const VoxelBox box = editing::whole_box(grid);
  Canvas canvas = task.canvas(box);
  const bool done = canvas.rewrite(box, task.context, [&](int i, int j, int k, Label old) {
    const Eigen::Vector3d index(i, j, k);
    return grid.p_in_ct(index).xyz.norm() < bead.radius ? bead.label : old;
  });
  if (!done) return std::nullopt;
  return canvas;
}

const editing::ToolKind& Bead::kind() {
  static const editing::Described<Bead> kKind(
      {"bead",
       1000,
       {editing::label_field("label", &Bead::label), editing::length_field("radius_mm", &Bead::radius, 8e-3)},
       {"bead"},
       [](const Bead& t) {
         return editing::StepName{"bead", t.label, t.radius};
       },
       put_bead});
  return kKind;
}

const ui::WindowTool& bead_window_tool() {
  static const ui::WindowTool kTool = [] {
    ui::WindowTool tool{"bead",
                        1000,
                        'Z',
                        "String a bead",
                        {{"bead", "Bead"}},
                        [](const EditSettings&) { return "A ball about the origin."; },
                        "a ball about the origin"};
    tool.page = {ui::number_box("bead_radius", "Radius", {0.5, 8.0, 0.5, 1, "mm"}, &Bead::radius, 1e3)};
    tool.whole = [](const EditSettings& s, const ui::WholeVolume&) {
      auto bead = s.of<Bead>();
      bead.label = s.label;
      return bead;
    };
    return tool;
  }();
  return kTool;
}

EditTools with_bead() {
  EditTools tools = ui::edit_tools();
  tools.push_back(&bead_window_tool());
  return tools;
}

}  // namespace

class OwnToolTest : public QObject, private SegmentationWindow {
  Q_OBJECT
 private slots:
  void init();
  void cleanup();
  void SettingsOfAToolAreAValue();
  void ToolsAreListedByTheirPlaces();
  void PageShowsAndSetsTheToolsOwnSettings();
  void EditIsAppliedNamedAndUndone();
  void TableHasItsRow();

 private:
  void post(engine::Command command) {
    engine_->post(std::move(command));
    QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 60000));
  }
  template <class Widget>
  Widget* of_box(const char* name) {
    return box_->findChild<Widget*>(QString::fromLatin1(name));
  }

  std::unique_ptr<ui::EngineBridge> engine_;
  std::unique_ptr<ui::ViewState> views_;
  std::unique_ptr<ui::EditSession> session_;
  std::unique_ptr<QWidget> page_;
  std::unique_ptr<ui::EditBox> box_;
};

void OwnToolTest::init() {
  engine_ = std::make_unique<ui::EngineBridge>();
  views_ = std::make_unique<ui::ViewState>();
  session_ = std::make_unique<ui::EditSession>(*engine_, *views_);
  page_ = std::make_unique<QWidget>();
  box_ = std::make_unique<ui::EditBox>(*session_, *page_, nullptr, with_bead());
  box_->show();
  session_->set_active(true);
}

void OwnToolTest::cleanup() {
  box_.reset();
  page_.reset();
  session_.reset();
  views_.reset();
  engine_.reset();
  folder_.reset();
}

void OwnToolTest::SettingsOfAToolAreAValue() {
  EditSettings settings;
  QCOMPARE(std::as_const(settings).of<Bead>().radius, 4e-3);
  QVERIFY(settings == EditSettings());
  (void)settings.of<Bead>();
  QVERIFY(settings == EditSettings() && EditSettings() == settings);  // asked for, not changed
  EditSettings copy = settings;
  copy.of<Bead>().radius = 5e-3;
  QCOMPARE(std::as_const(settings).of<Bead>().radius, 4e-3);
  QVERIFY(copy != settings && settings != copy && copy != EditSettings() && EditSettings() != copy);
  settings.of<Bead>().radius = 5e-3;
  QVERIFY(copy == settings);
  settings.of<Smooth>().radius = 1e-3;
  QVERIFY(copy != settings && settings != copy);
  QCOMPARE(std::as_const(copy).of<Smooth>().radius, Smooth().radius);
}

void OwnToolTest::ToolsAreListedByTheirPlaces() {
  std::string codes;
  for (const ui::EditTool tool : ui::edit_tools()) codes += tool->code + ' ';
  QCOMPARE(codes, std::string("paint erase scissors threshold grow level_tracing islands fill_holes smooth "
                              "margin interpolate logical move_branch vessel_path "));
}

void OwnToolTest::PageShowsAndSetsTheToolsOwnSettings() {
  auto* button = of_box<QToolButton>("tool_bead");
  auto* radius = of_box<QDoubleSpinBox>("bead_radius");
  QVERIFY(button != nullptr && radius != nullptr && !radius->isVisible());
  QTest::mouseClick(button, Qt::LeftButton);
  QCOMPARE(session_->tool(), &bead_window_tool());
  QVERIFY(button->isChecked() && radius->isVisible());
  QCOMPARE(radius->value(), 4.0);
  radius->setValue(6.0);
  QCOMPARE(session_->settings().of<Bead>().radius, 6e-3);
  session_->set_tool(ui::edit_tool("smooth"));
  QVERIFY(!radius->isVisible());
  of_box<QDoubleSpinBox>("smooth_radius")->setValue(2.0);
  QCOMPARE(session_->settings().of<Smooth>().radius, 2e-3);
  QCOMPARE(session_->settings().of<Bead>().radius, 6e-3);
  session_->set_tool(&bead_window_tool());
  QCOMPARE(radius->value(), 6.0);
}

void OwnToolTest::EditIsAppliedNamedAndUndone() {
  make_ct();
  post(engine::ImportImage{folder_->path() / "ct.nrrd"});
  session_->set_tool(&bead_window_tool());
  EditSettings settings = session_->settings();
  settings.label = structure::kVenaCava;
  settings.of<Bead>().radius = 5e-3;
  session_->set_settings(settings);
  session_->apply();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 60000));
  const auto count = [this] {
    const auto& labels = engine_->state()[part::labels];
    return labels ? labels->voxels.histogram().at(structure::kVenaCava) : 0L;
  };
  // Centres of 2 mm voxels at odd millimetres from the origin: (+-1, +-1, +-1) and those with one or two 3s.
  QCOMPARE(count(), 8L + 24L + 24L);
  auto* undo = of_box<QToolButton>("undo");
  QCOMPARE(undo->text(), QStringLiteral("Undo: Bead, 5 mm, Vena cava"));
  undo->click();
  QVERIFY(QTest::qWaitFor([this] { return engine_->tasks().empty(); }, 60000));
  QVERIFY(!engine_->state()[part::labels] || engine_->state()[part::labels]->voxels.histogram().size() <= 1 ||
          count() == 0L);
}

void OwnToolTest::TableHasItsRow() {
  QVERIFY(ui::tool_table(with_bead()).ends_with("| String a bead | Z | a ball about the origin |\n"));
  QVERIFY(ui::tool_table().find("bead") == std::string::npos);
}

}  // namespace glisson

int main(int argc, char** argv) { return glisson::run_in_window<glisson::OwnToolTest>(argc, argv); }
#include "own_tool_test.moc"
