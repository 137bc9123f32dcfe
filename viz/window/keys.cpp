#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "viz/player/camera_moves.h"
#include "viz/player/practice.h"
#include "viz/text/rich_text.h"
#include "viz/window/key_codes.h"
#include "viz/window/map_view.h"
#include "viz/window/panels.h"
#include "viz/window/scene_marks.h"
#include "viz/window/second_pane.h"
#include "viz/window/time_strip.h"

namespace isect::viz {
namespace {

bool pressed(key::Code code, bool repeat = false) { return ImGui::IsKeyPressed(code, repeat); }

void paste(WindowSession& s) {
  const char* text = ImGui::GetClipboardText();
  if (!text || !*text) return s.toast.complain("The clipboard holds no text");
  const std::string words = text;
  if (words.find_first_not_of(" \t\r\n") != words.find('{'))
    return s.toast.complain("The clipboard holds some other text; Ctrl+C copies a state that can be pasted");
  attempt(s.toast, [&] {
    const ReaderState state = reader_state_from_json(text, s.player.lessons());
    s.player.go(state);
    s.settings.beside = beside_of(state);
    s.toast.say("State pasted. Ctrl+Z goes back");
  });
}

void resizing_keys(double& size) {
  if (pressed(key::plus, true) || pressed(key::equal, true) || pressed(key::keypad_plus, true)) size += 0.1;
  if (pressed(key::minus, true) || pressed(key::keypad_minus, true)) size -= 0.1;
  if (pressed(key::zero) || pressed(key::keypad_0)) size = 1;
  size = std::clamp(std::round(10 * size) / 10, least_size, most_size);
}

void with_control(WindowSession& s) {
  if (pressed(key::q)) s.requests.close = may_leave(s);
  resizing_keys(s.settings.size);
  if (s.review) return;
  if (pressed(key::o)) s.requests.sheet = Sheet::picker;
  const bool again = pressed(key::y) || (pressed(key::z) && ImGui::GetIO().KeyShift);
  attempt(s.toast, [&] {
    if (again) {
      if (!s.player.redo()) s.toast.say("Nothing to do again");
    } else if (pressed(key::z) && !s.player.undo()) {
      s.toast.say("Nothing to take back");
    }
  });
  if (pressed(key::v)) paste(s);
  if (pressed(key::s)) save_back(s);
  if (!pressed(key::c)) return;
  ReaderState state = s.player.reader_state();
  if (two_panes(s.player, s.settings)) state.beside = OtherSide{s.settings.beside->method, s.settings.beside->preset};
  ImGui::SetClipboardText(to_json(state).c_str());
  s.toast.say("State copied as JSON");
}

/// Loads the preset after the one loaded last, or before it.
void neighbour_preset(WindowSession& s, int by) {
  Player& player = s.player;
  const std::vector<const Preset*> group = player.played().group();
  const int count = static_cast<int>(group.size());
  if (count == 0) return;
  const auto at = std::ranges::find(group, player.origin(), &Preset::id);
  const int now = at == group.end() ? (by > 0 ? -1 : 0) : static_cast<int>(at - group.begin());
  const Preset& next = *group[static_cast<std::size_t>((now + by + count) % count)];
  attempt(s.toast, [&] { load_preset(player, next, scene_in_file(s)); });
}

/// Moves through the widgets, one after the other; also in a sheet, while its search field takes the letters.
void focus_keys(Focus& focus, bool in_popup) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseClicked[0]) focus.clear();
  if (in_popup && !io.KeyCtrl && pressed(key::tab, true)) focus.move(io.KeyShift ? -1 : 1);
  if ((io.WantTextInput && !in_popup) || io.KeyCtrl || io.KeyShift) return;
  if (pressed(key::down, true)) focus.move(1);
  if (pressed(key::up, true)) focus.move(-1);
  if (in_popup && !io.WantTextInput && pressed(key::right, true)) focus.move(1);
  if (in_popup && !io.WantTextInput && pressed(key::left, true)) focus.move(-1);
  if (pressed(key::f6)) focus.next_group();
  if (pressed(key::enter) || pressed(key::keypad_enter)) focus.press();
}

/// Page Down and Page Up, a presenter's two buttons: on and back in a lecture and in a playlist, else the presets.
void page_keys(WindowSession& s) {
  if (pressed(key::page_down, true) && shows_rest(s)) return;
  const bool repeat = !pages_go_on(s) || !leads_on(s);  // a key that is held does not run on into another lesson
  const int by = (pressed(key::page_down, repeat) ? 1 : 0) - (pressed(key::page_up, true) ? 1 : 0);
  if (by == 0) return;
  if (!pages_go_on(s)) return neighbour_preset(s, by);
  by > 0 ? go_on(s) : go_back(s);
}

