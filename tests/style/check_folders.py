#!/usr/bin/env python3
"""The house as its includes draw it.

- An #include "..." names a file that exists: "lanthorn/NAME/x.h" in the include/ folder of its library, everything else from
  the repository root (shaders also from their own folder).
- Public headers (below an include/ folder) include public headers only.
- Includes run one way along the floors of CONTRIBUTING.md.
- A technique includes nothing of another technique, and what techniques share includes nothing of any technique.
- No two headers define types of one name in one namespace: a program that links both would mix them up without a word.
- JSON is parsed in engine/core/json.cpp alone, which bounds depth and numbers.
- Every source belongs to a target: a CMakeLists.txt in its folder or above names it.
- Every shader is used: a source loads it by its path, or what is used includes it; what tests alone load is a test's.
"""
import os
import re
import subprocess
import sys

os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
files = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], check=True, capture_output=True, text=True).stdout.split("\n")
files = [f for f in files if f and os.path.exists(f)]
known = set(files)
problems = []

# Folders by floor, lowest first; a folder includes another of its floor only where BESIDE says so.
FLOORS = [
    ["engine/core", "engine/build_info"],
    ["engine/manual", "engine/ecs"],
    ["engine/scene"],
    ["engine/animation", "engine/deformation", "engine/physics", "engine/assets", "engine/image_module"],
    ["engine/gpu"],
    ["engine/render"],
    ["engine/runtime"],
    ["engine/replay", "engine/input", "engine/ui", "engine/audio", "engine/session", "engine/shell"],
    ["gi_module"],
    ["game"],
    ["tools"],
]
BESIDE = {
    ("engine/core", "engine/build_info"),
    ("engine/image_module", "engine/assets"),
    ("engine/session", "engine/replay"),
    ("engine/ui", "engine/input"),
    ("engine/shell", "engine/input"),
    ("engine/shell", "engine/ui"),
    ("engine/shell", "engine/audio"),
    ("engine/shell", "engine/session"),
    ("engine/shell", "engine/replay"),
}
# `replay` knows neither a runtime nor a renderer.
NEVER = {("engine/replay", "engine/runtime"), ("engine/replay", "engine/render"), ("engine/replay", "engine/gpu")}
# gi_module renders from the FrameScene alone.
NEVER |= {("gi_module", "engine/assets"), ("gi_module", "game"), ("gi_module", "tools")}

level = {room: i for i, floor in enumerate(FLOORS) for room in floor}


def room_of(path):
    parts = path.split("/")
    if parts[0] == "engine":
        return "/".join(parts[:2])
    return parts[0] if parts[0] in level else None


headers = {}  # "lanthorn/NAME/x.h" -> file
for f in files:
    found = re.match(r".*/include/(lanthorn/.+)$", f)
    if found:
        if found.group(1) in headers:
            problems.append(f"{f}: {headers[found.group(1)]} is included by the same name")
        headers[found.group(1)] = f

CODE = re.compile(r"\.(cpp|h|glsl|comp|frag|vert|geom)$")
SHADER = re.compile(r"\.(glsl|comp|frag|vert|geom)$")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"')
PARSES_JSON = re.compile(r"[Jj]son::(parse|accept|sax_parse|from_\w+)\s*\(")
JSON_DOOR = "engine/core/json.cpp"
FOREIGN = ("backends/imgui_impl_",)  # Dear ImGui's own folder
OUTSIDE = ("tests/consumer/",)       # projects of their own, with an installation

for f in files:
    if not CODE.search(f) or f.startswith(OUTSIDE):
        continue
    room = room_of(f)
    technique = re.match(r"gi_module/techniques/([^/]+)/", f)
    technique = technique.group(1) if technique and technique.group(1) != "include" else None
    with open(f, errors="replace") as text:
        for number, line in enumerate(text, 1):
            if room and f != JSON_DOOR and PARSES_JSON.search(line):
                problems.append(f"{f}:{number}: parses JSON, expected parse_json() of engine/core/json.h")
            m = INCLUDE.match(line)
            if not m or m.group(1).startswith(FOREIGN):
                continue
            name = m.group(1)
            place = f"{f}:{number}"
            target = headers.get(name) or (name if name in known else None)
            if target is None and SHADER.search(f):
                beside = os.path.normpath(os.path.join(os.path.dirname(f), name))
                target = beside if beside in known else None
            if target is None:
                problems.append(f'{place}: "{name}" names no file of the tree')
                continue
            if "/include/lanthorn/" in target and name not in headers and not SHADER.search(f):
                problems.append(f'{place}: "{name}" is public: include it as "{target.split("/include/", 1)[1]}"')
            if "/include/lanthorn/" in f and "/include/lanthorn/" not in target:
                problems.append(f'{place}: a public header includes "{name}", which is private')
            to = room_of(target)
            if room and to and room != to:
                if (room, to) in NEVER:
                    problems.append(f"{place}: {room} may not include {to}")
                elif level[to] > level[room] or (level[to] == level[room] and (room, to) not in BESIDE):
                    problems.append(f"{place}: {room} includes {to}, which is not below it")
            other = re.match(r"gi_module/techniques/([^/]+)/", target)
            if other and other.group(1) != "include" and f.startswith("gi_module/"):
                shared = f.startswith(("gi_module/shared/", "gi_module/reference/"))
                if shared or (technique and technique != other.group(1)):
                    problems.append(f"{place}: {os.path.dirname(f)} includes the technique {other.group(1)}'s {name}")

