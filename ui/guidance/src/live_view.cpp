// SPDX-License-Identifier: GPL-3.0-or-later
#include "glisson/ui/guidance/live_view.h"

#include <QBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "glisson/ui/common/panel.h"
#include "glisson/ui/common/save_name.h"

namespace glisson::ui {
namespace {

constexpr int kLinesHeight = 56;  ///< three lines of the live view's words, pixels

}  // namespace

LiveView::LiveView(LiveViewModel& model, ReviewModel& review, CorrectionModel& correction, AgainModel& again,
                   MomentsModel& moments, QWidget* parent)
    : QWidget(parent),
      model_(model),
      review_(review),
      correction_(correction),
      again_(again),
      moments_(moments),
      timeline_(new TimelineBar(review, this)),
      picture_(new LivePicture({}, this)),
      right_(new LivePicture(tr("Right"), this)),
      raw_(new PictureView(tr("Raw"), this)) {
  setObjectName(QStringLiteral("guidance_view"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* banner = new QLabel(this);
  banner->setProperty("role", "banner");
  banner->setWordWrap(true);
  layout->addWidget(banner);
  auto* leave = new QPushButton(tr("Back to live (Esc)"), this);
  leave->setObjectName(QStringLiteral("leave_kept_moment"));
  leave->setFocusPolicy(Qt::NoFocus);  // the keys belong to the picture
  layout->addWidget(leave);
  connect(leave, &QPushButton::clicked, &moments, &MomentsModel::go_live);
  couplings_.add(moments.shown, [leave](int number) { leave->setVisible(number != 0); });
  layout->addLayout(make_pictures(), 1);
  auto* line = new QLabel(this);
  line->setProperty("role", "probe");
  line->setContentsMargins(10, 4, 10, 4);
  // A reason takes a second line on small screens, in German a third: there is always room for it, so that
  // nothing jumps.
  line->setWordWrap(true);
  line->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  line->setMinimumHeight(kLinesHeight);
  layout->addWidget(line);
  layout->addWidget(timeline_);
  add_buttons();
  show_picture();

  connect(picture_, &LivePicture::clicked, &model, &LiveViewModel::choose_at);
  connect(picture_, &LivePicture::pointed, &model,
          [&model](const Eigen::Vector2d& pixel) { model.point_at(pixel); });
  connect(picture_, &LivePicture::left, &model, [&model] { model.point_at({}); });
  connect(picture_, &LivePicture::marked, &model, &LiveViewModel::mark_at);
  join_correction(picture_, StereoView::left);
  join_correction(right_, StereoView::right);
  connect(&model, &LiveViewModel::picture_changed, this, &LiveView::show_picture);
  connect(picture_, &PictureView::drawn, &model, &LiveViewModel::note_drawn);
  couplings_.add(model.banner, [banner](const QString& text) { show_warning(*banner, text); });
  couplings_.add(model.mark, [this](const QString& words) {
    picture_->set_mark(words);
    right_->set_mark(words);
  });
  couplings_.add(model.line, [line](const QString& text) { line->setText(text); });
  couplings_.add(model.is_fresh, [line](const QVariant& is) { set_style_property(line, "fresh", is); });
}

QLayout* LiveView::make_pictures() {
  picture_->set_hint(
      tr("Register the model to a frame of the laparoscope; the augmented picture appears here."));
  pictures_ = new QHBoxLayout;
  pictures_->setSpacing(2);
  raw_->setObjectName(QStringLiteral("raw_picture"));
  raw_->hide();
  right_->setObjectName(QStringLiteral("right_picture"));
  right_->set_hint(tr("There is no right picture of this frame."));
  right_->hide();
  pictures_->addWidget(picture_, 1);
  pictures_->addWidget(right_, 1);
  pictures_->addWidget(raw_, 1);
  return pictures_;
}

void LiveView::add_buttons() {
  show_raw_ = add_button("show_raw", tr("Raw"), tr("The raw picture beside the overlay (B)"));
  show_raw_->setCheckable(true);
  show_right_ =
      add_button("show_right", tr("Right"),
                 tr("The right picture with its overlay: a wrong depth shows in one of the two (V)"));
  show_right_->setCheckable(true);
  QToolButton* save = add_button("save_picture", tr("Picture…"), tr("Save the picture as it is drawn (P)"));
  QToolButton* whole = add_button("whole_screen", QStringLiteral("F11"), tr("Whole screen (F11)"));
  connect(show_raw_, &QToolButton::toggled, this, [this](bool on) {
    raw_->setVisible(on);
    raw_->set_picture(model_.on_screen().raw);
  });
  connect(show_right_, &QToolButton::toggled, this, [this](bool on) {
    right_->setVisible(on);
    tell_screen();
  });
  connect(save, &QToolButton::clicked, this, &LiveView::save_picture);
  connect(whole, &QToolButton::clicked, this, &LiveView::switch_whole_screen);
}

void LiveView::join_correction(LivePicture* picture, StereoView view) {
  connect(picture, &LivePicture::taken_hold, &correction_, [this, view](const Eigen::Vector2d& pixel) {
    if (!model_.shows_kept()) correction_.grab(pixel, view);  // the organ is elsewhere by now
  });
  connect(picture, &LivePicture::held_at, &correction_, &CorrectionModel::drag_to);
  connect(picture, &LivePicture::let_go, &correction_, &CorrectionModel::let_go);
  couplings_.add(correction_.is_correcting, [picture](bool is) { picture->set_correcting(is); });
  couplings_.add(correction_.line, [picture, view](const std::optional<CorrectionModel::Line>& drag) {
    const bool is_here = drag && drag->view == view;
    picture->set_drag_line(is_here ? std::optional(std::pair(drag->from, drag->to)) : std::nullopt);
  });
}

QToolButton* LiveView::add_button(const char* name, const QString& text, const QString& tip) {
  auto* button = new QToolButton(this);
  button->setObjectName(QLatin1String(name));
  button->setText(text);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::NoFocus);
  timeline_->add_at_end(button);
  return button;
}

void LiveView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

void LiveView::arrange() {
  const Picture& shown = model_.picture();
  if (shown.empty() || size().isEmpty()) return;
  // By the whole view: what is said above and below the pictures comes and goes.
  const double across = static_cast<double>(width()) / shown.width,
               down = static_cast<double>(height()) / shown.height;
  const bool beside = std::min(0.5 * across, down) >= std::min(across, 0.5 * down);
  pictures_->setDirection(beside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

void LiveView::show_picture() {
  const PaintedOverlay& shown = model_.on_screen();
  arrange();
  picture_->set_picture(shown.picture, shown.screen);
  if (show_raw_->isChecked()) raw_->set_picture(shown.raw, shown.raw_screen);
  if (show_right_->isChecked()) right_->set_picture(shown.right, shown.right_screen);
  tell_screen();
}

void LiveView::tell_screen() {
  if (whole_screen_ || model_.picture().empty()) return;  // the larger one decides
  model_.set_screen(picture_->screen_size({model_.picture().width, model_.picture().height}),
                    show_raw_->isChecked(), show_right_->isChecked());
}

void LiveView::keyPressEvent(QKeyEvent* event) {
  // Only what steps through frames goes on while its key is held: all else would begin and end by turns.
  const bool is_step = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
  if (event->isAutoRepeat() && !is_step) return;
  switch (event->key()) {
    case Qt::Key_Escape:
      if (correction_.line.value()) return correction_.give_up();
      if (model_.shows_kept()) return moments_.go_live();
      isFullScreen() ? void(close()) : model_.let_go();
      return;
    case Qt::Key_F11:
      return switch_whole_screen();
    case Qt::Key_B:
      return show_raw_->toggle();
    case Qt::Key_V:
      return show_right_->toggle();
    case Qt::Key_P:
      return save_picture();
    case Qt::Key_K:
      return moments_.keep();
    case Qt::Key_C:
      if (correction_.is_offered && !model_.shows_kept())
        correction_.is_correcting = !correction_.is_correcting;
      return;
    case Qt::Key_R:
      return again_.start_or_cancel();
    case Qt::Key_Z:
      if (event->modifiers().testFlag(Qt::ControlModifier)) return correction_.undo();
      return QWidget::keyPressEvent(event);
    default:
      if (!timeline_->press(event->key(), event->modifiers())) QWidget::keyPressEvent(event);
  }
}

LiveView::~LiveView() { delete whole_screen_; }

void LiveView::switch_whole_screen() {
  if (isFullScreen()) {
    close();
    return;
  }
  if (whole_screen_ && whole_screen_->isVisible()) {  // one that was closed may still be on its way out
    whole_screen_->close();
    return;
  }
  whole_screen_ = new LiveView(model_, review_, correction_, again_, moments_);
  whole_screen_->setAttribute(Qt::WA_DeleteOnClose);
  whole_screen_->setObjectName(QStringLiteral("whole_screen_view"));
  whole_screen_->setWindowTitle(window()->windowTitle());  // whose case it is
  connect(window(), &QWidget::windowTitleChanged, whole_screen_, &QWidget::setWindowTitle);
  window()->installEventFilter(this);
  whole_screen_->showFullScreen();
  whole_screen_->picture_->setFocus();
}

bool LiveView::eventFilter(QObject* watched, QEvent* event) {
  // The picture would stay, and the program with it, when its window is closed; not when that is minimised.
  if (event->type() == QEvent::Hide && !event->spontaneous() && watched == window() && whole_screen_)
    whole_screen_->close();
  return QWidget::eventFilter(watched, event);
}

void LiveView::save_picture() {
  const Picture held = model_.picture();  // the video goes on while the dialog asks
  const QString path = ask_where_to_save(
      this, tr("Save the picture"), QStringLiteral("frame_%1.png").arg(model_.shown_index()),
      tr("Pictures (*.png *.jpg)"),
      {QStringLiteral(".png"), QStringLiteral(".jpg"), QStringLiteral(".jpeg")});
  if (path.isEmpty()) return;
  const QString error = LiveViewModel::save_picture(held, path);
  if (!error.isEmpty()) QMessageBox::warning(this, tr("Save the picture"), error);
}

}  // namespace glisson::ui
