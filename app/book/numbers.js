"use strict";
// Numbers as people type them, by the rules of viz/text/number_text.cpp: tests/typed_numbers.json holds both to them.
/// The number that a text denotes; throws an Error that says what is wrong.
function isect_number(typed) {
  const signs = { "−": "-", "–": "-", "·": "*", "⋅": "*", "×": "*", "÷": "/", "⁄": "/", "π": "pi", "√": "sqrt", "²": "^2",
    "³": "^3", ",": ".", "\t": " ", "\u00a0": " ", "\u2009": "", "\u202f": "" };
  const text = [...typed].map(sign => signs[sign] ?? sign).join(""), deepest = 40;
  let at = 0;
  function fail(why) { throw new Error(why); }
  function next() {
    while (text[at] === " ") ++at;
    return text[at] ?? "";
  }
  function at_word(word) { return next(), text.startsWith(word, at); }
  function take(word) {
    if (!at_word(word)) return false;
    at += word.length;
    return true;
  }
  function sum(depth) {
    let value = product(depth);
    for (;;) {
      if (take("+")) value += product(depth);
      else if (take("-")) value -= product(depth);
      else return value;
    }
  }
  function product(depth) {
    let value = signed_power(depth);
    for (;;) {
      if (take("*")) value *= signed_power(depth);
      else if (take("/")) {
        const by = signed_power(depth);
        if (by === 0) fail("it divides by 0");
        value /= by;
      } else if (at_word("pi") || at_word("sqrt")) value *= power(depth);
      else return value;
    }
  }
  function signed_power(depth) {
    if (depth > deepest) fail("too many brackets and signs");
    if (take("-")) return -signed_power(depth + 1);
    if (take("+")) return signed_power(depth + 1);
    return power(depth);
  }
  function power(depth) {
    const base = factor(depth);
    return take("^") ? base ** signed_power(depth + 1) : base;
  }
  function factor(depth) {
    if (depth > deepest) fail("too many brackets and signs");
    if (take("(")) {
      const value = sum(depth + 1);
      if (!take(")")) fail("a bracket is not closed");
      return value;
    }
    if (take("pi")) return Math.PI;
    if (take("sqrt")) {
      const square = factor(depth + 1);
      if (square < 0) fail("it takes the root of a negative number");
      return Math.sqrt(square);
    }
    return number();
  }
  function number() {
    if (next() === "") fail("a number is missing");
    const found = /^(\d+\.?\d*|\.\d+)(e[+-]?\d+)?/i.exec(text.slice(at));
    if (!found) fail(`“${text.slice(at)}” is not a number`);
    const value = Number(found[0]);
    if (!Number.isFinite(value) || (value === 0 && /[1-9]/.test(found[1]))) fail(`“${found[0]}” is beyond the range of numbers`);
    at += found[0].length;
    return value;
  }
  const value = sum(0);
  if (next() !== "") fail(`“${text.slice(at)}” does not belong to a number`);
  if (!Number.isFinite(value)) fail("that is no finite number");
  return value;
}
