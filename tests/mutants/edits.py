"""Small edits of C++ source, of the kinds that slips are: found in the text, without a parser."""

import difflib
import re
from dataclasses import dataclass


@dataclass(frozen=True)
class Edit:
    file: str  # from the top of the tree
    kind: str
    start: int  # of the text that is replaced
    end: int
    new: str

    def applied(self, text):
        return text[: self.start] + self.new + text[self.end :]

    def diff(self, text):
        """The lines that change, without their numbers: how a survivor is known again after other edits."""
        lines = difflib.unified_diff(text.split("\n"), self.applied(text).split("\n"), n=0, lineterm="")
        return [line[0] + " " + line[1:].strip() for line in lines if line[:2] not in ("--", "++", "@@")]

    def line(self, text):
        return text.count("\n", 0, self.start) + 1


def blanked(text):
    """The text with comments, preprocessor lines and the insides of literals as spaces, so that places stay."""
    pattern = r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])*\'|^#[^\n]*'

    def blank(match):
        word = match.group()
        inside = re.sub(r"[^\n]", " ", word[1:-1])
        return word[0] + inside + word[-1] if word[0] in "\"'" else re.sub(r"[^\n]", " ", word)

    return re.sub(pattern, blank, text, flags=re.DOTALL | re.MULTILINE)


def closing(text, at):
    """Where the bracket that opens at `at` is closed."""
    depth = 0
    for k in range(at, len(text)):
        depth += (text[k] in "([{") - (text[k] in ")]}")
        if depth == 0:
            return k
    return -1


def split_arguments(text, first, last):
    """Where each argument between two brackets begins and ends."""
    pieces, depth, begin = [], 0, first
    for k in range(first, last):
        depth += (text[k] in "([{") - (text[k] in ")]}")
        if text[k] == "," and depth == 0:
            pieces.append((begin, k))
            begin = k + 1
    pieces.append((begin, last))
    trimmed = []
    for a, b in pieces:
        word = text[a:b]
        trimmed.append((a + len(word) - len(word.lstrip()), b - len(word) + len(word.rstrip())))
    return trimmed


# What one word becomes. Each pair stands for both directions.
WORDS = {
    "operator": {" + ": [" - "], " - ": [" + "], " * ": [" / "], " / ": [" * "], " += ": [" -= ", " = "],
                 " -= ": [" += "], " *= ": [" /= "], " /= ": [" *= "], "++": ["--"], " | ": [" & "], " % ": [" / "]},
    "comparison": {" < ": [" <= ", " > ", " >= "], " <= ": [" < ", " > "], " > ": [" >= ", " < ", " <= "],
                   " >= ": [" > ", " < "], " == ": [" != "], " != ": [" == "]},
    "logic": {" && ": [" || "], " || ": [" && "], "true": ["false"], "false": ["true"]},
}
PAIRS = ["x y", "vx vy", "nx ny", "rx ry", "a b", "i j", "min max", "begin end", "floor ceil", "sin cos", "first second",
         "front back", "left lower", "left right", "low high", "width height", "px py", "own_a own_b", "spin_a spin_b",
         "radius_a radius_b", "arm_a arm_b", "x_of y_of", "vx_of vy_of", "force_x force_y", "load_x load_y",
         "stiffness damping", "before after", "first last", "row column", "seconds steps", "relative absolute",
         "open close", "push_back insert", "any_of all_of", "isfinite isinf", "error warning", "out err"]
SWAPS = {}
for one, other in (pair.split() for pair in PAIRS):
    SWAPS.setdefault(one, []).append(other)
    SWAPS.setdefault(other, []).append(one)


def word_edits(code):
    for kind, words in WORDS.items():
        for old, news in words.items():
            edge = r"\b" if old[0].isalpha() else ""
            for match in re.finditer(edge + re.escape(old) + edge, code):
                around = code[: match.start()].rstrip()[-1:] + code[match.end() :].lstrip()[:1]
                if '"' in around and old in (" + ", " - "):
                    continue  # texts are joined, not added
                for new in news:
                    yield kind, match.start(), match.end(), new
    for match in re.finditer(r"!(?=[\w(])", code):
        yield "logic", match.start(), match.end(), ""
    for match in re.finditer(r"(?<=[.>:(\s\[])(\w+)\b", code):
        for new in SWAPS.get(match.group(1), []):
            yield "field", match.start(1), match.end(1), new


