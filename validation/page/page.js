"use strict";
// What the page does beyond reading: contents that follow, tables that sort, filter and fold, checks built when opened.
(() => {
  const $ = (selector, within = document) => within.querySelector(selector);
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];
  const make = (tag, properties = {}, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };
  document.documentElement.classList.add("scripted");

  // Data of the page: deflated, in base64.
  const unpacked = async (id) => {
    const bytes = Uint8Array.from(atob($("#" + id).textContent.trim()), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  };
  window.furrow = { unpacked };

  // ---- contents ----
  const button = $("#contents_button"), contents = $("#contents");
  button.hidden = matchMedia("(min-width: 68rem)").matches;
  matchMedia("(min-width: 68rem)").addEventListener("change", (e) => (button.hidden = e.matches));
  const open = (yes) => {
    contents.classList.toggle("open", yes);
    button.setAttribute("aria-expanded", yes);
    if (yes) $("#contents a.current")?.scrollIntoView({ block: "nearest" });
  };
  button.addEventListener("click", () => open(!contents.classList.contains("open")));
  contents.addEventListener("click", (e) => e.target.closest("a") && open(false));
  addEventListener("keydown", (e) => e.key === "Escape" && open(false));
  const lines = new Map(all("#contents a").map((a) => [a.getAttribute("href").slice(1), a]));
  const in_order = (a, b) => (a.compareDocumentPosition(b) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1);
  const places = [...lines.keys()].map((id) => document.getElementById(id)).filter((e) => e && e.tagName === "SECTION").sort(in_order);
  const follow = () => {
    let here = null;
    for (const place of places) if (place.getBoundingClientRect().top < innerHeight / 3) here = place;
    for (const a of lines.values()) {
      a.classList.remove("current");
      a.removeAttribute("aria-current");
    }
    if (here) {
      const line = lines.get(here.id);
      line.classList.add("current");
      line.setAttribute("aria-current", "true");
      const box = contents.getBoundingClientRect(), at = line.getBoundingClientRect();
      if (at.top < box.top || at.bottom > box.bottom) contents.scrollTop += at.top - box.top - contents.clientHeight / 3;
    }
  };
  let waiting = false;
  addEventListener("scroll", () => {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => ((waiting = false), follow()));
  }, { passive: true });
  follow();

  // ---- tables ----
  const number = (cell) => {
    const text = cell.textContent.replace(/−/g, "-").replace(/(\d),(?=\d{3}(?!\d))/g, "$1").replace(/\s*×\s*10(-?\d+)/, "e$1").replace(/^10(-?\d+)$/, "1e$1").trim();
    const value = parseFloat(text);
    return Number.isNaN(value) ? null : value;
  };
  const by = (column, down) => (a, b) => {
    const x = a.cells[column], y = b.cells[column];
    if (!x || !y) return 0;
    const p = number(x), q = number(y);
    const order = p !== null && q !== null ? p - q : p !== null ? -1 : q !== null ? 1 : x.textContent.localeCompare(y.textContent);
    return down ? -order : order;
  };
  // A number as programs read it, words as they are.
  const plain = (cell) => {
    const text = cell.textContent.trim().replace(/\s+/g, " ");
    return /^[−-]?[\d.,]+(\s?×\s?10[−-]?\d+)?$|^10[−-]?\d+$/.test(text) && !/,(?!\d{3}(?!\d))/.test(text) ? String(number(cell)) : text;
  };
  const csv = (table) => [table.tHead.rows[0], ...all("tbody tr:not(.group)", table)].map((row) =>
    [...row.cells].map((cell) => '"' + plain(cell).replace(/"/g, '""') + '"').join(",")).join("\n");
  const save = (table) => {
    const link = make("a", { href: URL.createObjectURL(new Blob([csv(table)], { type: "text/csv" })), download: table.id + ".csv" });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };
  const group_rows = (table) => {
    const body = table.tBodies[0], width = table.tHead.rows[0].cells.length;
    let name = null, head = null, members = [];
    const close = () => {
      if (!head) return;
      const chips = new Map();
      for (const row of members) for (const chip of all(".chip", row)) chips.set(chip.textContent.trim(), (chips.get(chip.textContent.trim()) || 0) + 1);
      const words = [...chips].map(([what, n]) => n + " " + what).join(", ");
      const toggle = make("button", { type: "button", textContent: "▾ " + name + ": " + members.length + " rows" + (words ? ": " + words : "") });
      const own = members;
      toggle.setAttribute("aria-expanded", "true");
      toggle.addEventListener("click", () => {
        const shut = toggle.getAttribute("aria-expanded") === "true";
        toggle.setAttribute("aria-expanded", !shut);
        toggle.textContent = (shut ? "▸" : "▾") + toggle.textContent.slice(1);
        for (const row of own) row.classList.toggle("folded", shut);
        table.dispatchEvent(new Event("filter"));
      });
      head.firstChild.append(toggle);
    };
    for (const row of [...body.rows]) {
      const now = row.cells[0].textContent.trim();
      if (now !== name) {
        close();
        name = now;
        members = [];
        const cell = make("th", { colSpan: width, scope: "rowgroup" });
        head = make("tr", { className: "group" }, cell);
        body.insertBefore(head, row);
      }
      members.push(row);
    }
    close();
  };
  const tools_of = (table) => {
    const body = table.tBodies[0], rows = [...body.rows], heads = [...table.tHead.rows[0].cells];
    if (table.classList.contains("grouped")) group_rows(table);
    const with_groups = [...body.rows];
    const box = make("input", { type: "search", placeholder: "filter rows" });
    box.setAttribute("aria-label", "Filter the rows of the table");
    const count = make("output"), chosen = new Set(), kinds = new Map();
    for (const row of rows) for (const chip of all(".chip", row)) kinds.set(chip.textContent.trim(), chip.className);
    const filter = () => {
      const words = box.value.toLowerCase().split(/\s+/).filter(Boolean);
      let shown = 0;
      for (const row of rows) {
        const text = row.textContent.toLowerCase();
        const kept = words.every((w) => text.includes(w)) && (chosen.size === 0 || all(".chip", row).some((c) => chosen.has(c.textContent.trim())));
        shown += kept ? 1 : 0;
        row.hidden = !kept || row.classList.contains("folded");
      }
      count.textContent = shown === rows.length ? rows.length + " rows" : shown + " of " + rows.length + " rows";
    };
    box.addEventListener("input", filter);
    table.addEventListener("filter", filter);
    const chips = kinds.size < 2 || kinds.size > 6 ? [] : [...kinds.keys()].map((kind) => {
      const toggle = make("button", { type: "button", textContent: kind });
      toggle.setAttribute("aria-pressed", "false");
      toggle.addEventListener("click", () => {
        chosen.has(kind) ? chosen.delete(kind) : chosen.add(kind);
        toggle.setAttribute("aria-pressed", chosen.has(kind));
        filter();
      });
      return toggle;
    });
    const saved = make("button", { type: "button", textContent: "save as CSV" });
    saved.addEventListener("click", () => save(table));
    heads.forEach((head, k) => {
      if (head.querySelector("button") || !head.textContent.trim()) return;
      const sort = make("button", { type: "button" });
      sort.append(...head.childNodes);
      head.append(sort);
      sort.addEventListener("click", () => {
        const down = head.getAttribute("aria-sort") === "ascending";
        for (const other of heads) other.removeAttribute("aria-sort");
        head.setAttribute("aria-sort", down ? "descending" : "ascending");
        for (const row of with_groups) if (row.classList.contains("group")) row.remove();
        body.append(...rows.slice().sort(by(k, down)));
      });
    });
    table.closest(".scroll").before(make("div", { className: "tools" }, box, ...chips, saved, count));
    filter();
  };
  // What is far down waits until the page has been painted and the reader comes near.
  const near = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (!entry.isIntersecting) continue;
      near.unobserve(entry.target);
      tools_of(entry.target.querySelector("table"));
    }
  }, { rootMargin: "1500px" });
  for (const table of all("table:not(.plain)")) if (table.tBodies[0].rows.length > 8) near.observe(table.closest(".scroll"));

  // A region takes the keyboard only if it scrolls.
  const scrollers = () => {
    for (const region of all(".scroll, .plot")) region.scrollWidth > region.clientWidth + 1 ? region.setAttribute("tabindex", "0") : region.removeAttribute("tabindex");
  };
  addEventListener("load", scrollers);
  addEventListener("resize", scrollers);

  // ---- checks ----
  let checks = null;
  const load_checks = () => (checks ??= unpacked("checks_data").then((bytes) => {
    const { columns, words, rows } = JSON.parse(new TextDecoder().decode(bytes));
    return rows.map((row) => Object.fromEntries(columns.map((c, k) => [c, typeof row[k] === "string" ? words[+row[k].slice(1)] : row[k]])));
  }));
  // As html.h shows them.
  const grouped = (text) => (/^−?\d{5,}$/.test(text) ? text.replace(/\d(?=(\d{3})+$)/g, "$&,") : text);
  const digits = (x) => {
    if (typeof x !== "number") return String(x);
    const power = x === 0 ? 0 : Math.floor(Math.log10(Math.abs(x)) + 1e-9);
    if (power >= -4 && power <= 6) return grouped(String(+x.toPrecision(4)).replace("-", "−"));
    const [mantissa, exponent] = x.toExponential(2).split("e");
    const sign = exponent[0] === "-" ? "−" : "";
    return make("span", {}, mantissa.replace("-", "−") + " × 10", make("sup", { textContent: sign + exponent.slice(1) }));
  };
  const check_id = (check, k) => "check_" + check.test.replace(/\W/g, "_") + "_" + k;
  const check_table = (list, name) => {
    const table = make("table", { className: "checks" });
    table.createCaption().append(make("span", { className: "unseen", textContent: name }));
    const head = table.createTHead().insertRow();
    for (const words of ["Check", "Expected", "Got", "Error", "Tolerance", "Of limit", "Why this tolerance, and what for"]) {
      head.append(make("th", { scope: "col", textContent: words, className: /Check|Why/.test(words) ? "" : "number" }));
    }
    const body = table.createTBody();
    for (const check of list) {
      const row = body.insertRow();
      row.id = check.id;
      const cell = (className, text, small) => row.append(make("td", { className }, text, ...(small ? [make("small", { textContent: small })] : [])));
      cell("", check.name, check.test);
      cell("number", digits(check.want));
      cell("number", digits(check.got));
      cell("number", digits(check.error));
      cell("number", digits(check.tolerance), check.kind);
      cell("number", check.good ? make("span", {}, digits(+(100 * check.of_limit).toPrecision(3)), " %") : make("span", { className: "chip bad", textContent: "✗ failed" }));
      cell("", check.reason, check.sentence + " (" + check.requirement + ", " + check.file + ")");
      row.cells[0].append(make("a", { className: "here", href: "#" + check.id, textContent: "#", ariaLabel: "Link to this check" }));
    }
    const region = make("div", { className: "scroll", tabIndex: 0 }, table);
    region.setAttribute("role", "region");
    region.setAttribute("aria-label", name);
    return region;
  };
  const with_ids = async () => {
    const list = await load_checks();
    const counts = new Map();
    for (const check of list) {
      const k = (counts.get(check.test) || 0) + 1;
      counts.set(check.test, k);
      check.id ??= check_id(check, k);
    }
    return list;
  };
  const fill = async (suite) => {
    if (suite.dataset.filled) return;
    suite.dataset.filled = "yes";
    const list = (await with_ids()).filter((check) => check.test.split(".")[0] === suite.dataset.suite);
    suite.append(check_table(list, "Checks of " + suite.dataset.suite));
    tools_of_checks(suite);
  };
  const tools_of_checks = (suite) => {
    const table = suite.querySelector("table");
    if (table.tBodies[0].rows.length > 8) tools_of(Object.assign(table, { id: "checks_of_" + suite.dataset.suite }));
  };
  for (const suite of all("details.suite")) suite.addEventListener("toggle", () => suite.open && fill(suite));
  const finder = $("#checks_tools");
  if (finder) {
    finder.hidden = false;
    finder.className = "tools";
    const box = make("input", { type: "search", placeholder: "find checks" }), count = make("output");
    box.setAttribute("aria-label", "Find checks by words of their names, tests, requirements or reasons");
    box.addEventListener("input", async () => {
      const words = box.value.toLowerCase().split(/\s+/).filter(Boolean), found = $("#checks_found");
      found.replaceChildren();
      count.textContent = "";
      if (words.length === 0) return;
      const list = (await with_ids()).filter((c) => {
        const text = [c.name, c.test, c.requirement, c.reason, c.sentence, c.file].join(" ").toLowerCase();
        return words.every((w) => text.includes(w));
      });
      if (words.join(" ") !== box.value.toLowerCase().split(/\s+/).filter(Boolean).join(" ")) return;
      count.textContent = list.length + " found" + (list.length > 100 ? ", the first 100 shown" : "");
      const shown = check_table(list.slice(0, 100).map((c) => ({ ...c, id: "found_" + c.id })), "Checks found");
      if (list.length) found.append(shown);
    });
    finder.append(box, count);
  }

  // ---- links to what is folded or not built yet ----
  // What stands above a target is laid out, and grows, when it comes near: until the reader moves, the target stays.
  let target = null;
  const growing = new ResizeObserver(() => target?.scrollIntoView());
  for (const section of all("main section")) growing.observe(section);
  for (const move of ["wheel", "touchstart", "pointerdown", "keydown"]) addEventListener(move, () => { target = null; }, { passive: true });
  const reveal = async () => {
    const id = decodeURIComponent(location.hash.slice(1));
    if (!id) return;
    if (id.startsWith("check_")) {
      const check = (await with_ids()).find((c) => c.id === id);
      const suite = check && document.getElementById("checks_" + check.test.split(".")[0]);
      if (suite) {
        suite.open = true;
        await fill(suite);
      }
    }
    target = document.getElementById(id);
    if (!target) return;
    setTimeout(() => { target = null; }, 3000);
    for (let e = target; e; e = e.parentElement) if (e.tagName === "DETAILS") e.open = true;
    target.scrollIntoView();
  };
  addEventListener("hashchange", reveal);
  if (location.hash) reveal();
  addEventListener("beforeprint", () => { for (const d of all("details.unfold")) d.open = true; });
})();
