#!/usr/bin/env python3
"""The matrix of pairs: what each question about two shapes is proved by, read from the sources themselves.

    matrix.py            prints the table and the gaps
    matrix.py --check    fails where core/README.md or the named gaps are not as the sources are
    matrix.py --write    writes the table into core/README.md

A pair is a public function of two shapes in a header of core/isect: its name is the question. It is proved by
  oracle     a test of its header that finds the truth in rationals
  families   hard cases that are drawn: in bench/<header>, in that test, or by the judge of scenes, tests/proof
  suite      a suite of measurements in bench includes its header and measures a test by its name (`measured_as`)
  query      a kind of `isect query`, or a scene as one of its lines
  cases      hard cases for other libraries: tests/cases/<kind>.json, or lines of tests/cases/scenes
  free       a listener costs nothing: tests/core/zero_cost_trace.cpp, some of its groups in a long run alone ("-": it takes
             no listener)
  fuzz       the kind's fields in tests/fuzz/cases_fuzz.cpp, or a scene's objects in scenes_fuzz.cpp
  scene      a scene asks it ("-": one of the two is no object of a scene)
  lesson     a lesson tells it
A gap that tests/core/matrix_gaps.txt does not name fails, and so does a named gap that is none any more.
"""

import collections
import functools
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CORE, GAPS, README = ROOT / "core/isect", ROOT / "tests/core/matrix_gaps.txt", ROOT / "core/README.md"
COLUMNS = ["oracle", "families", "suite", "query", "cases", "free", "fuzz", "scene", "lesson"]
BEGIN, END = "<!-- matrix: written by tests/core/matrix.py -->\n", "<!-- end of the matrix -->\n"

QUESTIONS = "relate intersects intersect first_hit all_hits may_intersect locate side cull clip".split()
SHAPES = ("Point Segment Straight Ray Plane Sphere Aabb Obb Kdop Capsule Cylinder Cone Triangle Polygon Ring ConvexPolygon HalfSpaces Hull3 "
          "Frustum TriangleMesh TriangulatedPolygon Interval").split()
SIGNATURE = re.compile(r"\b(%s)\(const ([\w:]+)(?:<([^>]*)>)?& ?\w*,\s*(?:const )?([\w:]+)(?:<([^>]*)>)?& ?\w*" % "|".join(QUESTIONS))

# What `isect query` calls a shape, where that is not its name in small letters.
KIND_OF = {"Aabb": "box", "HalfSpaces": "solid", "Straight": "line", "Hull3": "hull", "TriangleMesh": "mesh"}
# Kinds that are not called by both shapes: (first, second, dimension).
OTHER_KINDS = {("Point", "Polygon", "2"): "pip", ("Point", "Ring", "2"): "pip", ("Point", "ConvexPolygon", "2"): "pip",
               ("Ray", "Polygon", "3"): "ray_polygon", ("Segment", "Polygon", "3"): None,  # its kind is of the plane
               ("Ring", "Plane", "2, 3"): "polygon_plane", ("Ring", "Aabb", "2, 3"): "polygon_box",
               ("ConvexPolygon", "ConvexPolygon", "2"): "convex_polygons",
               ("Ray", "Ring", "3"): "ray_polygon", ("Ray", "Triangle", "3"): "ray_polygon"}

# Kinds that are called as their headers.
OF_HEADER = {("ray_outline", "2"): ("Ray", "ray_outline"), ("line_triangle", "3"): ("Ray", "line_triangle"),
             ("point_plane", "2, 3"): ("Plane", "point_plane")}

# What suites call a shape, where that is not its name in small letters; and tests that are not called by both shapes.
SUITE_OF = {"HalfSpaces": "half-spaces", "Straight": "line", "Hull3": "hull", "TriangleMesh": "mesh",
            "ConvexPolygon": "convex-polygon", "TriangulatedPolygon": "polygon-in-space"}
OTHER_TESTS = {("Point", "Polygon"): "point-in-polygon", ("Point", "ConvexPolygon"): "point-in-convex-polygon"}

# What scenes call a shape: the types of objects that it stands for.
OBJECTS = {"Aabb": ["box"], "HalfSpaces": ["hull", "kdop", "obb", "frustum"], "Straight": ["line", "ray", "segment"],
           "TriangleMesh": ["mesh"], "Ring": ["polygon"], "TriangulatedPolygon": ["polygon"], "Hull3": ["hull"]}

