// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/segmentation/branch_preview.h"

#include "glisson/core/error.h"

namespace glisson::ui {
namespace {

/// Whether what is shown may stay in sight until it is known what that click would do. One that makes a
/// vessel is drawn again as the pointer moves; one that moves a branch must move the voxel that the click is
/// on: along a branch little changes.
bool stands_for(const BranchPreview::Shown& shown, const LabelMap& labels, const editing::Tool& tool) {
  if (!shown.problem.empty() || &shown.edit.tool.kind() != &tool.kind()) return false;
  if (tool.get_if<editing::ReassignBranch>() == nullptr) return true;
  const auto &moves = shown.edit.tool.as<editing::ReassignBranch>(),
             &click = tool.as<editing::ReassignBranch>();
  if (moves.label != click.label || moves.to != click.to) return false;
  const VolumeGrid& grid = labels.voxels.grid();
  const Eigen::Vector3i v = grid.index_of(Point<CtFrame>(click.p_in_ct)).array().round().matrix().cast<int>();
  return grid.contains(v) && shown.result.labels.voxels.at(v) != labels.voxels.at(v);
}

}  // namespace

Cancellable<BranchPreview::Shown> BranchPreview::compute(const Order& order, const RunContext& context) {
  Shown shown{order.edit, {}, {}};
  try {
    auto edited = editing::apply_edit(*order.labels, *order.image, order.edit, context);
    if (!edited) return std::nullopt;
    shown.result = std::move(*edited);
  } catch (const Error& error) {
    shown.problem = error.what();
  }
  return shown;
}

BranchPreview::BranchPreview(ViewState& views, EditAt edit_at, QObject* parent)
    : QObject(parent),
      views_(views),
      edit_at_(std::move(edit_at)),
      computing_(this, compute, [this](const Order& order, const std::shared_ptr<const Shown>& result) {
        // The labels may be others by now; and the pointer may have left the branches.
        if (wanted_ && order.labels == labels_) show(result);
      }) {
  for (const auto signal : {&ViewState::pointer_changed, &ViewState::crosshair_changed})
    connect(&views_, signal, this, &BranchPreview::follow);
}

void BranchPreview::set_case(std::shared_ptr<const Image> image, std::shared_ptr<const LabelMap> labels) {
  const bool same = labels == labels_ && image == image_;
  image_ = std::move(image);
  labels_ = std::move(labels);
  if (same) return follow();  // settings may have changed what a click does
  wanted_.reset();
  computing_.cancel();
  show(nullptr);
}

void BranchPreview::follow() {
  const auto& pointer = views_.pointer();
  const auto edit = image_ && labels_ && pointer ? edit_at_(*pointer) : std::nullopt;
  if (edit == wanted_) return;
  wanted_ = edit;
  if (wanted_)
    computing_.give({image_, labels_, *wanted_});
  else
    computing_.cancel();
  // Until a click there is known, the one that is shown stands for it only where it moves the same branch.
  if (shown_ && !(wanted_ && stands_for(*shown_, *labels_, wanted_->tool))) show(nullptr);
}

void BranchPreview::show(std::shared_ptr<const Shown> shown) {
  if (shown == shown_) return;
  shown_ = std::move(shown);
  emit changed();
}

}  // namespace glisson::ui
