"""The markdown pages of the tree, taken apart."""

import re

import tree

source = tree.source
PAGES = tree.files(".md")
FENCED = re.compile(r"^```(.*)\n((?:.*\n)*?)```$", re.MULTILINE)

# Commands that take too long to be run here, as they stand on a page: why, and what is run in their place. Of each, -h must work
# and name its options.
TOO_LONG = {
    "scripts/report": "builds the program and makes the page; the test browser.page makes it with the program that is there",
    "scripts/test": "builds everything and runs this test, too; exit_codes_test.py runs the script with a build that does nothing",
    "scripts/test --junit results.xml": "the same",
    "scripts/studies": "makes what is old again, for minutes or hours; the test studies.quick makes the short forms",
    "furrow study --check --out reference_data/studies": "takes minutes; it is the test studies.recomputed",
}


def text_of(page):
    return (source / page).read_text()


def blocks_of(page):
    """Pairs of what stands behind the three marks, and the text between them."""
    assert text_of(page).count("\n```") % 2 == 0, f"{page}: a block does not end"
    return FENCED.findall(text_of(page))


def prose_of(page):
    return FENCED.sub("", text_of(page))


def spans_of(page):
    return [span for span in re.findall(r"`([^`\n]+)`", prose_of(page)) if span.strip()]


def sections_of(page):
    """What a link may name behind the #, of each heading: as GitHub makes it."""
    headings = re.findall(r"^#+ (.*)$", prose_of(page), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def commands_of(text):
    """The commands of a block, a line each, without what a comment says of them."""
    lines = [re.sub(r"\s+# .*", "", line).strip() for line in text.replace("\\\n", " ").splitlines()]
    return [line for line in lines if line]
