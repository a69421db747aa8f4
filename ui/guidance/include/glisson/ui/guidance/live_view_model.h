// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QProperty>
#include <QTimer>
#include <QVariant>
#include <cstdint>
#include <deque>
#include <optional>

#include "glisson/ui/common/couplings.h"
#include "glisson/ui/common/drawable_source.h"
#include "glisson/ui/common/figures_table.h"
#include "glisson/ui/guidance/lesion_rows.h"
#include "glisson/ui/guidance/overlay_worker.h"
#include "glisson/ui/guidance/playback_model.h"
#include "glisson/ui/guidance/review_model.h"
#include "glisson/ui/guidance/screen_times.h"

namespace glisson::engine {
struct KeptMoment;
}

namespace glisson::ui {

/// Which picture is to be drawn, and what is said of the one on the screen: live, frozen, of the registered
/// frame, or none. Nothing of a former case or a former playing is ever shown as of the present one.
class LiveViewModel : public QObject {
  Q_OBJECT
 public:
  /// All outlive this.
  LiveViewModel(EngineBridge& engine, DrawableSource& drawables, PlaybackModel& playback, ReviewModel& review,
                OverlayWorker& worker, QObject* parent = nullptr);

  const scene::OverlayStyle& style() const { return style_; }
  void set_style(const scene::OverlayStyle& style);
  /// The lesion whose numbers are told; 0: none.
  void choose(Label lesion);
  /// The one at a pixel of the picture on the screen; beside all of them: none.
  void choose_at(const Eigen::Vector2d& pixel);
  /// Marks the place of the organ's surface at a pixel, where a tool touches it, say; beside the organ: takes
  /// the mark away. Where there is one lesion only it is chosen.
  void mark_at(const Eigen::Vector2d& pixel);
  /// Marks a place that a tracked tool touches; empty: it has let go, and its mark goes. What a hand has
  /// marked stays until a tool touches.
  void touch(const std::optional<guidance::SurfacePlace>& place);
  /// Where the pointer is on the picture; empty: elsewhere. The focus follows it.
  void point_at(const std::optional<Eigen::Vector2d>& pixel);
  /// Neither a lesion nor a mark.
  void let_go();
  /// A place of the organ to be looked at over the registered picture, as an outline, instead of where the
  /// registration has put it, and instead of the last picture of what was followed. Camera's frame, metres.
  struct Proposed {
    Points nodes;
    QString line;  ///< what is said of it below the picture
  };
  void propose(std::optional<Proposed> proposed);
  /// Outline and margin are shown as a proposal where surfaces speak against the live organ's place, so that
  /// a hand can take hold of them and correct it.
  void show_refuted(bool on);
  /// A moment that was kept, with its pictures as they were taken.
  struct Kept {
    std::shared_ptr<const engine::KeptMoment> moment;
    Picture left, right;
  };
  /// Shows it as it was, marked as not live, until it is put away (empty). What is live goes on unseen, and
  /// into a recording.
  void show_kept(std::optional<Kept> kept);
  bool shows_kept() const { return kept_.has_value(); }
  /// The one on the screen; empty: none.
  const Picture& picture() const { return on_screen_.picture; }
  /// The same, with the raw picture, and both ready for the screen.
  const PaintedOverlay& on_screen() const { return on_screen_; }
  /// From now on pictures are made ready for a view of this size, in the screen's pixels.
  /// @param with_raw the raw picture, too. @param with_right the right one with its overlay likewise.
  void set_screen(const QSize& size, bool with_raw, bool with_right);
  /// A view has painted the picture that is on the screen.
  void note_drawn();
  /// From the camera to the screen, of this playing.
  const ScreenTimes& screen_times() const { return screen_times_; }
  /// Writes it (.png, .jpg). @return what went wrong; empty: nothing.
  static QString save_picture(const Picture& held, const QString& path);
  /// Of the picture on the screen, where it is one of a video that is or was followed: live, a former or the
  /// last frame. Null: the registered frame, a kept moment or no picture is there. Until the next picture.
  const OverlayFrame* followed() const;
  /// Of the frame on the screen.
  int shown_index() const { return shown_.index; }
  /// The picture on the screen is of now; else it says itself that it is not.
  bool shows_live() const { return shows_live_; }
  /// Augmented pictures shown so far.
  int pictures_shown() const { return pictures_shown_; }

