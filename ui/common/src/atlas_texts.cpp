// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/atlas_texts.h"

#include <QCoreApplication>
#include <algorithm>

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
    const QString statistics = tr("from %1 livers (%2), %3 mm")
                                   .arg(proposal.members)
                                   .arg(QString::fromStdString(proposal.origin))
                                   .arg(1e3 * proposal.deviation(), 0, 'f', 0);
    switch (proposal.source()) {
      case atlas::Source::image:
        return tr("found in the CT");
      case atlas::Source::person:
        return tr("placed by hand");
      case atlas::Source::both:
        return tr("%1; drawn to the ridge found in the CT on %2 % of its course")
            .arg(statistics)
            .arg(share(proposal, atlas::Source::both));
      case atlas::Source::statistics:
        break;
    }
    return statistics;
  }

 private:
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
QString decision_text(atlas::Decision decision) { return AtlasTexts::decision(decision); }

}  // namespace glisson::ui
