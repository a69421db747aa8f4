// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/atlas_texts.h"

#include <QCoreApplication>
#include <algorithm>

#include "glisson/engine/landmark_origin.h"
#include "glisson/ui/common/texts.h"

namespace glisson::ui {
namespace {

/// Context of these words for translators.
class AtlasTexts {
  Q_DECLARE_TR_FUNCTIONS(AtlasTexts)
 public:
  static QString structure(atlas::Structure structure) {
    switch (structure) {
      case atlas::Structure::umbilical_notch:
        return tr("Umbilical notch");
      case atlas::Structure::falciform_line:
        return tr("Falciform ligament");
      case atlas::Structure::anterior_margin:
        return tr("Anterior margin");
      case atlas::Structure::vena_cava:
        return tr("Vena cava");
      case atlas::Structure::portal_entrance:
        return tr("Portal vein's entrance");
      case atlas::Structure::gallbladder_bed:
        return tr("Gallbladder's bed");
    }
    return {};
  }
  static QString decision(atlas::Decision decision) {
    switch (decision) {
      case atlas::Decision::proposed:
        return tr("proposed");
      case atlas::Decision::accepted:
        return tr("accepted");
      case atlas::Decision::moved:
        return tr("moved");
      case atlas::Decision::not_visible:
        return tr("not visible");
    }
    return {};
  }
  static QString reason(const atlas::Proposal& proposal) {
    if (share(proposal, atlas::Source::image) == 100) return tr("found in the CT");
    const long by_hand = share(proposal, atlas::Source::person), drawn = share(proposal, atlas::Source::both);
    if (by_hand == 100) return tr("placed by hand");
    QString reason = tr("from %1 livers (%2), %3 mm")
                         .arg(QString::number(proposal.members), QString::fromStdString(proposal.origin),
                              QString::number(1e3 * proposal.deviation(), 'f', 0));
    for (const atlas::Followed& one : proposal.follows) reason = followed_text(proposal, reason, one);
    if (drawn > 0) reason = drawn_text(proposal, reason, drawn);
    if (by_hand > 0)
      reason = tr("%1; placed by hand on %2 % of its course").arg(reason, QString::number(by_hand));
    return reason;
  }

 private:
  /// What some of its points lie where they do for.
  static QString followed_text(const atlas::Proposal& proposal, const QString& reason,
                               const atlas::Followed& one) {
    const bool is_notch = one.on == atlas::Structure::umbilical_notch;
    const QString other = structure(one.on);
    QString text = one.source == atlas::Source::both    ? tr("follows the notch as the portal vein shows it")
                   : one.source == atlas::Source::image ? tr("follows what the CT shows (%1)").arg(other)
                   : is_notch                           ? tr("follows the notch that you placed")
                                                        : tr("follows what you placed (%1)").arg(other);
    const long percent = 100L * one.points / std::max(1L, static_cast<long>(proposal.points.rows()));
    if (percent < 100) text = tr("%1 on %2 % of its course").arg(text, QString::number(percent));
    return QStringLiteral("%1; %2").arg(reason, text);
  }
  /// What the CT shows beside the statistics. @param drawn % of the points
  static QString drawn_text(const atlas::Proposal& proposal, const QString& reason, long drawn) {
    if (proposal.structure == atlas::Structure::umbilical_notch)
      return tr("%1; drawn to where the portal vein's umbilical part shows it").arg(reason);
    const QString text =
        proposal.structure == atlas::Structure::falciform_line
            ? tr("%1; drawn to the plane of the portal vein's umbilical part on %2 % of its course")
            : tr("%1; drawn to the ridge found in the CT on %2 % of its course");
    return text.arg(reason, QString::number(drawn));
  }
  static long share(const atlas::Proposal& proposal, atlas::Source source) {
    const auto count = std::count(proposal.sources.begin(), proposal.sources.end(), source);
    return 100L * static_cast<long>(count) / std::max(1L, static_cast<long>(proposal.sources.size()));
  }
};

}  // namespace

QString landmark_text(const QString& code) {
  const auto structure = atlas::structure_of(code.toStdString());
  return structure ? landmark_text(*structure) : QString();
}
QString landmark_text(atlas::Structure structure) { return AtlasTexts::structure(structure); }
QString reason_text(const atlas::Proposal& proposal) { return AtlasTexts::reason(proposal); }
QString reasons_text(const engine::CaseState& state, const atlas::Proposal& proposal) {
  const QString reason = reason_text(proposal);
  if (!engine::mark_stands(state, proposal.structure)) return reason;
  const QString mark =
      note_text(std::string("landmarks.mark_stays ") + atlas::structure_code(proposal.structure));
  return QStringLiteral("%1\n%2").arg(reason, mark);
}
QString decision_text(atlas::Decision decision) { return AtlasTexts::decision(decision); }

}  // namespace glisson::ui
