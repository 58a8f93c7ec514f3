"""Links and names of files in README.md and docs/ lead to files and headings that exist.

A link is [words](path#heading) or an image; a heading's anchor is made as GitHub makes it. A name of a
file is `folder/file.h`, from the repository's root or from the page; `api/x.h` stands for any. CHANGELOG.md
may name old files.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NAMED = re.compile(r"`([\w./-]+/[\w.-]+\.(?:h|cpp|py|toml|md|bib|cmake|json|js))`")
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")


def unfenced(text):
    """The text without fenced blocks."""
    return re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)


def prose(text):
    """The text without fenced blocks and code in backticks."""
    return re.sub(r"`[^`\n]*`", "", unfenced(text))


def anchors(text):
    """Anchors of all headings, numbered where one comes twice."""
    seen, found = {}, set()
    for line in unfenced(text).splitlines():
        match = re.match(r"#{1,6}\s+(.*?)\s*#*$", line)
        if not match:
            continue
        words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", match[1])
        name = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        count = seen.get(name, 0)
        seen[name] = count + 1
        found.add(f"{name}-{count}" if count else name)
    return found


def wrong(file):
    """Sentences about links of a file that lead nowhere."""
    for target in LINK.findall(prose(file.read_text())):
        if re.match(r"[a-z]+:", target):
            continue  # of the web
        path, _, heading = target.partition("#")
        to = (file.parent / path).resolve() if path else file
        where = f"{file.relative_to(ROOT)}: '{target}'"
        if not to.exists():
            yield f"{where}: there is no such file"
        elif ROOT not in to.parents and to != ROOT:
            yield f"{where}: leads out of the repository"
        elif heading and heading not in anchors(to.read_text()):
            yield f"{where}: there is no such heading"
    for name in NAMED.findall(unfenced(file.read_text())) if file.name != "CHANGELOG.md" else []:
        if Path(name).stem != "x" and not (ROOT / name).exists() and not (file.parent / name).exists():
            yield f"{file.relative_to(ROOT)}: there is no file '{name}'"


def main():
    files = [f for f in [*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"), ROOT / "viewer/README.md"]
             if f.exists()]
    found = [sentence for file in files for sentence in wrong(file)]
    links = sum(len(LINK.findall(prose(file.read_text()))) for file in files)
    if links < 50:
        found.append(f"wanted 50 links and more, found {links}")
    print("\n".join(found) or f"{links} links of {len(files)} files lead somewhere")
    sys.exit(bool(found))


main()
