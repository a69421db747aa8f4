// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QRegularExpression>
#include <algorithm>
#include <map>
#include <set>

#include "thrown_sentences.h"

/// @file
/// What is thrown through helpers: functions, members and lambdas that throw what their caller says. A call
/// of such a helper counts as the throw within it, with the arguments in the parameters' places.

namespace glisson::thrown {

inline const QString kErrors = QStringLiteral("InputError|FileError|UsageError");

/// As long as the code, with nothing in its literals.
inline QString without_literals(QString code) {
  for (qsizetype at = 0; at < code.size(); ++at) {
    if (code[at] != QLatin1Char('"') && code[at] != QLatin1Char('\'')) continue;
    const bool is_separator = code[at] == QLatin1Char('\'') && at > 0 && code[at - 1].isDigit();
    if (is_separator) continue;
    const qsizetype size = literal_at(code, at).size();
    code.replace(at, size, QString(size, QLatin1Char('"')));
    at += size - 1;
  }
  return code;
}

/// Where names of values stand in code: neither in literals nor as members of something.
inline std::vector<QRegularExpressionMatch> names_in(const QString& code) {
  static const QRegularExpression kName(QStringLiteral("(?<![\\w.]|->)[A-Za-z_]\\w*"));
  std::vector<QRegularExpressionMatch> names;
  for (auto match = kName.globalMatch(without_literals(code)); match.hasNext();)
    names.push_back(match.next());
  return names;
}

using Values = QHash<QString, QString>;

/// With values in the places of names.
inline QString filled(QString code, const Values& values) {
  const auto names = names_in(code);
  for (auto name = names.rbegin(); name != names.rend(); ++name)
    if (const auto value = values.find(name->captured()); value != values.end())
      code.replace(name->capturedStart(), name->capturedLength(),
                   QLatin1Char('(') + *value + QLatin1Char(')'));
  return code;
}

/// A function or a lambda with a body.
struct Function {
  QString name;
  QString type;  ///< of which it is the call; empty: it has a name
  QStringList parameters, defaults;
  std::set<QString> texts;       ///< parameters that hold words
  qsizetype begin = 0, end = 0;  ///< of its body, in the code
};

/// The parameters of a function by their names.
inline void read_parameters(const QString& list, Function& function) {
  static const QRegularExpression kName(QStringLiteral("(\\w+)\\s*$"));
  static const QRegularExpression kWords(QStringLiteral("\\b(string|string_view|char|auto|QString)\\b"));
  QString whole;
  for (const QString& part : parts_of(list, QStringLiteral(","))) {
    whole += part;
    if (part == QLatin1String(",") || whole.count(QLatin1Char('<')) > whole.count(QLatin1Char('>'))) continue;
    if (whole.startsWith(QLatin1Char(','))) whole.remove(0, 1);
    const qsizetype equals = whole.indexOf(QLatin1Char('='));
    const QString name = kName.match(whole.left(equals)).captured(1);
    const QString otherwise = equals < 0 ? QString() : whole.mid(equals + 1).trimmed();
    function.parameters << name;
    function.defaults << (otherwise == QLatin1String("{}") ? QStringLiteral("\"\"") : otherwise);
    if (whole.left(equals).contains(kWords)) function.texts.insert(name);
    whole.clear();
  }
}

/// What stands before the `{` of a body: its parameters' brackets and its name. False: it is no function's.
inline bool read_head(const QString& code, const QString& bare, qsizetype brace, Function& function) {
  static const QRegularExpression kBehind(
      QStringLiteral("\\)\\s*(?:const|noexcept|override|final|mutable|->[\\w:<>&*, ]+|\\s)*$"));
  static const QRegularExpression kLambda(QStringLiteral("(\\w+)\\s*=\\s*\\[[^\\[\\]]*\\]\\s*$"));
  static const QRegularExpression kCalled(QStringLiteral("(?:(\\w+)::)?(operator\\(\\)|\\w+)\\s*$"));
  static const QRegularExpression kType(QStringLiteral("\\b(?:struct|class)\\s+(\\w+)[^;]*$"));
  const qsizetype from = std::max<qsizetype>(0, brace - 200);
  const auto behind = kBehind.match(bare.mid(from, brace - from));
  if (!behind.hasMatch()) return false;
  const qsizetype close = from + behind.capturedStart();
  qsizetype open = close;
  for (int depth = 0; open >= 0; --open) {
    depth += bare[open] == QLatin1Char(')') ? 1 : bare[open] == QLatin1Char('(') ? -1 : 0;
    if (depth == 0) break;
  }
  if (open < 0) return false;
  const QString before = bare.mid(std::max<qsizetype>(0, open - 300), std::min<qsizetype>(300, open));
  const auto lambda = kLambda.match(before);
  const auto called = kCalled.match(before);
  function.name = lambda.hasMatch() ? lambda.captured(1) : called.captured(2);
  if (function.name == QLatin1String("operator()")) {
    const qsizetype type =
        bare.left(open).lastIndexOf(QRegularExpression(QStringLiteral("\\b(struct|class)\\b")));
    function.type = !called.captured(1).isEmpty()
                        ? called.captured(1)
                        : kType.match(bare.mid(type, 60).section('{', 0, 0)).captured(1);
  }
  static const QStringList kNoNames{"if", "for", "while", "switch", "catch", ""};
  if (kNoNames.contains(function.name)) return false;
  read_parameters(code.mid(open + 1, close - open - 1), function);
  return true;
}

/// Outer ones before those within them.
inline std::vector<Function> functions_in(const QString& code) {
  const QString bare = without_literals(code);
  std::vector<Function> functions;
  std::vector<std::ptrdiff_t> open;  // -1: a brace of something else
  for (qsizetype at = 0; at < bare.size(); ++at) {
    if (bare[at] == QLatin1Char('{')) {
      Function function;
      function.begin = at;
      const bool is_one = read_head(code, bare, at, function);
      open.push_back(is_one ? static_cast<std::ptrdiff_t>(functions.size()) : -1);
      if (is_one) functions.push_back(function);
    } else if (bare[at] == QLatin1Char('}') && !open.empty()) {
      if (open.back() >= 0) functions[static_cast<std::size_t>(open.back())].end = at;
      open.pop_back();
    }
  }
  return functions;
}

/// A function that throws what its caller says, and the throw in its parameters' names.
struct Helper {
  Function function;
  Call thrown;

