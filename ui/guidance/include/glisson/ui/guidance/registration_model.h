// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProperty>
#include <QStringList>
#include <memory>
#include <vector>

#include "glisson/patient/registration.h"
#include "glisson/registration/register_model.h"
#include "glisson/ui/common/couplings.h"
#include "glisson/ui/common/engine_bridge.h"
#include "glisson/ui/common/figures_table.h"

namespace glisson::ui {

/// A place in the organ whose error the registration expects.
struct SpotRow {
  Label lesion = 0;          ///< 0: a vessel fork
  QString name, kind;        ///< kind: which of the structure's forks; empty of a lesion
  QString expected, within;  ///< mean error; reach of the region that holds it in 95 of 100 cases
  bool operator==(const SpotRow&) const = default;
};
using SpotRows = std::vector<SpotRow>;

/// What there is to say of the case's registration, and what it still needs. Widgets read the properties.
class RegistrationModel : public QObject {
  Q_OBJECT
 public:
  explicit RegistrationModel(EngineBridge& engine, QObject* parent = nullptr);

  QProperty<bool> is_unchecked;   ///< nobody has said that the model is right
  QProperty<FigureRows> figures;  ///< of the registration; none: there is no registration
  QProperty<QString> doubts;      ///< a line each
  QProperty<QString> notes;       ///< what else was noted when it was made, a line each
  QProperty<bool> is_refused;     ///< and nobody has accepted it
  QProperty<bool> holds{false};   ///< it is there, up to date and not refused: so is what it says of errors
  QProperty<bool> is_being_made{false};  ///< another one: what is decided now would be decided about that
  QProperty<QString>
      error_words;  ///< whether it holds, and what is expected of its error; empty: there is none
  QProperty<QStringList> rivals;       ///< other places where the organ may be, a line each
  QProperty<QStringList> rival_words;  ///< the same, a few words each, for below a picture
  /// Lesions, then vessel forks: how far off each may be. None of a registration that is refused or out of
  /// date.
  QProperty<SpotRows> spots;
  QProperty<bool> has_former{false};  ///< there is a registration before this one
  QProperty<bool> can_undo{false};    ///< it can be had back now
  /// How the shape is found when somebody registers.
  QProperty<registration::Method> method{registration::Method::automatic};
  QProperty<int> shown_rival{-1};     ///< the one that is compared with the registration; -1: none
  QProperty<QStringList> looked_for;  ///< lesions that one more look may tell of, by name
  QProperty<int> shown_look{-1};      ///< of Registration::looks, the one that the colours show; -1: none

  /// The former registration changes places with the present one.
  void undo();
  /// Why nothing is decided about the registration while another one is being made.
  static QString wait_words();
  /// The nodes of the one that is compared, camera's frame; null: none.
  const Points* rival_nodes() const;

 private:
  static QString termination_words(const Registration& registration);
  void read_case();
  void read_tasks();
  void read_rivals(const Registration& registration);
  void read_spots(const Registration& registration);
  void read_error(const Registration& registration);
  void read_looks(const Registration& registration);
  /// Where one more look helps most, of the shown lesion, else of the one that it helps most.
  QString look_words() const;

  EngineBridge& engine_;
  std::shared_ptr<const Registration> source_;
  QStringList look_words_;  ///< one a lesion of `looked_for`
  int helped_most_ = -1;    ///< of these; -1: none much
  Couplings couplings_;
};

}  // namespace glisson::ui
