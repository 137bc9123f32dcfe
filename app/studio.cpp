#include "app/studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/ownership.h"
#include "viz/alt_text.h"
#include "viz/crop.h"
#include "viz/paper.h"

namespace isect::program {

namespace {

constexpr double points_a_cm = 72 / 2.54;

/// The walks of all presets, made once for each lesson: presets stay as they are.
const std::vector<viz::Walk>& walks_of(const viz::Lesson& lesson) {
  static std::map<const viz::Lesson*, std::vector<viz::Walk>> known;
  std::vector<viz::Walk>& walks = known[&lesson];
  if (walks.empty())
    for (const viz::Preset& p : lesson.presets) walks.push_back(lesson.walk(p.parameters));
  return walks;
}

viz::Figure composed(const Excerpt& e, int step, const viz::PageLayout& layout) {
  return viz::figure(e.walk.steps[step], camera_for(e, step, layout.width / layout.picture_height()), layout);
}

void need_pixels_in_bounds(const viz::Drawing& drawing, double scale) {
  constexpr double most = 1 << 26;
  const double pixels = drawing.width * drawing.height * scale * scale;
  if (pixels > most)
    throw viz::BadInput(
        fmt::format("dpi: {:.0f} make a picture of {:.0f} million pixels, and {:.0f} million are the "
                    "most; give fewer, or --format svg or pdf",
                    72 * scale, pixels / 1e6, most / 1e6));
}

}  // namespace

viz::Camera camera_for(const Excerpt& e, int step, double aspect) {
  if (e.camera) return *e.camera;
  const viz::Camera framed = viz::frame_alike(viz::opening(*e.lesson), e.walk, walks_of(*e.lesson), aspect);
  return viz::closer(framed, e.walk.steps[step].scene, aspect);
}

Studio::Studio(const Style& style, const std::string& backend) : style_(style) {
  const viz::Backend wanted = viz::backend_named(backend);
  if (std::ranges::any_of(style.formats, &viz::Format::pixels)) offscreen_ = std::make_unique<viz::Offscreen>(wanted);
}

viz::Drawing Studio::draw(const Excerpt& e, int step) {
  const viz::PageLayout page =
      viz::page_layout(e.walk, style_.theme, style_.size.width, style_.size.height, style_.title);
  viz::Drawing drawing = style_.paper ? on_paper(e, step).drawing : composed(e, step, page).drawing;
  if (style_.crop) drawing = viz::cropped(drawing, style_.paper ? 1 : page.theme.sizes.margin);
  if (style_.transparent) drawing.background.a = 0;
  return drawing;
}

viz::Figure Studio::on_paper(const Excerpt& e, int step) {
  const auto camera = [&](double aspect) { return camera_for(e, step, aspect); };
  auto made = viz::readable_figure(e.walk, step, style_.theme, *style_.paper, style_.title, camera);
  if (!made)
    throw viz::BadInput(
        fmt::format("width: at {:.1f} cm the labels of {} meet or leave it, and at 8 times that, too; "
                    "give more, or a smaller --text-size",
                    style_.paper->width / points_a_cm, file_of(e, step)));
  if (made->size.width > style_.paper->width)
    widened_.push_back(fmt::format("{}: {:.1f} cm", file_of(e, step), made->size.width / points_a_cm));
  return std::move(made->figure);
}

std::string Studio::write(const Excerpt& e, int step, const viz::Drawing& drawing, const viz::Format& format) {
  viz::Imprint imprint;
  imprint.title = viz::figure_title(*e.lesson, e.walk.steps[step]);
  imprint.alt = viz::alt_text(*e.lesson, e.parameters, e.walk, step);
  imprint.letters = style_.letters;
  if (style_.paper) imprint.width_pt = drawing.width, imprint.dpi = style_.dpi;
  const double scale = style_.paper ? style_.dpi / 72 : 1;
  if (format.pixels) need_pixels_in_bounds(drawing, scale);
  return format.write(drawing, metadata_of(e, step), imprint,
                      [&](const viz::Drawing& d) { return offscreen_->render(d, scale); });
}

std::string Studio::renderer(const viz::Format& format) const { return format.pixels ? offscreen_->driver() : "cairo"; }

}  // namespace isect::program