/// Whether a key is pressed that types nothing.
bool silent_key() {
  for (const auto& [first, last] : key::silent)
    for (int code = first; code <= last; ++code)
      if (pressed(static_cast<key::Code>(code))) return true;
  return false;
}

/// While the screen is dark, any key makes it light, and does nothing else unless Ctrl is held; Shift and Alt alone
/// leave it dark. Returns whether that is all for this frame.
bool makes_light(WindowSession& s) {
  ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl) s.dark = false;
  if (!s.dark) return false;
  s.dark = io.InputQueueCharacters.empty() && !silent_key();
  io.InputQueueCharacters.resize(0);
  return true;
}

void moving_keys(WindowSession& s) {
  Player& player = s.player;
  const bool shift = ImGui::GetIO().KeyShift;  // with it the arrows turn the scene, or move a handle
  const bool repeat = !leads_on(s);            // a key that is held does not run on into another lesson
  if (!shift && pressed(key::right, true) && shows_rest(s)) return;
  if (!shift && pressed(key::right, repeat)) go_on(s);
  if (!shift && pressed(key::left, true)) go_back(s);
  if (pressed(key::escape)) s.ui.focus.clear();
  if (pressed(key::home)) player.first();
  if (pressed(key::end)) player.last();
  if (pressed(key::tab)) s.panels = !s.panels;
  if (pressed(key::f1)) s.requests.sheet = Sheet::keys;
  if (pressed(key::f12)) s.requests.sheet = Sheet::save;
  if (pressed(key::f11)) {
    s.full_screen = !s.full_screen;
    const std::string words = "Ctrl + and Ctrl − change the size of everything";
    if (s.full_screen) s.toast.say(s.panels ? words + ", Tab begins a lecture" : words);
  }
}

/// The keys of a review: on, and out of it. Letters and digits answer.
void review_keys(WindowSession& s) {
  const bool done = s.review->result.has_value() && s.ui.focus.name().empty();
  const bool entered = done && (pressed(key::enter) || pressed(key::keypad_enter));
  if (entered || (pressed(key::right) && !ImGui::GetIO().KeyShift)) next_in_review(s);
  if (pressed(key::f1)) s.requests.sheet = Sheet::keys;
  if (pressed(key::f11)) s.full_screen = !s.full_screen;
  if (pressed(key::escape)) leave_review(s);
}

void load_number(WindowSession& s, std::size_t number) {
  const std::vector<const Preset*> group = s.player.played().group();
  if (number > group.size()) return;
  attempt(s.toast, [&] { load_preset(s.player, *group[number - 1], scene_in_file(s)); });
}

/// Gives the answer that is this digit, unless another answer begins with it, too. Otherwise it does nothing: loading a
/// preset would take the question away.
void answer_with(Player& player, char digit) {
  const std::vector<std::string>& choices = player.quiz().asked()->choices;
  const auto begins = [&](const std::string& choice) { return plain(choice).starts_with(digit); };
  const auto found =
      std::ranges::find_if(choices, [&](const std::string& c) { return plain(c) == std::string(1, digit); });
  if (found != choices.end() && std::ranges::count_if(choices, begins) == 1)
    player.answer(static_cast<int>(found - choices.begin()));
}

/// Does what a letter or a sign asks for.
void command(WindowSession& s, char c) {
  Player& player = s.player;
  switch (c) {
    case ' ':
      if (!player.running() && shows_rest(s)) return;
      return player.toggle_play();
    case '[':
      return attempt(s.toast, [&] { player.open_neighbour(-1); });
    case ']':
      return attempt(s.toast, [&] { player.open_neighbour(1); });
    case 'e':
      return attempt(s.toast, [&] { fault_or_back(player, s.step_words.before_fault); });
    case 'g':
      s.requests.sheet = Sheet::terms;
      return;
    case 'h':
      s.requests.sheet = Sheet::progress;
      return;
    case 'j':
      return go_to_contact(player, s.toast);
    case 'k':
      return run_time(player, s.toast);
    case 'l':
      return toggle_pin(player, s.toast);
    case 'm':
      s.settings.reduced_motion = !s.settings.reduced_motion;
      player.reduce_motion(s.settings.reduced_motion);
      return s.toast.say(s.settings.reduced_motion ? "Nothing moves by itself now" : "Steps and views glide again");
    case 'n':
      if (!pages_go_on(s) && !leads_on(s)) return pass_questions(player, s.settings, s.toast);
      return go_on(s);
    case 'i':
      s.requests.sheet = Sheet::stops;
      return;
    case 'b':
    case '.':
      s.dark = !s.panels;
      return;
    case 'v':
      return toggle_panes(player, s.settings, s.toast);
    case 'w':
      return show_map(player, s.settings, s.toast);
    case 'r':
      return attempt(s.toast, [&] { player.restart(); });
    case 'y':
      s.step_words.answer.other = player.quiz().answered().has_value();
      return;
    case 't':
      if (review_count(player.lessons()) == 0) return s.toast.say("A review needs a course of five lessons");
      s.requests.sheet = Sheet::reviews;
      return;
    case 'p':
      return set_perspective(player, true);
    case 'o':
      return set_perspective(player, false);
    case 'f':
      return frame_all(player);
    case '+':
    case '=':
      s.requests.zoom *= 1.15;
      return;
    case '-':
      s.requests.zoom /= 1.15;
      return;
    case 's':
      s.requests.sheet = Sheet::save;
      return;
    case '?':
      s.requests.sheet = Sheet::keys;
      return;
    default:
      return;
  }
}

