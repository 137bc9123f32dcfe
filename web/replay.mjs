// The lessons and the oracle as emscripten compiles them, held to what the native program has said:
//   node replay.mjs BUILD ROOT ISECT [PEER_CASES]
// Each query's answer is the native one, to the byte; each preset's trace is the accepted one.
import { spawnSync } from "node:child_process";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

const [build, root, isect, peers] = process.argv.slice(2);
const options = { encoding: "utf8", maxBuffer: 1 << 30 };
const compiled = (args, input = "") =>
  spawnSync(process.execPath, ["--no-experimental-fetch", join(build, "replay.js"), ...args], { ...options, input });

const traces = compiled([join(root, "snapshots")]);
const differ = traces.stdout.trim().split("\n"), summary = differ.pop();
differ.slice(0, 20).forEach(line => console.log(line));
console.log(`traces: ${summary}`);
if (!/^\d+ presets, \d+ steps/.test(summary)) console.log(traces.stderr), process.exit(1);

/// Cases of a file: a list, or an object that has them, as `tests/cases` and the peers' files do.
function cases_in(file) {
  const json = JSON.parse(readFileSync(file, "utf8"));
  return Array.isArray(json) ? json : Array.isArray(json.cases) ? json.cases : [];
}
const lines = readFileSync(join(root, "tests/app/query_examples.jsonl"), "utf8").split("\n").filter(Boolean);
for (const folder of [join(root, "tests/cases"), peers].filter(f => f && existsSync(f)))
  for (const file of readdirSync(folder).filter(name => name.endsWith(".json")).sort())
    for (const one of cases_in(join(folder, file))) lines.push(JSON.stringify(one));
const input = lines.join("\n") + "\n";
const native = spawnSync(isect, ["query"], { ...options, input }).stdout.split("\n");
const answers = compiled([], input).stdout.split("\n");
let same = 0;
const other = [];
lines.forEach((line, i) => {
  if (native[i] === answers[i]) ++same;
  else other.push(`${line.slice(0, 160)}\n  native   ${native[i]}\n  compiled ${answers[i]}`);
});
other.slice(0, 10).forEach(text => console.log(text));
console.log(`queries: ${lines.length}, ${same} answers are equal, ${other.length} are not`);
process.exit(differ.length === 0 && other.length === 0 && lines.length > 1000 ? 0 : 1);
