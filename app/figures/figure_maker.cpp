#include "app/figures/figure_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numeric>
#include <stdexcept>

#include "app/figures/cases.h"
#include "app/figures/ownership.h"
#include "app/shell/terminal.h"
#include "viz/compose/crop.h"
#include "viz/compose/strip.h"
#include "viz/formats/tikz.h"

namespace isect::program {

namespace {

constexpr double points_a_cm = 72 / 2.54;
constexpr double strip_gap = 1.5;  ///< between the figures of a strip, in their texts' size

/// Whether a figure in this format has its faces in a file of their own.
bool has_faces_apart(const viz::Drawing& drawing, const viz::Format& format) {
  return format.name == "tikz" && viz::count_faces(drawing) > viz::most_tikz_faces;
}

std::string told(const std::string& which, double width) {
  return fmt::format("{}: {:.1f} cm", which, width / points_a_cm);
}

/// Returns the walks of all presets, made once for each lesson: presets do not change.
const std::vector<viz::Walk>& walks_of(const viz::Lesson& lesson) {
  static std::map<const viz::Lesson*, std::vector<viz::Walk>> known;
  std::vector<viz::Walk>& walks = known[&lesson];
  if (walks.empty())
    for (const viz::Preset& p : lesson.presets) walks.push_back(lesson.walk(p.parameters));
  return walks;
}

/// Returns the camera of a shot, where `camera` is that of a step.
viz::Camera camera_of(const Excerpt& e, const Shot& shot, double aspect,
                      viz::Camera (*camera)(const Excerpt&, const viz::Step&, double aspect)) {
  const viz::Camera to = camera(e, e.walk.steps[shot.step], aspect);
  if (!(shot.share < 1)) return to;
  return viz::between(camera(e, e.walk.steps[shot.from], aspect), to, viz::ease_in_out(shot.share));
}

viz::Figure composed(const Excerpt& e, const Shot& shot, const viz::PageLayout& layout) {
  const double aspect = layout.width / layout.picture_height();
  return viz::figure(e.walk.steps[shot.step], camera_of(e, shot, aspect, camera_for), layout);
}

/// Throws viz::BadInput if all pictures of a file together have too many pixels.
void need_pixels_in_bounds(double pixels, const std::string& cure) {
  constexpr double most = 1 << 26;
  if (pixels > most)
    throw viz::BadInput(fmt::format("size: {:.0f} million pixels in one file, and {:.0f} million are the most; {}",
                                    pixels / 1e6, most / 1e6, cure));
}

// On paper a picture is twice as wide as it is high, or higher if it would leave much of that width empty.
constexpr double widest_shape = 2, highest_shape = 1.4;

double shape_of(const Excerpt& e, const viz::Walk& walk) {
  viz::Box2 all = {viz::Vec2::Constant(INFINITY), viz::Vec2::Constant(-INFINITY)};
  for (const viz::Step& step : walk.steps) {
    if (step.scene.items.empty()) continue;
    const viz::Box2 box = viz::extent(step.scene.items, e.camera.value_or(viz::opening(*e.lesson, step.view)));
    all = {all.lo.cwiseMin(box.lo), all.hi.cwiseMax(box.hi)};
  }
  const viz::Vec2 size = all.hi - all.lo;
  return size.y() > 0 && size.x() > 0 ? std::clamp(size.x() / size.y(), highest_shape, widest_shape) : widest_shape;
}

/// Puts each in the middle of a frame that holds the largest.
std::vector<viz::Drawing> equally_large(std::vector<viz::Drawing> drawings) {
  double width = 0, height = 0;
  for (const viz::Drawing& drawing : drawings)
    width = std::max(width, drawing.width), height = std::max(height, drawing.height);
  for (viz::Drawing& drawing : drawings) drawing = viz::centred(std::move(drawing), width, height);
  return drawings;
}

/// Returns the camera as camera_for does; but on paper, where room is scarce, a scene that is seen from nearer than the
/// others of its walk fills more of the picture.
viz::Camera paper_camera(const Excerpt& e, const viz::Step& step, double aspect) {
  constexpr double taken = 0.8;
  if (e.camera) return *e.camera;
  const viz::Camera framed = viz::frame_alike(viz::opening(*e.lesson, step.view), e.walk, walks_of(*e.lesson), aspect);
  const viz::Camera usual = viz::closer(framed, step.scene, aspect);
  if (!(usual.half_height < framed.half_height)) return viz::placed(step.view, usual);
  viz::Camera nearer = viz::frame(usual, {&step.scene}, aspect, 0);
  nearer.half_height = std::min(usual.half_height, nearer.half_height / taken);
  return viz::placed(step.view, nearer);
}

}  // namespace

viz::Camera camera_for(const Excerpt& e, const viz::Step& step, double aspect) {
  return e.camera ? *e.camera : viz::step_camera(*e.lesson, e.walk, walks_of(*e.lesson), step.view, step.scene, aspect);
}

FigureMaker::FigureMaker(const Style& style, const std::string& backend) : style_(style) {
  const viz::Backend wanted = viz::backend_named(backend);
  if (std::ranges::any_of(style.formats, &viz::Format::pixels)) offscreen_ = std::make_unique<viz::Offscreen>(wanted);
}

viz::Drawing FigureMaker::draw(const Excerpt& e, int step) { return draw(e, std::vector{step}).front(); }

std::vector<viz::Drawing> FigureMaker::draw(const Excerpt& e, const std::vector<int>& steps) {
  return draw(e, shots_of(steps));
}

std::vector<viz::Drawing> FigureMaker::draw(const Excerpt& e, const std::vector<Shot>& shots) {
  Drawings drawings = e.scaled_with ? draw_with_others(e, shots) : draw_alone(e, shots);
  if (style_.paper)
    tell_widened(shots.size() == 1 ? file_of(e, shots.front().step) : folder_of(e), drawings.front().width);
  for (viz::Drawing& drawing : drawings)
    if (style_.transparent) drawing.background.a = 0;
  return drawings;
}

std::vector<viz::Drawing> FigureMaker::draw_alone(const Excerpt& e, const std::vector<Shot>& shots) {
  if (style_.paper && style_.crop)
    return cropped_to_paper([&](const viz::PaperSize& size) { return whole(e, shots, size); });
  if (style_.paper) return whole(e, shots, *style_.paper);
  const viz::PageLayout page =
      viz::page_layout(e.walk, style_.theme, style_.size.width, style_.size.height, style_.title);
  Drawings drawings;
  for (const Shot& shot : shots) drawings.push_back(composed(e, shot, page).drawing);
  return style_.crop ? viz::cropped(std::move(drawings), page.theme.sizes.margin) : drawings;
}

std::vector<viz::Drawing> FigureMaker::draw_alike(Excerpts all) {
  const OneScale scale(all);
  if (style_.paper) {
    const auto at = [&](const viz::PaperSize& size) {
      Drawings drawings;
      for (viz::Figure& figure : equally_wide(
               scale.walk(), [&](int step) { return sight(scale, all, step); }, size, style_.title))
        drawings.push_back(std::move(figure.drawing));
      return equally_large(std::move(drawings));
    };
    return style_.crop ? cropped_to_paper(at) : at(*style_.paper);
  }
  const viz::PageLayout page =
      viz::page_layout(scale.walk(), style_.theme, style_.size.width, style_.size.height, style_.title);
  Drawings drawings;
  for (int step = 0; step < static_cast<int>(scale.walk().steps.size()); ++step)
    drawings.push_back(
        viz::figure(scale.walk().steps[step], scale.camera(step, page.width / page.picture_height()), page).drawing);
  return style_.crop ? viz::cropped(std::move(drawings), page.theme.sizes.margin) : drawings;
}

std::vector<viz::Drawing> FigureMaker::draw_with_others(const Excerpt& e, const std::vector<Shot>& shots) {
  const std::vector<Excerpt>& all = *e.scaled_with;
  const auto [found, is_new] = alike_.try_emplace(e.scaled_with);
  if (is_new) found->second = draw_alike(all);
  const auto own = all.begin() + static_cast<std::ptrdiff_t>(e.scaled_as);
  const std::size_t first = std::accumulate(
      all.begin(), own, std::size_t{0}, [](std::size_t sum, const Excerpt& other) { return sum + other.steps.size(); });
  Drawings drawings;
  for (const Shot& shot : shots) {
    const auto at = std::ranges::find(own->steps, shot.step);
    if (at == own->steps.end()) throw std::logic_error("this step is not among those at one scale");
    drawings.push_back(found->second[first + static_cast<std::size_t>(at - own->steps.begin())]);
  }
  return drawings;
}

std::vector<viz::Drawing> FigureMaker::whole(const Excerpt& e, const std::vector<Shot>& shots,
                                             const viz::PaperSize& size) {
  Drawings drawings(shots.size());
  std::map<int, viz::PaperSize> sizes;  // what is seen on the way has that of its step
  for (std::size_t i = shots.size(); i-- > 0;) {
    const Shot& shot = shots[i];
    if (!(shot.share < 1)) {
      viz::OnPaper made = on_paper(e.walk, shot.step, sight(e, e.walk, shot.step), size, style_.title);
      sizes[shot.step] = made.size;
      drawings[i] = std::move(made.figure.drawing);
      continue;
    }
    const viz::PageLayout page = viz::paper_layout(e.walk, shot.step, style_.theme, sizes.at(shot.step), style_.title);
    const double aspect = page.width / page.picture_height();
    drawings[i] = viz::figure(e.walk.steps[shot.step], camera_of(e, shot, aspect, paper_camera), page).drawing;
  }
  return equally_large(std::move(drawings));
}

std::vector<viz::Drawing> FigureMaker::cropped_to_paper(
    const std::function<Drawings(const viz::PaperSize&)>& draw) const {
  constexpr int most_rounds = 12;
  constexpr double widest = 4, near = 0.05;
  const viz::PaperSize& asked = *style_.paper;
  const double margin = viz::paper_theme(style_.theme, asked.text_size).sizes.margin;
  const bool for_width = style_.sides != Style::Sides::height, for_height = style_.sides != Style::Sides::width;
  viz::PaperSize size = asked;
  Drawings best;
  double best_over = INFINITY;
  for (int round = 0; round < most_rounds; ++round) {
    const Drawings now = viz::cropped(draw(size), margin);
    const double wide = for_width ? now.front().width - asked.width : 0;
    const double high = for_height ? now.front().height - asked.height : 0;
    const double over = !for_height ? wide : !for_width ? high : std::max(wide, high);
    // Too large is worse than too small; among those too small the largest is best.
    const bool better = over > near ? over < best_over : best_over > near || over > best_over;
    if (better) best = now, best_over = over;
    if (std::abs(over) <= near && (!for_width || !for_height || std::min(wide, high) >= -near)) break;
    if (for_width) size.width -= wide;
    if (for_height) size.height -= high;
    if (!for_width) size.width = asked.width / asked.height * size.height;
    if (!(size.width > 0.2 * asked.width && size.width < widest * asked.width)) break;
    if (for_height && !(size.height > 0.2 * asked.height && size.height < widest * asked.height)) break;
  }
  const double width = for_width ? std::max(asked.width, best.front().width - near) : best.front().width;
  const double height = for_height ? std::max(asked.height, best.front().height - near) : best.front().height;
  for (viz::Drawing& drawing : best) drawing = viz::centred(std::move(drawing), width, height);
  return best;
}

bool FigureMaker::is_widened(double width) const {
  constexpr double more = 0.1;
  return style_.sides != Style::Sides::height && width > style_.paper->width + more;
}

void FigureMaker::tell_widened(const std::string& which, double width) {
  if (is_widened(width)) widened_.push_back(told(which, width));
}

FigureMaker::Sight FigureMaker::sight(const Excerpt& e, const viz::Walk& walk, int step) {
  return {folder_of(e), [&] { return shape_of(e, walk); },
          [&, step](double aspect) { return paper_camera(e, walk.steps[step], aspect); }};
}

FigureMaker::Sight FigureMaker::sight(const OneScale& scale, Excerpts all, int step) {
  return {folder_of(all[scale.case_of(step)]), [&] { return std::clamp(scale.shape(), highest_shape, widest_shape); },
          [&, step](double aspect) { return scale.camera(step, aspect); }};
}

viz::OnPaper FigureMaker::on_paper(const viz::Walk& walk, int step, const Sight& seen, viz::PaperSize size,
                                   bool title) {
  if (!(size.height > 0) && !walk.steps[step].scene.chart) {
    const double usual = viz::paper_layout(walk, step, style_.theme, size, title).height;
    size.height = usual + size.width * (1 / seen.shape() - 1 / widest_shape);
  }
  auto made = viz::readable_figure(walk, step, style_.theme, size, title, seen.camera);
  if (!made)
    throw viz::BadInput(
        fmt::format("width: at {:.1f} cm the labels of {} meet or leave it, and at 8 times that, too; "
                    "give more, or a smaller --text-size",
                    size.width / points_a_cm, seen.whose + ", " + walk.steps[step].slug));
  return std::move(*made);
}

std::vector<viz::Figure> FigureMaker::equally_wide(const viz::Walk& walk, const std::function<Sight(int)>& sight_of,
                                                   viz::PaperSize size, bool title) {
  std::vector<viz::Figure> figures;
  const int steps = static_cast<int>(walk.steps.size());
  for (int step = 0; step < steps;) {
    viz::OnPaper made = on_paper(walk, step, sight_of(step), size, title);
    if (made.size.width > size.width) {  // all again
      size = made.size, figures.clear(), step = 0;
      continue;
    }
    figures.push_back(std::move(made.figure)), ++step;
  }
  return figures;
}

viz::Drawing FigureMaker::draw_strip(Excerpts cases, int columns, bool fewer, bool captions) {
  const auto at = [&](const viz::PaperSize& size) { return whole_strip(cases, columns, captions, size); };
  const auto drawn = [&] {
    if (!style_.crop) return at(*style_.paper);
    return cropped_to_paper([&](const viz::PaperSize& size) { return Drawings{at(size)}; }).front();
  };
  viz::Drawing drawing = drawn();
  while (fewer && columns > 1 && is_widened(drawing.width)) --columns, drawing = drawn();
  tell_widened(cases.size() == 1 ? folder_of(cases[0]) : stem_of(cases, "strip"), drawing.width);
  if (style_.transparent) drawing.background.a = 0;
  return drawing;
}

viz::Drawing FigureMaker::whole_strip(Excerpts cases, int columns, bool captions, const viz::PaperSize& size) {
  const viz::Theme theme = viz::paper_theme(style_.theme, size.text_size);
  const double gap = strip_gap * size.text_size;
  viz::PaperSize each = size;
  each.width = (each.width - (columns - 1) * gap) / columns;
  std::vector<viz::Figure> figures;
  if (cases.size() > 1) {
    const OneScale scale(cases);
    figures = equally_wide(
        scale.walk(), [&](int step) { return sight(scale, cases, step); }, each, false);
  } else {
    const Excerpt& e = cases[0];
    viz::Walk part = e.walk;  // rows that none of these steps needs are omitted
    part.steps.clear();
    for (const int step : e.steps) part.steps.push_back(e.walk.steps[step]);
    figures = equally_wide(
        part, [&](int step) { return sight(e, part, step); }, each, false);
  }
  const std::vector<std::string> words = part_captions(cases, captions);
  std::vector<viz::Frame> frames;
  for (std::size_t i = 0; i < figures.size(); ++i) frames.push_back({std::move(figures[i]), words[i]});
  return viz::strip(frames, columns, theme, gap).drawing;
}

viz::Imprint FigureMaker::imprint_of(const FigureInfo& info, const viz::Drawing& drawing) const {
  viz::Imprint imprint;
  imprint.title = info.imprint, imprint.alt = info.alt, imprint.letters = style_.letters;
  if (style_.paper) imprint.width_pt = drawing.width, imprint.dpi = style_.dpi;
  return imprint;
}

viz::Metadata FigureMaker::metadata_of(const FigureInfo& info) const {
  viz::Metadata data = info.metadata;
  data.emplace("style", style_.words);
  return data;
}

std::string FigureMaker::write(const FigureInfo& info, const viz::Drawing& drawing, const viz::Format& format) {
  const double scale = pixels_a_unit();
  if (format.pixels)
    need_pixels_in_bounds(drawing.width * drawing.height * scale * scale,
                          "give a smaller --size or fewer --dpi, or --format svg or pdf");
  return format.write(drawing, metadata_of(info), imprint_of(info, drawing),
                      [&](const viz::Drawing& d) { return offscreen_->render(d, scale); });
}

FigureFile FigureMaker::write_for_folder(const FigureInfo& info, const viz::Drawing& drawing,
                                         const viz::Format& format) {
  if (!has_faces_apart(drawing, format)) return write(info, drawing, format);
  viz::Imprint imprint = imprint_of(info, drawing);
  viz::Metadata data = metadata_of(info);
  imprint.faces = std::filesystem::path(faces_of(info.stem)).filename().string() + ".pdf";
  std::string bytes = viz::tikz(drawing, data, imprint);
  data["file"] = faces_of(info.stem);
  return {std::move(bytes), viz::tikz_faces(drawing, data, imprint)};
}

std::string FigureMaker::film(const FigureInfo& info, const std::vector<Shot>& shots,
                              const std::vector<viz::Drawing>& drawings, const viz::Format& format) {
  const double scale = pixels_a_unit();
  const viz::Drawing& first = drawings.front();
  std::vector<double> seconds;
  for (const Shot& shot : shots) seconds.insert(seconds.end(), static_cast<std::size_t>(shot.times), shot.seconds);
  need_pixels_in_bounds(static_cast<double>(seconds.size()) * first.width * first.height * scale * scale,
                        "give a smaller --size, or fewer steps");
  std::vector<viz::Picture> pictures;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const auto render = [&](const viz::Drawing& d) { return offscreen_->render(d, scale); };
    pictures.insert(pictures.end(), static_cast<std::size_t>(shots[i].times), viz::pixels_of(drawings[i], render));
  }
  return format.film(pictures, seconds, metadata_of(info), imprint_of(info, first));
}

std::string FigureMaker::renderer(const viz::Format& format) const {
  return format.pixels ? offscreen_->driver() : "cairo";
}

void say_faces_inside(const viz::Drawing& drawing, const viz::Format& format) {
  if (has_faces_apart(drawing, format))
    say(
        fmt::format("tikz: the {} faces are paths here, which LaTeX takes seconds to set; stdout has no room for a "
                    "picture of them beside the figure, and a folder (--out DIR) has",
                    viz::count_faces(drawing)));
}

void say_widened(const FigureMaker& maker) {
  const std::vector<std::string>& all = maker.widened();
  if (all.empty()) return;
  say(fmt::format("width: at this text size the labels of {} figure{} would meet or leave the picture, so {} wider:",
                  all.size(), all.size() == 1 ? "" : "s", all.size() == 1 ? "it is" : "they are"));
  constexpr std::size_t enough = 12;
  for (std::size_t i = 0; i < std::min(enough, all.size()); ++i) say("  " + all[i]);
  if (all.size() > enough) say(fmt::format("  and {} others; manifest.json has every width", all.size() - enough));
  say("Give a smaller --text-size to have them narrower.");
}

}  // namespace isect::program
