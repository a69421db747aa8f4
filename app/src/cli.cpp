// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli.h"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QByteArray>
#include <QDir>
#include <QLocale>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "exit_code.h"
#include "glisson/core/failure_sentence.h"
#include "glisson/core/log_file.h"
#include "glisson/core/output_file.h"
#include "glisson/core/stopwatch.h"
#include "glisson/engine/obstacle.h"
#include "glisson/engine/outcome_log.h"
#include "glisson/ui/common/error_texts.h"
#include "glisson/ui/common/texts.h"

namespace glisson::app {
namespace fs = std::filesystem;
namespace {

constexpr double kSecondsALine = 60.0;

bool on_terminal() { return ::isatty(STDERR_FILENO) == 1; }

/// Set by the signal handler: an atomic bool that is lock-free, which a handler may touch.
const std::shared_ptr<CancelFlag>& interrupt_flag() {
  static const auto kFlag = std::make_shared<CancelFlag>();
  return kFlag;
}
void on_interrupt(int) {
  // Whoever asks again does not want to wait: what is half written is swept at the next start.
  if (interrupt_flag()->requested()) ::_exit(kCancelled);
  interrupt_flag()->request();
}

void clear_progress() {
  if (on_terminal()) std::fputs("\r\033[K", stderr);
}

/// In place on a terminal; elsewhere a line a minute, so that a log of a long run tells how far it is.
void show_progress(double fraction, const QString& doing) {
  const QByteArray text = QString::asprintf("%3.0f %%  ", 100.0 * fraction).toUtf8() + doing.toUtf8();
  if (on_terminal()) {
    std::fprintf(stderr, "\r\033[K%s", text.constData());
  } else {
    static Stopwatch since_told;
    if (since_told.seconds() < kSecondsALine) return;
    since_told = {};
    std::fprintf(stderr, "%s\n", text.constData());
  }
  std::fflush(stderr);
}

/// @throws FileError when no file can be written there. What a killed run left there goes.
void require_place_for(const fs::path& file) {
  const fs::path place = place_for_file(file);
  const fs::path folder = place.has_parent_path() ? place.parent_path() : fs::path(".");
  if (::access(folder.c_str(), W_OK) != 0)
    throw FileError(file.string() + ": its folder cannot be written to. Choose another folder.");
  sweep_leftovers(folder);
}

}  // namespace

bool is_same_place(const fs::path& a, const fs::path& b) {
  std::error_code failure;
  if (fs::equivalent(a, b, failure)) return true;
  // What is not there yet has a name alone.
  const fs::path one = fs::weakly_canonical(fs::absolute(a, failure), failure);
  return !failure && one == fs::weakly_canonical(fs::absolute(b, failure), failure) && !failure;
}

void catch_interrupts() {
  interrupt_flag();  // made now, not inside the handler
  struct sigaction action = {};
  action.sa_handler = on_interrupt;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  // A terminal that is closed, unless the person has said that it does not matter (nohup).
  struct sigaction before = {};
  if (::sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
    ::sigaction(SIGHUP, &action, nullptr);
}

bool until_interrupted(const std::function<void()>& work) {
  try {
    work();
    return true;
  } catch (const Interrupted&) {
    return false;
  }
}

QString kept_text(int finished, const fs::path& where) {
  if (finished == 0) return Cli::tr("cancelled; nothing was written.");
  return Cli::tr("cancelled; %1 holds what was finished (%2), marked as incomplete.")
      .arg(QString::fromStdString(where.string()))
      .arg(finished);
}

void say(const QString& line) {
  clear_progress();
  std::puts(line.toUtf8().constData());
  std::fflush(stdout);
}

void provide_runtime_folder() {
  if (qEnvironmentVariableIsSet("XDG_RUNTIME_DIR")) return;
  const QString folder = QDir::temp().filePath("runtime-" + qEnvironmentVariable("USER", "glisson") + "-" +
                                               QString::number(::getuid()));
  // Qt trusts only a folder of this user that no other may enter.
  std::error_code failure;
  fs::create_directory(folder.toStdString(), failure);
  // In a folder open to all, somebody else may have put something of this name there.
  struct stat there = {};
  if (::lstat(folder.toUtf8().constData(), &there) != 0 || !S_ISDIR(there.st_mode) ||
      there.st_uid != ::geteuid())
    return;
  fs::permissions(folder.toStdString(), fs::perms::owner_all, failure);
  if (!failure) qputenv("XDG_RUNTIME_DIR", folder.toUtf8());
}

bool has_display() {
  return qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
}

Arguments::Arguments(const QString& command, const QString& description) : command_(command) {
  parser_.setApplicationDescription(description);
  parser_.addOption({{"h", "help"}, Cli::tr("Show this help.")});
  option("seed", Cli::tr("Seed of everything random."), "N", "1");
  option("json", Cli::tr("Write the figures to this file, as one flat JSON object."), "FILE");
}

void Arguments::positional(const QString& name, const QString& description, const QString& syntax) {
  parser_.addPositionalArgument(name, description, syntax);
  takes_positionals_ = true;
}
void Arguments::option(const QString& name, const QString& description, const QString& value_name,
                       const QString& fallback) {
  const QString shown =
      fallback.isEmpty() ? description : description + Cli::tr(" Default: %1.").arg(fallback);
  parser_.addOption({name, shown, value_name, fallback});
}
void Arguments::flag(const QString& name, const QString& description) {
  parser_.addOption({name, description});
  flags_ << name;
}

void Arguments::option_with_usual_value(const QString& name, const QString& description,
                                        const QString& value_name) {
  option(name, description, value_name);
  may_stand_alone_ << QStringLiteral("--") + name;
}

bool Arguments::parse(const QStringList& given) {
  QStringList arguments = given;  // Qt's parser knows of no such options
  for (qsizetype i = 0; i < arguments.size(); ++i)
    if (may_stand_alone_.contains(arguments[i]) &&
        (i + 1 == arguments.size() || arguments[i + 1].startsWith(QLatin1String("--"))))
      arguments[i] += QLatin1Char('=');
  if (!parser_.parse(QStringList("glisson " + command_) + arguments)) {
    QString told = parser_.errorText();
    if (told.endsWith(QLatin1Char('.'))) told.chop(1);
    throw UsageError(told.toStdString() + ". See 'glisson " + command_.toStdString() + " --help'.");
  }
  if (!parser_.isSet("help")) {
    refuse_slips();
    if (!takes_positionals_ && !positionals().isEmpty())
      throw UsageError(positionals().front().toStdString() + ": is no option of 'glisson " +
                       command_.toStdString() + "'. See 'glisson " + command_.toStdString() + " --help'.");
    // A folder that the command itself will make is a good place too.
    const fs::path folder = path("json").parent_path();
    const bool made_here =
        parser_.optionNames().contains("out") && !folder.empty() && is_same_place(folder, path("out"));
    if (has("json") && !made_here) output_file("json");
    return true;
  }
  QString help = parser_.helpText();
  // Only where Qt names the program, in the first line: "NAME.glisson" holds the same word.
  const QString program = QCoreApplication::arguments().value(0);
  help.replace(help.indexOf(program), program.size(), "glisson " + command_);
  std::fputs(help.toUtf8().constData(), stdout);
  return false;
}

void Arguments::refuse_slips() const {
  if (positionals().contains(QString()))
    throw UsageError(
        Cli::tr("glisson %1: an argument is empty. See 'glisson %1 --help'.").arg(command_).toStdString());
  const QStringList names = parser_.optionNames();
  for (const QString& name : names) {
    if (names.count(name) > 1)
      throw UsageError(Cli::tr("--%1: is given twice. Leave one of them out.").arg(name).toStdString());
    if (flags_.contains(name) || may_stand_alone_.contains(QStringLiteral("--") + name)) continue;
    // The next option is taken for the value of one that has none.
    if (value(name).isEmpty() || value(name).startsWith(QLatin1String("--")))
      throw UsageError(
          Cli::tr("--%1: has no value. See 'glisson %2 --help'.").arg(name, command_).toStdString());
  }
}

fs::path Arguments::required_path(const QString& name) const {
  if (!has(name) || value(name).isEmpty())
    throw UsageError("--" + name.toStdString() + ": is needed. See 'glisson " + command_.toStdString() +
                     " --help'.");
  return path(name);
}

fs::path Arguments::output_file(const QString& name, const QStringList& endings) const {
  const fs::path file = required_path(name);
  require_place_for(file);
  refuse_shared_place(name);
  const auto fits = [&](const QString& ending) { return value(name).endsWith(ending, Qt::CaseInsensitive); };
  if (!endings.isEmpty() && std::none_of(endings.begin(), endings.end(), fits))
    throw UsageError("--" + name.toStdString() + " " + file.string() + ": must end in " +
                     endings.join(", ").toStdString() + ".");
  return file;
}

void Arguments::refuse_shared_place(const QString& name) const {
  const auto refuse = [&](const QString& other) {
    throw UsageError(Cli::tr("--%1 %2: %3 is the same file. Choose another name.")
                         .arg(name, value(name), other)
                         .toStdString());
  };
  QStringList others = parser_.optionNames();
  others.removeDuplicates();
  for (const QString& other : others)
    if (other != name && !value(other).isEmpty() && is_same_place(path(name), path(other)))
      refuse(QStringLiteral("--") + other);
  for (const QString& given : positionals())
    if (is_same_place(path(name), given.toStdString())) refuse(given);
}

void Arguments::refuse_idle(const QString& beside, const QStringList& idle) const {
  for (const QString& name : idle)
    if (has(name))
      throw UsageError(Cli::tr("--%1: means nothing with %2. Leave it out.").arg(name, beside).toStdString());
}

void Arguments::refuse_without(const QString& needed, const QStringList& idle) const {
  if (has(needed)) return;
  for (const QString& name : idle)
    if (has(name))
      throw UsageError(
          Cli::tr("--%1: means nothing without --%2. Leave it out.").arg(name, needed).toStdString());
}

void Arguments::require_existing(const QString& name) const {
  if (has(name) && !fs::exists(path(name)))
    throw FileError(path(name).string() + ": does not exist. Check --" + name.toStdString() + ".");
}

double Arguments::number(const QString& name, double low, double high) const {
  return numbers(name, 1, low, high).front();
}

std::vector<double> Arguments::numbers(const QString& name, int count, double low, double high) const {
  const QStringList parts = value(name).split(QLatin1Char(','));
  bool good = parts.size() == count;
  std::vector<double> found;
  for (const QString& part : parts) {
    bool is_number = false;
    found.push_back(QLocale::c().toDouble(part, &is_number));
    good = good && is_number && std::isfinite(found.back()) && found.back() >= low && found.back() <= high;
  }
  if (good) return found;
  const std::string least = QString::number(low).toStdString(), most = QString::number(high).toStdString(),
                    told = "--" + name.toStdString() + " " + value(name).toStdString();
  if (count == 1) throw UsageError(told + ": must be a number from " + least + " to " + most + ".");
  throw UsageError(told + ": must be " + std::to_string(count) + " numbers between commas, each from " +
                   least + " to " + most + ".");
}

int Arguments::integer(const QString& name, int low, int high) const {
  const double found = number(name, low, high);
  if (found != std::floor(found))
    throw UsageError("--" + name.toStdString() + " " + value(name).toStdString() +
                     ": must be a whole number.");
  return static_cast<int>(found);
}

LengthUnit Arguments::unit(const QString& name) const {
  const std::string code = value(name).toStdString();
  if (const auto unit = unit_named(code)) return *unit;
  throw UsageError("--" + name.toStdString() + " " + code + ": must be mm, cm or m.");
}

QStringList Arguments::positionals(int low, int high) const {
  const QStringList given = parser_.positionalArguments();
  if (given.size() >= low && given.size() <= high) return given;
  const std::string wanted = std::to_string(low) + (high > low ? "-" + std::to_string(high) : "");
  throw UsageError("glisson " + command_.toStdString() + ": " + std::to_string(given.size()) +
                   " arguments were given besides the options, " + wanted + " is needed. See 'glisson " +
                   command_.toStdString() + " --help'.");
}

std::uint64_t Arguments::seed() const {
  bool good = false;
  const std::uint64_t seed = value("seed").toULongLong(&good);
  if (!good) throw UsageError("--seed " + value("seed").toStdString() + ": must be a whole number from 0.");
  return seed;
}

Session::Session(const Arguments& arguments)
    : arguments_(arguments),
      context_(
          [this](double fraction, std::string_view stage) {
            const QString doing = command_.empty() ? QString() : ui::command_text(command_) + ": ";
            show_progress(fraction, doing + ui::stage_text(stage));
          },
          interrupt_flag(), arguments.seed()),
      script_(context_),
      begin_(std::chrono::steady_clock::now()),
      log_(log_to_file(log_folder())) {}

engine::Outcome Session::post(engine::Command command) {
  command_ = command.code();
  std::optional<engine::Outcome> outcome;
  with_names([&] { outcome = script_.run(std::move(command)); });
  if (!outcome) throw Interrupted();
  engine::log_outcome(log_, *outcome, ui::logged_error);
  clear_progress();
  for (const auto& [key, value] : outcome->figures) figures[key] = value;
  figures["seconds_" + outcome->command] = outcome->seconds;
  for (const std::string& note : outcome->notes)  // what an import tells its model may tell, too
    if (std::ranges::find(notes, note) == notes.end()) notes.push_back(note);
  return *outcome;
}

void Session::need(const engine::Needs& parts) const {
  with_names([&] { engine::require_parts(state(), parts); });
}

void Session::with_names(const std::function<void()>& work) const {
  try {
    work();
  } catch (const Interrupted&) {
    throw;
  } catch (const Error& failure) {
    const std::string sentence = failure.what();
    log_.write(LogLevel::error, command_ + ' ' + ui::logged_error(sentence));
    for (const auto& [name, files] : files_of_)
      if (sentence.starts_with(name + ": ")) throw Error(files + sentence.substr(name.size()));
    throw;
  } catch (const std::exception& failure) {
    const std::string sentence = sentence_of(failure, command_);
    log_.write(LogLevel::error, command_ + ' ' + ui::logged_error(sentence));
    throw Error(sentence);
  }
}

OverlayFrame Session::follow(engine::LiveInput input, double fraction) {
  auto overlay = script_.follow(std::move(input));
  if (!overlay) throw Interrupted();
  show_progress(fraction, Cli::tr("frame %1").arg(overlay->index));
  return *overlay;
}

void Session::tell(const Figures& more) {
  for (const auto& [key, value] : more) figures[key] = value;
}

void Session::attempt(const std::function<void()>& work) {
  try {
    work();
  } catch (...) {
    if (!failure_) failure_ = std::current_exception();
  }
}

void Session::finish() {
  figures["seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  for (const std::string& note : notes) say(Cli::tr("note: ") + ui::note_text(note));
  for (const auto& [key, value] : figures)
    say(QString("%1 %2")
            .arg(QString::fromStdString(key), -36)
            .arg(std::isfinite(value) ? QString::number(value, 'g', 6) : Cli::tr("unknown")));
  // Last, where the person looks: what was written where.
  for (const auto& [key, value] : texts)
    say(QString("%1 %2").arg(QString::fromStdString(key), -36).arg(QString::fromStdString(value)));
  if (arguments_.has("json")) write_figures(arguments_.path("json"), figures, texts);
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

}  // namespace glisson::app
