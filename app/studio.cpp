#include "app/studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/ownership.h"
#include "app/terminal.h"
#include "viz/closing.h"
#include "viz/crop.h"
#include "viz/strip.h"

namespace isect::program {

namespace {

constexpr double points_a_cm = 72 / 2.54;
constexpr double strip_gap = 1.5;  ///< between the figures of a strip, in their texts' size

std::string told(const std::string& which, double width) {
  return fmt::format("{}: {:.1f} cm", which, width / points_a_cm);
}

/// The walks of all presets, made once for each lesson: presets stay as they are.
const std::vector<viz::Walk>& walks_of(const viz::Lesson& lesson) {
  static std::map<const viz::Lesson*, std::vector<viz::Walk>> known;
  std::vector<viz::Walk>& walks = known[&lesson];
  if (walks.empty())
    for (const viz::Preset& p : lesson.presets) walks.push_back(lesson.walk(p.parameters));
  return walks;
}

viz::Figure composed(const Excerpt& e, int step, const viz::PageLayout& layout) {
  return viz::figure(e.walk.steps[step], camera_for(e, e.walk.steps[step], layout.width / layout.picture_height()),
                     layout);
}

/// On one line.
std::string with_caption(const viz::Lesson& lesson, const viz::Step& step) {
  std::string text = step.title + ". " + viz::own_caption(lesson, step);
  std::ranges::replace(text, '\n', ' ');
  return text;
}

/// All pictures of a file together.
void need_pixels_in_bounds(double pixels, const std::string& cure) {
  constexpr double most = 1 << 26;
  if (pixels > most)
    throw viz::BadInput(fmt::format("size: {:.0f} million pixels in one file, and {:.0f} million are the most; {}",
                                    pixels / 1e6, most / 1e6, cure));
}

}  // namespace

viz::Camera camera_for(const Excerpt& e, const viz::Step& step, double aspect) {
  if (e.camera) return *e.camera;
  const viz::Camera framed = viz::frame_alike(viz::opening(*e.lesson), e.walk, walks_of(*e.lesson), aspect);
  return viz::closer(framed, step.scene, aspect);
}

Studio::Studio(const Style& style, const std::string& backend) : style_(style) {
  const viz::Backend wanted = viz::backend_named(backend);
  if (std::ranges::any_of(style.formats, &viz::Format::pixels)) offscreen_ = std::make_unique<viz::Offscreen>(wanted);
}

viz::Drawing Studio::draw(const Excerpt& e, int step) {
  const viz::PageLayout page =
      viz::page_layout(e.walk, style_.theme, style_.size.width, style_.size.height, style_.title);
  viz::Drawing drawing;
  if (style_.paper) {
    viz::OnPaper made = on_paper(e, e.walk, step, *style_.paper, style_.title);
    if (made.size.width > style_.paper->width) widened_.push_back(told(file_of(e, step), made.size.width));
    drawing = std::move(made.figure.drawing);
  } else {
    drawing = composed(e, step, page).drawing;
  }
  if (style_.crop) drawing = viz::cropped(drawing, style_.paper ? 1 : page.theme.sizes.margin);
  if (style_.transparent) drawing.background.a = 0;
  return drawing;
}

std::vector<viz::Drawing> Studio::draw(const Excerpt& e, const std::vector<int>& steps) {
  std::vector<viz::Drawing> drawings;
  double width = 0, height = 0;
  for (const int step : steps) {
    drawings.push_back(draw(e, step));
    width = std::max(width, drawings.back().width), height = std::max(height, drawings.back().height);
  }
  for (viz::Drawing& drawing : drawings) {
    const viz::Vec2 by((width - drawing.width) / 2, (height - drawing.height) / 2);
    if (!by.isZero(0))
      for (viz::Shape& shape : drawing.shapes) viz::move(shape, by);
    drawing.width = width, drawing.height = height;
  }
  return drawings;
}

viz::OnPaper Studio::on_paper(const Excerpt& e, const viz::Walk& walk, int step, const viz::PaperSize& size,
                              bool title) {
  const auto camera = [&](double aspect) { return camera_for(e, walk.steps[step], aspect); };
  auto made = viz::readable_figure(walk, step, style_.theme, size, title, camera);
  if (!made)
    throw viz::BadInput(
        fmt::format("width: at {:.1f} cm the labels of {} meet or leave it, and at 8 times that, too; "
                    "give more, or a smaller --text-size",
                    size.width / points_a_cm, folder_of(e) + ", " + walk.steps[step].slug));
  return std::move(*made);
}

viz::Drawing Studio::draw_strip(const Excerpt& e, int columns, bool captions) {
  const viz::Theme theme = viz::paper_theme(style_.theme, style_.paper->text_size);
  const double gap = strip_gap * style_.paper->text_size;
  viz::PaperSize each = *style_.paper;
  each.width = (each.width - (columns - 1) * gap) / columns;
  const double asked = each.width;
  viz::Walk part = e.walk;  // rows that none of these steps needs take no room
  part.steps.clear();
  for (const int step : e.steps) part.steps.push_back(e.walk.steps[step]);
  std::vector<viz::Frame> frames;
  for (std::size_t i = 0; i < part.steps.size(); ++i) {  // as wide as the one that needs most
    viz::OnPaper made = on_paper(e, part, static_cast<int>(i), each, false);
    if (made.size.width > each.width) {
      each = made.size, frames.clear(), i = static_cast<std::size_t>(-1);
      continue;
    }
    const viz::Step& step = part.steps[i];
    frames.push_back({std::move(made.figure), captions ? with_caption(*e.lesson, step) : step.title});
  }
  viz::Drawing drawing = viz::strip(frames, columns, theme, gap).drawing;
  if (each.width > asked) widened_.push_back(told(folder_of(e), drawing.width));
  if (style_.transparent) drawing.background.a = 0;
  return drawing;
}

viz::Imprint Studio::imprint_of(const Piece& piece, const viz::Drawing& drawing) const {
  viz::Imprint imprint;
  imprint.title = piece.imprint, imprint.alt = piece.alt, imprint.letters = style_.letters;
  if (style_.paper) imprint.width_pt = drawing.width, imprint.dpi = style_.dpi;
  return imprint;
}

std::string Studio::write(const Piece& piece, const viz::Drawing& drawing, const viz::Format& format) {
  const double scale = pixels_a_unit();
  if (format.pixels)
    need_pixels_in_bounds(drawing.width * drawing.height * scale * scale,
                          "give a smaller --size or fewer --dpi, or --format svg or pdf");
  return format.write(drawing, piece.metadata, imprint_of(piece, drawing),
                      [&](const viz::Drawing& d) { return offscreen_->render(d, scale); });
}

std::string Studio::film(const Piece& piece, const std::vector<viz::Drawing>& drawings, double seconds,
                         const viz::Format& format) {
  const double scale = pixels_a_unit();
  const viz::Drawing& first = drawings.front();
  need_pixels_in_bounds(static_cast<double>(drawings.size()) * first.width * first.height * scale * scale,
                        "give a smaller --size, or fewer steps");
  std::vector<viz::Picture> pictures;
  for (const viz::Drawing& drawing : drawings)
    pictures.push_back(viz::pixels_of(drawing, [&](const viz::Drawing& d) { return offscreen_->render(d, scale); }));
  return format.film(pictures, seconds, piece.metadata, imprint_of(piece, first));
}

std::string Studio::renderer(const viz::Format& format) const { return format.pixels ? offscreen_->driver() : "cairo"; }

void say_widened(const Studio& studio) {
  const std::vector<std::string>& all = studio.widened();
  if (all.empty()) return;
  say(fmt::format("width: at this text size the labels of {} figure{} would meet or leave the picture, so {} wider:",
                  all.size(), all.size() == 1 ? "" : "s", all.size() == 1 ? "it is" : "they are"));
  constexpr std::size_t enough = 12;
  for (std::size_t i = 0; i < std::min(enough, all.size()); ++i) say("  " + all[i]);
  if (all.size() > enough) say(fmt::format("  and {} others; manifest.json has every width", all.size() - enough));
  say("Give a smaller --text-size to have them narrower.");
}

}  // namespace isect::program
