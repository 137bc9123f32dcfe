#pragma once
// The keys that the window uses. Since 1.87 Dear ImGui has a number of its own for every key; before (Debian 12 has
// 1.86) it uses the back end's, here GLFW's, and is told which of them it needs itself.

#include <imgui.h>

namespace isect::viz::key {

#if IMGUI_VERSION_NUM < 18700
enum Code : int {
  space = 32,
  escape = 256,
  enter = 257,
  tab = 258,
  backspace = 259,
  insert = 260,
  del = 261,
  right = 262,
  left = 263,
  down = 264,
  up = 265,
  page_up = 266,
  page_down = 267,
  home = 268,
  end = 269,
  f1 = 290,
  f2 = 291,
  f6 = 295,
  f11 = 300,
  f12 = 301,
  f25 = 314,
  zero = '0',
  minus = '-',
  equal = '=',
  plus = '+',
  keypad_0 = 320,
  keypad_minus = 333,
  keypad_plus = 334,
  keypad_enter = 335,
  a = 'A',
  c = 'C',
  o = 'O',
  q = 'Q',
  s = 'S',
  v = 'V',
  x = 'X',
  y = 'Y',
  z = 'Z'
};

/// The keys that type nothing, but for those that change others, such as Shift: ranges, each up to its last one.
inline constexpr Code silent[][2] = {{escape, f25}, {keypad_enter, keypad_enter}};

/// Tells Dear ImGui its own keys.
inline void map() {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyMap[ImGuiKey_Tab] = tab;
  io.KeyMap[ImGuiKey_LeftArrow] = left;
  io.KeyMap[ImGuiKey_RightArrow] = right;
  io.KeyMap[ImGuiKey_UpArrow] = up;
  io.KeyMap[ImGuiKey_DownArrow] = down;
  io.KeyMap[ImGuiKey_PageUp] = page_up;
  io.KeyMap[ImGuiKey_PageDown] = page_down;
  io.KeyMap[ImGuiKey_Home] = home;
  io.KeyMap[ImGuiKey_End] = end;
  io.KeyMap[ImGuiKey_Insert] = insert;
  io.KeyMap[ImGuiKey_Delete] = del;
  io.KeyMap[ImGuiKey_Backspace] = backspace;
  io.KeyMap[ImGuiKey_Space] = space;
  io.KeyMap[ImGuiKey_Enter] = enter;
  io.KeyMap[ImGuiKey_Escape] = escape;
  io.KeyMap[ImGuiKey_KeyPadEnter] = keypad_enter;
  io.KeyMap[ImGuiKey_A] = a;
  io.KeyMap[ImGuiKey_C] = c;
  io.KeyMap[ImGuiKey_V] = v;
  io.KeyMap[ImGuiKey_X] = x;
  io.KeyMap[ImGuiKey_Y] = y;
  io.KeyMap[ImGuiKey_Z] = z;
}
#else
using Code = ImGuiKey;
inline constexpr Code tab = ImGuiKey_Tab, left = ImGuiKey_LeftArrow, right = ImGuiKey_RightArrow, up = ImGuiKey_UpArrow,
                      down = ImGuiKey_DownArrow, page_up = ImGuiKey_PageUp, page_down = ImGuiKey_PageDown,
                      home = ImGuiKey_Home, end = ImGuiKey_End, insert = ImGuiKey_Insert, del = ImGuiKey_Delete,
                      backspace = ImGuiKey_Backspace, space = ImGuiKey_Space, enter = ImGuiKey_Enter,
                      escape = ImGuiKey_Escape, keypad_enter = ImGuiKey_KeypadEnter, f1 = ImGuiKey_F1, f2 = ImGuiKey_F2,
                      f6 = ImGuiKey_F6, f11 = ImGuiKey_F11, f12 = ImGuiKey_F12, a = ImGuiKey_A, c = ImGuiKey_C,
                      o = ImGuiKey_O, q = ImGuiKey_Q, s = ImGuiKey_S, zero = ImGuiKey_0, minus = ImGuiKey_Minus,
                      equal = ImGuiKey_Equal, plus = ImGuiKey_Equal, keypad_0 = ImGuiKey_Keypad0,
                      keypad_minus = ImGuiKey_KeypadSubtract, keypad_plus = ImGuiKey_KeypadAdd, v = ImGuiKey_V,
                      x = ImGuiKey_X, y = ImGuiKey_Y, z = ImGuiKey_Z;

inline constexpr Code silent[][2] = {{ImGuiKey_Tab, ImGuiKey_Backspace},
                                     {ImGuiKey_Enter, ImGuiKey_Escape},
                                     {ImGuiKey_F1, ImGuiKey_F12},
                                     {ImGuiKey_CapsLock, ImGuiKey_Pause},
                                     {ImGuiKey_KeypadEnter, ImGuiKey_KeypadEnter}};

inline void map() {}
#endif

}  // namespace isect::viz::key
