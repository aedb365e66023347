#!/usr/bin/env python3
"""What public headers leave without a comment, from Doxygen's warnings.   tools/documented.py WARNINGS LIST [--write]

Every class, enumeration and function needs a comment, but those of a namespace `detail`, special members and operators. LIST holds how many
a header may lack yet, and only shrinks: more fails, and fewer, too, until --write has put the lower number in. Any other warning fails.
"""
import re
import sys

COUNTED = re.compile(r"^(\S+?):(\d+): warning: (Compound|Member) (.*?)(?: \((\w+)\) of \w+ (.*?))? is not documented\.$")


def needs_comment(what, name, kind, owner):
    scope = (name if what == "Compound" else owner or "").split("::")
    if "detail" in scope or kind in ("variable", "typedef"):
        return False
    function = name.split("(")[0]
    constructor = scope[-1].split("<")[0].strip() == function
    return what == "Compound" or not (constructor or function.startswith(("~", "operator")))


def main():
    warnings, allowed = sys.argv[1:3]
    found, other = {}, []
    for line in open(warnings, encoding="utf-8").read().splitlines():
        match = COUNTED.match(line)
        if not match:
            other.append(line)
        elif needs_comment(*match.groups()[2:]):
            path = re.sub(r"^.*?((engine|gi_module|tools)/)", r"\1", match[1])
            found.setdefault(path, []).append(f"{path}:{match[2]}: {match[4]} has no comment")
    limits = {path: int(n) for n, path in (line.split() for line in open(allowed, encoding="utf-8"))}
    problems = list(other)
    for path in sorted(found.keys() | limits.keys()):
        now, limit = len(found.get(path, [])), limits.get(path, 0)
        if now > limit:
            problems += found[path] + [f"{path}: {now} without a comment, at most {limit}: say what each is"]
        elif now < limit and "--write" not in sys.argv:
            problems.append(f"{path}: {now} without a comment, {allowed} says {limit}: lower it (tools/docs --write)")
    if "--write" in sys.argv and not problems:
        with open(allowed, "w", encoding="utf-8") as file:
            file.writelines(f"{len(found[path])} {path}\n" for path in sorted(found))
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


sys.exit(main())
