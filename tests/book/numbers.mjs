// A page reads what is typed as the program does: numbers.mjs app/book/numbers.js tests/typed_numbers.json
import { readFileSync } from "node:fs";
const [script, table] = process.argv.slice(2).map(file => readFileSync(file, "utf8"));
const read = new Function(script + "\nreturn isect_number;")();
const cases = JSON.parse(table), wrong = [];
for (const [typed, wanted] of cases) {
  let got;
  try { got = read(typed); } catch (refused) { got = refused.message; }
  const right = typeof wanted === "string" ? typeof got === "string" && got.includes(wanted)
      : typeof got === "number" && Math.abs(got - wanted) <= 1e-15 * Math.abs(wanted);
  if (!right) wrong.push(`“${typed}”: ${got}, and not ${wanted}`);
}
console.log([...wrong, `${cases.length} texts, ${wrong.length} wrong`].join("\n"));
process.exit(wrong.length > 0 || cases.length < 80 ? 1 : 0);