/// Handles characters, not keys: they work on every keyboard layout.
void character(WindowSession& s, char c) {
  if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const Question* const asked = s.player.quiz().asked();
  const bool letter = asked && c >= 'a' && c - 'a' < static_cast<int>(asked->choices.size());
  if (letter && s.player.quiz().asks_more()) return s.player.show_choices();
  if (c >= '0' && c <= '9' && asked) return answer_with(s.player, c);
  if (letter) return s.player.answer(c - 'a');
  if (s.review && std::string_view("fjkop+=-?").find(c) == std::string_view::npos) return;  // nothing leads away
  if (c >= '0' && c <= '9') return load_number(s, c == '0' ? 10 : static_cast<std::size_t>(c - '0'));
  command(s, c);
}

}  // namespace

KeptScene kept_scene(const WindowSession& s) {
  if (s.player.lesson().made_from.empty()) return KeptScene::nowhere;
  if (s.scene_file.fresh.text) return KeptScene::without_file;
  return s.scene_file.save ? KeptScene::in_file : KeptScene::nowhere;
}

void save_back(WindowSession& s) {
  if (const KeptScene kept = kept_scene(s); kept != KeptScene::in_file) {
    if (kept == KeptScene::without_file) s.save_sheet.what = SaveSheet::What::scene;
    s.requests.sheet = Sheet::save;
    return;
  }
  attempt(s.toast, [&] {
    s.scene_file.save(s.player.lesson(), s.player.parameters());
    s.scene_file.written = &s.player.lesson();
    s.player.reread();
    s.toast.say("Saved into the scene's file");
  });
}

const Lesson* scene_in_file(const WindowSession& s) {
  const auto& versions = s.scene_file.versions;
  const auto now = versions.find(&s.player.lesson()), saved = versions.find(s.scene_file.written);
  if (now == versions.end()) return nullptr;
  const Lesson* const in_file = saved != versions.end() && saved->second == now->second ? saved->first : now->second;
  return in_file->made_from != now->first->made_from ? in_file : nullptr;
}

void load_preset(Player& player, const Preset& preset, const Lesson* in_file) {
  in_file ? player.show_version(*in_file) : player.load(preset);
}

bool may_leave(WindowSession& s) {
  if (s.review) leave_review(s);
  const bool as_in_file = !s.player.played().preset_id().empty() && !scene_in_file(s);
  const KeptScene kept = kept_scene(s);
  if (kept == KeptScene::nowhere || as_in_file || s.scene_file.told_unsaved == s.player.revision()) return true;
  s.scene_file.told_unsaved = s.player.revision();
  s.toast.complain(std::string("This scene is not saved: Ctrl+S saves it; Ctrl+Q once more leaves it as ") +
                   (kept == KeptScene::in_file ? "its file is" : "it came"));
  return false;
}

void keys(WindowSession& s) {
  if (makes_light(s)) return;
  if (std::exchange(s.step_words.answer.other, false))
    attempt(s.toast, [&] {
      if (!ask_with_other_numbers(s.player)) s.toast.say("No other setting asks this with other numbers");
    });
  const ImGuiIO& io = ImGui::GetIO();
  const bool in_popup = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
  focus_keys(s.ui.focus, in_popup);
  // In a lecture they go on also while an answer is being typed: a presenter has no other keys.
  if (!in_popup && !io.KeyCtrl && !s.review && !(s.panels && io.WantTextInput)) page_keys(s);
  if (io.WantTextInput || in_popup) return;
  if (io.KeyCtrl) return with_control(s);
  (s.review ? review_keys : moving_keys)(s);
  bool answered = false;
  for (const ImWchar c : io.InputQueueCharacters) {
    const bool darkens = c == '.' && !s.panels && !s.review && !s.step_words.answer.typing;  // a presenter's third key
    const bool of_answer = !darkens && typed_into_answer(s.player, s.step_words.answer, c);
    answered = answered || of_answer;
    if (!of_answer && c < 128) character(s, static_cast<char>(c));
  }
  if (answered) ImGui::GetIO().InputQueueCharacters.resize(0);  // the field that opens would take them once more
}

}  // namespace isect::viz
