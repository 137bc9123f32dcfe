// What a live page tells of each preset is what the native book has written. node told.mjs FOLDER
import { readFileSync, readdirSync } from "node:fs";
import { join, resolve } from "node:path";
import { createRequire } from "node:module";
import { writeFileSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { gunzipSync } from "node:zlib";

const folder = resolve(process.argv[2]);
/// The session, from the scripts that pages from disk load.
export async function session(site, file) {
  const made = mkdtempSync(join(tmpdir(), "isect-live-"));
  const script = [file, file.replace(".js", "-packed.js")].map(one => readFileSync(join(site, one), "utf8")).join("\n");
  writeFileSync(join(made, "isect.cjs"), script + "\nmodule.exports = isect_module;\n");
  const isect_module = createRequire(import.meta.url)(join(made, "isect.cjs"));
  rmSync(made, { recursive: true });
  const code = await isect_module({ wasmBinary: gunzipSync(Buffer.from(isect_module.packed, "base64")) });
  const answer = asked => code.ccall("isect_answer", "string", ["string"], [asked]);
  return request => JSON.parse(answer(JSON.stringify(request)));
}

const of_lessons = await session(folder, "isect.js"), of_scenes = await session(folder, "scenes.js");
const text = html => html.replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&quot;", '"').replaceAll("&apos;", "'").replaceAll("&amp;", "&");
const plain = html => html.replace(/<span data-name="[^"]*">([^]*?)<\/span>/g, "$1").replace(/<svg[^]*?<\/svg>/g, "").trim();
/// Numbers may differ in their last places: sums of three products are taken in another order by the vector instructions
/// of the native build, and sines come from the C library. All else is equal.
const number = /[0-9][0-9,]*(\.[0-9]+)?/g, last_places = 1e-8;
function alike(a, b) {
  if (a.replace(number, "#") !== b.replace(number, "#")) return false;
  const value = text => Number(text.replaceAll(",", "")), x = a.match(number) ?? [], y = b.match(number) ?? [];
  return x.every((n, i) => n === y[i] || Math.abs(value(n) - value(y[i])) <= last_places * Math.abs(value(n)));
}
/// The search for a tight box of a mesh follows the last bits to another one.
const boxes = { "bounding-volumes": ["tilted", "ball"] };
const without_boxes = text => text.replace(/^.*<th scope="row">(OBB|AABB)<\/th>.*$/gm, "");
/// The lines that differ.
function difference(a, b) {
  const x = a.split("\n"), y = b.split("\n");
  return x.flatMap((line, i) => line === y[i] ? [] : [`  native ${line}`, `  live   ${y[i] ?? ""}`]).slice(0, 8).join("\n");
}
let stations = 0, last_place = 0, said_in_all = 0;
const wrong = [];
for (const page of readdirSync(folder).filter(name => name.endsWith(".html")).sort()) {
  const source = readFileSync(join(folder, page), "utf8"), lesson = source.match(/data-lesson="([^"]*)"/)?.[1];
  if (!lesson) continue;
  const scenes = lesson === "scene", ask = scenes ? of_scenes : of_lessons;
  for (const [, preset, walk] of source.matchAll(/<section class="walk[^"]*" id="([^"]*)">([^]*?)<\/section>/g)) {
    const articles = [...walk.matchAll(/<article class="(?:ask|step)[^"]*" id="([^"]*)"([^>]*)>\n([^]*?)<\/article>/g)];
    let frame = ask({ do: "open", ...(scenes ? { scene: text(walk.match(/<pre>([^]*?)<\/pre>/)[1]) } : { lesson, preset }) });
    articles.forEach(([, id, attributes, body], at) => {
      if (at > 0) frame = ask({ do: "go", at });
      ++stations;
      const line = Number(attributes.match(/ data-line="(\d+)"/)?.[1] ?? -1), said = attributes.match(/ data-said="(\w+)"/)?.[1] ?? "";
      if (said !== "") ++said_in_all;
      if (line !== frame.line || said !== frame.said) wrong.push(`${lesson} ${id}: line ${line} says "${said}", live line ${frame.line} "${frame.said}"`);
      const [above, below] = body.replace(/<figure[^]*<\/figure>\n/, "\u0000").split("\u0000");
      const kept = boxes[lesson]?.includes(preset) ? without_boxes : text => text;
      const written = kept(plain(below === undefined ? above : above + below)), told = kept(plain((frame.above ?? "") + (frame.below ?? "")));
      if (!frame.wrong && written !== told && alike(written, told)) ++last_place;
      else if (frame.wrong || written !== told) wrong.push(`${lesson} ${id}: ${frame.wrong ?? ""}\n${difference(written, told)}`);
    });
    const given = walk.match(/<p class="given">[^]*?<\/p>/)[0];
    if (plain(frame.given ?? "") !== given) wrong.push(`${lesson} ${preset}, what is given:\n  native ${given}\n  live   ${frame.given}`);
    if (frame.count !== articles.length) wrong.push(`${lesson} ${preset}: ${frame.count} stations of ${articles.length}`);
  }
}
wrong.slice(0, 12).forEach(text => console.log(text));
console.log(`${stations} stations, ${last_place} differ in last places, ${wrong.length} otherwise`);
process.exitCode = wrong.length === 0 && stations > 100 && said_in_all > 20 ? 0 : 1;