  // For widgets to read.
  QProperty<QString> banner;      ///< above the picture; empty: none
  QProperty<QString> line;        ///< below it
  QProperty<QString> mark;        ///< in the picture, for who looks at nothing else; empty: none
  QProperty<QVariant> is_fresh;   ///< whether it shows where things are now; invalid: there is no picture
  QProperty<FigureRows> figures;  ///< of the live picture
  QProperty<LesionRows> lesions;  ///< of the picture on the screen
  QProperty<Label> chosen{0};     ///< lesion
  QProperty<FigureRows> numbers;  ///< of the chosen one

 signals:
  /// See on_screen().
  void picture_changed();
  /// A kept moment has given way to something else: a former frame, another case.
  void kept_put_away();
  /// A playing has ended, of which pictures were drawn.
  void times_told(const glisson::ui::ScreenTimes& times);

 private:
  bool draws_refuted(const OverlayFrame& overlay) const;
  void read_case();
  void show_live();
  bool is_live_stale() const;
  /// A proposed place stands over the registered frame, or does as soon as a kept moment is put away.
  bool shows_proposed() const;
  /// The last picture of what was followed stays, and no proposed place stands in its stead.
  bool shows_last_picture() const { return playback_.is_frozen && !shows_proposed(); }
  void show_registered();
  /// Of the registered frame. @pre there is a registration.
  std::vector<LesionVerdict> lesions_at_start(const OverlayFrame& overlay);
  void show_frozen();
  /// A former frame of this playing.
  void show_moment(const Moment& moment);
  /// What was on the screen before a former frame was.
  void show_present();
  void show_recorded(const OverlayFrame& overlay);
  void draw_kept();
  /// Nobody sees it, a recording has it.
  void draw_unseen(OverlayJob job);
  void tell_kept(const PaintedOverlay& painted);
  /// Without drawing anything in its place.
  void drop_kept();
  /// What is looked at in the picture on the screen.
  scene::OverlayInterest& interest() { return kept_ ? kept_interest_ : interest_; }
  /// Draws what is on the screen once more, in the present style. Live, the next picture has it anyway.
  void redraw();
  /// Nothing is shown: neither a picture nor what was said of it.
  void put_away();
  void submit(OverlayJob job);
  OverlayJob make_job();
  void show_painted(const PaintedOverlay& painted);
  void show_lesions(const PaintedOverlay& painted);
  void show_failed(const QString& message, int generation);
  void show_still(const OverlayFrame& overlay);
  void show_live_figures(const OverlayFrame& overlay, double draw);
  void tell_times();
  void show_freshness();
  /// Live pictures a second; 0: unknown yet.
  double rate() const;

  EngineBridge& engine_;
  DrawableSource& drawables_;
  PlaybackModel& playback_;
  ReviewModel& review_;
  OverlayWorker& worker_;
  Couplings couplings_;
  scene::OverlayStyle style_;
  scene::OverlayInterest interest_;            ///< of what is live
  std::optional<Kept> kept_;                   ///< on the screen, or about to be
  std::shared_ptr<const Points> kept_margin_;  ///< CT frame
  scene::OverlayInterest kept_interest_;
  bool is_kept_painted_ = false;
  std::uint64_t interest_of_ = 0;  ///< the case's number
  OverlayFrame shown_;             ///< of the picture on the screen
  QTimer freshness_;
  QElapsedTimer clock_, since_painted_, since_figures_;
  std::deque<qint64> painted_at_;  ///< milliseconds
  double last_age_ = 0.0;
  int pictures_shown_ = 0;
  bool was_tracking_ = false, shows_refuted_ = false, is_touched_ = false, shows_live_ = false;
  bool is_stale_ = false;  ///< what is followed, since a picture of it has come
  std::optional<Proposed> proposed_;
  std::optional<OverlayJob> job_;       ///< the last one
  std::optional<OverlayJob> live_job_;  ///< the last one of a live picture
  PaintedOverlay on_screen_;
  ScreenTimes screen_times_;
  std::optional<std::chrono::steady_clock::time_point>
      undrawn_;  ///< when the picture on the screen was taken
  QSize screen_;
  bool with_raw_ = false, with_right_ = false;
  int generation_ = 0;                    ///< pictures of former ones are not shown any more
  std::shared_ptr<const Points> margin_;  ///< CT frame
  std::shared_ptr<const model::BuiltModel> model_source_;
  std::shared_ptr<const Landmarks> landmarks_source_;
};

}  // namespace glisson::ui
