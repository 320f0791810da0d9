#!/usr/bin/env python3
"""Drives the page of `furrow report` in a headless browser, as a reader would.

page_test.py REPORT ARTEFACTS: the directory of the page, and where the pictures go. AXE names axe.min.js; without it the
accessibility tests are skipped. Without a browser all is skipped, with exit code 77."""
import base64
import os
import pathlib
import re
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import browser  # noqa: E402

WIDE, PHONE = (1400, 900), (390, 844)
LONGEST = 450  # characters of a cell: why a statement is not reproduced takes up to 437
HIGHEST = 145e3  # px of the page at WIDE: 129,836 measured; a dump, such as the hashes of run.json's files, adds 30,000
REPORT, ARTEFACTS = (pathlib.Path(a).resolve() for a in sys.argv[1:3])
AXE = os.environ.get("AXE", "")


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.profile = tempfile.TemporaryDirectory()
        cls.browser = browser.Browser(cls.profile.name)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.profile.cleanup()

    def open(self, size=WIDE, **look):
        self.browser.events.clear()
        self.browser.scripts(True)
        self.browser.look(*size, **look)
        self.browser.open((REPORT / "index.html").as_uri())
        return self.browser

    def picture(self, name):
        self.browser.picture(ARTEFACTS / f"{name}.png")

    def player(self, scene="scenario_3"):
        b = self.open()
        b.run(f"document.querySelector('#{scene} .player').scrollIntoView()")
        b.wait(f"document.querySelector('#{scene} .player').player?.to_mm !== undefined")
        b.run(f"window.p = document.querySelector('#{scene} .player').player; p.stop = () => p.pause(); 0")
        return b

    # ---- what is there ----

    def test_the_first_screen_holds_verdict_finding_tiles_and_date(self):
        b = self.open()
        self.picture("first_screen")
        for what in ("#verdict", "#commit", "#made_at", "#summary_finding h2", "#summary_finding svg", "#tile_right", "#tile_accurate",
                     "#tile_breaks", "#tile_fast", "#tile_engines", "#tile_paper"):
            place = b.run(f"(r => r && [r.top, r.height])(document.querySelector('{what}')?.getBoundingClientRect())")
            self.assertTrue(place and place[1] > 0, what)
            self.assertLess(place[0], WIDE[1], f"{what} is below the first screen")
        for what in ("#tile_right", "#tile_accurate", "#tile_breaks", "#tile_fast", "#tile_engines", "#tile_paper", "#failing h2"):
            bottom = b.run(f"document.querySelector('{what}')?.getBoundingClientRect().bottom")
            self.assertLess(bottom or 0, WIDE[1], f"{what} is cut by the first screen")
        if b.run("!!document.querySelector('#failing li')"):
            self.assertLess(b.run("document.querySelector('#failing li').getBoundingClientRect().top") + 20, WIDE[1], "the first that does not hold")
        self.assertRegex(b.run("document.querySelector('#verdict').textContent"), r"[\d,]+ checks of \d+ requirements: \d+ failed")
        self.assertRegex(b.run("document.querySelector('#made_at').dateTime"), r"^\d{4}-\d\d-\d\dT")

    def test_nothing_complains(self):
        b = self.open()
        b.run("(async () => { for (let y = 0; y < document.body.scrollHeight; y += 800) { scrollTo(0, y); await new Promise(f => setTimeout(f, 30)); } })()")
        b.run("(async () => { for (const s of document.querySelectorAll('details')) { s.open = true; await new Promise(f => setTimeout(f, 5)); } })()")
        self.assertEqual(b.complaints(), [])

    def test_it_is_light_and_needs_no_other_file(self):
        text = (REPORT / "index.html").read_text()
        self.assertLess(len(text.encode()), 4e6)
        films = [len(f) for f in re.findall(r'<script type="text/plain" id="film_\w+">([^<]*)<', text)]
        self.assertGreater(len(films), 2)
        self.assertLess(max(films), 220e3, "the largest film")
        self.assertLess(sum(films), 1.5e6, "all films")
        self.assertEqual(re.findall(r'<(?:link|script|img|iframe)[^>]* (?:src|href)=', text), [])

    def test_it_is_painted_at_once(self):
        first = min(self.open().wait("performance.getEntriesByName('first-contentful-paint')[0]?.startTime") for _ in range(3))
        print(f"first paint after {first:.0f} ms of wall clock, the best of three; it is the work that is judged, since machines may be busy")
        b = self.open()
        b.call("Performance.enable", timeDomain="threadTicks")
        work = []
        for _ in range(3):
            b.call("Page.navigate", url="about:blank")
            took = lambda: {m["name"]: m["value"] for m in b.call("Performance.getMetrics")["metrics"]}["TaskDuration"]
            before = took()
            b.call("Page.navigate", url=(REPORT / "index.html").as_uri())
            b.wait("performance.getEntriesByName('first-contentful-paint')[0]?.startTime")
            work.append(took() - before)
        b.call("Performance.disable")
        print(f"work of the main thread up to the first paint: {min(work):.3f} s of CPU time")
        # The goal is 0.3 s. 0.22 to 0.40 s were measured on one machine, so more than twice that is another page, not another day.
        self.assertLess(min(work), 1.0, "s of CPU time of the main thread up to the first paint")

    def test_every_link_within_the_page_leads_somewhere(self):
        b = self.open()
        self.assertEqual(b.run("[...document.querySelectorAll('a[href^=\"#\"]')].map(a => a.getAttribute('href').slice(1)).filter(i => !document.getElementById(i))"), [])
        self.assertEqual(b.run("(ids => ids.filter((i, k) => ids.indexOf(i) !== k))([...document.querySelectorAll('[id]')].map(e => e.id))"), [])
        files = b.run("[...new Set([...document.querySelectorAll('a[href]')].map(a => a.getAttribute('href')).filter(h => !h.startsWith('#')))]")
        self.assertEqual([f for f in files if not (REPORT / f).exists()], [])

    def test_a_link_to_a_section_leads_to_it_and_stays_there(self):
        b = self.open()
        for size in (WIDE, PHONE):
            for section in ("scenario_3", "verification", "part_made"):
                b = self.open(size)
                b.open((REPORT / "index.html").as_uri() + "#" + section)
                top = f"document.getElementById('{section}').getBoundingClientRect().top"
                b.wait(f"Math.abs({top}) < 120")  # sections above it are laid out as they come into view
                b.run("new Promise(f => setTimeout(f, 300))")
                self.assertLess(abs(b.run(top)), 120, f"{section} at a width of {size[0]}")

    def test_the_contents_show_the_section_in_view(self):
        b = self.open()
        shown = "(([a, n]) => a && a.top >= n.top && a.bottom <= n.bottom)(['#contents a.current', '#contents'].map(s => document.querySelector(s)?.getBoundingClientRect()))"
        for section in ("scenario_3", "verification", "part_made"):
            b.open((REPORT / "index.html").as_uri() + "#" + section)
            b.wait(f"document.querySelector('#contents a.current')?.getAttribute('href') === '#{section}'")
            self.assertTrue(b.run(shown), f"the line of {section} is out of sight")

    def test_what_can_be_cited_has_an_id(self):
        b = self.open()
        self.assertEqual(b.run("[...document.querySelectorAll('h2, h3, h4, main table, main figure')].filter(e => !e.id && !e.closest('section[id], details[id], .player')).map(e => e.outerHTML.slice(0, 80))"), [])

    def test_without_script_the_verdict_and_the_stills_are_there(self):
        b = self.open()
        b.scripts(False)
        b.open((REPORT / "index.html").as_uri())
        b.scripts(True)
        self.assertEqual(b.run("document.documentElement.classList.contains('scripted')"), False)
        self.assertGreater(b.run("document.querySelectorAll('#scenario_3 .panels svg').length"), 3)
        self.assertGreater(b.run("document.querySelectorAll('#checks summary').length"), 20)

    def test_no_table_is_a_dump(self):
        b = self.open()
        b.run("for (const s of document.querySelectorAll('main section')) s.style.contentVisibility = 'visible'")
        self.assertEqual(b.run(f"[...document.querySelectorAll('main td')].filter(c => c.textContent.length > {LONGEST}).map(c => c.closest('table').id + ': ' + c.textContent.length)"), [])
        runs = b.run("document.querySelector('#table_runs').offsetHeight")
        self.assertLess(runs, 2000, "the table of the runs is two screens at most")
        height = b.run("document.querySelector('main').scrollHeight")
        print(f"the page is {height} px high")
        self.assertLess(height, HIGHEST)
        self.assertEqual(b.run("[...document.querySelectorAll('#table_runs tbody a')].length"), b.run("document.querySelectorAll('#table_runs thead th').length") - 1)

    def test_statements_and_requirements_have_links_of_their_own(self):
        b = self.open()
        if not b.run("!!document.querySelector('#study_statements')"):
            self.skipTest("the page was made without studies")
        b.scripts(False)  # what is cited is there without a script
        b.open((REPORT / "index.html").as_uri())
        b.scripts(True)
        rows = "[...document.querySelectorAll('#study_statements table')][0].querySelectorAll('tbody tr')"
        self.assertGreater(b.run(rows + ".length"), 60)
        self.assertTrue(b.run(f"[...{rows}].every(r => r.id.startsWith('statement_'))"))
        self.assertTrue(b.run(f"[...{rows}].every(r => r.querySelector('a[href^=\"#\"]') && r.querySelector('a[href=\"statements.toml\"]'))"))
        if b.run("!!document.querySelector('#checks details')"):
            said = int(b.run("document.querySelector('#verdict').textContent.match(/of ([\\d,]+) requirements/)[1].replace(',', '')"))
            self.assertEqual(b.run("document.querySelectorAll('tr[id^=\"requirement_\"]').length"), said)

    def test_drawings_are_whole_and_say_what_they_show(self):
        b, cut = self.open(), {}
        files = sorted(REPORT.glob("*.svg"))
        self.assertGreater(len(files), 10)
        for file in files:
            text = file.read_text()
            self.assertNotRegex(text, "(?i)<title>gnuplot|gnuplot_plot_", file.name)
            b.open(file.as_uri())
            outside = b.run("""(box => [...document.querySelectorAll('text')].filter(t => t.textContent.trim() && (r => r.left < box.left - 0.5 ||
                r.right > box.right + 0.5 || r.top < box.top - 0.5 || r.bottom > box.bottom + 0.5)(t.getBoundingClientRect())).map(t => t.textContent.trim()))(
                document.documentElement.getBoundingClientRect())""")
            if outside:
                cut[file.name] = outside
        self.assertEqual(cut, {})

    # ---- figures, terms, numbers ----

    def test_a_curve_under_the_pointer_stands_out_and_says_its_name(self):
        b = self.open()
        figure = "#figure_work_precision_scenario_1"
        if not b.run(f"!!document.querySelector('{figure}')"):
            self.skipTest("the page was made without studies")
        b.run(f"document.querySelector('{figure}').scrollIntoView()")
        b.wait(f"document.querySelector('{figure} g[data-name=\"ab2\"] path')")
        self.assertEqual(b.run("document.querySelectorAll('.plot g > title').length"), 0, "the browser's own titles would come too")
        x, y, faint = b.run(f"""(() => {{ const path = document.querySelector('{figure} g[data-name="ab2"] path'), at = path.getPointAtLength(path.getTotalLength() / 2);
            const place = new DOMPoint(at.x, at.y).matrixTransform(path.getScreenCTM());
            return [place.x, place.y, +getComputedStyle(path.closest('[opacity]')).opacity]; }})()""")
        self.assertLess(faint, 0.7, "what is not in front is faint")
        b.call("Input.dispatchMouseEvent", type="mouseMoved", x=x + 2, y=y + 2)
        name = b.wait("(l => !l.hidden && l.textContent)(document.querySelector('.curve_name'))")
        lit = b.run(f"[...document.querySelectorAll('{figure} g.lit')].map(g => g.dataset.name)")
        self.assertTrue(lit and set(lit) == {name}, (lit, name))
        self.assertEqual(b.run(f"+getComputedStyle(document.querySelector('{figure} g.lit [opacity]') ?? document.querySelector('{figure} g.lit path')).opacity"), 1)
        b.call("Input.dispatchMouseEvent", type="mouseMoved", x=2, y=2)
        b.wait("document.querySelector('.curve_name').hidden")
        self.assertEqual(b.run("document.querySelectorAll('g.lit').length"), 0)

    def test_terms_are_explained_where_a_section_first_uses_them(self):
        b = self.open()
        if not b.run("!!document.querySelector('#study_work_precision')"):
            self.skipTest("the page was made without studies")
        linked = b.run("[...document.querySelectorAll('#study_work_precision a.term')].map(a => [a.textContent, a.getAttribute('href'), a.title])")
        self.assertEqual(len({name for name, _, _ in linked}), len(linked), "each once")
        self.assertTrue({"pece", "rkc", "+t", "+e"} <= {name for name, _, _ in linked}, linked)
        self.assertTrue(all(title for _, _, title in linked))
        self.assertEqual(b.run("document.querySelectorAll('button a.term').length"), 0)

    def test_numbers_of_checks_are_written_as_those_of_tables(self):
        b = self.open()
        b.run("document.querySelector('details.suite').open = true")
        b.wait("document.querySelector('details.suite table.checks td')")
        cells = b.run("[...document.querySelectorAll('details.suite table.checks td.number')].map(c => c.firstChild.textContent)")
        self.assertEqual([c for c in cells if re.search(r"\de[+−-]?\d|\d{5,}(?!.*\.)", c.split(".")[0])], [])

    # ---- the players ----

    def test_a_player_plays_and_pauses(self):
        b = self.player()
        start = b.run("p.go(0); p.toggle(); p.mm")
        b.wait(f"p.mm > {start} + 5")
        b.run("p.toggle()")
        stopped = b.run("p.mm")
        self.assertEqual(b.run("new Promise(f => setTimeout(() => f(p.mm), 300))"), stopped)

    def test_scrubbing_the_curve_keeps_step_with_the_scene(self):
        b = self.player()
        pictures = set()
        for part in (0.2, 0.5, 0.9):
            mm = b.run(f"""(() => {{ const r = p.curve.getBoundingClientRect(), x = r.left + r.width * {part};
                p.curve.dispatchEvent(new PointerEvent('pointerdown', {{ clientX: x, clientY: r.top + 20, pointerId: 1, buttons: 1 }})); return [p.mm, p.to_mm(x - r.left)]; }})()""")
            self.assertAlmostEqual(mm[0], mm[1], 6)
            self.assertAlmostEqual(float(b.run("p.curve.getAttribute('aria-valuenow')")), mm[0], delta=0.06)
            self.assertIn(" N", b.run("p.said.textContent"))
            pictures.add(b.run("p.canvases[0].toDataURL()"))
        self.assertEqual(len(pictures), 3, "the scene has moved")
        self.picture("player")

    def test_keys_step_from_picture_to_picture(self):
        b = self.player()
        key = "p.curve.dispatchEvent(new KeyboardEvent('keydown', {{ key: '{}', cancelable: true }})); p.mm"
        b.run("p.go(0)")
        second = b.run(key.format("ArrowRight"))
        self.assertAlmostEqual(second, b.run("p.first.mm[1]"))
        self.assertEqual(b.run(key.format("ArrowLeft")), 0)
        self.assertAlmostEqual(b.run(key.format("End")), b.run("p.end"))

    def test_two_runs_stand_side_by_side_at_the_same_displacement(self):
        b = self.player("scenario_2")
        if b.run("p.choices.length") < 2:
            self.skipTest("the page was made without --players")
        b.run("p.beside(p.choices.at(-1).id)")
        b.wait("p.films.length === 2")
        b.run("p.go(300)")
        self.assertRegex(b.run("p.said.textContent"), r"^300 mm: .* N and .* N")
        self.assertNotEqual(b.run("p.canvases[0].toDataURL()"), b.run("p.canvases[1].toDataURL()"))
        self.picture("two_runs")

    def test_torn_links_are_counted_up_to_the_moment(self):
        b = self.player()
        self.assertEqual(b.run("p.go(0); p.said.textContent.match(/(\\d+) links torn/)[1]"), "0")
        self.assertEqual(int(b.run("p.go(p.end); p.said.textContent.match(/(\\d+) links torn/)[1]")), b.run("p.first.torn.length"))

    def test_colours_and_chains_change_the_picture(self):
        b = self.player()
        pictures = [b.run(f"p.set({o}); p.canvases[0].toDataURL()") for o in ("{colour: 'stress'}", "{colour: 'speed'}", "{colour: 'overlap'}", "{chains: true}")]
        self.assertEqual(len(set(pictures)), 4)

    def test_who_asks_for_little_motion_gets_a_picture_a_second(self):
        b = self.player()
        b.look(*WIDE, motion="reduce")
        b.run("p.go(0); p.toggle()")
        self.assertEqual(b.run("new Promise(f => setTimeout(() => f(p.mm), 400))"), 0)
        b.wait("p.mm > 0")
        b.run("p.pause()")

    # ---- tables ----

    def test_statements_are_filtered_by_verdict_and_words(self):
        b = self.open()
        if not b.run("!!document.querySelector('#study_statements')"):
            self.skipTest("the page was made without studies")
        b.run("document.querySelector('#study_statements table').scrollIntoView()")
        b.wait("document.querySelector('#study_statements .tools')")
        shown = "[...document.querySelectorAll('#study_statements table')][0].querySelectorAll('tbody tr:not(.group):not([hidden])').length"
        every = b.run(shown)
        b.run("[...document.querySelectorAll('#study_statements .tools button')].find(b => b.textContent.includes('not reproduced')).click()")
        some = b.run(shown)
        self.assertTrue(0 < some < every, (some, every))
        self.assertEqual(b.run("[...document.querySelector('#study_statements table').querySelectorAll('tbody tr:not(.group):not([hidden])')].every(r => r.textContent.includes('not reproduced'))"), True)
        self.picture("statements")
        b.run("(i => { i.value = 'largest force'; i.dispatchEvent(new Event('input')); })(document.querySelector('#study_statements .tools input'))")
        self.assertLess(b.run(shown), some)

    def test_a_head_sorts_its_column_both_ways(self):
        b = self.open()
        b.run("document.querySelector('#terms details').open = true")
        b.run("document.querySelector('#table_methods').scrollIntoView()")  # tables get their tools when they are seen
        b.wait("document.querySelector('#terms .tools')")
        column = "[...document.querySelectorAll('#table_methods tbody tr')].map(r => +r.cells[2].textContent)"
        for order in (False, True):
            b.run("document.querySelectorAll('#table_methods thead button')[2].click()")
            values = b.run(column)
            self.assertEqual(values, sorted(values, reverse=order))

    def test_a_page_of_checks_opens_to_its_rows(self):
        b = self.open()
        if not b.run("!!document.querySelector('#checks details')"):
            self.skipTest("the page was made without checks")
        self.assertEqual(b.run("document.querySelectorAll('#checks table').length"), 0, "built when opened")
        b.run("document.querySelector('#checks details').open = true")
        b.wait("document.querySelector('#checks details tbody tr')")
        self.assertEqual(b.run("document.querySelectorAll('#checks details tbody tr').length"),
                         int(b.run("document.querySelector('#checks summary span').textContent.match(/\\d+/)[0]")))
        one = b.run("document.querySelector('#checks tbody tr').id")
        b.open((REPORT / "index.html").as_uri() + "#" + one)
        b.wait(f"document.getElementById('{one}')?.getBoundingClientRect().top < {WIDE[1]}")

    def test_checks_are_found_by_words(self):
        b = self.open()
        if not b.run("!!document.querySelector('#checks_tools input')"):
            self.skipTest("the page was made without checks")
        b.run("(i => { i.value = 'energy'; i.dispatchEvent(new Event('input')); })(document.querySelector('#checks_tools input'))")
        b.wait("document.querySelectorAll('#checks_found tbody tr').length > 3")
        self.assertTrue(b.run("[...document.querySelectorAll('#checks_found tbody tr')].every(r => r.textContent.toLowerCase().includes('energy'))"))

    # ---- what a reviewer asks ----

    def rows_of(self, b, caption):
        """The cells of the rows of the table whose caption begins so."""
        return b.run(f"""(t => t && [...t.querySelectorAll('tbody tr:not(.group)')].map(r => [...r.cells].map(c => c.textContent.trim())))(
            [...document.querySelectorAll('main table')].find(t => t.caption?.textContent.trim().startsWith({caption!r})))""")

    def table(self, b, caption):
        rows = self.rows_of(b, caption)
        if not rows:
            self.skipTest("the page was made without studies")
        return rows

    def test_cost_of_an_error_is_given_for_the_best_method_and_the_papers(self):
        rows = self.table(self.open(), "The cheapest method at an error")
        asked = [r for r in rows if r[0] == "scene 1" and r[1] == "0.001"]
        self.assertEqual(len(asked), 1, "what does an error of 1e-3 cost in scene 1?")
        best, of_best, of_papers = asked[0][2:5]
        self.assertTrue(best and of_best and of_papers, asked[0])

    def test_the_step_is_said_to_be_above_or_below_the_limit_in_each_scene(self):
        rows = self.table(self.open(), "Is the step of each scene below")
        at_lattice = [r for r in rows if r[0] == "scene 3, discs" and r[1].startswith("as the plate is where the paper has it meet the lattice")]
        self.assertEqual(len(at_lattice), 1)
        for row in rows:
            wanted = "above the limit" if float(row[2]) > 1 else "below the limit"
            self.assertIn(wanted, row[3], row)

    def test_what_is_not_reproduced_says_why(self):
        rows = self.table(self.open(), "Every statement of the paper, judged")
        refuted = [r for r in rows if "not reproduced" in r[2]]
        self.assertTrue(refuted)
        self.assertEqual([r for r in refuted if len(r) < 9 or not r[8]], [])

    def test_every_section_says_when_by_what_and_where_its_numbers_were_made(self):
        for row in self.table(self.open(), "When the kept numbers of each section"):
            self.assertRegex(row[4], r"[0-9a-f]{7}", row)
            if row[6] != "scripts/faults":  # which did not say when in its earlier form
                self.assertRegex(row[3], r"\d{4}-\d\d-\d\d", row)
            self.assertRegex(row[5], "today's solver|older than the solver", row)

    def test_engines_are_judged_case_by_case(self):
        b = self.open()
        if not b.run("!!document.querySelector('#judgements table')"):
            self.skipTest("the page was made without judgements")
        cases = self.rows_of(b, "Cases by engines")
        self.assertGreater(len(cases), 40)
        names = b.run("[...document.querySelectorAll('#judgements thead .upright')].map(h => h.textContent)")
        self.assertTrue(any("LAMMPS" in n for n in names) and any("pece" in n for n in names), names)
        self.assertTrue(all(len(row) == len(names) + 1 for row in cases))

    def test_scenes_have_their_figures(self):
        b = self.open()
        for name in ("scenario_3_force", "scenario_3_overlaps", "scenario_3_tears", "scenario_3_by_step"):
            if name.endswith("by_step") and not (REPORT / "scenario_3_half").exists():
                continue  # the page was made without --players
            self.assertTrue((REPORT / f"{name}.svg").exists(), name)
            self.assertTrue(b.run(f"[...document.querySelectorAll('#scenario_3 a')].some(a => a.getAttribute('href') === '{name}.svg')"), name)

    # ---- other readers ----

    def test_a_phone_scrolls_in_one_direction(self):
        b = self.open(PHONE)
        b.run("for (const s of document.querySelectorAll('main section')) s.style.contentVisibility = 'visible'")
        self.assertLessEqual(b.run("document.documentElement.scrollWidth"), PHONE[0])
        self.picture("phone")
        b.run("document.querySelector('#contents_button').click()")
        self.assertTrue(b.run("document.querySelector('#contents_list').offsetHeight > 100"))

    def test_words_of_figures_can_be_read_on_a_phone(self):
        b = self.open(PHONE)
        b.run("for (const s of document.querySelectorAll('main section')) s.style.contentVisibility = 'visible'")
        small = b.run("""[...document.querySelectorAll('.plot > svg')].filter(s => s.getBoundingClientRect().width).flatMap(s => {
            const scale = s.getBoundingClientRect().width / s.viewBox.baseVal.width;
            const least = Math.min(...[...s.querySelectorAll('text')].map(t => parseFloat(getComputedStyle(t).fontSize) * scale));
            return least < 9 ? [(s.closest('figure[id]') || s.parentNode).id + ': ' + least.toFixed(1) + ' px'] : [];
        })""")
        self.assertEqual(small, [])

    def test_dark_is_dark_and_paper_is_white(self):
        ground = "getComputedStyle(document.body).backgroundColor.match(/\\d+/g).map(Number)[0]"
        b = self.open(scheme="dark")
        self.picture("dark")
        self.assertLess(b.run(ground), 60)
        b.look(*WIDE, scheme="dark", media="print")
        self.assertGreater(b.run(ground), 240)

    def assert_accessible(self, size):
        if not AXE:
            self.skipTest("axe cannot be had: npm install axe-core, and AXE=.../axe.min.js")
        b = self.open(size)
        b.run("for (const s of document.querySelectorAll('main section')) s.style.contentVisibility = 'visible'")
        b.run("(async () => { for (let y = 0; y < document.body.scrollHeight; y += 800) { scrollTo(0, y); await new Promise(f => setTimeout(f, 20)); } dispatchEvent(new Event('resize')); })()")
        b.call("Runtime.evaluate", expression=pathlib.Path(AXE).read_text())
        found = b.run("axe.run(document, { resultTypes: ['violations'] }).then(r => r.violations.map(v => v.id + ' (' + v.impact + '): ' + v.nodes.length + ', first ' + v.nodes[0].html.slice(0, 160)))")
        self.assertEqual(found, [])

    def test_axe_finds_nothing_on_a_wide_screen(self):
        self.assert_accessible(WIDE)

    def test_axe_finds_nothing_on_a_phone(self):
        self.assert_accessible(PHONE)


    # ---- pictures to look at ----

    def test_pictures_of_every_part_are_kept(self):
        for name, size, scheme in (("wide", WIDE, "light"), ("phone", PHONE, "light"), ("dark", WIDE, "dark")):
            b = self.open(size, scheme=scheme)
            b.run("for (const s of document.querySelectorAll('main section')) s.style.contentVisibility = 'visible'")
            for part in b.run("[...document.querySelectorAll('section.part')].map(p => p.id)"):
                b.run(f"document.getElementById('{part}').scrollIntoView(); new Promise(f => setTimeout(f, 150))")
                self.picture(f"{name}_{part}")
        b = self.open()
        paper = base64.b64decode(b.call("Page.printToPDF", preferCSSPageSize=True, printBackground=True)["data"])
        (ARTEFACTS / "print.pdf").write_bytes(paper)
        self.assertTrue(paper.startswith(b"%PDF"))


if __name__ == "__main__":
    if not browser.found():
        print("skipped: there is no Chromium here (Debian's package chromium)")
        sys.exit(77)
    ARTEFACTS.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
