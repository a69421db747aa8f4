// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/common/named_video_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QStringList>
#include <cstddef>
#include <memory>

#include "glisson/core/printable.h"
#include "glisson/engine/commands/set_video.h"
#include "glisson/engine/parts/named_video.h"
#include "glisson/ui/common/engine_bridge.h"

namespace glisson::ui {
namespace {

/// Context of these sentences for translators.
class NamedVideoQuestion {
  Q_DECLARE_TR_FUNCTIONS(NamedVideoQuestion)
};

/// One a line; what the case brought along must not look like words of the window.
QString lines_of(const std::vector<std::string>& sources) {
  constexpr std::size_t kLongest = 1000;
  QStringList lines;
  for (const std::string& source : sources) lines << QString::fromStdString(printable(source, kLongest));
  return lines.join(QLatin1Char('\n'));
}

void ask(QWidget* parent, EngineBridge& engine) {
  const std::shared_ptr<const engine::VideoSource> named = engine.state()[part::named_video];
  auto* box = new QMessageBox(
      QMessageBox::Question, NamedVideoQuestion::tr("Pictures named by the case"),
      NamedVideoQuestion::tr("The case names these pictures. It chose them, nobody on this computer has:") +
          QStringLiteral("\n\n") + lines_of(engine::named_sources(engine.state())),
      QMessageBox::NoButton, parent);
  box->setTextFormat(Qt::PlainText);
  box->setObjectName(QStringLiteral("named_video_question"));
  box->setInformativeText(
      NamedVideoQuestion::tr("Open them only if you trust the case. Left out, they stay named in the case, "
                             "and you can open pictures at any time (Stereo > Open)."));
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* open = box->addButton(NamedVideoQuestion::tr("Open the pictures"), QMessageBox::AcceptRole);
  open->setObjectName(QStringLiteral("named_video_open"));
  QPushButton* leave = box->addButton(NamedVideoQuestion::tr("Leave them out"), QMessageBox::RejectRole);
  leave->setObjectName(QStringLiteral("named_video_leave"));
  box->setDefaultButton(leave);
  box->setEscapeButton(leave);
  QObject::connect(open, &QPushButton::clicked, parent, [&engine, named] {
    if (engine.state()[part::named_video] == named)  // of the case that is open still
      engine.post(engine::SetVideo{named->left, named->right});
  });
  box->open();
}

}  // namespace

std::vector<std::string> ask_named_video(QWidget* parent, EngineBridge& engine,
                                         const engine::Outcome& outcome) {
  std::vector<std::string> notes = outcome.notes;
  const auto& named = engine.state()[part::named_video];
  if (outcome.status != engine::Status::done || !outcome.traits.replaces_case() || !named ||
      !engine::is_there(*named))
    return notes;
  ask(parent, engine);
  std::erase_if(notes, [](const std::string& note) { return note.starts_with("case.video_lost "); });
  return notes;
}

}  // namespace glisson::ui
