"""Files of one folder are compiled together (unity builds): no two of them may define the same thing.

Looks at what stands in unnamed namespaces, wherever CMake draws the line between two batches. Functions
may share a name if their parameters differ, among themselves and with functions of headers, which they would hide
from the other files; types may not have the name of a header's type. Run from the repository root; prints every
offence.
"""
import collections
import pathlib
import re
import sys

TEXT = re.compile(r'R"\((?:.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|//[^\n]*|/\*.*?\*/', re.S)
NAMED = re.compile(r"\b(?:struct|class|enum(?: class)?) (\w+)[^;{}()]*$")
USING = re.compile(r"^using (\w+) = (.*)$", re.S)
FUNCTION = re.compile(r"([\w~]+)\s*\(([^{}]*)\)[^(){}]*$", re.S)


def parameters(text):
    """The types of a parameter list, names and defaults left out."""
    depth, out, one = 0, [], ""
    for c in text + ",":
        depth += (c in "<({[") - (c in ">)}]")
        if c == "," and depth == 0:
            one = re.sub(r"=.*", "", one, flags=re.S).strip()
            out.append(re.sub(r"\s+", " ", re.sub(r"(?<=[\s&*>])\w+$", "", one)).strip())
            one = ""
        else:
            one += c
    return "(" + ", ".join(out) + ")"


def definitions(text, unnamed=True):
    """(line, what) of everything in unnamed namespaces, or in named ones alone, at their top level."""
    text = TEXT.sub(lambda m: ("" if m[0][0] == "/" else '""') + "\n" * m[0].count("\n"), text)
    text = re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*$", lambda m: "\n" * m[0].count("\n"), text, flags=re.M)
    stack, start, round_brackets = [], 0, 0
    for i, c in enumerate(text):
        round_brackets += (c == "(") - (c == ")")
        if c not in "{};" or (c == ";" and round_brackets):
            continue
        head = text[start:i].strip()
        wanted = ("unnamed", "named") if unnamed else ("named",)
        inside = bool(stack) and stack[-1] == wanted[0] and all(s in wanted for s in stack)
        line = text.count("\n", 0, start + len(text[start:i]) - len(text[start:i].lstrip())) + 1
        if c == "{":
            if re.fullmatch(r"(inline )?namespace", head):
                stack.append("unnamed")
            elif re.match(r"(inline )?namespace\b", head):
                stack.append("named")
            else:
                if inside:
                    yield line, head
                stack.append("body")
        elif c == "}":
            stack.pop() if stack else None
        elif inside:
            yield line, head
        start = i + 1


def name_of(head):
    """What `head` defines: a name, with its parameters if it is a function; None: nothing."""
    head = re.sub(r"^template\s*<[^{};]*?>\s*(?=\w|\[)", "", head).strip()
    head = re.sub(r"\[\[.*?\]\]\s*", "", head)
    if using := USING.match(head):
        return f"using {using[1]}", re.sub(r"\s+", " ", using[2])
    if head.startswith(("using", "friend", "static_assert")) or not head:
        return None
    if re.match(r"(inline |static )?(constexpr|const)\b", head):
        # Constants begin with k: the first after its type, others after a comma.
        flat, depth = "", 0
        for c in head:
            depth -= c in ")}]>"
            flat += c if depth == 0 and c not in ")}]>" else ""
            depth += c in "({[<"
        names = re.findall(r"(?:^|[\s*&,])(k[A-Z]\w*)\s*(?=[=({\[,]|$)", flat)
        if names:
            return names[0], ""
    if named := NAMED.search(head):
        return named[1], ""
    if (function := FUNCTION.search(head)) and not re.search(r"\b\w+::\w+\s*\($", head[:function.start(2)]):
        return function[1] + parameters(function[2]), ""
    return None


def public_names():
    """Types that headers declare, by name, and functions, by name and parameters."""
    types, functions = {}, {}
    for path in sorted(pathlib.Path(".").rglob("*.h")):
        if path.parts[0] in ("build", "out", "bench", "tests") or "node_modules" in path.parts:
            continue
        text = path.read_text()
        for declared in re.finditer(r"^(?:struct|class|enum class) (\w+)[^;]*?\{", text, re.M):
            types.setdefault(declared[1], path)
        if "namespace internal" not in text and "::internal" not in text:
            for _, head in definitions(text, unnamed=False):
                if (found := name_of(head)) and "(" in found[0]:
                    functions.setdefault(found[0], path)
    return types, functions


def offences():
    types, functions = public_names()
    folders = collections.defaultdict(list)
    for path in sorted(pathlib.Path(".").rglob("*.cpp")):
        if path.parts[0] not in ("build", "out", "bench") and "node_modules" not in path.parts and not path.parts[0].startswith("."):
            folders[path.parent].append(path)
    for folder, paths in folders.items():
        first = {}
        for path in paths:
            own = set()
            for line, head in definitions(path.read_text()):
                found = name_of(head)
                if not found or found[0] in own:
                    continue
                own.add(found[0])
                name, value = found
                if name in types and re.match(r"(struct|class|enum)", head):
                    yield f"{path}:{line}: {name} is a type of {types[name]}, too"
                if name in functions:
                    yield f"{path}:{line}: {name} is a function of {functions[name]}, too"
                if name in first and not (value and value == first[name][1]):
                    yield f"{path}:{line}: {name} is in {first[name][0]}, too"
                first.setdefault(name, (path, value))


bad = [*offences()]
print("\n".join(bad))
sys.exit(bool(bad))
