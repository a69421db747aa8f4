// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/error_texts.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <algorithm>
#include <optional>
#include <vector>

#include "error_phrases.h"

namespace glisson::ui {
namespace {

/// Context of these sentences for translators. %1, %2, ... stand for files and for what the system says.
class Errors {
  Q_DECLARE_TR_FUNCTIONS(Errors)
 public:
  static const std::vector<const char*>& sentences() {
    static const std::vector<const char*> kSentences = {
        QT_TRANSLATE_NOOP("Errors", "%1: does not exist. Check the path."),
        QT_TRANSLATE_NOOP("Errors", "%1: cannot be opened (%2). Check the path."),
        QT_TRANSLATE_NOOP("Errors", "%1: could not be read to its end. Check the disk."),
        QT_TRANSLATE_NOOP("Errors", "%1: is a folder. Name a file in it."),
        QT_TRANSLATE_NOOP("Errors", "%1: is a folder, a file is to be written here. Choose another name."),
        QT_TRANSLATE_NOOP("Errors", "%1: is a device or a pipe, not a file. Choose another name."),
        QT_TRANSLATE_NOOP("Errors", "%1: its folder does not exist. Create it or choose another."),
        QT_TRANSLATE_NOOP("Errors", "%1: could not be written (%2). Check permissions and free space."),
        QT_TRANSLATE_NOOP("Errors", "%1: what was written reads back differently. Check the disk."),
        QT_TRANSLATE_NOOP("Errors", "%1: is a link that leads back to itself. Choose another name."),
        QT_TRANSLATE_NOOP("Errors",
                          "%1: is a link that another user has put there. Choose another name or folder."),
        QT_TRANSLATE_NOOP("Errors", "%1: no folder can be made here (%2). Check permissions."),
        QT_TRANSLATE_NOOP("Errors", "%1: could not be replaced (%2). Choose another name."),
        QT_TRANSLATE_NOOP("Errors", "%1: could not be flushed to disk (%2). Free some space."),
        QT_TRANSLATE_NOOP(
            "Errors",
            "%1: is open for writing by %2. Close it there, or save under another name. If that "
            "program runs no longer, remove %3."),
        QT_TRANSLATE_NOOP("Errors",
                          "%1: cannot be opened for writing: %2 cannot be written. Check the permissions of "
                          "its folder, or open it for reading."),
        QT_TRANSLATE_NOOP("Errors", "%1: exists and is not a case. Choose another name."),
        QT_TRANSLATE_NOOP("Errors",
                          "%1: a case is a folder whose name ends in .glisson. Choose such a name."),
        QT_TRANSLATE_NOOP("Errors",
                          "%1: case.json: is missing: this folder is not a case. Choose a folder "
                          "NAME.glisson."),
        QT_TRANSLATE_NOOP("Errors",
                          "%1: version: is %2, this program reads up to %3. Open it with a newer Glisson."),
        QT_TRANSLATE_NOOP("Errors", "%1: %2: is not valid JSON. Correct it there or write the file anew."),
        QT_TRANSLATE_NOOP("Errors", "%1: is malformed (%2). Restore the case from a copy."),
        QT_TRANSLATE_NOOP("Errors",
                          "%1: the case reads back differently from what was written. Check the disk's free "
                          "space; the old case stands."),
        QT_TRANSLATE_NOOP("Errors",
                          "%1: is no file of the case and could not be kept (%2). Move it elsewhere and save "
                          "again; the old case stands."),
        QT_TRANSLATE_NOOP("Errors", "%1: cannot be used (%2). Check the path."),
        QT_TRANSLATE_NOOP("Errors",
                          "%1: cannot be used (%2). Check the permissions of the file and of its folders."),
        QT_TRANSLATE_NOOP("Errors", "%1: cannot be used (%2). Free some space on the disk."),
        QT_TRANSLATE_NOOP("Errors", "%1: stopped unexpectedly (%2). The case is as it was."),
        QT_TRANSLATE_NOOP(
            "Errors",
            "%1: memory ran out. Close other programs, or take a smaller volume or a coarser mesh."),
        QT_TRANSLATE_NOOP("Errors",
                          "case: path: the case has never been saved. Choose a folder NAME.glisson to save "
                          "it to."),
    };
    return kSentences;
  }
};

/// What stands for the placeholders; empty: the sentence is another one.
std::optional<QStringList> values_in(const QString& sentence, const char* known) {
  QString pattern = QRegularExpression::escape(QString::fromUtf8(known));
  pattern.replace(QRegularExpression(QStringLiteral("\\\\%\\d")), QStringLiteral("(.+)"));
  const QRegularExpressionMatch match =
      QRegularExpression(QRegularExpression::anchoredPattern(pattern)).match(sentence);
  if (!match.hasMatch()) return {};
  return match.capturedTexts().mid(1);
}

/// At once: a file's name may hold a %2 of its own.
QString filled(const QString& text, const QStringList& values) {
  QString result;
  for (qsizetype at = 0; at < text.size(); ++at) {
    const int number = text[at] == QLatin1Char('%') && at + 1 < text.size() ? text[at + 1].digitValue() : -1;
    if (number < 1 || number > values.size()) {
      result += text[at];
      continue;
    }
    result += values[number - 1];
    ++at;
  }
  return result;
}

/// A phrase, and what a text says in its places.
struct Match {
  const char* phrase;
  QStringList values;
};

/// Begins and ends as a phrase with places: most do not, and need no pattern.
bool may_match(const QString& text, std::string_view words) {
  return text.startsWith(QLatin1String(words.substr(0, words.find('%')))) &&
         text.endsWith(QLatin1String(words.substr(std::min(words.size(), words.rfind('%') + 2))));
}

std::optional<Match> match_of(const QString& text, const std::vector<const char*>& known) {
  for (const char* phrase : known) {
    const std::string_view words(phrase);
    const bool is_plain = words.find('%') == std::string_view::npos;
    if (is_plain ? text != QLatin1String(phrase) : !may_match(text, words)) continue;
    const auto values = is_plain ? QStringList() : values_in(text, phrase);
    if (values) return Match{phrase, *values};
  }
  return {};
}

QString translated(const Match& match, const char* context) {
  return filled(QCoreApplication::translate(context, match.phrase), match.values);
}

/// Without what stands in its places: that may name a file or a person.
std::string anonymous(const char* phrase) {
  std::string text;
  for (const char* at = phrase; *at != '\0'; ++at) {
    const bool place = at[0] == '%' && at[1] >= '1' && at[1] <= '9';
    text += place ? '_' : *at;
    if (place) ++at;
  }
  return text;
}

constexpr const char* kPhrases = "ErrorPhrases";

/// FILE: FIELD: problem. Remedy.
struct Parts {
  QString where;  ///< file and field, as they are
  QString problem;
  std::optional<Match> known_problem, known_remedy;
};

Parts parts_of(QString sentence) {
  Parts parts;
  if (sentence.endsWith(QLatin1Char('.'))) sentence.chop(1);
  const QString between = QStringLiteral(". "), behind = QStringLiteral(": ");
  for (qsizetype at = sentence.lastIndexOf(between); at >= 0;
       at = at > 0 ? sentence.lastIndexOf(between, at - 1) : -1) {
    parts.known_remedy = match_of(sentence.mid(at + between.size()), known_remedies());
    if (!parts.known_remedy) continue;
    sentence.truncate(at);
    break;
  }
  parts.problem = sentence;
  for (qsizetype at = 0; at >= 0;) {
    parts.known_problem = match_of(sentence.mid(at), known_problems());
    if (parts.known_problem) {
      parts.where = sentence.left(std::max<qsizetype>(0, at - behind.size()));
      break;
    }
    const qsizetype next = sentence.indexOf(behind, at);
    at = next < 0 ? -1 : next + behind.size();
  }
  return parts;
}

QString told_by(std::string_view sentence) {
  return QString::fromUtf8(sentence.data(), static_cast<qsizetype>(sentence.size()));
}

}  // namespace

QString error_text(std::string_view sentence) {
  const QString told = told_by(sentence);
  if (const auto whole = match_of(told, Errors::sentences())) return translated(*whole, "Errors");
  const Parts parts = parts_of(told);
  if (!parts.known_problem && !parts.known_remedy) return told;
  const QString problem = parts.known_problem ? translated(*parts.known_problem, kPhrases) : parts.problem;
  QString text = parts.where.isEmpty() ? problem : filled(Errors::tr("%1: %2"), {parts.where, problem});
  if (parts.known_remedy) text += QStringLiteral(". ") + translated(*parts.known_remedy, kPhrases);
  return text + QLatin1Char('.');
}

bool is_error_known(std::string_view sentence) {
  const QString told = told_by(sentence);
  return match_of(told, Errors::sentences()) || parts_of(told).known_problem;
}

std::string logged_error(std::string_view sentence) {
  const QString told = told_by(sentence);
  if (const auto whole = match_of(told, Errors::sentences())) return anonymous(whole->phrase);
  const Parts parts = parts_of(told);
  std::string text = parts.known_problem ? anonymous(parts.known_problem->phrase) : "another error";
  if (parts.known_remedy) text += ". " + anonymous(parts.known_remedy->phrase);
  return text;
}

std::vector<const char*> error_phrases() {
  std::vector<const char*> all = known_problems();
  all.insert(all.end(), known_remedies().begin(), known_remedies().end());
  return all;
}

}  // namespace glisson::ui
