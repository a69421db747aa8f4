// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/series_texts.h"

#include <QCoreApplication>
#include <QStringList>
#include <cmath>

namespace glisson::ui {
namespace {

/// Context of these words for translators.
class SeriesTexts {
  Q_DECLARE_TR_FUNCTIONS(SeriesTexts)
 public:
  static QString doubt(SeriesDoubt doubt) {
    switch (doubt) {
      case SeriesDoubt::derived:
        return tr("derived from other images");
      case SeriesDoubt::other_modality:
        return tr("neither CT nor MR");
      case SeriesDoubt::few_slices:
        return tr("few slices");
      case SeriesDoubt::not_axial:
        return tr("not axial");
      case SeriesDoubt::reformatted:
        return tr("reformatted");
      case SeriesDoubt::screenshot:
        return tr("screenshot or sheet");
      case SeriesDoubt::localizer:
        return tr("scout (localizer)");
      case SeriesDoubt::frames:
        return tr("several frames in a file: cannot be read");
      case SeriesDoubt::mask:
        return tr("mask: two grey values only");
      case SeriesDoubt::no_image:
        return tr("no images (report, contours or segmentation)");
    }
    return {};
  }
  static QString phase(SeriesPhase phase) {
    switch (phase) {
      case SeriesPhase::unsaid:
        break;
      case SeriesPhase::native:
        return tr("native");
      case SeriesPhase::arterial:
        return tr("arterial");
      case SeriesPhase::portal_venous:
        return tr("portal venous");
      case SeriesPhase::delayed:
        return tr("delayed");
    }
    return {};
  }
  static QString number(double mm) { return QString::number(mm, 'f', mm >= 10.0 ? 1 : 2); }
  static QString spacing(const DicomSeries& series) {
    const bool thick = series.thickness_mm > 0.0;
    if (series.pixel_mm.minCoeff() <= 0.0)
      return thick ? tr("slices %1 mm thick").arg(number(series.thickness_mm)) : QString();
    QStringList parts = {number(series.pixel_mm.x()), number(series.pixel_mm.y())};
    if (series.gap_mm > 0.0) parts << number(series.gap_mm);
    const QString text = tr("%1 mm").arg(parts.join(QStringLiteral(" × ")));
    if (!thick || std::abs(series.thickness_mm - series.gap_mm) <= 0.05 * series.thickness_mm) return text;
    return tr("%1, slices %2 mm thick").arg(text, number(series.thickness_mm));
  }
  static QString none() { return tr("no description"); }
};

}  // namespace

QString doubt_text(SeriesDoubt doubt) { return SeriesTexts::doubt(doubt); }

QString doubts_text(const DicomSeries& series) {
  QStringList all;
  for (const SeriesDoubt doubt : doubts_about(series)) all << SeriesTexts::doubt(doubt);
  return all.join(QStringLiteral("; "));
}

QString phase_text(SeriesPhase phase) { return SeriesTexts::phase(phase); }
QString spacing_text(const DicomSeries& series) { return SeriesTexts::spacing(series); }

QString description_text(const DicomSeries& series) {
  return series.description.empty() ? SeriesTexts::none() : QString::fromStdString(series.description);
}

}  // namespace glisson::ui
