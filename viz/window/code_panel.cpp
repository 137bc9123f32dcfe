#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "viz/text/rich_text.h"
#include "viz/walk/branch.h"
#include "viz/walk/pseudocode.h"
#include "viz/window/layout.h"
#include "viz/window/panels.h"

namespace isect::viz {

std::vector<std::string> rows_of_line(const std::string& words, ImFont* font, float room) {
  constexpr std::size_t most = 2000;                                             // a lesson has a hundred
  static std::map<std::pair<std::string, int>, std::vector<std::string>> known;  // each frame needs all
  if (known.size() > most) known.clear();
  const int columns = static_cast<int>(room / text_width(font, "0"));
  const auto [found, fresh] = known.try_emplace({words, columns});
  if (fresh) found->second = code_rows(words, columns);
  return found->second;
}

namespace {

constexpr float padding = 20, code_top = 46, code_top_of_two = 14;
constexpr float code_left = 42, row_pitch = 18;  ///< of a line's words; distance between rows of a long line
constexpr float said_room = 40;                  ///< for "yes" or "no" beside a line

/// A line of pseudocode on as many rows as it takes, the later ones indented further.
struct CodeLine {
  std::vector<std::string> rows;
  ImFont* font = nullptr;
  float pitch_of_rows = row_pitch;
  float beside = said_room;

