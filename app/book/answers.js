"use strict";
// A line's number and the letters of an order as people type them, and what is said to an order, by the rules of
// viz/walk/pointed_line.cpp and viz/walk/given_order.cpp: tests/typed_answers.json holds both to them.
/// The line, from 0, whose number was typed; throws an Error that says what is wrong.
function isect_line(typed, lines) {
  const text = typed.replaceAll(" ", "").toLowerCase().replace(/^line/, "");
  if (text === "") throw new Error("a line's number is missing");
  if (!/^[0-9]+$/.test(text)) throw new Error(`“${typed}” is not a line's number`);
  const number = text.length > 4 ? lines + 1 : Number(text);
  if (number < 1 || number > lines) throw new Error(`the lines have the numbers 1 to ${lines}`);
  return number - 1;
}
/// The letters of so many tiles in the order in which they were typed; throws an Error that says what is wrong.
function isect_order(typed, tiles) {
  const letters = "abcdefghijklmnopqrstuvwxyz".slice(0, tiles), order = [];
  for (const letter of typed.toLowerCase().replace(/[ ,]/g, "")) {
    if (!letters.includes(letter)) throw new Error(`the letters are a to ${letters.at(-1)}`);
    if (order.includes(letter)) throw new Error(`${letter} is there twice`);
    order.push(letter);
  }
  for (const letter of letters) if (!order.includes(letter)) throw new Error(`${letter} is missing`);
  return order.join("");
}
/// What is said to an order, as HTML; empty: it is right. Tiles of one rank may come in any order among themselves.
function isect_said_to_order(order, { tiles, ranks, wrong }) {
  const at = letter => letter.charCodeAt(0) - 97, sorted = [...ranks].sort((a, b) => a - b);
  const place = [...order].findIndex((letter, i) => ranks[at(letter)] !== sorted[i]);
  if (place < 0) return "";
  const known = wrong.find(([letters]) => letters === order), name = tiles[at(order[place])];
  if (known) return known[1];
  if (place === 0) return `The first is not ${name}.`;
  const words = ["no", "one", "two", "three", "four", "five", "six", "seven", "eight"];
  return `The first ${place === 1 ? "is" : `${words[place] ?? place} are`} right. The next is not ${name}.`;
}