# Types and where they are defined.
NAMESPACE = re.compile(r"^namespace (lanthorn[\w:]*) \{", re.M)
TYPE = re.compile(r"^(?:struct|class|enum class|enum) (\w+)(?: final)?(?: *:(?!:)[^{;]*)? *\{", re.M)
defined = {}
for f in files:
    if f.endswith(".h") and room_of(f):
        with open(f) as stream:
            text = stream.read()
        inside = NAMESPACE.search(text)
        for m in TYPE.finditer(text):
            name = (inside.group(1) if inside else "") + "::" + m.group(1)
            if defined.setdefault(name, f) != f:
                problems.append(f"{f}: {name} is defined in {defined[name]} too")

# Sources and their targets.
lists = {}
for f in files:
    if os.path.basename(f) == "CMakeLists.txt":
        lists[os.path.dirname(f)] = open(f).read()
# What lists name from the repository's root or by way of another folder.
by_path = set()
for folder, text in lists.items():
    for word in re.split(r"[\s()\"]+", text):
        if word.startswith("${PROJECT_SOURCE_DIR}/"):
            by_path.add(word.removeprefix("${PROJECT_SOURCE_DIR}/"))
        elif word.startswith("../"):
            by_path.add(os.path.normpath(os.path.join(folder, word)))
for f in files:
    if not f.endswith(".cpp"):
        continue
    folder = os.path.dirname(f)
    named = False
    while True:
        text = lists.get(folder)
        if text is not None:
            relative = os.path.relpath(f, folder)
            words = set(re.split(r"[\s()\"]+", text))
            stem = relative[: -len(".cpp")]
            parts = relative.split("/")
            # As written, from the repository's root, with a folder that a function of that list puts before it, or in a loop.
            named = (relative in words or f in by_path
                     or (len(parts) > 1 and "/".join(parts[1:]) in words and parts[0] in words)
                     or (stem in words and re.search(r"\$\{\w+\}\.cpp", text) is not None))
        if named or not folder:
            break
        folder = os.path.dirname(folder)
    if not named:
        problems.append(f"{f}: no CMakeLists.txt names it")

# Shaders and who uses them. Paths in C++ are whole, or put together of a beginning and a name: "FOLDER/lit_" + "texels" + ".comp".
shaders = {f for f in files if SHADER.search(f)}
literals, of_tests, included = set(), set(), {}
for f in files:
    if not CODE.search(f):
        continue
    with open(f, errors="replace") as stream:
        text = stream.read()
    if not SHADER.search(f):
        (of_tests if f.startswith("tests/") else literals).update(re.findall(r'"([^"\\\n]+)"', text))
    for name in re.findall(r'^\s*#\s*include\s*"([^"]+)"', text, re.M) if SHADER.search(f) or not f.startswith("tests/") else ():
        beside = os.path.normpath(os.path.join(os.path.dirname(f), name))
        included.setdefault(f, set()).add(headers.get(name) or (name if name in known else beside))
beginnings = [l for l in literals if "/" in l and "." not in l]


def loaded(shader):
    stem = os.path.splitext(shader)[0]
    if shader.startswith("tests/") and shader in of_tests:
        return True
    return shader in literals or any(stem.startswith(b) and stem[len(b):] in literals for b in beginnings)


used = {f for f in shaders if loaded(f)} | {f for f in included if not SHADER.search(f)}
todo = list(used)
while todo:
    for f in included.get(todo.pop(), ()):
        if f not in used:
            used.add(f)
            todo.append(f)
for f in sorted(shaders - used):
    problems.append(f"{f}: no source loads it and nothing that is used includes it")

for problem in problems:
    print(problem, file=sys.stderr)
print(f"{len(files)} files, {len(headers)} public headers, {len(problems)} problems")
sys.exit(1 if problems else 0)