  bool takes(qsizetype arguments) const {
    return arguments <= function.parameters.size() &&
           (arguments == function.parameters.size() || !function.defaults[arguments].isEmpty());
  }
  /// What a call of it throws.
  Call called_with(const Call& call) const {
    Values values;
    for (qsizetype i = 0; i < function.parameters.size(); ++i)
      values[function.parameters[i]] = i < call.arguments.size() ? call.arguments[i] : function.defaults[i];
    Call error{thrown.name, {}, call.at, true};
    for (const QString& argument : thrown.arguments) error.arguments << filled(argument, values);
    return error;
  }
  bool operator==(const Helper& other) const {
    return function.name == other.function.name && function.type == other.function.type &&
           function.parameters == other.function.parameters && thrown.arguments == other.thrown.arguments;
  }
};

/// Source files, which see each other's helpers by their includes.
class Sources {
 public:
  /// @param path from the top, as modules/core/src/error.cpp.
  void add(const QString& path, const QString& source) {
    File& file = files_[path];
    file.code = plain(source);
    file.functions = functions_in(file.code);
  }
  /// After all were added.
  void find_helpers() {
    for (auto& [path, file] : files_) see(path, file.seen);
    for (auto& [path, file] : files_) {
      for (const QString& seen : file.seen) file.constants.insert(constants_in(files_.at(seen).code));
      file.constants.insert(constants_in(file.code));  // its own go first
    }
    constexpr int kDeepest = 8;  // helpers that call helpers
    bool is_more = true;
    for (int depth = 0; depth < kDeepest && is_more; ++depth) {
      is_more = false;
      for (const auto& [path, file] : files_)
        for (const Call& call : throws_in(path)) is_more = keep_helper(path, call) || is_more;
    }
  }
  std::vector<QString> paths() const {
    std::vector<QString> all;
    for (const auto& [path, file] : files_) all.push_back(path);
    return all;
  }
  /// What a file throws itself, then what it throws through helpers.
  std::vector<Call> throws_in(const QString& path) const {
    const File& file = files_.at(path);
    std::vector<Call> all = calls_in(file.code, kErrors);
    QMultiHash<QString, const Helper*> helpers;
    for (const QString& seen : file.seen)
      for (const Helper& helper : files_.at(seen).helpers)
        for (const QString& name : names_of(helper, file.code)) helpers.insert(name, &helper);
    const QString names = QStringList(helpers.uniqueKeys()).join(QLatin1Char('|'));
    for (const Call& call : names.isEmpty() ? std::vector<Call>() : calls_in(file.code, names))
      for (const Helper* helper : helpers.values(call.name))
        if (helper->takes(call.arguments.size()) && !is_declaration(call, file.code))
          all.push_back(helper->called_with(call));
    for (Call& call : all)
      for (QString& argument : call.arguments) argument = filled(argument, file.constants);
    return all;
  }

