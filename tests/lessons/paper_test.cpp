// Figures on paper: from 3 cm to a page's width their texts have one size, and no label meets another.

#include <zlib.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "lessons/lessons.h"
#include "tests/catch.h"
#include "viz/chart/case_map.h"
#include "viz/compose/labels.h"
#include "viz/compose/paper.h"
#include "viz/compose/strip.h"
#include "viz/formats/files.h"
#include "viz/text/rich_text.h"
#include "viz/text/tex.h"
#include "viz/text/text.h"
#include "viz/walk/closing.h"

namespace paper_test {
using namespace isect::viz;
using isect::lessons::all_lessons;

namespace {

constexpr double points_a_cm = 72 / 2.54;
constexpr double widths[] = {3, 5, 8, 12, 16};

/// What a compressed stream of a PDF holds.
std::string inflated(const std::string& bytes) {
  std::string out(std::size_t{1} << 22, '\0');
  uLongf size = out.size();
  if (uncompress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                 bytes.size()) != Z_OK)
    return {};
  out.resize(size);
  return out;
}

/// The sizes of all letters of a page in hundredths of a point: "9 0 0 -9 72.1 70.2 Tm" sets them at 9.
std::set<int> sizes_in(const std::string& pdf) {
  std::set<int> sizes;
  for (std::size_t at = pdf.find("stream\n"); at != pdf.npos; at = pdf.find("stream\n", at + 1)) {
    const std::size_t begin = at + 7, end = pdf.find("endstream", begin);
    if (pdf.compare(at - 3, 3, "end") == 0 || end == pdf.npos) continue;
    std::istringstream words(inflated(pdf.substr(begin, end - begin)));
    std::vector<std::string> before;
    for (std::string word; words >> word; before.push_back(word))
      if (word == "Tm" && before.size() >= 6)
        sizes.insert(static_cast<int>(std::lround(100 * std::abs(std::stod(before[before.size() - 6])))));
  }
  return sizes;
}

}  // namespace

TEST_CASE("every letter on paper has the size that is told, scripts the one below it, as the PDF says", "[paper]") {
  const bool all_presets = std::getenv("ISECT_LONG") != nullptr;
  int scripts = 0, figures = 0;
  for (const Lesson* lesson : all_lessons()) {
    std::vector<Walk> walks;
    for (const Preset& p : lesson->presets) walks.push_back(walk_with_map(*lesson, p.parameters));
    for (std::size_t i = 0; i < (all_presets ? walks.size() : 1); ++i)
      for (const double width : {5, 8, 16})
        for (int step = 0; step < static_cast<int>(walks[i].steps.size()); ++step) {
          const Step& shown = walks[i].steps[step];
          const auto camera = [&](double aspect) {
            return closer(frame_alike(opening(*lesson), walks[i], walks, aspect), shown.scene, aspect);
          };
          INFO(lesson->id << "/" << lesson->presets[i].id << ", " << shown.slug << " at " << width << " cm");
          const auto made = readable_figure(walks[i], step, ThemeName::print, {width * points_a_cm, 0}, true, camera);
          REQUIRE(made);
          Imprint imprint;
          imprint.width_pt = made->figure.drawing.width;
          const std::set<int> sizes = sizes_in(pdf(made->figure.drawing, {}, imprint));
          REQUIRE_FALSE(sizes.empty());
          for (const int size : sizes) {
            const bool text = std::abs(size - 900) <= 1, script = std::abs(size - 900 * script_size) <= 5;
            INFO(size / 100.0 << " pt");
            CHECK((text || script));
            scripts += script;
          }
          ++figures;
        }
  }
  CHECK(figures > 500);
  CHECK(scripts > 20);  // the others are found, too
}

TEST_CASE("labels on paper neither meet nor leave at 3, 5, 8, 12 and 16 cm, or the figure is wider", "[paper]") {
  std::map<double, int> drawn, wider;
  for (const Lesson* lesson : all_lessons()) {
    std::vector<Walk> walks;
    for (const Preset& p : lesson->presets) walks.push_back(walk_with_map(*lesson, p.parameters));
    const Walk& walk = walks.front();
    for (const double width : widths)
      for (int step = 0; step < static_cast<int>(walk.steps.size()); ++step) {
        const auto camera = [&](double aspect) {
          return closer(frame_alike(opening(*lesson), walk, walks, aspect), walk.steps[step].scene, aspect);
        };
        INFO(lesson->id << ", " << walk.steps[step].slug << " at " << width << " cm");
        const auto made = readable_figure(walk, step, ThemeName::print, {width * points_a_cm, 0}, true, camera);
        REQUIRE(made);
        CHECK(label_faults(made->figure, 6).empty());
        CHECK(made->figure.drawing.width == made->size.width);
        CHECK(made->size.width <= 1.001 * std::max(12.0, width) * points_a_cm);
        if (walk.steps[step].slug == closing_slug) continue;  // a card of text does not go into 3 cm
        ++drawn[width];
        wider[width] += made->size.width > 1.001 * width * points_a_cm;
      }
  }
  CHECK(wider[16] == 0);
  CHECK(wider[12] == 0);
  CHECK(10 * wider[8] < drawn[8]);
  CHECK(2 * wider[3] < drawn[3]);  // a line of algebra at 9 pt takes more
}

