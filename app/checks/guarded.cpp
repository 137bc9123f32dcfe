// Pictures in further looks, as a preset's file lists them: other themes, sizes and formats.

#include "app/checks/causes.h"
#include "app/checks/pictured.h"
#include "app/checks/text_difference.h"
#include "app/figures/figure_maker.h"

namespace isect::program {

namespace {

using Kind = Failure::Kind;

Style style_of_guard(const Guard& guard) {
  StyleOptions options;
  options.theme = guard.theme, options.size = guard.size, options.width = guard.width;
  options.format = guard.format == "png" ? "svg" : guard.format;  // of pixels only the drawing is asked for here
  return style_of(options);
}

}  // namespace

void Baselines::check_guard(const Excerpt& e, const Guard& guard, const std::vector<viz::Change>& changes,
                            std::vector<Failure>& found) {
  const Style style = style_of_guard(guard);
  FigureMaker maker(style, "auto");
  for (int step = 0; step < static_cast<int>(e.walk.steps.size()); ++step) {
    if (!has_picture(e, step)) continue;
    Pictured p = pictured(e, step, &guard);
    p.style = style.words;
    if (need_no_drawing(p, found)) continue;
    try {
      const viz::Drawing drawing = maker.draw(e, step);
      if (guard.format == "png") {
        check_picture(p, drawing, changes, found);
      } else {
        FigureInfo info = info_of(e, step);
        info.metadata = kept_metadata(p);
        check_text(p, maker.write(info, drawing, viz::format_named(guard.format)), changes, found);
      }
    } catch (const viz::BadInput& error) {  // the labels meet, say, however wide it is made
      found.push_back(about(p, failure(Kind::preset, error.what(), p.baseline)));
    }
  }
}

void Baselines::check_text(const Pictured& p, const std::string& now, const std::vector<viz::Change>& changes,
                           std::vector<Failure>& found) {
  std::optional<Failure> f;
  try {
    if (!viz::is_there(p.baseline)) {
      f = failure(Kind::missing, "no picture was accepted yet", p.baseline);
    } else if (std::string was = viz::read_regular_file(p.baseline); is_lfs_pointer(was)) {
      f = lfs_pointer(p.baseline);
    } else if (was != now) {
      const TextDifference difference = first_difference(was, now);
      f = failure(Kind::text, in_words(difference), p.baseline);
      f->line = difference.line;
      if (const std::string cause = cause_of_picture(changes, p.step); cause != only_pixels) f->cause = cause;
      f->accepted_file = std::move(was);
    }
  } catch (const viz::FileError& error) {
    f = failure(Kind::unreadable, error.what(), p.baseline);
  }
  conclude(
      p, std::move(f), [&] { return now; }, [](const Failure&) { return std::string(); }, found);
}

}  // namespace isect::program