 private:
  struct File {
    QString code;
    std::vector<Function> functions;
    std::vector<Helper> helpers;
    std::set<QString> seen;  ///< itself, and what it includes
    Values constants;
  };

  void see(const QString& path, std::set<QString>& seen) const {
    static const QRegularExpression kInclude(QStringLiteral("#include \"([^\"]+)\""));
    if (!files_.contains(path) || !seen.insert(path).second) return;
    for (auto match = kInclude.globalMatch(files_.at(path).code); match.hasNext();) {
      const QString name = match.next().captured(1);
      see(path.section(QLatin1Char('/'), 0, -2) + QLatin1Char('/') + name, seen);
      const QString module = name.section(QLatin1Char('/'), 1, 1);
      see(QStringLiteral("modules/%1/include/%2").arg(module, name), seen);
    }
  }
  static Values constants_in(const QString& code) {
    static const QRegularExpression kConstant(
        QStringLiteral("\\b(k[A-Z]\\w*)(?:\\[\\])?(?:\\s*=\\s*|\\{)(\"(?:[^\"\\\\]|\\\\.)*\")\\}?;"));
    Values constants;
    for (auto match = kConstant.globalMatch(code); match.hasNext();) {
      const auto constant = match.next();
      constants[constant.captured(1)] = constant.captured(2);
    }
    return constants;
  }
  /// What a helper is called in a file: by its name, or as a value of its type.
  static QStringList names_of(const Helper& helper, const QString& code) {
    const QString& type = helper.function.type;
    if (type.isEmpty()) return {helper.function.name};
    QStringList values;
    const QRegularExpression value(QStringLiteral("\\b%1\\b[&\\s]+(\\w+)").arg(type));
    for (auto match = value.globalMatch(code); match.hasNext();) values << match.next().captured(1);
    return values;
  }
  static bool is_declaration(const Call& call, const QString& code) {
    static const QRegularExpression kType(
        QStringLiteral("\\b(?!return|throw|else)\\w+[>&*]?\\s+(?:\\w+::)*$"));
    const qsizetype from = std::max<qsizetype>(0, call.at - 80);
    return code.mid(from, call.at - from).contains(kType);
  }
  /// Whether a function that throws what its caller says was not known yet.
  bool keep_helper(const QString& path, const Call& call) {
    const File& file = files_.at(path);
    for (auto function = file.functions.rbegin(); function != file.functions.rend(); ++function) {
      if (call.at < function->begin || call.at > function->end) continue;
      const bool is_sentence = call.arguments.size() == 1;
      bool is_said = false;
      for (const QString& argument : is_sentence ? call.arguments : call.arguments.mid(2))
        for (const auto& name : names_in(argument)) is_said |= function->texts.contains(name.captured());
      if (!is_said) continue;
      return keep(path, Helper{*function, call});
    }
    return false;
  }
  /// Where it stands, and in the headers that declare it.
  bool keep(const QString& path, const Helper& helper) {
    bool is_new = add_new(helper, files_.at(path).helpers);
    for (const QString& seen : files_.at(path).seen) {
      File& file = files_.at(seen);
      Helper declared = helper;
      if (seen != path && is_header(seen) && !is_header(path) &&
          read_declaration(file.code, declared.function))
        is_new = add_new(declared, file.helpers) || is_new;
    }
    return is_new;
  }
  static bool is_header(const QString& path) { return path.endsWith(QLatin1String(".h")); }
  static bool add_new(const Helper& helper, std::vector<Helper>& helpers) {
    if (std::ranges::find(helpers, helper) != helpers.end()) return false;
    helpers.push_back(helper);
    return true;
  }
  /// The defaults of its parameters. False: it is not declared there.
  static bool read_declaration(const QString& code, Function& function) {
    const QString name =
        function.type.isEmpty() ? function.name : function.type + QStringLiteral("\\b[^;].*operator\\(\\)");
    const QRegularExpression declaration(
        QStringLiteral("\\b(?!return|throw|else)\\w+[>&*]?\\s+%1\\s*\\(([^;{]*)\\)[^;{()]*;").arg(name),
        QRegularExpression::DotMatchesEverythingOption);
    Function declared;
    const auto match = declaration.match(code);
    if (!match.hasMatch()) return false;
    read_parameters(match.captured(1), declared);
    function.defaults = declared.defaults;
    return declared.parameters.size() == function.parameters.size();
  }

  std::map<QString, File> files_;
};

}  // namespace glisson::thrown
