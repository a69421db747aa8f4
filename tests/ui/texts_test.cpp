// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/texts.h"
#include "glisson/core/note_value.h"
#include "glisson/engine/obstacle.h"
#include "glisson/registration/next_look.h"
#include "glisson/stereo/faults.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTest>
#include <QXmlStreamReader>

namespace glisson {

class TextsTest : public QObject {
  Q_OBJECT
 private slots:
  void NotesAreSentencesWithTheirValues();
  void NumbersAreWrittenForPeople();
  void StructuresInNotesHaveTheirNames();
  void UnknownNotesStayReadable();
  void EveryFaultOfPicturesIsASentence();
  void EveryStageOfTheModulesHasAWord();
  void EveryCommandHasItsWords();
  void EveryPartHasItsWords();
  void TranslationsKeepThePlaceholders_data();
  void TranslationsKeepThePlaceholders();
};

void TextsTest::NotesAreSentencesWithTheirValues() {
  QCOMPARE(
      ui::note_text("vessels.pieces_dropped hepatic_veins 14 ml 0.423"),
      QStringLiteral("Hepatic veins: loose specks left out of the vessel model: 14 (0.42 ml). In 3D they are "
                     "drawn, over the picture with thin branches only."));
  QCOMPARE(ui::note_text("liver.pieces_dropped 1 ml 0.0135"),
           QStringLiteral("Separate specks of liver were left out: 1 (0.01 ml)."));
  QVERIFY(!ui::note_text("no_notch").contains(QLatin1Char('_')));
  QVERIFY(ui::note_text("seed.liver_apart 4").startsWith(QLatin1String("Liver seed 4 had no effect: ")));
  QVERIFY(ui::note_text("seed.not_liver_taken 2 lesion_1").contains(QLatin1String("seed 2 had no effect: ")));
  for (const char* code :
       {"seed.liver_apart 4", "seed.liver_taken 4 vena_cava", "seed.not_liver_taken 2 lesion_1"})
    QVERIFY(!ui::note_text(code).contains(QLatin1Char('%')));
  // Names come whole, whatever they hold.
  QCOMPARE(ui::note_text("surfaces.of_one_name " + note_value("liver 50%: old.stl") + " liver.ply"),
           QStringLiteral("The file liver 50%: old.stl was not used: liver.ply shows the same structure."));
  QCOMPARE(ui::notes_text({"liver.small", "liver.large"}).count(QLatin1Char('\n')), 1);
}

void TextsTest::NumbersAreWrittenForPeople() {
  QVERIFY(ui::note_text("vessels.branches_pruned 227 mm 4.15e+03").contains(QStringLiteral("4150 mm")));
  QVERIFY(ui::note_text("mesh.sliver_deg 8.250000").contains(QStringLiteral("8.25\u00b0")));
  QCOMPARE(ui::note_text("lesion_2.error_large 9.46 8"),
           QStringLiteral("Lesion 2 is expected to be off by 9.5 mm on average (limit 8 mm)."));
}

void TextsTest::StructuresInNotesHaveTheirNames() {
  // An error's sentence within a note stays as it is.
  QVERIFY(ui::note_text("case.points_lost a/points.json: report: is missing. Try 0.50.")
              .endsWith(QStringLiteral("(a/points.json: report: is missing. Try 0.50.)")));
  QCOMPARE(
      ui::note_text("lesion_2.not_found"),
      QStringLiteral(
          "Lesion 2 was not found: nothing at its seeds differs from the liver. What there was of it stays. "
          "Drag across it in a slice to tell its diameter, or paint it."));
  QCOMPARE(
      ui::note_text("lesion_2.as_drawn"),
      QString("Lesion 2: no border was found where its diameter was drawn. It is a ball of that diameter: "
              "check it in the slices."));
  QCOMPARE(
      ui::note_text("lesion_2.click_without_effect 3"),
      QString("Lesion 2: of its seeds, 3 had no effect. Nothing there differs from the liver, and what the "
              "others found does not reach there. Paint what is missing."));
  QCOMPARE(
      ui::note_text("lesion_2.under_surface 4"),
      QString("Lesion 2 comes within 4 mm of the liver's surface, where the CT does not show its border: "
              "whether liver covers it is not known. Check it in the slices."));
  QCOMPARE(
      ui::note_text("lesion_6.bright"),
      QString("Lesion 6 is brighter than the liver: a vein, or a lesion that takes up contrast. Check it in "
              "the slices."));
  QCOMPARE(
      ui::note_text("lesion_6.perhaps_vein 47"),
      QString("Lesion 6 is brighter than the liver, and a vein goes on at 47 % of its surface: it may be a "
              "piece of that vein. Check it in the slices."));
  QCOMPARE(
      ui::note_text("look.surface lesion_2 left_underside 6.2 3.1"),
      QString("Lesion 2: one more look helps most at the left lobe's underside. Expected error then 3.1 mm "
              "instead of 6.2 mm."));
  for (const std::string& place : registration::places_on_liver())
    QVERIFY2(!ui::note_text("look.surface lesion_1 " + place + " 6.2 3.1").contains(QLatin1Char('_')),
             place.c_str());
  QVERIFY(ui::note_text("lesion.dropped lesion_3 mm3 12.5").startsWith(QStringLiteral("Lesion 3")));
  QVERIFY(ui::note_text("lesion.dropped lesion_3 mm3 12.5").contains(QStringLiteral("12.5 mm")));
}

void TextsTest::UnknownNotesStayReadable() {
  QCOMPARE(ui::note_text("mesh.odd_thing portal_vein 0.5"),
           QStringLiteral("Mesh: odd thing Portal vein 0.50"));
}

void TextsTest::EveryFaultOfPicturesIsASentence() {
  constexpr int kLast = static_cast<int>(stereo::Fault::interlaced);
  for (int fault = 0; fault <= kLast; ++fault) {
    const std::string note = stereo::fault_note(static_cast<stereo::Fault>(fault));
    QVERIFY2(ui::note_text(note) != ui::readable_code(note), note.c_str());
    QVERIFY2(ui::note_text(note).endsWith(QLatin1Char('.')), note.c_str());
  }
}

void TextsTest::EveryStageOfTheModulesHasAWord() {
  static const QRegularExpression kCode(QStringLiteral("progress\\([^;]*\"([a-z_]+(\\.[a-z_]+)+)\""));
  int found = 0;
  QDirIterator files(qEnvironmentVariable("GLISSON_SOURCE_DIR") + QStringLiteral("/modules"),
                     {QStringLiteral("*.cpp")}, QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    QFile file(files.next());
    QVERIFY(file.open(QIODevice::ReadOnly));
    for (auto codes = kCode.globalMatch(QString::fromUtf8(file.readAll())); codes.hasNext(); ++found) {
      const std::string code = codes.next().captured(1).toStdString();
      QVERIFY2(ui::stage_text(code) != ui::readable_code(code), code.c_str());
    }
  }
  QVERIFY(found > 30);
}

void TextsTest::EveryCommandHasItsWords() {
  static const QRegularExpression kCode(QStringLiteral("(?:\\.code = |_traits\\()\"([a-z_]+)\""));
  int found = 0;
  QDirIterator files(
      qEnvironmentVariable("GLISSON_SOURCE_DIR") + QStringLiteral("/modules/engine/src/commands"),
      {QStringLiteral("*.cpp")}, QDir::Files);
  for (; files.hasNext(); ++found) {
    QFile file(files.next());
    QVERIFY(file.open(QIODevice::ReadOnly));
    const auto code = kCode.match(QString::fromUtf8(file.readAll()));
    QVERIFY2(code.hasMatch(), qPrintable(file.fileName()));
    const std::string name = code.captured(1).toStdString();
    QVERIFY2(ui::command_text(name) != ui::readable_code(name), name.c_str());
  }
  QVERIFY(found > 35);
}

/// Of each part that is kept it is said in words what to do when it is missing, out of date or refused.
void TextsTest::EveryPartHasItsWords() {
  using Kind = engine::Obstacle::Kind;
  for (const engine::Part part : engine::all_parts()) {
    if (!part.type().is_saved()) continue;
    const engine::PartSpec& spec = part.type().spec();
    const auto is_told = [&](Kind kind) {
      const QString words = ui::obstacle_text(engine::Obstacle{kind, part, std::nullopt});
      const QString code = QString::fromUtf8(part.code().data(), static_cast<qsizetype>(part.code().size()));
      return words != QStringLiteral("There is no %1 yet.").arg(code) &&
             words != QStringLiteral("%1 is out of date: make it anew.").arg(code) &&
             words != QStringLiteral("%1 was refused: make it anew, or accept it.").arg(code);
    };
    const std::string code(part.code());
    QVERIFY2(!spec.remedy.empty(), code.c_str());
    QVERIFY2(is_told(Kind::missing), code.c_str());
    QVERIFY2(spec.made_of.empty() || spec.stands_alone || is_told(Kind::stale), code.c_str());
    QVERIFY2(!spec.is_refused || (is_told(Kind::refused) && !spec.refused_remedy.empty()), code.c_str());
  }
}

void TextsTest::TranslationsKeepThePlaceholders_data() {
  QTest::addColumn<QString>("file");
  const QString folder = qEnvironmentVariable("GLISSON_SOURCE_DIR") + QStringLiteral("/translations/");
  for (const char* language : {"de", "fr"})
    QTest::newRow(language) << folder + QStringLiteral("glisson_%1.ts").arg(QLatin1String(language));
}

void TextsTest::TranslationsKeepThePlaceholders() {
  QFETCH(QString, file);
  QFile input(file);
  QVERIFY(input.open(QIODevice::ReadOnly));
  QXmlStreamReader reader(&input);
  const auto placeholders = [](const QString& text) {
    static const QRegularExpression kPlaceholder(QStringLiteral("%[0-9]|\\[\\*\\]|^ | $"));
    QStringList found;
    for (auto matches = kPlaceholder.globalMatch(text); matches.hasNext();)
      found << matches.next().captured();
    found.sort();
    return found;
  };
  QString source;
  int compared = 0;
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    if (reader.name() == QLatin1String("source")) {
      source = reader.readElementText();
    } else if (reader.name() == QLatin1String("translation")) {
      const bool unfinished = reader.attributes().value(QLatin1String("type")) == QLatin1String("unfinished");
      QString translation = reader.readElementText(QXmlStreamReader::IncludeChildElements);
      if (translation.startsWith(QLatin1Char('\n'))) translation = translation.trimmed();  // plural forms
      QVERIFY2(!unfinished && !translation.isEmpty(), qPrintable(source));
      QVERIFY2(placeholders(source) == placeholders(translation), qPrintable(source));
      ++compared;
    }
  }
  QVERIFY2(!reader.hasError(), qPrintable(reader.errorString()));
  QVERIFY(compared > 300);
}

}  // namespace glisson

QTEST_APPLESS_MAIN(glisson::TextsTest)
#include "texts_test.moc"
