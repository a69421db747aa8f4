// SPDX-License-Identifier: GPL-3.0-or-later
// Every text that the window and the commands say has a translation in each language: a question of which one
// button is in another language is answered by guessing.
#include <QTest>
#include <QXmlStreamReader>

#include <filesystem>
#include <map>
#include <string>

#include "glisson/core/files.h"
#include "thrown_sentences.h"

namespace glisson {

namespace fs = std::filesystem;

namespace {

fs::path root() { return qEnvironmentVariable("GLISSON_SOURCE_DIR").toStdString(); }

QString text_of(const fs::path& file) { return QString::fromStdString(read_file(file)); }

/// What a literal means, without its quotes.
QString meaning(QString literal) {
  static const QRegularExpression kCode(QStringLiteral("\\\\u([0-9a-fA-F]{4})"));
  for (auto match = kCode.match(literal); match.hasMatch(); match = kCode.match(literal))
    literal.replace(match.capturedStart(), match.capturedLength(),
                    QChar(static_cast<char16_t>(match.captured(1).toUShort(nullptr, 16))));
  return literal.replace(QLatin1String("\\n"), QLatin1String("\n"))
      .replace(QLatin1String("\\\""), QLatin1String("\""))
      .replace(QLatin1String("\\\\"), QLatin1String("\\"));
}

/// The texts of tr("...") and of QT_TRANSLATE_NOOP("context", "...").
QSet<QString> texts_in(const QString& source) {
  static const QRegularExpression kTold(QStringLiteral(
      "(?:\\btr\\(\\s*|\\bQT_TRANSLATE_NOOP\\(\\s*\"[^\"]*\"\\s*,\\s*)\"((?:[^\"\\\\]|\\\\.)*)\""));
  QSet<QString> texts;
  for (auto match = kTold.globalMatch(thrown::plain(source)); match.hasNext();)
    texts << meaning(match.next().captured(1));
  return texts;
}

/// Those that a file of translations has whole, by the context that they are asked for in.
QMap<QString, QSet<QString>> translated_in(const fs::path& file) {
  const QString text = text_of(file);
  QXmlStreamReader xml(text);
  QMap<QString, QSet<QString>> translated;
  QString context, source;
  while (!xml.atEnd()) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("source")) source = xml.readElementText();
    if (xml.name() != QLatin1String("translation")) continue;
    const bool is_whole = xml.attributes().value(QLatin1String("type")).isEmpty();
    const QString told = xml.readElementText(QXmlStreamReader::IncludeChildElements);
    if (is_whole && !told.trimmed().isEmpty()) translated[context] << source;
  }
  return translated;
}

}  // namespace

class TranslatedTest : public QObject {
  Q_OBJECT
 private slots:
  void TextsAreFoundInSources() {
    const QString source = QStringLiteral(
        "say(tr(\"One \\\"two\\\"\"\n      \" three.\")); // tr(\"no\")\nQT_TRANSLATE_NOOP(\"cli\", "
        "\"Four\\u2026\")");
    QCOMPARE(texts_in(source),
             (QSet<QString>{QStringLiteral("One \"two\" three."), QStringLiteral("Four…")}));
  }

  void EveryTextIsTranslated_data() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"de", "fr"}) QTest::newRow(language) << QString::fromLatin1(language);
  }
  void EveryTextIsTranslated() {
    QFETCH(QString, language);
    const auto by_context =
        translated_in(root() / "translations" / ("glisson_" + language.toStdString() + ".ts"));
    QSet<QString> in_any;
    for (const QSet<QString>& texts : by_context) in_any |= texts;
    // The commands and what they tell of experiments have one context, and so have the steps of the labels'
    // history; those of the window are as many as its classes.
    const std::map<std::string, QSet<QString>> known = {
        {"ui", in_any},
        {"app", by_context.value("cli")},
        {"modules/experiments/src", by_context.value("cli")},
        {"modules/engine/src/steps", by_context.value("EditTexts")}};
    QStringList missing;
    int looked_at = 0;
    for (const auto& [folder, translated] : known)
      for (const auto& entry : fs::recursive_directory_iterator(root() / folder)) {
        const fs::path& file = entry.path();
        if (file.extension() != ".cpp" && file.extension() != ".h") continue;
        for (const QString& text : texts_in(text_of(file))) {
          ++looked_at;
          if (!text.isEmpty() && !translated.contains(text))
            missing << QString::fromStdString(file.filename().string()) + QStringLiteral(": ") + text;
        }
      }
    QVERIFY(looked_at > 1500);
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(QLatin1Char('\n'))));
  }
};

}  // namespace glisson

QTEST_GUILESS_MAIN(glisson::TranslatedTest)
#include "translated_test.moc"
