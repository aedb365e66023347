#!/usr/bin/env python3
"""What Doxygen reads of a file (INPUT_FILTER of docs/Doxyfile): `//` comments as documentation, pages with links that the site has.

Headers: a comment above a declaration becomes `///`, one behind a member `///<`, one before `#pragma once` that of the file. Lines behind that
stay where they are, so that warnings name the right ones.
"""
import os
import re
import sys

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
COMMENT = re.compile(r"^(\s*)//(?!/)(.*)$")
TRAILING = re.compile(r"^(\s*\S.*?)(\s+)//(?!/)(.*)$")


def escaped(text):
    """Text that means itself: Doxygen's and HTML's own signs lose their meaning outside `code`."""
    parts = text.split("`")
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"([\\@<>#&]|(?<!\w)::)", r"\\\1", parts[i])
    return "`".join(parts)


def block(texts):
    """The lines of a comment. Those that are set in after an empty one are a diagram or an example: code."""
    out = []
    code = False
    for n, text in enumerate(texts):
        code = text.startswith("   ") and (code or (n > 0 and not texts[n - 1].strip()))
        out.append("    " + text if code else escaped(text))
    return out


def paragraph(texts):
    """The first paragraph of a comment, on one line."""
    words = [text.strip() for text in texts] + [""]
    return " ".join(words[: words.index("")])


def documents(lines, end):
    """Whether a comment that ends before line `end` belongs to the declaration there."""
    following = lines[end].strip() if end < len(lines) else ""
    return bool(following) and not following.startswith(("}", "#", "private:", "public:", "protected:"))


def header(lines, stem):
    """`stem`: the file's name without its ending; the class of that name has the file's words, up to the first empty line."""
    out = []
    summary = ""
    i = 0
    column = None  # of the comment behind the line before
    top = True
    while i < len(lines):
        line = lines[i]
        if line.startswith("#pragma once"):
            top = False
            i += bool(out)  # makes room for @file
            if out:
                continue
        comment = COMMENT.match(line)
        if comment and column is not None and len(comment[1]) == column:
            out.append(f"{comment[1]}///<{escaped(comment[2])}")
            i += 1
            continue
        column = None
        if comment:
            end = i
            while end < len(lines) and COMMENT.match(lines[end]):
                end += 1
            indent = comment[1]
            texts = block([COMMENT.match(line)[2] for line in lines[i:end]])
            if top and not out:
                out.append("/// @file")
                words = re.sub(r"^\w+: (\w)", lambda match: match[1].upper(), paragraph(texts))
                summary = words.replace("*/", "")
            marks = "///" if top or documents(lines, end) else "//"
            out += [indent + marks + text for text in texts]
            i = end
            continue
        if line.startswith(("class ", "struct ")) and line.endswith("{") and not out[-1].startswith(("//", "template")):
            name = re.match(r"\w+ (\w+)", line)[1]
            if summary and name.lower() == stem.replace("_", ""):
                line = f"/** {summary} */ {line}"  # the file is about this one
        trailing = TRAILING.match(line)
        if trailing and '"' not in trailing[1] and not re.match(r"\s*(#|\}|namespace|public|private)", line) and not trailing[1].endswith(("{", "(", ":", "&&", "||", "\\")):
            column = len(trailing[1]) + len(trailing[2])
            line = f"{trailing[1]}{trailing[2]}///<{escaped(trailing[3])}"
        out.append(line)
        i += 1
    return out


def page(lines, path):
    """Links to files that are no part of the site become their words; headings have no names there."""
    folder = os.path.dirname(path)

    def link(match):
        words, target = match[1], match[2]
        if re.match(r"[a-z]+:", target):
            return match[0]
        name = target.partition("#")[0]
        full = os.path.normpath(os.path.join(folder, name))
        if name.endswith(".md") and in_site(full):
            return f"[{words.replace('`', '')}]({name})"
        return words

    out = []
    open_code = False  # a `...` that began on a line before: Doxygen takes its @ for a command
    for line in lines:
        line = re.sub(r"(?<!!)\[([^]]*)\]\(([^)\s]+)\)", link, line)
        odd = line.count("`") % 2 == 1
        if open_code or odd:
            line = line.replace("@", "\\@")
        open_code = open_code != odd and bool(line)
        out.append(line)
    return out


def in_site(path):
    name = os.path.relpath(path, ROOT)
    return name in ("README.md", "CONTRIBUTING.md", "CHANGELOG.md") or name.startswith("docs/")


def main():
    path = os.path.abspath(sys.argv[1])
    lines = open(path, encoding="utf-8").read().split("\n")
    print("\n".join(page(lines, path) if path.endswith(".md") else header(lines, os.path.basename(path)[:-2])))


main()
