"""What Doxygen is given in place of a header: `docs/doxygen_filter.py HEADER` prints it.

The columns of comments beside fields and enumerators (`double d;  // depth [m]`) become documentation of
these, the comment at the head becomes that of the file, and names of XML elements in comments (<robot>) are
escaped. Lines keep their numbers.
"""
import html
import re
import sys

BESIDE = re.compile(r"^(?P<code>\s*[^/\s].*?[;,}\w\"')])\s+// (?P<words>.*)$")
ALONE = re.compile(r"^\s*// (?P<words>.*)$")
CODE = re.compile(r"^\s*[^/\s]")


def escaped(words):
    """Words of a comment without what Doxygen takes for commands, elements or links."""
    words = html.escape(words, quote=False)
    words = re.sub(r"@(?!param|throws|return|note|file)", "@@", words)
    words = re.sub(r"(?<!\\)([#%\\])", r"\\\1", words)
    return re.sub(r"(^| )\.\.?(?=\s|$)", r"\1&hellip;", words)


def document(lines):
    beside, inside = False, False
    for line, before, after in zip(lines, ["", *lines], [*lines[1:], ""]):
        if line == "" and before == "#pragma once" and after.startswith("///"):
            line = "/// @file"
        inside = (inside or re.match(r"(struct|class|enum)\b.*\{", line)) and not line.startswith("}")
        if line != "/// @file" and (doc := re.match(r"^(\s*/// ?)(.*)$", line)):
            yield doc[1] + escaped(doc[2])
        elif inside and (found := BESIDE.match(line)) and "(" not in found["code"].split("//")[0].split("=")[0]:
            beside = True
            yield f"{found['code']}  ///< {escaped(found['words'])}"
            continue
        elif beside and (found := ALONE.match(line)):
            yield f"///< {escaped(found['words'])}"
            continue
        else:
            yield line
        beside = False


print("\n".join(document(open(sys.argv[1], encoding="utf-8").read().splitlines())))