def constant_edits(code):
    for match in re.finditer(r"(?<![\w.])(\d+\.?\d*(?:e[+-]?\d+)?)(?![\w.'])", code):
        word = match.group()
        if re.fullmatch(r"\d+", word):
            news = [str(int(word) + 1)] + ([str(int(word) - 1)] if int(word) > 0 else [])
        else:
            news = ["1.0"] if float(word) == 0 else [repr(2 * float(word)), repr(0.5 * float(word)), repr(1.1 * float(word))]
        for new in news:
            yield "constant", match.start(), match.end(), new


def index_edits(code):
    for match in re.finditer(r"(?<=[\w\])])\[([\w.:>-]+)\](?! ?[({])", code):
        for new in (" + 1", " - 1"):
            yield "index", match.end(1), match.end(1), new


def condition_edits(code):
    for match in re.finditer(r"\bif (?:constexpr )?\(", code):
        last = closing(code, match.end() - 1)
        first = max(match.end(), code.rfind(";", match.end(), last) + 1)
        if last > first:
            for new in ("!(", "true || (", "false && ("):
                yield "condition", first, last, (new, ")")
    for match in re.finditer(r" \? ", code):  # a ? b : c
        middle, end = ternary(code, match.end())
        if middle:
            yield "condition", match.end(), end, (match.end(), middle, middle + 3, end)


def ternary(code, begin):
    """Where ` : ` stands that belongs to the question mark before `begin`, and where the last part ends."""
    depth, middle = 0, 0
    for k in range(begin, len(code)):
        depth += (code[k] in "([{") - (code[k] in ")]}")
        if code.startswith(" ? ", k) and depth == 0 and not middle:
            return 0, 0  # one in another
        if code.startswith(" : ", k) and depth == 0:
            middle = middle or k
        elif middle and (depth < 0 or (depth == 0 and code[k] in ",;?")):
            return middle, k
    return 0, 0


def argument_edits(code):
    for match in re.finditer(r"(?<=\w)[({](?=[^)}])", code):
        if re.search(r"\b(if|for|while|switch|catch|return|sizeof|const|else|do|namespace|struct|class)\s*$", code[: match.start()]):
            continue
        last = closing(code, match.start())
        if last < 0 or ";" in code[match.end() : last]:
            continue
        pieces = split_arguments(code, match.end(), last)
        for (a, b), (c, d) in zip(pieces, pieces[1:]):
            one, other = code[a:b], code[c:d]
            if one and other and one != other and not re.search(r"[\w>][&*]* \w+( = .*)?$", one):
                yield "argument", a, d, (a, b, c, d)


def statement_edits(code):
    """Calls, assignments, jumps: what a slip may leave out. No declarations: that does not compile."""
    stack, begin = [], 0
    for k, letter in enumerate(code):
        if letter in "([{":
            stack.append(letter)
        elif letter in ")]}" and stack:
            stack.pop()
        if letter in "{}" or (letter == ";" and (not stack or stack[-1] == "{")):
            if letter == ";":
                yield from one_statement(code, begin, k)
            begin = k + 1


def one_statement(code, begin, end):
    first = begin
    while True:
        first += len(code[first:end]) - len(code[first:end].lstrip())
        head = re.match(r"(if (constexpr )?|for |while )\(|else\b|case [\w:]+:|default:|public:|private:", code[first:end])
        if not head:
            break
        last = first + head.end() - 1
        first = closing(code, last) + 1 if code[last] == "(" else last + 1
    word = code[first:end]
    call = re.match(r"[\w.:>\-\[\]()*+ ]*?[\w>]\(.*\)$", word, re.DOTALL) and not re.match(r"[\w:<>]+[&*]* [\w:]+\(", word)
    assigned = re.match(r"[\w.\[\]>\-*()+]+(\[[^\]]*\])? ([+\-*/|&]|<<)?= ", word)
    if call or assigned or re.match(r"(\+\+|--|continue$|break$|return$|throw |\w+_? << |delete )", word):
        yield "statement", first, end, ""


def edits_of(file, text):
    """Every edit of one file; those that do nothing are left out."""
    code = blanked(text)
    found = set()
    for make in (word_edits, constant_edits, index_edits, condition_edits, argument_edits, statement_edits):
        for kind, start, end, new in make(code):
            if kind == "condition" and len(new) == 2:
                new = new[0] + text[start:end] + new[1]
            elif isinstance(new, tuple):  # places that change
                a, b, c, d = new
                new = text[c:d] + text[b:c] + text[a:b]
            if kind != "statement" or code[start:end].strip():
                found.add((kind, start, end, new))
    return [Edit(file, kind, start, end, new) for kind, start, end, new in sorted(found)]