# A clipped part is no verdict that scenes' cases or their fuzzing tell.
CLIPPED = ("clip_polygon", "clip_segment")
# What scenes ask through another header: (header that they include, what it includes).
THROUGH = {"sphere_half_spaces": "capsule_half_spaces", "triangle_half_spaces": "sphere_triangle"}
# A convex polygon prepared for many questions is no object of a scene: outlines are asked as polygons of any form. Nor
# is an interval.
NO_OBJECT = ("point_convex_polygon", "convex_polygons", "interval_interval")

Pair = collections.namedtuple("Pair", "header first second dimension")


def text(path):
    return path.read_text(encoding="utf-8") if path.is_file() else ""


def all_text(folder, pattern):
    return "\n".join(text(p) for p in sorted((ROOT / folder).rglob(pattern)))


def public(source):
    """A header without comments and without what stands in its namespaces `detail`."""
    source = re.sub(r"//[^\n]*", "", source)
    for found in re.finditer(r"namespace [\w:]*detail(?:::\w+)? \{", source):
        depth, at = 1, found.end()
        while depth and at < len(source):
            depth += {"{": 1, "}": -1}.get(source[at], 0)
            at += 1
        source = source[:found.start()] + re.sub(r"[^\n]", " ", source[found.start():at]) + source[at:]
    return source


@functools.cache
def pairs():
    """Each pair with its questions, in the order of the headers."""
    found = {}
    for header in sorted(CORE.glob("*.h")):
        for question, a, of_a, b, of_b in SIGNATURE.findall(public(text(header))):
            a, b = a.split("::")[-1], b.split("::")[-1]
            if a not in SHAPES or b not in SHAPES:
                continue
            numbers = re.findall(r"\b[23]\b", f"{of_a} {of_b}")
            dimension = numbers[0] if numbers else "2" if "ConvexPolygon" in (a, b) else "3" if {"TriangleMesh", "TriangulatedPolygon", "Cylinder", "Cone", "Straight"} & {a, b} else "1" if a == b == "Interval" else "2, 3"
            asked = found.setdefault(Pair(header.stem, a, b, dimension), [])
            if question not in asked:
                asked.append(question)
    return found


def measured_as(pair):
    """The name of its test in the report. Where several headers ask the same two shapes, the header's name follows."""
    shapes = pair[1:3]
    name = "-".join(SUITE_OF.get(s, s.lower()) for s in shapes)
    header = pair.header.replace("_", "-")
    others = [p for p in pairs() if p[1:3] == shapes and p != pair]
    if name != header and any(p.header != pair.header for p in others):
        name += " " + header
    if pair.dimension == "3" and any(p.header == pair.header for p in others):
        name += " in space"
    return OTHER_TESTS.get(shapes, name)


