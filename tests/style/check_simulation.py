#!/usr/bin/env python3
"""What would make two runs of the simulation differ, found in its source.

- Wall clocks, and the C library's and the system's random numbers: a step is a function of level, seed and inputs.
- Iteration over std::unordered_map and std::unordered_set, whose order the library chooses; over std::map and std::set of pointers,
  whose order addresses choose.
- Sums in the order of threads: atomic floating-point numbers, tbb::parallel_reduce, std::execution policies, and `+=` in the body of a
  parallel loop to what all its calls share.

A line that is right all the same says so behind it: `// order does not matter: WHY` or `// for reports: WHY`.
"""
import os
import re
import subprocess
import sys

FOLDERS = ("engine/animation/", "engine/deformation/", "engine/ecs/", "engine/input/", "engine/physics/", "engine/replay/", "engine/runtime/", "engine/scene/",
           "engine/session/", "game/level/", "game/rules/")
EXCUSE = re.compile(r"//.*\b(order does not matter|for reports): \S")
LINES = [
    (re.compile(r"\b(system_clock|steady_clock|high_resolution_clock|gettimeofday|clock_gettime|std::clock|std::time|localtime)\b"),
     "a wall clock"),
    (re.compile(r"\b(std::rand|srand|random_device|mt19937(_64)?|default_random_engine|getrandom)\b"), "random numbers that are no counter's"),
    (re.compile(r"\bstd::atomic<\s*(float|double|long double)\s*>"), "an atomic sum of fractions, in the order of threads"),
    (re.compile(r"\bparallel_reduce\b"), "parallel_reduce, whose sums follow the threads (parallel_deterministic_reduce does not)"),
    (re.compile(r"\bstd::execution::(par|par_unseq|unseq)\b"), "an execution policy, whose order is not known"),
]
UNORDERED = re.compile(r"\bstd::unordered_(?:multi)?(?:map|set)<[^;]*?>\s+(\w+)\s*[;{=(,)]")
BY_ADDRESS = re.compile(r"\bstd::(?:multi)?(?:map|set)<\s*(?:const\s+)?[\w:]+(?:\s+const)?\s*\*[^;]*?>\s+(\w+)\s*[;{=(,)]")
PARALLEL = re.compile(r"\b(?:parallel_each|parallel_for|parallel_for_each)\s*\(")
ADDS = re.compile(r"(?<![\w.\]>)])(\w+)\s*[+\-*]=(?!=)")


def body_of(text, at):
    """From the bracket at `at` to the one that closes it."""
    depth = 0
    for i in range(at, len(text)):
        depth += {"(": 1, ")": -1}.get(text[i], 0)
        if depth == 0:
            return text[at:i]
    return text[at:]


def problems_in(name, text, others=""):
    """`others`: a header whose members the source may go through."""
    found = []
    lines = text.split("\n")

    def say(number, what):
        if not EXCUSE.search(lines[number - 1]):
            found.append(f"{name}:{number}: {what}")

    bare = [re.sub(r'"(?:[^"\\]|\\.)*"', '""', line).split("//")[0] for line in lines]
    code = "\n".join(bare)
    for number, line in enumerate(bare, 1):
        for pattern, what in LINES:
            if pattern.search(line):
                say(number, what)
    for pattern, what in ((UNORDERED, "in an order that the library chooses"), (BY_ADDRESS, "in the order of addresses")):
        for variable in set(pattern.findall(code) + pattern.findall(others)):
            through = re.compile(r"for\s*\([^;)]*:\s*(?:\w+(?:\.|->))*" + variable + r"\s*\)|\b" + variable + r"\.c?begin\(\)")
            for m in through.finditer(code):
                say(code.count("\n", 0, m.start()) + 1, f"goes through '{variable}' {what}")
    for m in PARALLEL.finditer(code):
        body = body_of(code, m.end() - 1)
        for add in ADDS.finditer(body):
            variable = add.group(1)
            own = re.search(r"[\w>&*]\s+[&*]?" + variable + r"\s*(?:[=;,){:]|\[)", body)
            if not own:
                say(code.count("\n", 0, m.end() - 1 + add.start()) + 1, f"adds to '{variable}' in the order of threads")
    return found


PLANTED = [
    "const auto now = std::chrono::steady_clock::now();",
    "const int dice = std::rand();",
    "std::mt19937 random(1);",
    "std::unordered_map<int, double> mass;\nfor (const auto& [id, m] : mass) {\n    sum += m;\n}",
    "std::unordered_set<Entity> open;\nauto first = open.begin();",
    "std::set<const Body*> touched;\nfor (const Body* body : touched) {\n}",
    "std::atomic<float> sum{0};",
    "tbb::parallel_reduce(range, 0.0, add, plus);",
    "std::reduce(std::execution::par, a, b);",
    "double sum = 0;\nbodies.parallel_each([&](const Body& b) {\n    sum += b.mass;\n});",
]
HONEST = [
    "std::unordered_map<int, double> mass;\nconst auto found = mass.find(3);",
    "std::map<std::string, int> ages;\nfor (const auto& [name, age] : ages) {\n}",
    "bodies.parallel_each([&](Body& b) {\n    double sum = 0;\n    sum += b.mass;\n    b.speed += sum;\n});",
    "tbb::parallel_deterministic_reduce(range, 0.0, add, plus);",
    "const auto start = std::chrono::steady_clock::now();  // for reports: how long it took",
    "say(\"std::rand\");  // and std::time in words",
]


def check_itself():
    for text in PLANTED:
        if not problems_in("planted", text):
            sys.exit(f"check_simulation.py does not find what was planted:\n{text}")
    for text in HONEST:
        if found := problems_in("honest", text):
            sys.exit(f"check_simulation.py finds {found} in what is right:\n{text}")


def main():
    check_itself()
    os.chdir(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
    files = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], check=True, capture_output=True, text=True).stdout.split("\n")
    files = [f for f in files if f.startswith(FOLDERS) and f.endswith((".cpp", ".h")) and os.path.exists(f)]
    if len(files) < 100:
        sys.exit(f"check_simulation.py found {len(files)} sources, expected those of the simulation")
    problems = []
    for f in files:
        with open(f) as stream:
            text = stream.read()
        header = ""
        for other in (f[:-4] + ".h", *(g for g in files if g.endswith("/" + os.path.basename(f)[:-4] + ".h"))):
            if f.endswith(".cpp") and os.path.exists(other):
                with open(other) as stream:
                    header += stream.read()
        problems += problems_in(f, text, header)
    for problem in problems:
        print(problem, file=sys.stderr)
    sys.exit(1 if problems else 0)


main()
