#pragma once
// Key numbers as GLFW gives them and the headless tests use them; window.cpp checks that they agree.

namespace isect::viz::key {

enum Code {
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
  f12 = 301,
  keypad_enter = 335,
  a = 'A',
  c = 'C',
  o = 'O',
  q = 'Q',
  v = 'V',
  x = 'X',
  y = 'Y',
  z = 'Z'
};

}  // namespace isect::viz::key
