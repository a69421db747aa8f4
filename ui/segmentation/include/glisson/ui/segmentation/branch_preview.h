// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "glisson/editing/edit.h"
#include "glisson/ui/common/preview_service.h"
#include "glisson/ui/common/view_state.h"
#include "glisson/ui/segmentation/window_tool.h"

namespace glisson::ui {

/// What a click of the tools that move or make branches would do where the pointer is, computed before it
/// happens, beside the window's thread.
class BranchPreview : public QObject {
  Q_OBJECT
 public:
  /// The edit that a click there would be; empty: a click there does nothing.
  using EditAt = std::function<std::optional<editing::Edit>(const PointerPlace& place)>;
  struct Shown {
    editing::Edit edit;
    editing::Edited result;  ///< empty labels where there is a problem
    std::string problem;     ///< why the click could do nothing
  };

  /// @param edit_at is asked in the window's thread, while there are an image and labels.
  BranchPreview(ViewState& views, EditAt edit_at, QObject* parent = nullptr);

  /// Whose branches; null: nothing is shown. Other labels put away what is shown until the pointer moves.
  void set_case(std::shared_ptr<const Image> image, std::shared_ptr<const LabelMap> labels);
  /// Of the tool that clicks; another one's puts away what is shown.
  void set_tool(EditTool tool);
  /// Null: the pointer is over no branch, or it is not known yet what would move.
  const std::shared_ptr<const Shown>& shown() const { return shown_; }

 signals:
  void changed();

 private:
  struct Order {
    std::shared_ptr<const Image> image;
    std::shared_ptr<const LabelMap> labels;
    editing::Edit edit;
  };
  /// On the thread.
  static Cancellable<Shown> compute(const Order& order, const RunContext& context);
  void follow();
  bool shown_may_stay() const;  ///< until it is known what is wanted
  void show(std::shared_ptr<const Shown> shown);

  ViewState& views_;
  EditAt edit_at_;
  EditTool tool_ = nullptr;
  std::shared_ptr<const Image> image_;
  std::shared_ptr<const LabelMap> labels_;
  std::optional<editing::Edit> wanted_;
  std::shared_ptr<const Shown> shown_;
  PreviewService<Order, Shown> computing_;
};

}  // namespace glisson::ui
