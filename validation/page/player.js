"use strict";
// Runs that move beside their force curve. A film: header as JSON, then its numbers, frame after frame as differences.
(() => {
  const sequential = ["#ffffd9", "#edf8b1", "#c7e9b4", "#7fcdbb", "#41b6c4", "#1d91c0", "#225ea8", "#253494", "#081d58"];
  const rgb = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16));
  const mixed = (a, b, t) => "rgb(" + a.map((x, k) => Math.round(x + (b[k] - x) * t)).join(",") + ")";
  const ramp = Array.from({ length: 256 }, (_, k) => {
    const at = (k / 255) * 8, low = Math.min(7, Math.floor(at));
    return mixed(rgb(sequential[low]), rgb(sequential[low + 1]), at - low);
  });
  const blue = [0, 114, 178], grey = [187, 187, 187], orange = [213, 94, 0];
  const diverging = (z) => (z < 0 ? mixed(grey, blue, Math.min(1, -z)) : mixed(grey, orange, Math.min(1, z)));
  const make = (tag, properties = {}, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };
  const inflated = async (text) => {
    const bytes = Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return await new Response(stream).arrayBuffer();
  };

  // Frames of numbers, each but the first the difference to the one before.
  const summed = (values, width) => {
    for (let k = width; k < values.length; ++k) values[k] += values[k - width];
    return values;
  };
  const read_film = async (id) => {
    const buffer = await inflated(document.getElementById(id).textContent);
    const length = new DataView(buffer).getUint32(0, true);
    const film = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
    let at = 4 + length;
    const take = (type, width, differences = true) => {
      const count = width * (differences ? film.mm.length : 1);
      const values = new type(buffer.slice(at, at + count * type.BYTES_PER_ELEMENT));
      at += count * type.BYTES_PER_ELEMENT;
      return differences ? summed(values, width) : values;
    };
    const n = film.radius.length, m = film.nodes;
    film.discs = take(Int16Array, 2 * n);
    film.stress = take(Uint8Array, n);
    film.speed = take(Uint8Array, n);
    film.node = take(Int16Array, 2 * m);
    film.link_force = take(Int8Array, film.links.length);
    film.plate = take(Int16Array, 2 * film.plates.length);
    film.low = take(Int16Array, film.curve.count, false);
    film.high = take(Int16Array, film.curve.count, false);
    return film;
  };

  // Whole number of the last frame at a displacement, and how far on towards the next.
  const place = (film, mm) => {
    let k = 0;
    while (k + 2 < film.mm.length && film.mm[k + 1] <= mm) ++k;
    const next = Math.min(k + 1, film.mm.length - 1), span = film.mm[next] - film.mm[k];
    const smooth = film.mm.length >= 60 && span > 0;
    const part = span > 0 ? Math.min(1, Math.max(0, (mm - film.mm[k]) / span)) : 0;
    return smooth ? [k, next, part] : [part >= 1 ? next : k, part >= 1 ? next : k, 0];
  };
  const between = (values, width, [k, next, part], j) => {
    const a = values[k * width + j];
    return a + (values[next * width + j] - a) * part;
  };

  // Pairs of discs that overlap, by a grid of cells as large as the largest disc.
  const contacts = (x, y, r) => {
    const n = r.length, cell = 2 * Math.max(...r, 1e-9), cells = new Map(), found = [];
    const key = (i, j) => i * 100003 + j;
    for (let k = 0; k < n; ++k) {
      const i = Math.floor(x[k] / cell), j = Math.floor(y[k] / cell);
      for (let di = -1; di <= 1; ++di)
        for (let dj = -1; dj <= 1; ++dj)
          for (const other of cells.get(key(i + di, j + dj)) || []) {
            const overlap = r[k] + r[other] - Math.hypot(x[k] - x[other], y[k] - y[other]);
            if (overlap > 0) found.push([k, other, overlap]);
          }
      const own = key(i, j);
      if (!cells.has(own)) cells.set(own, []);
      cells.get(own).push(k);
    }
    return found;
  };

  const fit = (canvas, height_over_width) => {
    const scale = devicePixelRatio || 1, width = canvas.clientWidth, height = Math.round(width * height_over_width);
    if (canvas.width !== Math.round(width * scale) || canvas.height !== Math.round(height * scale)) {
      canvas.width = Math.round(width * scale);
      canvas.height = Math.round(height * scale);
      canvas.style.height = height + "px";
    }
    const context = canvas.getContext("2d");
    context.setTransform(scale, 0, 0, scale, 0, 0);
    context.clearRect(0, 0, width, height);
    return [context, width, height];
  };
  const colour_of = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim() || "#222";

  const draw_scene = (film, canvas, mm, options) => {
    const [x0, y0, x1, y1] = options.view; // of the first film: what another one throws further is not seen
    const [left, foot] = film.box;
    const [c, width, height] = fit(canvas, (y1 - y0) / (x1 - x0));
    const metre = width / (x1 - x0), q = film.unit, here = place(film, mm);
    const px = (x) => (x - x0) * metre, py = (y) => height - (y - y0) * metre;
    const n = film.radius.length, x = new Float64Array(n), y = new Float64Array(n);
    for (let k = 0; k < n; ++k) {
      x[k] = left + q * (between(film.discs, 2 * n, here, 2 * k) + 32768);
      y[k] = foot + q * (between(film.discs, 2 * n, here, 2 * k + 1) + 32768);
    }
    const touching = options.chains || options.colour === "overlap" ? contacts(x, y, film.radius) : [];
    const shade = new Float64Array(n);
    if (options.colour === "overlap") {
      for (const [a, b, overlap] of touching) {
        const share = overlap / Math.min(film.radius[a], film.radius[b]);
        shade[a] = Math.max(shade[a], share / options.tops.overlap);
        shade[b] = Math.max(shade[b], share / options.tops.overlap);
      }
    } else {
      const values = options.colour === "speed" ? film.speed : film.stress;
      const scale = film.tops[options.colour] / options.tops[options.colour] / 255; // one scale for all films
      for (let k = 0; k < n; ++k) shade[k] = scale * between(values, n, here, k);
    }
    c.lineWidth = Math.max(0.4, 0.06 * metre * (film.radius[0] || 0.01));
    c.strokeStyle = "#808080";
    for (let k = 0; k < n; ++k) {
      c.fillStyle = options.chains ? "#d8d8d8" : ramp[Math.max(0, Math.min(255, Math.round(255 * shade[k])))];
      c.beginPath();
      c.arc(px(x[k]), py(y[k]), film.radius[k] * metre, 0, 2 * Math.PI);
      c.fill();
      c.stroke();
    }
    if (options.chains) {
      c.strokeStyle = "#9a3412";
      c.lineCap = "round";
      for (const [a, b, overlap] of touching) {
        const r = (film.radius[a] * film.radius[b]) / (film.radius[a] + film.radius[b]);
        c.lineWidth = 0.75 * metre * r * Math.pow(overlap / (2 * r), 1.5);
        c.beginPath();
        c.moveTo(px(x[a]), py(y[a]));
        c.lineTo(px(x[b]), py(y[b]));
        c.stroke();
      }
      c.lineCap = "butt";
    }
    const m = film.nodes, node = (k, j) => between(film.node, 2 * m, here, 2 * k + j) + 32768;
    const torn = new Set(film.torn.filter(([at]) => at <= mm).map(([, link]) => link));
    const line = (a, b) => {
      c.beginPath();
      c.moveTo(px(left + q * node(a, 0)), py(foot + q * node(a, 1)));
      c.lineTo(px(left + q * node(b, 0)), py(foot + q * node(b, 1)));
      c.stroke();
    };
    for (const bending of [true, false]) {
      film.links.forEach(([a, b, kind], k) => {
        if ((kind === 2) !== bending || torn.has(k)) return;
        c.lineWidth = Math.max(bending ? 2 : 1, (bending ? 0.0035 : 0.0014) * metre);
        c.strokeStyle = diverging(between(film.link_force, film.links.length, here, k) / 127);
        line(a, b);
      });
    }
    c.setLineDash([2, 3]);
    c.strokeStyle = "#d00000";
    c.lineWidth = 1;
    for (const k of torn) line(film.links[k][0], film.links[k][1]);
    c.setLineDash([]);
    c.fillStyle = colour_of("--ink");
    for (let k = 0; k < m; ++k) {
      c.beginPath();
      c.arc(px(left + q * node(k, 0)), py(foot + q * node(k, 1)), Math.max(1, 0.0011 * metre), 0, 2 * Math.PI);
      c.fill();
    }
    c.fillStyle = "#6b6b6bcc";
    film.plates.forEach(([w, h], k) => {
      const from = left + q * (between(film.plate, 2 * film.plates.length, here, 2 * k) + 32768);
      const lower = foot + q * (between(film.plate, 2 * film.plates.length, here, 2 * k + 1) + 32768);
      c.fillRect(px(from), py(lower + h), w * metre, h * metre);
    });
    c.strokeStyle = colour_of("--ink");
    c.lineWidth = 2;
    for (const [wx, wy, nx, ny] of film.walls) {
      c.beginPath();
      c.moveTo(px(wx - 99 * ny), py(wy + 99 * nx));
      c.lineTo(px(wx + 99 * ny), py(wy - 99 * nx));
      c.stroke();
    }
  };

  const force_at = (film, mm) => {
    const k = Math.min(film.curve.count - 1, Math.max(0, Math.floor(mm / film.curve.step)));
    return film.curve.count ? film.high[k] * film.curve.unit : NaN;
  };
  const inks = ["--ink", "--alarm"];
  const draw_curves = (films, canvas, mm, end, stills) => {
    const narrow = canvas.clientWidth < 500;
    const [c, width, height] = fit(canvas, narrow ? 0.42 : 0.2);
    const left = 46, right = 8, top = 12, bottom = 30;
    const peak = Math.max(1e-9, ...films.map((f) => f.curve.peak)) * 1.05;
    const px = (at) => left + (at / end) * (width - left - right), py = (f) => height - bottom - (f / peak) * (height - top - bottom);
    c.font = "12px system-ui, Arial, sans-serif";
    c.fillStyle = colour_of("--soft");
    c.strokeStyle = colour_of("--line");
    c.lineWidth = 1;
    const nice = (range, count) => {
      const raw = range / count, power = Math.pow(10, Math.floor(Math.log10(raw)));
      return power * [1, 2, 5, 10].find((s) => s * power >= raw);
    };
    c.textAlign = "right";
    const dy = nice(peak, 4);
    for (let f = 0; f <= peak; f += dy) {
      c.beginPath();
      c.moveTo(left, py(f));
      c.lineTo(width - right, py(f));
      c.stroke();
      c.fillText(+f.toPrecision(4), left - 5, py(f) + 4);
    }
    c.textAlign = "center";
    const dx = nice(end, narrow ? 4 : 9);
    for (let at = 0; at <= end * 1.0001; at += dx) {
      const text = String(+at.toPrecision(4));  // the last one stays within the canvas
      c.fillText(text, Math.min(px(at), width - c.measureText(text).width / 2 - 1), height - 16);
    }
    c.fillText(films[0].axis === "mm" ? "displacement of the " + films[0].tool + " [mm]" : "time [ms]", (left + width - right) / 2, height - 3);
    c.textAlign = "left";
    c.fillText("F [N]", 2, 11);
    films.forEach((film, which) => {
      c.strokeStyle = c.fillStyle = colour_of(inks[which]);
      c.globalAlpha = which === 1 ? 0.75 : 1;
      c.lineWidth = 1;
      c.beginPath();
      for (let k = 0; k < film.curve.count; ++k) {
        const at = px((k + 0.5) * film.curve.step);
        c.lineTo(at, py(film.low[k] * film.curve.unit));
        c.lineTo(at, py(film.high[k] * film.curve.unit));
      }
      c.stroke();
      c.globalAlpha = 1;
      c.strokeStyle = which === 0 ? "#d00000" : "#ff8a5c";
      for (const [at] of film.torn) {
        c.beginPath();
        c.moveTo(px(at), height - bottom);
        c.lineTo(px(at), height - bottom - 9);
        c.stroke();
      }
    });
    c.strokeStyle = c.fillStyle = colour_of("--accent");
    for (const at of stills) {
      c.beginPath();
      c.moveTo(px(at), top - 2);
      c.lineTo(px(at) - 4, top - 9);
      c.lineTo(px(at) + 4, top - 9);
      c.fill();
    }
    c.lineWidth = 2;
    c.beginPath();
    c.moveTo(px(mm), top);
    c.lineTo(px(mm), height - bottom);
    c.stroke();
    return (pixel) => Math.min(end, Math.max(0, ((pixel - left) / (width - left - right)) * end));
  };

  const words = (x, digits = 3) => String(+x.toPrecision(digits)).replace("-", "−");

  class Player {
    constructor(root) {
      this.root = root;
      this.choices = JSON.parse(root.dataset.films);
      this.films = [];
      this.mm = 0;
      this.speed = 1;
      this.options = { colour: "stress", chains: false };
    }
    async start() {
      this.first = await read_film(this.choices[0].id);
      this.films = [this.first];
      this.end = this.first.mm.at(-1);
      this.unit = this.first.axis;
      this.stills = this.first.stills;
      Object.assign(this.options, { view: this.first.box, tops: this.first.tops });
      this.build();
      this.mm = this.stills.length > 1 ? this.stills[1] : 0;
      this.draw();
      addEventListener("resize", () => this.draw());
      matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    }
    button(text, label, act) {
      const button = make("button", { type: "button", textContent: text, title: label });
      button.setAttribute("aria-label", label);
      button.addEventListener("click", act);
      return button;
    }
    select(label, entries, act) {
      const select = make("select", {}, ...entries.map(([value, text]) => make("option", { value, textContent: text })));
      select.addEventListener("change", () => act(select.value));
      return make("label", {}, label, select);
    }
    build() {
      this.play_button = this.button("▶ play", "Play or pause", () => this.toggle());
      this.play_button.className = "play";
      this.said = make("output");
      const has_discs = this.first.radius.length > 0;
      const controls = make("div", { className: "controls" }, this.play_button,
        this.button("◀", "One picture back", () => this.step(-1)), this.button("▶|", "One picture on", () => this.step(1)),
        this.select("speed", [["0.25", "¼"], ["0.5", "½"], ["1", "1"], ["2", "2"], ["4", "4"], ["8", "8"]], (v) => (this.speed = +v)));
      controls.querySelector("select").value = "1";
      if (has_discs) {
        controls.append(this.select("colour", [["stress", "stress"], ["speed", "speed"], ["overlap", "overlap"]], (v) => this.set({ colour: v })));
        const chains = make("input", { type: "checkbox" });
        chains.addEventListener("change", () => this.set({ chains: chains.checked }));
        controls.append(make("label", { title: "Lines between discs that touch, as thick as the elastic part of the Hertz force" }, chains, "force chains"));
      }
      if (this.choices.length > 1) {
        controls.append(this.select("beside it", [["", "nothing"], ...this.choices.slice(1).map((c) => [c.id, c.label])], (id) => this.beside(id)));
      }
      this.legend = make("span", { className: "legend" });
      this.stage = make("div", { className: "stage" });
      this.curve = make("canvas", { className: "curve", tabIndex: 0 });
      this.curve.setAttribute("role", "slider");
      this.curve.setAttribute("aria-label", "Force on the " + this.first.tool + " against the displacement: choose a moment");
      this.curve.setAttribute("aria-valuemin", "0");
      this.curve.setAttribute("aria-valuemax", words(this.end, 4));
      this.marks = make("div", { className: "controls" }, "pictures at ");
      for (const at of this.stills) this.marks.append(this.button(words(at) + " " + this.unit, "Go to " + words(at) + " " + this.unit, () => this.go(at)));
      this.root.replaceChildren(controls, this.stage, this.curve, this.marks, make("div", { className: "controls" }, this.said, this.legend));
      this.stages();
      const to = (event) => this.go(this.to_mm(event.clientX - this.curve.getBoundingClientRect().left));
      this.curve.addEventListener("pointerdown", (event) => {
        this.curve.setPointerCapture(event.pointerId);
        to(event);
      });
      this.curve.addEventListener("pointermove", (event) => event.buttons & 1 && to(event));
      this.curve.addEventListener("keydown", (event) => this.key(event));
      this.show_legend();
    }
    stages() {
      this.canvases = this.films.map((film, k) => {
        const canvas = make("canvas", { className: "scene" });
        canvas.setAttribute("role", "img");
        const choice = k === 0 ? this.choices[0] : this.choices.find((c) => c.id === this.second);
        canvas.setAttribute("aria-label", "The scene at the chosen moment: " + choice.label);
        const line = make("figcaption", {}, make("b", { textContent: choice.label }));
        if (this.films.length > 1) line.firstChild.style.color = "var(" + inks[k] + ")";
        return [canvas, make("figure", {}, line, canvas)];
      });
      this.stage.replaceChildren(...this.canvases.map(([, figure]) => figure));
      this.canvases = this.canvases.map(([canvas]) => canvas);
    }
    key(event) {
      const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageUp: 10, PageDown: -10 };
      if (event.key in steps) this.step(steps[event.key]);
      else if (event.key === "Home") this.go(0);
      else if (event.key === "End") this.go(this.end);
      else if (event.key === " ") this.toggle();
      else return;
      event.preventDefault();
    }
    set(options) {
      Object.assign(this.options, options);
      this.show_legend();
      this.draw();
    }
    show_legend() {
      const f = this.first, what = this.options.colour;
      if (!f.radius.length) return this.legend.replaceChildren("links: blue pressed, orange drawn, up to " + words(f.tops.link) + " N");
      const [top, unit, name] = { stress: [f.tops.stress / 1e3, "kPa", "von Mises stress"], speed: [f.tops.speed, "m/s", "speed"], overlap: [f.tops.overlap, "of the radius", "overlap"] }[what];
      if (this.options.chains) return this.legend.replaceChildren("lines: elastic part of the contact forces");
      const bar = make("span", { className: "bar" });
      bar.style.background = "linear-gradient(to right," + sequential.join(",") + ")";
      this.legend.replaceChildren(name + " 0", bar, words(top) + " " + unit + " and more");
    }
    async beside(id) {
      this.second = id;
      this.films = id ? [this.first, await read_film(id)] : [this.first];
      this.stages();
      this.draw();
    }
    go(mm) {
      this.mm = Math.min(this.end, Math.max(0, mm));
      this.draw();
    }
    step(by) {
      this.pause();
      const mm = this.first.mm;
      let k = 0;
      while (k + 1 < mm.length && mm[k + 1] <= this.mm + 1e-9) ++k;
      if (by < 0 && this.mm > mm[k] + 1e-9) ++k;
      this.go(mm[Math.min(mm.length - 1, Math.max(0, k + by))]);
    }
    toggle() {
      this.playing ? this.pause() : this.play();
    }
    pause() {
      this.playing = false;
      this.play_button.textContent = "▶ play";
    }
    play() {
      if (this.mm >= this.end) this.mm = 0;
      this.playing = true;
      this.play_button.textContent = "❚❚ pause";
      const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
      let last = performance.now(), waited = 0;
      const rate = this.end / 15; // the whole way in 15 s
      const tick = (now) => {
        if (!this.playing) return;
        waited += (now - last) / 1e3;
        last = now;
        if (!still || waited > 1) { // who asked for little motion gets a picture a second
          this.mm = Math.min(this.end, this.mm + rate * this.speed * waited);
          waited = 0;
          this.draw();
        }
        this.mm < this.end ? requestAnimationFrame(tick) : this.pause();
      };
      requestAnimationFrame(tick);
    }
    draw() {
      this.films.forEach((film, k) => draw_scene(film, this.canvases[k], this.mm, this.options));
      this.to_mm = draw_curves(this.films, this.curve, this.mm, this.end, this.stills);
      const forces = this.films.map((f) => force_at(f, this.mm)).filter(Number.isFinite);
      const torn = this.first.torn.filter(([at]) => at <= this.mm).length;
      const text = words(this.mm, 4) + " " + this.unit + (forces.length ? ": " + forces.map((f) => words(f) + " N").join(" and ") : "") + (this.first.links.length ? ", " + torn + " links torn" : "");
      this.said.textContent = text;
      this.curve.setAttribute("aria-valuenow", words(this.mm, 4));
      this.curve.setAttribute("aria-valuetext", text);
    }
  }

  // A film is unpacked when its player comes near.
  const near = new IntersectionObserver((entries) => {
    for (const { isIntersecting, target } of entries) {
      if (!isIntersecting) continue;
      near.unobserve(target);
      const player = new Player(target);
      target.player = player;
      player.start().catch((error) => (target.textContent = "The film cannot be shown: " + error.message));
    }
  }, { rootMargin: "600px" });
  for (const root of document.querySelectorAll(".player")) near.observe(root);
})();
