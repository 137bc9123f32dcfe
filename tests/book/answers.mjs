// A page reads lines and orders, and judges orders, as the program does: answers.mjs app/book/answers.js tests/typed_answers.json
import { readFileSync } from "node:fs";
const [script, table] = process.argv.slice(2).map(file => readFileSync(file, "utf8"));
const { line, order, said } = new Function(script + "\nreturn { line: isect_line, order: isect_order, said: isect_said_to_order };")();
const cases = JSON.parse(table), wrong = [];
let checked = 0;
function check(what, got, wanted) {
  ++checked;
  const refused = got instanceof Error;
  if (refused ? typeof wanted !== "string" || !got.message.includes(wanted) : got !== wanted) wrong.push(`${what}: ${got}, and not ${wanted}`);
}
function tried(read) {
  try { return read(); } catch (refused) { return refused; }
}
for (const [typed, lines, wanted] of cases.lines) check(`“${typed}”`, tried(() => line(typed, lines)), wanted);
for (const [typed, tiles, wanted] of cases.orders) check(`“${typed}”`, tried(() => order(typed, tiles)), wanted);
for (const one of cases.said) check(`${one.order} of ${one.ranks}`, said(one.order, one), one.said);
console.log([...wrong, `${checked} answers, ${wrong.length} wrong`].join("\n"));
process.exit(wrong.length > 0 || checked < 50 ? 1 : 0);
