// SPDX-License-Identifier: GPL-3.0-or-later
#include "sitting.h"

#include <QAbstractButton>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <stdexcept>

#include "glisson/engine/parts/image.h"
#include "glisson/engine/parts/labels.h"
#include "glisson/engine/parts/review.h"
#include "glisson/engine/parts/seeds.h"
#include "glisson/insilico/layperson.h"
#include "glisson/segmentation/evaluate.h"
#include "glisson/ui/common/task_button.h"
#include "glisson/ui/segmentation/label_table.h"
#include "glisson/volume/io.h"
#include "human_times.h"

namespace glisson::stopwatch {
namespace {

constexpr double kLeastLesion = 1.0;  // ml: a smaller one is not clicked, as in `glisson prove patient`
constexpr const char* kCase = "patient.glisson";

class Person {
 public:
  Person(const SittingOptions& options, ui::MainWindow& window)
      : options_(options), window_(window), hand_(window, sitting_.ledger) {
    hand_.album = options.out;
  }

  void open_ct() {
    sitting_.ledger.begin("open the CT");
    hand_.read_what_is_new();
    QPushButton* open = nullptr;
    for (QPushButton* button : window_.findChildren<QPushButton*>())
      if (button->isVisible() && button->text().startsWith(QStringLiteral("DICOM folder"))) open = button;
    if (open == nullptr) throw std::runtime_error("nothing offers to open a folder");
    hand_.will_answer_with(options_.ct, HumanTimes::kFindFolder);
    hand_.press(*open);
    hand_.settle();
    if (!image()) throw std::runtime_error("no CT was opened: " + window_.status_text().toStdString());
    hand_.read_what_is_new();
    photograph("1_opened");
    if (options_.truth.empty()) return;
    truth_ = recode(read_labels(options_.truth), read_label_codes(options_.codes), options_.truth.string());
    require_same_grid(truth_->voxels.grid(), image()->grid, "the expert's labels, and the CT");
    insilico::split_lesions(*truth_, kLeastLesion);
  }

  void click_seeds() {
    sitting_.ledger.begin(options_.proposes ? "have seeds proposed" : "click seeds");
    if (options_.proposes) {
      hand_.press(*task("propose_seeds").button());
      hand_.settle();
      look_at_seeds();
    } else {
      insilico::LaypersonOptions eye;
      eye.seed = options_.seed;
      if (options_.lesions) eye.least_lesion_ml = kLeastLesion;
      const segmentation::Seeds meant = insilico::click_as_layperson(*image(), *truth_, eye);
      place("seed_parenchyma", meant.liver);
      place("seed_background", meant.background);
      for (std::size_t n = 0; n < meant.lesions.size(); ++n)
        place(("seed_" + structure_name(static_cast<Label>(structure::kFirstLesion + n))).c_str(),
              meant.lesions[n]);
    }
    photograph("2_seeds");
  }

  void segment() {
    sitting_.ledger.begin("segment");
    bool is_photographed = false;
    hand_.press(*task("segment").button());
    hand_.settle([&] {
      if (is_photographed || !window_.views().state().evolving()) return;
      is_photographed = true;
      photograph("3_segmenting");
    });
    if (!labels()) throw std::runtime_error("nothing was segmented");
    hand_.read_what_is_new();
    keep();
    photograph("4_segmented");
  }

  void look() {
    sitting_.ledger.begin("look through the slices");
    const VolumeGrid& grid = labels()->voxels.grid();
    double low = 1e9, high = -1e9;  // metres
    const std::vector<std::uint8_t> liver = inside_liver(*labels());
    const auto in_slice = static_cast<std::size_t>(grid.size.x()) * static_cast<std::size_t>(grid.size.y());
    for (std::size_t at = 0; at < liver.size(); at += 1)
      if (liver[at] != 0) {
        const int k = static_cast<int>(at / in_slice);
        const double height = grid.p_in_ct({0.0, 0.0, double(k)}).xyz.z();
        low = std::min(low, height);
        high = std::max(high, height);
        at = (at / in_slice + 1) * in_slice - 1;
      }
    hand_.look_through(axial(), high, low);
    hand_.settle();
  }

  void correct() {
    if (!truth_) return;
    for (int n = 1; n <= options_.corrections; ++n) {
      const auto click = insilico::correct_as_layperson(*truth_, *labels(), static_cast<std::uint64_t>(n));
      if (!click) return;
      sitting_.ledger.begin("correction " + std::to_string(n));
      choose(click->is_liver ? "seed_parenchyma" : "seed_background");
      place_one(click->p_in_ct);
      hand_.read_what_is_new();
      hand_.think(HumanTimes::kLookAtCorrection);
      keep();
    }
    photograph("5_corrected");
  }

