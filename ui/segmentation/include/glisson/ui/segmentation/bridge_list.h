// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "glisson/editing/bridges.h"
#include "glisson/ui/common/preview_service.h"
#include "glisson/ui/segmentation/edit_session.h"

class QLabel;
class QListWidget;

namespace glisson::ui {

/// Where the portal and the hepatic tree touch, and where a part hangs on a tree by a neck: a click goes
/// there. Looked for beside the window's thread whenever the labels have changed while the list is in sight.
class BridgeList : public QWidget {
  Q_OBJECT
 public:
  BridgeList(EditSession& session, EngineBridge& engine, ViewState& views, QWidget* parent = nullptr);

  struct Found {
    std::vector<editing::Bridge> bridges;
    std::vector<editing::Joint> joints;
  };

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  void order();
  void accept(const std::shared_ptr<const LabelMap>& of, const Found& found);

  EngineBridge& engine_;
  ViewState& views_;
  QListWidget* list_ = nullptr;
  QLabel* state_ = nullptr;
  std::vector<Point<CtFrame>> places_;
  std::shared_ptr<const LabelMap> wanted_;
  PreviewService<std::shared_ptr<const LabelMap>, Found> looking_;
};

}  // namespace glisson::ui
