#!/usr/bin/env python3
"""What public headers leave without a comment, from Doxygen's warnings.   tools/documented.py WARNINGS

Every class, enumeration and function needs a comment, but those of a namespace `detail`, special members and operators. Any other
warning fails, too.
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
    problems = []
    for line in open(sys.argv[1], encoding="utf-8").read().splitlines():
        match = COUNTED.match(line)
        if not match:
            problems.append(line)
        elif needs_comment(*match.groups()[2:]):
            path = re.sub(r"^.*?((engine|gi_module|tools)/)", r"\1", match[1])
            problems.append(f"{path}:{match[2]}: {match[4]} has no comment: say what it is")
    print("\n".join(problems), end="\n" if problems else "")
    return 1 if problems else 0


sys.exit(main())
