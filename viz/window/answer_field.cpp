// The field for what a question asks for besides a choice: a number, a line, an order.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "viz/text/rich_text.h"
#include "viz/walk/given_answer.h"
#include "viz/window/column.h"
#include "viz/window/panels.h"

namespace isect::viz {
namespace {

constexpr float answer_height = 36;
constexpr const char* answer_name = "answer";

/// Empties the field if it holds what was typed for another question.
void renew(AnswerField& field, const Player& player) {
  const std::pair of{player.walk_number(), player.index()};
  if (field.of == of) return;
  field = {};
  field.of = of;
}

/// Sets the cursor behind what was typed before the field had the keyboard; Dear ImGui would select it.
int to_the_end(ImGuiInputTextCallbackData* data) {
  AnswerField& field = *static_cast<AnswerField*>(data->UserData);
  if (!field.at_end) data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
  field.at_end = true;
  return 0;
}

void stop_typing(AnswerField& field) {
  field.typing = field.begun = field.at_end = false;
  field.frames = 0;
}

void begin_typing(AnswerField& field) {
  stop_typing(field);
  field.typing = true;
}

/// Lets the reader type. Returns whether that ended with Enter.
bool typed_to_its_end(Ui& ui, AnswerField& field, const Rect& r) {
  ui.rects[answer_name] = r;
  focused(ui, answer_name, r);
  ImGui::SetCursorScreenPos(top_left(r));
  ImGui::SetNextItemWidth(r.width());
  // Dear ImGui focuses it in one of the next frames, and 1.90 only within the window that has the focus already.
  if (!field.begun && field.frames++ % 4 == 0) {
    ImGui::SetWindowFocus();
    ImGui::SetKeyboardFocusHere();
  }
  const float above = std::max(0.0f, (answer_height - ImGui::GetFontSize()) / 2);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2{10, above});
  const bool entered =
      ImGui::InputText("##answer", &field.text,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways, to_the_end, &field);
  ImGui::PopStyleVar();
  const bool left = left_by_tab(ui, answer_name) || (field.begun && !ImGui::IsItemActive());
  if (ImGui::IsItemActive()) field.begun = true;
  if (entered || left) stop_typing(field);
  return entered;
}

/// Draws the field as it waits. Returns whether it is to be typed into.
bool waits(Ui& ui, const AnswerField& field, const Rect& r) {
  const Press p = press(ui, answer_name, r);
  const Palette& c = ui.palette;
  filled(r, p.hovered ? c.hovered : c.frame);
  outlined(r, p.hovered ? c.first : c.rule);
  const bool empty = field.text.empty();
  text(ui.fonts.body, r.left + 10, r.middle_y(), packed(empty ? c.muted : c.text),
       empty ? "your answer" : fitted(ui.fonts.body, field.text, r.width() - 20));
  return p.clicked;
}

/// Answers with what was typed; if that can't be read, it says why, and the field stays open.
void submit(Player& player, AnswerField& field) {
  try {
    player.answer_typed(field.text);
  } catch (const BadInput& wrong) {
    field.refused = wrong.what();
    begin_typing(field);
  }
}

}  // namespace

void answer_field(Column& c, Player& player, AnswerField& field) {
  renew(field, player);
  const Palette& ink = c.ui.palette;
  const Question& question = *player.quiz().asked();
  if (question.order) order_tiles(c, *question.order, field);
  constexpr float gap = 8, button = 84, least = 100, most = 260;
  const std::string hint = question.order ? "Show the choices" : "Show the choices (A)";
  const float hint_width = text_width(c.ui.fonts.body, hint) + 28, for_field = c.width - button - gap;
  const bool in_a_row = for_field - hint_width - gap >= least;  // then all is in sight in a low strip, too
  const float width = std::min(in_a_row ? for_field - hint_width - gap : for_field, most);
  const Rect r{c.x, c.y, c.x + width, c.y + answer_height};
  bool entered = false;
  if (field.typing)
    entered = typed_to_its_end(c.ui, field, r);
  else if (waits(c.ui, field, r))
    begin_typing(field);
  const Rect beside{r.right + gap, r.top, r.right + gap + button, r.bottom};
  const bool pressed = chip(c.ui, "give answer", beside, "Answer", false);
  const auto show_choices = [&](float x, float y) {
    return chip(c.ui, "show choices", {x, y, x + hint_width, y + answer_height}, hint, false);
  };
  bool hinted = in_a_row && show_choices(beside.right + gap, r.top);
  c.y = r.bottom + 6;
  c.paragraph(how_to_answer(question), ink.muted);
  if (!field.refused.empty()) {
    const float top = c.y;
    c.paragraph(as_markup("That is not read: " + field.refused + "."), ink.miss);
    c.ui.rects["unread answer"] = {c.x, top, c.x + c.width, c.y};
  }
  c.y += 8;
  if (!in_a_row) {
    hinted = show_choices(c.x, c.y);
    c.y += answer_height;
  }
  if (entered || pressed) return submit(player, field);
  if (hinted) player.show_choices();
}

namespace {

/// Whether the answer that a question asks for may begin with this character.
bool begins_answer(const Question& question, ImWchar c) {
  constexpr ImWchar minus = 0x2212, root = 0x221A;
  const bool digit = c >= '0' && c <= '9';
  if (question.line) return digit;
  if (!question.order) return digit || c == '.' || c == '-' || c == '(' || c == minus || c == root;
  const ImWchar small = c >= 'A' && c <= 'Z' ? static_cast<ImWchar>(c - 'A' + 'a') : c;
  return small >= 'a' && small < 'a' + question.order->tiles.size();
}

}  // namespace

bool typed_into_answer(const Player& player, AnswerField& field, ImWchar c) {
  constexpr ImWchar minus = 0x2212, root = 0x221A;
  if (!player.quiz().asks_more()) return false;
  renew(field, player);
  if (field.begun) return false;  // then the field takes it
  const Question& question = *player.quiz().asked();
  if (!field.typing && !begins_answer(question, c)) return false;
  if (!field.typing) {
    begin_typing(field);
    if (!question.order) field.text.clear();  // tiles that were taken stay so
  }
  if (c == minus)
    field.text += "−";
  else if (c == root)
    field.text += "√";
  else if (c >= ' ' && c < 127)
    field.text += static_cast<char>(c);
  return true;
}

}  // namespace isect::viz