TEST_CASE("no label of a strip meets another, with captions as without", "[paper]") {
  const Theme theme = paper_theme(ThemeName::print, usual_text_size);
  for (const Lesson* lesson : all_lessons()) {
    const Walk walk = walk_with_map(*lesson, lesson->presets.front().parameters);
    for (const bool captions : {false, true}) {
      std::vector<Frame> frames;
      for (int step = 0; step < std::min(4, static_cast<int>(walk.steps.size())); ++step) {
        const auto camera = [&](double aspect) { return frame_alike(opening(*lesson), walk, {walk}, aspect); };
        auto made = readable_figure(walk, step, ThemeName::print, {7.5 * points_a_cm, 0}, false, camera);
        REQUIRE(made);
        frames.push_back({std::move(made->figure), captions ? walk.steps[step].caption : walk.steps[step].title});
      }
      const Strip strip = isect::viz::strip(frames, 2, theme, 12);
      INFO(lesson->id);
      for (const std::string& fault : label_faults(strip.drawing, strip.labels, 6)) UNSCOPED_INFO(fault);
      CHECK(label_faults(strip.drawing, strip.labels, 6).empty());
    }
  }
}

TEST_CASE("no bold heading on paper stands on a line, so that it would cut a shape, nor beside another as one",
          "[paper]") {
  int headings = 0;
  for (const Lesson* lesson : all_lessons()) {
    std::vector<Walk> walks;
    for (const Preset& p : lesson->presets) walks.push_back(walk_with_map(*lesson, p.parameters));
    const bool compares = lesson->id == "relations";  // shapes of all kinds, each below its heading
    for (std::size_t i = 0; i < (compares ? walks.size() : 1); ++i)
      for (const double width : {5, 8, 16})
        for (int step = 0; step < static_cast<int>(walks[i].steps.size()); ++step) {
          const auto camera = [&](double aspect) {
            return closer(frame_alike(opening(*lesson), walks[i], walks, aspect), walks[i].steps[step].scene, aspect);
          };
          const auto made = readable_figure(walks[i], step, ThemeName::print, {width * points_a_cm, 0}, true, camera);
          REQUIRE(made);
          const std::vector<Shape>& shapes = made->figure.drawing.shapes;
          std::vector<TextBox> row;
          for (std::size_t k = 0; k < shapes.size(); ++k) {
            const Text* text = std::get_if<Text>(&shapes[k]);
            if (!text || !text->bold) continue;
            if (plain(text->markup).size() == 1) continue;  // of an axis
            INFO(lesson->id << "/" << lesson->presets[i].id << ", " << walks[i].steps[step].slug << " at " << width
                            << " cm: " << plain(text->markup));
            ++headings;
            CHECK(text->halo == 0);
            const TextBox box = measure(*text);
            for (const Shape& shape : shapes)  // drawn before it or after it
              if (const Stroke* stroke = std::get_if<Stroke>(&shape)) {
                const std::vector<Vec2> line = flatten(stroke->path, 0.5);
                for (std::size_t j = 1; j < line.size(); ++j) CHECK(length_inside(line[j - 1], line[j], box) == 0);
              }
            for (const TextBox& other : row) {
              const bool beside = box.top < other.bottom && other.top < box.bottom;
              CHECK_FALSE((beside && box.left < other.right + 2 && other.left < box.right + 2));
            }
            row.push_back(box);
          }
        }
  }
  CHECK(headings > 1000);
}

TEST_CASE("every text of every lesson is ASCII in LaTeX, with its dollars and braces in pairs", "[paper]") {
  const auto check = [](const std::string& text) {
    INFO(text);
    CHECK(std::ranges::all_of(text, [](char c) { return static_cast<unsigned char>(c) < 128; }));
    int depth = 0, lowest = 0, dollars = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (text[i] == '\\') {
        ++i;
        continue;
      }
      depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
      lowest = std::min(lowest, depth);
      dollars += text[i] == '$';
    }
    CHECK((depth == 0 && lowest == 0));
    CHECK(dollars % 2 == 0);
  };
  for (const Lesson* lesson : all_lessons())
    for (const Preset& preset : lesson->presets) {
      const Walk walk = lesson->walk(preset.parameters);
      for (const std::string& line : walk.pseudocode) check(tex_plain(line));
      for (const Step& step : walk.steps) {
        for (const std::string& markup : {step.title, step.caption, step.formula, step.verdict.text})
          check(tex(markup));
        for (const Item& item : step.scene.items)
          if (const Label* label = std::get_if<Label>(&item)) check(tex(label->text));
        if (step.question) {
          check(tex(step.question->prompt));
          check(tex(step.question->because));
          for (const std::string& choice : step.question->choices) check(tex(choice));
        }
      }
    }
}

}  // namespace paper_test
