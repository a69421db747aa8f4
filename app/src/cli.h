// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QString>
#include <QStringList>
#include <chrono>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "glisson/core/error.h"
#include "glisson/core/json_file.h"
#include "glisson/core/log.h"
#include "glisson/core/units.h"
#include "glisson/engine/script.h"

/// @file
/// What all sub-commands share: options, an inline engine with progress on the terminal, figures as JSON,
/// exit codes.

namespace glisson::app {

/// Strings for people on the command line: Cli::tr("...").
struct Cli {
  Q_DECLARE_TR_FUNCTIONS(cli)
};

/// Something is wrong with the command line itself; exit code 2.
class UsageError : public Error {
 public:
  using Error::Error;
};
/// The person pressed Ctrl-C; exit code 130.
class Interrupted : public Error {
 public:
  Interrupted() : Error("cancelled; nothing was written.") {}
  /// @param kept what is left of the work, in a sentence.
  explicit Interrupted(const QString& kept) : Error(kept.toStdString()) {}
};
/// Does work of which a part is worth keeping. @return false: the person pressed Ctrl-C on the way.
bool until_interrupted(const std::function<void()>& work);
/// "cancelled; DIR holds what was finished (12), marked as incomplete."
QString kept_text(int finished, const std::filesystem::path& where);

/// The arguments of one sub-command. Adds --help, --seed and --json to those that it declares.
class Arguments {
 public:
  Arguments(const QString& command, const QString& description);

  void positional(const QString& name, const QString& description, const QString& syntax = {});
  void option(const QString& name, const QString& description, const QString& value_name,
              const QString& fallback = {});
  void option(const QString& name, const QString& description, const QString& value_name, double fallback) {
    option(name, description, value_name, QString::number(fallback));
  }
  /// One that means something without a word after it, too: its value is empty then.
  void option_with_usual_value(const QString& name, const QString& description, const QString& value_name);
  void flag(const QString& name, const QString& description);

  /// @return false when help was asked for and printed. @throws UsageError.
  bool parse(const QStringList& arguments);

  bool has(const QString& name) const { return parser_.isSet(name); }
  QString value(const QString& name) const { return parser_.value(name); }
  std::filesystem::path path(const QString& name) const { return parser_.value(name).toStdString(); }
  /// @throws UsageError when the option is absent.
  std::filesystem::path required_path(const QString& name) const;
  /// A file that the command will write. Asked for before the work, so that hours of it are not lost to a
  /// misspelt folder. @throws UsageError when the option is absent or of no such format, FileError when no
  /// file can stand there.
  /// Nothing else that the person named lies there.
  /// @param endings of the formats that can be written; empty: any.
  std::filesystem::path output_file(const QString& name, const QStringList& endings = {}) const;
  /// @param beside what makes options idle, in the person's language: "--clouds".
  /// @throws UsageError one of them is given: it would be left unread without a word.
  void refuse_idle(const QString& beside, const QStringList& idle) const;
  /// The same of what means something beside another option only, which is not given.
  void refuse_without(const QString& needed, const QStringList& idle) const;
  /// A file that is read at the end, when there is such an option. @throws FileError when it does not exist.
  void require_existing(const QString& name) const;
  /// @throws UsageError when it is not a number, or outside [low, high].
  double number(const QString& name, double low, double high) const;
  /// So many of them, "1,-2.5,0". @throws UsageError likewise.
  std::vector<double> numbers(const QString& name, int count, double low, double high) const;
  int integer(const QString& name, int low, int high) const;
  LengthUnit unit(const QString& name) const;
  QStringList positionals() const { return parser_.positionalArguments(); }
  /// @throws UsageError unless there are between `low` and `high`.
  QStringList positionals(int low, int high) const;

  std::uint64_t seed() const;

 private:
  /// @throws UsageError an option is given twice, or without the value that it takes.
  void refuse_slips() const;
  /// @throws UsageError another option or argument names the same file: it would be written over.
  void refuse_shared_place(const QString& name) const;

  QString command_;
  QCommandLineParser parser_;
  bool takes_positionals_ = false;
  QStringList flags_;            ///< that take no value
  QStringList may_stand_alone_;  ///< "--name"
};

/// A script of engine commands with its progress on the terminal, and the figures of everything that it did.
class Session {
 public:
  explicit Session(const Arguments& arguments);

  /// Does a command. @throws Error with the engine's sentence, Interrupted.
  engine::Outcome post(engine::Command command);
  /// What the person calls what the modules know by another name: their sentences begin with the files then.
  /// "stereo pair" -> "l.png, r.png". Nothing where no file was given.
  void call(const std::string& name, const std::string& files) {
    if (!files.empty()) files_of_[name] = files;
  }
  /// Follows one input, however long it takes. `fraction` of all inputs is done with it, for the terminal.
  /// @pre tracking was started. @throws Interrupted.
  OverlayFrame follow(engine::LiveInput input, double fraction);
  const engine::CaseState& state() const { return script_.state(); }
  /// @throws Error the engine's sentence on the first of these parts that the case does not have.
  void need(const engine::Needs& parts) const;
  /// Does something whose sentences name what call() has named.
  void with_names(const std::function<void()>& work) const;
  /// Progress, cancel and seed, for work outside the engine.
  const RunContext& context() const { return context_; }

  Figures figures;
  std::map<std::string, std::string> texts;
  std::vector<std::string> notes;

  /// Among the figures from now on; those that are there already are replaced.
  void tell(const Figures& more);
  /// Does what may fail where the work is safe already (a comparison with a truth, one more file): all is
  /// told before finish() throws the error.
  void attempt(const std::function<void()>& work);
  /// Prints the figures, and writes them where --json says, with `seconds`. @throws what attempt() met first.
  void finish();

 private:
  const Arguments& arguments_;
  std::map<std::string, std::string> files_of_;
  std::string command_;  ///< that is running, for the terminal
  RunContext context_;
  engine::Script script_;
  std::chrono::steady_clock::time_point begin_;
  Log log_;
  std::exception_ptr failure_;  ///< that finish() throws
};

/// Whether two paths are one file, or will be.
bool is_same_place(const std::filesystem::path& a, const std::filesystem::path& b);

/// From now on Ctrl-C cancels what is running instead of ending the process.
void catch_interrupts();

/// Prints a line and clears what progress left on it.
void say(const QString& line);

/// What drawing without a display, and the window, need of the environment: Qt keeps its sockets in
/// XDG_RUNTIME_DIR and complains on the terminal where a login (a container, a cron job) did not set it.
void provide_runtime_folder();

/// Whether the environment names a display that a window can be shown on.
bool has_display();

}  // namespace glisson::app
