#!/usr/bin/env python3
"""Which sources of a target may be compiled as one piece.

Names that are private to a source (unnamed namespaces) may be the same in two sources, or those of a header or of a local
variable of the other; such two do not share a piece, nor do two with other using-directives. The sources are formatted by
clang-format, so what stands at the level of a namespace begins its line. What this overlooks does not compile.

usage: unity_groups ROOT <TARGETS    reads "target<tab>source" lines, writes CMake code that sets UNITY_GROUP
"""
import collections
import functools
import pathlib
import re
import sys

MOST = 8  # sources in a piece: enough to share the headers' templates, few enough for two cores and 2 GB
NAMESPACE = re.compile(r"^(?:inline )?namespace ([\w:]*) ?\{$")
INCLUDE = re.compile(r'^#include "(.+)"', re.M)
TYPE = re.compile(r"(?:struct|class|union|enum class|enum) (?:alignas\(.*?\) )?(\w+)")
ALIAS = re.compile(r"(?:using|namespace) (\w+) = ")
LOCAL = re.compile(r"(?<!return)(?<!case)(?<!=)[ &*\[]([A-Za-z_]\w*)(?= = |\{|;|, |\)|\]| : |\[)")
MACRO = re.compile(r"[A-Z][A-Z_]+\(")


def names_in(line):
    """Those that a line at the level of a namespace declares."""
    line = re.sub(r"^template <.*?> (?=\w)", "", line)
    if MACRO.match(line) or line.startswith(("using namespace", "#", "//", "}", " ", "template <")):
        return []
    if line.startswith(("using ", "namespace ")):
        return ALIAS.findall(line)[:1]
    if found := TYPE.match(line):
        return [found[1]]
    head = re.split(r"//| = |\{", re.sub(r"\{[^{}()]*\}", "", line))[0]  # of several in one line, too
    if "(" in head:
        found = re.search(r"([\w:]+)\(", head)
        return [found[1]] if found and ":" not in found[1] else []
    return re.findall(r"([A-Za-z_]\w*)(?=\s*(?:\[.*?\])?(?: = |\{|;|,|$))", line)


def locals_in(text):
    """Those of parameters, of variables within functions, and of members, which look alike."""
    lines = (line.split("//")[0] for line in text.splitlines() if line.startswith(" ") or "(" in line)
    return {name for line in lines for name in LOCAL.findall(line)}


@functools.lru_cache(None)
def read(file):
    """Private names and all names, each with its line; using-directives; included headers; has macros; names of locals; for
    each name where it is: its namespace, and of a type also the file; and the namespaces that are opened."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', file.read_text(), flags=re.S)
    private, named, spaces, directives = {}, {}, [], set()
    places, opened = collections.defaultdict(set), set()
    for line in text.splitlines():
        if found := NAMESPACE.match(line):
            spaces.append(found[1])
            opened.add("::".join(spaces))
        elif line.startswith("}  // namespace"):
            spaces.pop()
        elif line.startswith("using namespace"):
            directives.add(line)
            opened.add("::".join([*spaces, line.split()[-1].rstrip(";")]))
        else:
            for name in names_in(line):
                named[name] = line
                is_type = ALIAS.match(line) or TYPE.match(line) and not line.endswith(";")
                places[name].add(("::".join(spaces), file if is_type else None))
                if "" in spaces or line.startswith(("static ", "using ", "namespace ")):
                    private[name] = line
    return private, named, frozenset(directives), INCLUDE.findall(text), "\n#define" in text, locals_in(text), places, opened


class Source:
    def __init__(self, root, file):
        self.file = file
        self.private, self.named, self.directives, _, self.alone, self.locals, _, opened = read(file)
        self.of_headers, self.headers, self.places = {}, set(), collections.defaultdict(set)
        self.opened = set(opened)
        open_ones = [file]
        while open_ones:
            at = open_ones.pop()
            for name in read(at)[3]:
                header = next((h for h in (root / "src" / name, root / name, at.parent / name) if h.is_file()), None)
                if header and header not in self.headers:
                    self.headers.add(header)
                    open_ones.append(header)
                    self.of_headers.update(read(header)[1])
                    self.opened |= read(header)[7]
                    for known, where in read(header)[6].items():
                        self.places[known] |= where

    def hides(self, other):
        seen_later = other.locals.union(*(read(header)[5] for header in other.headers - self.headers))
        for name, line in self.private.items():
            if name in seen_later and "(" not in re.split(r" = |\{", line)[0]:  # variables: -Wshadow
                return True
            theirs = other.named.get(name) or other.of_headers.get(name)
            if theirs and not (theirs == line and line.startswith(("using ", "namespace "))):
                return True
        variables = (name for header in self.headers - other.headers for name, line in read(header)[1].items()
                     if line.startswith("inline constexpr ") and "(" not in re.split(r" = |\{", line)[0])
        return any(name in other.locals for name in variables)  # -Wshadow, too

    def goes_with(self, other):
        if self.alone or other.alone or self.directives != other.directives:
            return False
        if self.hides(other) or other.hides(self):
            return False
        return not any(self.takes(name, other) or other.takes(name, self) for name in self.places.keys() & other.places.keys())

    def takes(self, name, other):
        """Whether headers have the name where the other's code would find it before, or beside, the one that it means."""
        mine, theirs = self.places[name], other.places[name]
        if ({space for space, _ in mine} - {space for space, _ in theirs}) & other.opened:
            return True
        types = [{(space, file) for space, file in places if file} for places in (mine, theirs)]
        return any(a[0] == b[0] and a[1] != b[1] for a in types[0] for b in types[1])


def groups_of(sources):
    groups = []
    for source in sources:
        fits = (g for g in groups if len(g) < MOST and all(source.goes_with(s) for s in g))
        group = next(fits, None)
        if group is None:
            groups.append([])
            group = groups[-1]
        group.append(source)
    return groups


def main():
    root = pathlib.Path(sys.argv[1])
    targets = collections.defaultdict(list)
    for line in sys.stdin.read().splitlines():
        target, file = line.split("\t")
        targets[target].append(pathlib.Path(file))
    of_file = functools.lru_cache(None)(lambda file: Source(root, file))
    for target, files in targets.items():
        for number, group in enumerate(groups_of([of_file(file) for file in files])):
            if len(group) == 1:
                continue
            names = " ".join(f'"{source.file}"' for source in group)
            print(f"set_source_files_properties({names} TARGET_DIRECTORY {target} PROPERTIES UNITY_GROUP {target}_{number})")
        print(f"set_target_properties({target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)")


main()
