// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QStringList>
#include <vector>

/// @file
/// What the sources throw, as they say it: enough of C++ is read for calls with literals, sums and choices.

namespace glisson::thrown {

/// Stands for a value that only a run knows.
inline const QString kValue = QStringLiteral("7");

/// One call, such as InputError(...).
struct Call {
  QString name;
  QStringList arguments;
  qsizetype at = 0;  ///< in the code
  bool is_through_helper = false;
};

/// The literal that begins at `at`, quotes included.
inline QString literal_at(const QString& code, qsizetype at) {
  qsizetype end = at + 1;
  while (end < code.size() && code[end] != code[at]) end += code[end] == QLatin1Char('\\') ? 2 : 1;
  return code.mid(at, end + 1 - at);
}

/// Without comments; raw literals as plain ones, and those that go on in the next line as one.
inline QString plain(const QString& source) {
  static const QRegularExpression kSplit(QStringLiteral("\"\\s*\\n\\s*\""));
  QString code;
  for (qsizetype at = 0; at < source.size();) {
    const auto stands = [&](const char* text) { return source.mid(at, 3).startsWith(QLatin1String(text)); };
    const bool is_separator = at > 0 && source[at] == QLatin1Char('\'') && source[at - 1].isDigit();
    if (stands("R\"(")) {
      const qsizetype end = source.indexOf(QLatin1String(")\""), at);
      QString text = source.mid(at + 3, end - at - 3);
      code += QLatin1Char('"') + text.replace("\\", "\\\\").replace("\"", "\\\"") + QLatin1Char('"');
      at = end + 2;
    } else if (stands("//")) {
      const qsizetype end = source.indexOf(QLatin1Char('\n'), at);
      at = end < 0 ? source.size() : end;
    } else if (source[at] == QLatin1Char('"') || (source[at] == QLatin1Char('\'') && !is_separator)) {
      const QString literal = literal_at(source, at);
      code += literal;
      at += literal.size();
    } else {
      code += source[at++];
    }
  }
  return code.remove(kSplit);
}

/// Parts of code between one of `marks` outside of brackets and literals; the marks themselves are parts.
/// Ends at a bracket that was not opened.
inline QStringList parts_of(const QString& code, const QString& marks) {
  QStringList parts{QString()};
  int depth = 0;
  for (qsizetype at = 0; at < code.size(); ++at) {
    const QChar c = code[at];
    if (c == QLatin1Char('"') || c == QLatin1Char('\'')) {
      const QString literal = literal_at(code, at);
      parts.last() += literal;
      at += literal.size() - 1;
      continue;
    }
    if (QStringLiteral("([{").contains(c)) ++depth;
    if (QStringLiteral(")]}").contains(c) && --depth < 0) break;
    const bool is_scope = c == QLatin1Char(':') && (code.mid(at, 2) == QLatin1String("::") ||
                                                    code.mid(at - 1, 2) == QLatin1String("::"));
    if (depth == 0 && marks.contains(c) && !is_scope)
      parts << QString(c) << QString();
    else
      parts.last() += c;
  }
  return parts;
}

/// Calls of these names, with their arguments as code.
inline std::vector<Call> calls_in(const QString& code, const QString& names) {
  const QRegularExpression name(QStringLiteral("\\b(%1)\\s*[({]").arg(names));
  std::vector<Call> calls;
  for (auto match = name.globalMatch(code); match.hasNext();) {
    const QRegularExpressionMatch begin = match.next();
    Call call{begin.captured(1), {}, begin.capturedStart()};
    for (const QString& part : parts_of(code.mid(begin.capturedEnd(), 4000), QStringLiteral(",")))
      if (part != QLatin1String(",")) call.arguments << part.trimmed();
    calls.push_back(call);
  }
  return calls;
}

/// What an argument may say. kValue alone: only a run knows.
inline QStringList texts_of(const QString& argument) {
  static const QRegularExpression kInBrackets(QStringLiteral("^(?:std::string)?\\((.*)\\)$"),
                                              QRegularExpression::DotMatchesEverythingOption);
  const QString code = argument.trimmed();
  const QStringList choice = parts_of(code, QStringLiteral("?:"));
  if (const qsizetype first = choice.indexOf(QStringLiteral("?")); first >= 0) {
    qsizetype second = first + 1;
    for (int open = 1; second < choice.size(); ++second) {
      if (choice[second] == QLatin1String("?")) ++open;
      if (choice[second] == QLatin1String(":") && --open == 0) break;
    }
    return texts_of(choice.mid(first + 1, second - first - 1).join(QString())) +
           texts_of(choice.mid(second + 1).join(QString()));
  }
  const QStringList sum = parts_of(code, QStringLiteral("+"));
  if (sum.size() > 1) {
    QStringList all{QString()};
    for (const QString& part : sum) {
      if (part == QLatin1String("+")) continue;
      QStringList longer;
      for (const QString& begin : all)
        for (const QString& end : texts_of(part)) longer << begin + end;
      all = longer;
    }
    return all;
  }
  if (code.startsWith(QLatin1Char('"')) && literal_at(code, 0).size() == code.size())
    return {code.mid(1, code.size() - 2).replace("\\\"", "\"").replace("\\\\", "\\")};
  const QRegularExpressionMatch inner = kInBrackets.match(code);
  if (inner.hasMatch() && inner.captured(1).contains(QLatin1Char('"'))) return texts_of(inner.captured(1));
  return {kValue};
}

}  // namespace glisson::thrown
