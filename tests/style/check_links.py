#!/usr/bin/env python3
"""What the pages name exists: files and headings that links lead to, and paths of the repository in `code`."""
import glob
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "../.."))
FOLDERS = ("assets", "cmake", "docs", "engine", "game", "gi_module", "packaging", "tests", "tools")
MADE = ("docs/html",)  # what a command makes


def headings(page):
    """The anchors of a page, as code hosts make them."""
    text = re.sub(r"^```.*?^```", "", open(page).read(), flags=re.S | re.M)
    found = set()
    for title in re.findall(r"^#+ (.*)", text, flags=re.M):
        title = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", title)
        found.add(re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-"))
    return found


def public_headers():
    return {
        path.split("/include/", 1)[1]
        for folder in ("engine", "gi_module", "tools")
        for path in glob.glob(f"{folder}/**/include/lanthorn/**", recursive=True)
    }


def complaints(page, headers):
    folder = os.path.dirname(page)
    inside = False
    for number, line in enumerate(open(page), 1):
        if line.startswith("```"):
            inside = not inside
        if inside:
            continue
        for target in re.findall(r"\]\(([^)\s]+)\)", line):
            if re.match(r"[a-z]+:", target):
                continue
            name, _, anchor = target.partition("#")
            path = os.path.normpath(os.path.join(folder, name)) if name else page
            if not os.path.exists(path):
                yield f"{page}:{number}: no such file: {target}"
            elif anchor and path.endswith(".md") and anchor not in headings(path):
                yield f"{page}:{number}: no such heading: {target}"
        for code in re.findall(r"`([^`\s]+)`", line):
            path = re.sub(r"[@:].*", "", code).rstrip("/")
            if re.search(r"[*{}<>$|]|[A-Z]{4}", path) or path in MADE:
                continue
            if path.startswith(tuple(f + "/" for f in FOLDERS)) and not os.path.exists(path):
                yield f"{page}:{number}: no such path: {code}"
            if path.startswith("lanthorn/") and path.rstrip("/") not in headers:
                yield f"{page}:{number}: no such public header: {code}"


def main():
    os.chdir(ROOT)
    pages = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", *glob.glob("docs/**/*.md", recursive=True)]
    headers = public_headers()
    found = [complaint for page in sorted(pages) for complaint in complaints(page, headers)]
    print("\n".join(found), file=sys.stderr, end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
