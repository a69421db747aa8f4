// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProperty>
#include <QTimer>
#include <memory>
#include <optional>
#include <utility>

#include "glisson/openigtlink/sender.h"
#include "glisson/ui/common/drawable_source.h"

namespace glisson::ui {

/// Tells other programs of what is followed live, while a person has switched it on. No case and no setting
/// does that.
class OpenIgtLinkModel : public QObject {
  Q_OBJECT
 public:
  /// Both outlive this.
  OpenIgtLinkModel(EngineBridge& engine, DrawableSource& drawables, QObject* parent = nullptr);
  ~OpenIgtLinkModel() override;

  /// @param address "ADDRESS:PORT"; `said` tells why where it cannot be listened at.
  void switch_on(const QString& address);
  /// What was told is withdrawn from the others' screens. Takes a tenth of a second at most.
  void switch_off();

  // For widgets to read.
  QProperty<bool> is_on{false};
  QProperty<QString> address{QStringLiteral("127.0.0.1:18944")};  ///< where it listens, or listened last
  QProperty<QString> said;                                        ///< how it stands; empty while it is off
  QProperty<QString> tone;  ///< of what is said, as the style sheet names it: good, warning, error

 private:
  void read_drawable();
  void read_live();
  void tell_state();
  void say(const QString& text, const QString& how);

  EngineBridge& engine_;
  DrawableSource& drawables_;
  std::unique_ptr<openigtlink::Sender> sender_;
  std::shared_ptr<const openigtlink::SentModel> sent_;
  bool is_withdrawn_ = true;
  /// Index and time of the frame that was there when it was switched on, until another comes: nobody knows
  /// how old it is.
  std::optional<std::pair<int, double>> old_;
  QTimer state_;
};

}  // namespace glisson::ui