  float height(float pitch) const { return pitch + pitch_of_rows * static_cast<float>(rows.size() - 1); }
};

/// Whether the line may have a "yes" or a "no" beside it, at this step or at another one.
bool may_say(const std::string& words) {
  return has_condition(words) || words.find("if ") != std::string::npos || words.find("else") != std::string::npos;
}

/// Returns all lines of the walk. A line whose condition may fail has room for its "yes" or "no".
std::vector<CodeLine> code_lines(const Ui& ui, const Walk& walk, float width) {
  ImFont* const font = ui.fonts.mono;
  std::vector<CodeLine> lines;
  for (const std::string& words : walk.pseudocode) {
    lines.push_back({rows_of_line(words, font, width - code_left - (may_say(words) ? said_room : 6)), font});
  }
  return lines;
}

float height_of(const std::vector<CodeLine>& lines, float pitch) {
  return std::accumulate(lines.begin(), lines.end(), 0.0f,
                         [&](float sum, const CodeLine& line) { return sum + line.height(pitch); });
}

/// Pitches and heights of the panel: roomy where the whole walk fits, tighter where it does not. The walk's fullest
/// step decides, so that lines keep their places while a reader steps.
struct Fit {
  float code_pitch, value_pitch, operations, code_height, values_height;
};

float most_values(const Ui& ui, const Walk& walk, const Step& shown, float width, float pitch) {
  float most = values_height(ui, shown, width, pitch);
  for (const Step& step : walk.steps) most = std::max(most, values_height(ui, step, width, pitch));
  return most;
}

/// `top`: the height of what stands above the code.
Fit fit(const Player& player, const Ui& ui, const std::vector<CodeLine>& lines, float width, float height, float top,
        bool paired) {
  const Walk& walk = player.walk();
  constexpr Fit sizes[] = {{26, 28, 58, 0, 0}, {23, 25, 34, 0, 0}, {21, 22, 34, 0, 0}};
  Fit f{};
  float room = 0;
  for (const Fit& size : sizes) {
    f = size;
    if (paired) f.operations = 0;
    f.code_height = height_of(lines, f.code_pitch);
    f.values_height = most_values(ui, walk, player.shown(), width, f.value_pitch);
    room = height - top - f.operations;
    if (f.code_height + f.values_height <= room) return f;
  }
  // Too much for this window: the code shows a part around its current line, the values scroll if necessary.
  const float least_code = std::min(f.code_height, 5 * f.code_pitch);
  f.values_height = std::min(values_height(ui, player.shown(), width, f.value_pitch), room - least_code);
  f.code_height = std::min(f.code_height, room - f.values_height);
  return f;
}

bool has(const std::vector<int>& lines, int line) { return std::find(lines.begin(), lines.end(), line) != lines.end(); }

/// Returns the next step, cyclically, that stands at this line; -1 if none does.
int step_at_line(const Player& player, int line) {
  for (int i = 1; i <= player.count(); ++i) {
    const int step = (player.index() + i) % player.count();
    if (player.walk().steps[step].line == line) return step;
  }
  return -1;
}

/// Returns whether a line's condition was true: on the current line, and on others that were refused.
std::optional<bool> said_at(const Player& player, int line) {
  const Step& shown = player.shown();
  if (line == shown.line) return taken(player.walk(), player.index());
  return has(shown.refused, line) ? std::optional(false) : std::nullopt;
}

/// How a line of one of two panes differs from the other's.
enum class Differs { no, by_name, first };

Differs differs(const Parted* parted, int line) {
  if (!parted) return Differs::no;
  if (line == parted->line) return Differs::first;
  return has(parted->renamed, line) ? Differs::by_name : Differs::no;
}

/// Marks a line that is the other pane's but for a name, less than one that differs.
void renamed_mark(Ui& ui, int line, const Rect& r, bool lit) {
  ui.rects["renamed line " + std::to_string(line + 1)] = r;
  text(ui.fonts.body, r.left + 7, r.middle_y(), packed(lit ? ui.palette.on_highlight : ui.palette.muted), "≈", 0.5f);
}

/// Fills the current line's ground; where that is grey among greys, with a dark rim.
void light_line(const Palette& c, const Rect& r, double strength) {
  filled(r, c.highlight.with_alpha(strength), 5);
  if (c.theme.name == ThemeName::grey) outlined(r, c.text.with_alpha(strength), 2, 5);
}

void code_line(Player& player, Ui& ui, int line, const CodeLine& words, float pitch, const Rect& r, Differs mark) {
  const Palette& c = ui.palette;
  const Step& step = player.shown();
  const bool current = line == step.line;
  const bool to_point_at = player.quiz().wants_line() && ui.side.empty();  // the question is the first pane's
  const int to = step_at_line(player, line);
  const Press p = press(ui, "line " + std::to_string(line + 1), r);
  if (current)
    light_line(c, r, player.motion().light());
  else if (p.hovered && (to >= 0 || to_point_at))
    filled(r, c.frame, 5);

  const bool lit = current && player.motion().light() > 0.5;  // until then the ink of other lines is easier to read
  if (mark == Differs::first) parted_mark(ui, "parted line", r, lit);
  if (mark == Differs::by_name) renamed_mark(ui, line, r, lit);
  const Colour& ink = lit ? c.on_highlight : has(step.untaken, line) ? c.muted : c.text;
  float y = r.top + pitch / 2;
  const float number = r.left + 30;
  const Rect place{r.left, std::max(r.top, ImGui::GetWindowPos().y), r.right,
                   std::min(r.bottom, ImGui::GetWindowPos().y + ImGui::GetWindowHeight())};
  const std::vector<std::string> subject = subject_of_line(player.walk().pseudocode[line], ui.names);
  if (p.hovered) ui.light.point(subject, place);
  if (ui.focus.name() == "line " + std::to_string(line + 1)) ui.light.hold(subject, place);
  text(ui.fonts.mono, number, y, packed(lit ? c.on_highlight : c.muted), std::to_string(line + 1), 1);
  const std::optional<bool> said = said_at(player, line);
  ImGui::PushClipRect({number + 8, r.top}, {r.right - (said ? words.beside : 4), r.bottom}, true);
  for (const std::string& row : words.rows) {
    text(words.font, r.left + code_left, y, packed(ink), row);
    lights_in(ui, words.font, r.left + code_left, y, row, lit);
    y += words.pitch_of_rows;
  }
  ImGui::PopClipRect();
  y = r.top + pitch / 2;
  if (said) {
    const std::string word = said_at_line(said);
    ImFont* const font = words.font == ui.fonts.mono_large ? ui.fonts.bold : ui.fonts.body;
    text(font, r.right - 12, y, packed(lit ? c.on_highlight : *said ? c.hit : c.miss), word, 1);
    ui.rects[word + " " + std::to_string(line + 1)] = {r.right + 4 - words.beside, y - 9, r.right - 8, y + 9};
  }
  // last, as it destroys the step that is shown
  if (p.clicked && to_point_at)
    player.answer_line(line);
  else if (p.clicked && to >= 0)
    player.go_to(to);
}

void code(Player& player, Ui& ui, const std::vector<CodeLine>& lines, const Rect& r, float pitch,
          const Parted* parted) {
  ui.rects["code lines"] = r;
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2{0, 0});
  ImGui::BeginChild("code", {r.width(), r.height()}, false, ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar();
  const int line = player.shown().line;
  const float top = ImGui::GetCursorScreenPos().y;
  float y = top;
  for (int i = 0; i < static_cast<int>(lines.size()); ++i) {
    const CodeLine& words = lines[i];
    const float height = words.height(pitch);
    code_line(player, ui, i, words, pitch, {r.left, y, r.right, y + height}, differs(parted, i));
    if (i == line && !ui.focus.name().starts_with(ui.side + "line "))
      ImGui::SetScrollFromPosY(y + height / 2 - ImGui::GetWindowPos().y, 0.5f);
    y += height;
  }
  ImGui::SetCursorScreenPos({r.left, top});
  ImGui::Dummy({1, y - top});
  more_beyond(ui, "code", r);
  ImGui::EndChild();
}

/// The height of the current line where it stands alone on one row.
float pitch_alone(const Ui& ui) { return static_cast<float>(ui.fonts.large) + 18; }

/// Returns the line in large letters, or in smaller ones if a word of it is too long. Its rows are the same at all
/// steps, whether they say "yes" or "no" of it or nothing.
CodeLine laid_out_alone(const Player& player, const Ui& ui, float width) {
  constexpr float beside = 50, between_rows = 6;
  const int line = player.step().line;
  const std::string words = unindented(player.walk().pseudocode[line]);
  const float room = width - code_left - (may_say(words) || said_at(player, line) ? beside + 6 : 10);
  CodeLine laid_out;
  for (ImFont* const font : {ui.fonts.mono_large, ui.fonts.mono}) {
    const double size = font == ui.fonts.mono_large ? ui.fonts.large : body_size;
    laid_out = {rows_of_line(words, font, room), font, static_cast<float>(size) + between_rows, beside};
    const auto fits = [&](const std::string& row) { return text_width(font, row) <= room; };
    if (std::ranges::all_of(laid_out.rows, fits)) break;
  }
  return laid_out;
}

}  // namespace

float current_line_height(const Player& player, const Ui& ui, float width) {
  return laid_out_alone(player, ui, width).height(pitch_alone(ui));
}

void current_line(Player& player, Ui& ui, const Rect& r) {
  code_line(player, ui, player.step().line, laid_out_alone(player, ui, r.width()), pitch_alone(ui), r, Differs::no);
}

void parted_mark(Ui& ui, const std::string& name, const Rect& r, bool lit) {
  ui.rects[name] = r;
  outlined(r, ui.palette.miss, 1.5f, 5);
  text(ui.fonts.body, r.left + 7, r.middle_y(), packed(lit ? ui.palette.on_highlight : ui.palette.miss), "≠", 0.5f);
}

void code_panel(Player& player, Ui& ui, const Rect& r, const Parted* parted) {
  begin_region(ui, "code panel", r);
  ImGui::GetWindowDrawList()->AddRectFilled({r.left, r.top}, {r.left + 1, r.bottom}, packed(ui.palette.rule));
  const std::vector<CodeLine> lines = code_lines(ui, player.walk(), r.width() - 20);
  const float top = parted ? code_top_of_two : code_top;
  const Fit f = fit(player, ui, lines, r.width() - 20, r.height(), top, parted != nullptr);
  const float heading = r.top + 32;
  if (!lines.empty() && !parted) text(ui.fonts.bold, r.left + padding, heading, packed(ui.palette.text), "Pseudocode");
  if (player.shown().counters.early_out && !parted)
    text(ui.fonts.body, r.right - padding, heading, packed(ui.palette.fresh_text), "early out", 1);
  const float code_bottom = r.top + top + f.code_height;
  code(player, ui, lines, {r.left + 10, r.top + top, r.right - 10, code_bottom}, f.code_pitch, parted);
  values_block(ui, player.shown(), {r.left + 10, code_bottom, r.right - 10, code_bottom + f.values_height},
               f.value_pitch, parted);
  if (!parted)
    operations_block(ui, player.shown().counters, {r.left + 10, r.bottom - f.operations, r.right - 10, r.bottom});
  ImGui::End();
}

}  // namespace isect::viz