class Evidence:
    def __init__(self):
        self.suites = [all_text(p.parent.relative_to(ROOT), "*.*") for p in sorted(ROOT.glob("bench/*/suite.cpp"))]
        self.kinds = set(re.findall(r"ISECT_HANDLER\(\s*(\w+)", all_text("app/query", "*_handlers.cpp")))
        self.kinds |= set(re.findall(r'\{"(\w+)", *"', all_text("app/query", "*_handlers.cpp")))
        self.fuzz = text(ROOT / "tests/fuzz/cases_fuzz.cpp")
        self.fuzzed = set(re.findall(r'"(\w+)"', text(ROOT / "tests/fuzz/scenes_fuzz.cpp")))  # types of objects
        self.lines = set()  # (type, type, dimension) of the scenes among the cases
        for dimension, name in (("2", "plane"), ("3", "space")):
            for line in text(ROOT / f"tests/cases/scenes/{name}.jsonl").splitlines():
                a, b = (next(iter(o)) for o in json.loads(line)["objects"])
                self.lines |= {(a, b, dimension), (b, a, dimension)}
        self.traced = text(ROOT / "tests/core/zero_cost_trace.cpp")
        self.scene = all_text("app/scene", "*.cpp") + all_text("app/scene", "*.h")
        self.scene += text(CORE / "ask.h") + text(CORE / "parts/ask_pairs.h")  # by which scenes ask any two shapes
        self.lessons = all_text("lessons", "*.cpp") + all_text("lessons", "*.h")
        self.tests = [text(p) for p in sorted((ROOT / "tests/core").rglob("*_test.cpp"))]

    def kind(self, pair):
        if (pair.header, pair.dimension) in OF_HEADER and OF_HEADER[pair.header, pair.dimension][0] == pair.first:
            return OF_HEADER[pair.header, pair.dimension][1]
        name = lambda shape: KIND_OF.get(shape, shape.lower())
        wanted = OTHER_KINDS.get(pair[1:], f"{name(pair.first)}_{name(pair.second)}")
        return wanted if wanted in self.kinds else None

    def asked_by_scenes(self, pair):
        include = f"<isect/{THROUGH.get(pair.header, pair.header)}.h>"
        return include in self.scene and pair.header not in NO_OBJECT

    def objects(self, pair):
        """Types of objects that a scene asks the pair of; none where it asks another question."""
        if pair.header in CLIPPED or not self.asked_by_scenes(pair):
            return []
        names = lambda shape: OBJECTS.get(shape, [shape.lower()])
        return [(a, b) for a in names(pair.first) for b in names(pair.second)]

    def in_lines(self, pair):
        asked = self.objects(pair)
        return bool(asked) and all(any((a, b, d) in self.lines for a, b in asked) for d in pair.dimension.split(", "))

    def measured(self, pair):
        """A ring is asked as a polygon of one: by the same code."""
        names = {measured_as(p) for p in (pair, pair._replace(second=pair.second.replace("Ring", "Polygon")))}
        return any(f"<isect/{pair.header}.h>" in suite and any(f'"{n}"' in suite for n in names) for suite in self.suites)

    def of(self, pair):
        include, kind = f"<isect/{pair.header}.h>", self.kind(pair)
        tests = "\n".join(t for t in self.tests if include in t)
        bench = ROOT / "bench" / pair.header
        scene = kind is not None and f'"{kind}"' in self.scene or self.asked_by_scenes(pair)
        takes_listener = "Trace&&" in text(CORE / f"{pair.header}.h")
        return {
            "oracle": bool(re.search(r"oracle|Rational|\btruth\b", tests)),
            "families": "family" in all_text(bench, "*.*") or bool(re.search("famil|all_numbers", tests)) or scene and pair.header not in CLIPPED,
            "suite": self.measured(pair),
            "query": f"`{kind}`" if kind else "scene" if scene else False,
            "cases": kind is not None and (ROOT / f"tests/cases/{kind}.json").is_file() or self.in_lines(pair),
            "free": include in self.traced if takes_listener else None,
            "fuzz": kind is not None and f'"{kind}"' in self.fuzz or any({a, b} <= self.fuzzed for a, b in self.objects(pair)),
            "scene": scene or (None if pair.header in NO_OBJECT else False),
            "lesson": include in self.lessons,
        }


def told(pair):
    return f"{pair.first} {pair.second} ({pair.header}, {pair.dimension})"


def table(rows):
    lines = ["| first | second | dimensions | questions | header | " + " | ".join(COLUMNS) + " |", "| --- " * (5 + len(COLUMNS)) + "|"]
    sign = {True: "yes", False: "", None: "-"}  # or a name
    for pair, (questions, proof) in rows.items():
        cells = [pair.first, pair.second, pair.dimension, ", ".join(f"`{q}`" for q in questions),
                 f"[`{pair.header}.h`](isect/{pair.header}.h)"] + [sign.get(proof[c], proof[c]) for c in COLUMNS]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main(arguments):
    evidence = Evidence()
    rows = {pair: (questions, evidence.of(pair)) for pair, questions in pairs().items()}
    gaps = [f"{told(pair)}: {c}" for pair, (_, proof) in rows.items() for c in COLUMNS if proof[c] is False]
    written = table(rows)
    readme = text(README)
    if "--write" in arguments:
        before, after = readme.split(BEGIN)[0], readme.split(END)[1]
        README.write_text(before + BEGIN + written + END + after, encoding="utf-8")
        return 0
    if "--check" not in arguments:
        print(written + "\n" + "\n".join(gaps))
        return 0
    named = [line for line in text(GAPS).splitlines() if line and not line.startswith("#")]
    wrong = [f"a gap that is not named: {g}" for g in gaps if g not in named]
    wrong += [f"named, and no gap any more: {g}" for g in named if g not in gaps]
    if BEGIN + written + END not in readme:
        wrong.append("core/README.md holds another table: tests/core/matrix.py --write")
    print("\n".join(wrong) or f"{len(rows)} pairs, {len(gaps)} gaps, all named")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