  void approve() {
    sitting_.ledger.begin("approve each label");
    auto* table = window_.findChild<ui::LabelTable*>();
    const std::vector<long> counts = labels()->voxels.histogram();
    for (std::size_t code = 1; code < counts.size(); ++code) {
      const auto label = static_cast<Label>(code);
      if (counts[code] == 0) continue;
      QTreeWidgetItem* row = table->row_of(label);
      if (row == nullptr) throw std::runtime_error(structure_name(label) + " has no row");
      if (table->currentItem() != row) {
        table->scrollToItem(row);
        QRect cell = table->visualItemRect(row);
        cell.setRight(cell.left() + table->columnWidth(ui::LabelTable::name));
        hand_.click(*table->viewport(), cell.center());
      }
      hand_.read_what_is_new();
      const auto* approve = window_.findChild<QPushButton*>(QStringLiteral("approve_label"));
      // The button waits for the eye; to read is longer than that.
      (void)QTest::qWaitFor([&] { return approve->isEnabled(); });
      hand_.press("approve_label");
      hand_.settle();
      const auto& review = window_.engine().state()[part::review];
      if (!review || review->count(label) == 0 || review->at(label) != ReviewState::approved)
        throw std::runtime_error(structure_name(label) + " was not approved");
    }
    photograph("6_approved");
  }

  void save() {
    sitting_.ledger.begin("save");
    sitting_.saved = options_.out / kCase;
    hand_.will_answer_with(sitting_.saved, HumanTimes::kFindFolder);
    hand_.shortcut(Qt::Key_S, Qt::ControlModifier);
    hand_.settle();
    if (window_.isWindowModified() || !std::filesystem::exists(sitting_.saved))
      throw std::runtime_error("the case was not saved: " + window_.status_text().toStdString());
    photograph("7_saved");
  }

  Sitting take() { return std::move(sitting_); }

 private:
  const std::shared_ptr<const Image>& image() const { return window_.engine().state()[part::image]; }
  const std::shared_ptr<const LabelMap>& labels() const { return window_.engine().state()[part::labels]; }
  ui::SliceView& axial() { return window_.views().slice(scene::Plane::axial); }
  ui::TaskButton& task(const char* name) {
    auto* found = window_.findChild<ui::TaskButton*>(QLatin1String(name));
    if (found == nullptr) throw std::runtime_error(std::string("there is no ") + name);
    return *found;
  }
  void photograph(const std::string& name) { hand_.photograph(options_.out / (name + ".png")); }

  void choose(const char* button) {
    if (!window_.findChild<QAbstractButton*>(QLatin1String(button))->isChecked()) hand_.press(button);
  }
  void place(const char* button, const Points& points) {
    if (points.rows() == 0) return;
    choose(button);
    for (Eigen::Index n = 0; n < points.rows(); ++n)
      place_one(Point<CtFrame>(Eigen::Vector3d(points.row(n).transpose())));
  }
  void place_one(const Point<CtFrame>& p) {
    const Points before = all_seeds();
    hand_.click(axial(), p);
    hand_.settle();
    const Points after = all_seeds();
    if (after.rows() != before.rows() + 1) throw std::runtime_error("a click placed no seed");
    double nearest = 1e9;
    for (Eigen::Index n = 0; n < after.rows(); ++n)
      nearest = std::min(nearest, 1e3 * (after.row(n).transpose() - p.xyz).norm());
    sitting_.placed_off_mm = std::max(sitting_.placed_off_mm, nearest);
  }
  segmentation::Seeds seeds() const {
    const auto& there = window_.engine().state()[part::seeds];
    return there ? *there : segmentation::Seeds{};
  }
  Points all_seeds() const {
    const segmentation::Seeds now = seeds();
    std::vector<Points> parts = now.lesions;
    parts.push_back(now.liver);
    parts.push_back(now.background);
    Eigen::Index rows = 0;
    for (const Points& one : parts) rows += one.rows();
    Points all(rows, 3);
    rows = 0;
    for (const Points& one : parts) {
      all.middleRows(rows, one.rows()) = one;
      rows += one.rows();
    }
    return all;
  }
  /// Where the proposed seeds lie: each is gone to.
  void look_at_seeds() {
    const Points liver = seeds().liver;
    if (liver.rows() == 0) throw std::runtime_error("nothing was proposed");
    for (Eigen::Index n = 0; n < liver.rows(); ++n)
      hand_.find_slice(axial(), Point<CtFrame>(Eigen::Vector3d(liver.row(n).transpose())));
    hand_.read_what_is_new();
  }
  void keep() {
    sitting_.seeds.push_back(seeds());
    sitting_.labels.push_back(labels()->voxels);
    if (truth_) sitting_.dice.push_back(segmentation::compare_labels(*labels(), *truth_).at("dice_liver"));
  }

  const SittingOptions& options_;
  ui::MainWindow& window_;
  Sitting sitting_;
  Hand hand_;
  std::optional<LabelMap> truth_;
};

}  // namespace

Sitting sit(const SittingOptions& options, ui::MainWindow& window) {
  Person person(options, window);
  person.open_ct();
  person.click_seeds();
  person.segment();
  person.look();
  person.correct();
  if (!options.truth.empty() && options.corrections > 0) person.look();
  person.approve();
  person.save();
  return person.take();
}

}  // namespace glisson::stopwatch
