#!/usr/bin/python3
"""Checks every page of the repository: links and their anchors lead somewhere, paths that code and pages name exist, numbers
of references are resolved, lines are short, and every page can be reached from README.md. No network."""
import os
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(os.environ.get("ARIADNE_SOURCE_DIR", pathlib.Path(__file__).parents[2]))
LONGEST_LINE = 120
SKIPPED = {"build", ".git"}
# Pages that a program writes are as wide as their tables.
MADE = re.compile(r"doc/lab/experiments/results/|doc/reference/parameters")


def files(*suffixes):
    for folder, folders, names in os.walk(ROOT):
        folders[:] = sorted(f for f in folders if f not in SKIPPED)
        for name in sorted(names):
            if not suffixes or name.endswith(suffixes):
                yield pathlib.Path(folder, name)


def pages():
    return list(files(".md"))


def without_code(text):
    """Lines of code become empty, so that lines keep their numbers; code within a line goes, too."""
    def blank(match):
        return "\n" * match.group(0).count("\n")
    text = re.sub(r"^( *)```.*?^\1```", blank, text, flags=re.M | re.S)
    text = re.sub(r"^    .*$", "", text, flags=re.M)
    return re.sub(r"`[^`\n]*`", "", text)


def anchors(page):
    """As GitHub and MyST make them of headings, and those that are set by hand."""
    text = page.read_text()
    found = set(re.findall(r'<a id="([^"]+)"', text))
    for heading in re.findall(r"^#+ +(.+)$", text, flags=re.M):
        slug = re.sub(r"[^\w\- ]", "", heading.lower().replace("`", ""))
        found.add(slug.replace(" ", "-"))
    return found


def links(page):
    """(line, target) of each link and picture. A link may go on in the next line."""
    text = without_code(page.read_text())
    for match in re.finditer(r"\]\(([^()\s]+)\)", text):
        yield text.count("\n", 0, match.start()) + 1, match.group(1)


class Pages(unittest.TestCase):
    def name(self, path):
        return str(path.relative_to(ROOT))

    def expect_none(self, problems):
        self.assertFalse(problems, "\n" + "\n".join(problems))

    def test_there_are_pages_to_check(self):
        self.assertGreater(len(pages()), 30)
        self.assertGreater(sum(len(list(links(page))) for page in pages()), 100)

    def test_every_link_leads_somewhere(self):
        problems = []
        for page in pages():
            for line, target in links(page):
                if re.match(r"[a-z]+:", target):
                    continue
                path, _, anchor = target.partition("#")
                to = (page.parent / path).resolve() if path else page
                where = f"{self.name(page)}:{line}: {target}"
                if not to.exists():
                    problems.append(f"{where}: no such file")
                elif anchor and anchor not in anchors(to):
                    problems.append(f"{where}: no such heading")
        self.expect_none(problems)

    def test_included_files_and_lines_are_there(self):
        problems = []
        for page in pages():
            for match in re.finditer(r"```\{literalinclude\} (\S+)\n((?::.*\n)*)", page.read_text()):
                to = page.parent / match.group(1)
                if not to.exists():
                    problems.append(f"{self.name(page)}: {match.group(1)}: no such file")
                    continue
                for option, text in re.findall(r":(start-at|end-at): (.*)", match.group(2)):
                    text = text.strip('"').replace('\\"', '"')
                    if text not in to.read_text():
                        problems.append(f"{self.name(page)}: {option} {text}: not in {match.group(1)}")
        self.expect_none(problems)

    def test_pages_that_code_names_are_there(self):
        problems = []
        for file in files(".h", ".cpp", ".txt", ".cmake", ".ini", ".py", ".md"):
            if MADE.search(self.name(file)):
                continue
            for number, line in enumerate(file.read_text(errors="replace").splitlines(), 1):
                for path in re.findall(r"(?<![\w/.-])doc/[\w./-]*\.(?:md|png)", line):
                    if not (ROOT / path).exists():
                        problems.append(f"{self.name(file)}:{number}: {path}: no such file")
        self.expect_none(problems)

    def test_numbers_of_references_are_in_the_bibliography(self):
        bibliography = (ROOT / "doc/explanation/bibliography.md").read_text()
        problems = []
        for file in files(".md", ".h", ".ini"):
            text = without_code(file.read_text()) if file.suffix == ".md" else file.read_text()
            for match in re.finditer(r"(?<![\w\])])\[(\d+)\](?!\()", text):
                in_prose = file.suffix == ".md" or re.search(r"(//|#|\").*$", text[:match.start()].splitlines()[-1])
                if in_prose and f"### [{match.group(1)}] " not in bibliography:
                    line = text.count("\n", 0, match.start()) + 1
                    problems.append(f"{self.name(file)}:{line}: [{match.group(1)}] is not in the bibliography")
        self.expect_none(problems)

    def test_equations_are_where_the_table_says(self):
        page = ROOT / "doc/explanation/loops.md"
        problems, rows = [], 0
        for row in page.read_text().splitlines():
            for equation in re.findall(r"Eq\. \(\d+\)", row.split("|")[1] if row.startswith("|") else ""):
                rows += 1
                linked = re.findall(r"\]\(([^()\s]+)\)", row)
                if not any(equation in (page.parent / file).read_text() for file in linked):
                    problems.append(f"{self.name(page)}: {equation}: not in {', '.join(linked) or 'any file'}")
        self.assertGreaterEqual(rows, 8)
        self.expect_none(problems)

    def test_lines_are_short(self):
        problems = []
        for page in pages():
            if MADE.search(self.name(page)):
                continue
            for number, line in enumerate(page.read_text().splitlines(), 1):
                row = line.lstrip().startswith("|")
                picture = line.startswith("![")
                if len(line) > LONGEST_LINE and not row and not picture:
                    problems.append(f"{self.name(page)}:{number}: {len(line)} characters: {line[:60]}...")
        self.expect_none(problems)

    def test_every_page_can_be_reached(self):
        reached, waiting = set(), [ROOT / "README.md"]
        while waiting:
            page = waiting.pop()
            if page in reached:
                continue
            reached.add(page)
            for _, target in links(page):
                to = (page.parent / target.partition("#")[0]).resolve()
                if to.is_dir() and (to / "README.md").exists():
                    to = to / "README.md"
                if to.suffix == ".md" and to.exists():
                    waiting.append(to)
        lost = [self.name(page) for page in pages() if page.resolve() not in reached and not
                re.search(r"results/[^/]+/table\.md$", self.name(page))]
        self.expect_none([f"{page}: no link leads here from README.md" for page in lost])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
