"use strict";
// The curve of a chart that is under the pointer stands out and says its name.
(() => {
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];
  const label = Object.assign(document.createElement("div"), { className: "curve_name", hidden: true });
  document.body.append(label);
  // The browser's own title comes late, and only where a thin line is met exactly.
  addEventListener("load", () => {
    for (const title of all(".plot g > title")) {
      title.parentElement.dataset.name = title.textContent;
      title.remove();
    }
  });
  const near = [[0, 0]];
  for (const away of [3, 6]) {
    for (let k = 0; k < 8; ++k) near.push([away * Math.cos(k * Math.PI / 4), away * Math.sin(k * Math.PI / 4)]);
  }
  const curve_at = (x, y) => {
    for (const [dx, dy] of near) {
      const curve = document.elementFromPoint(x + dx, y + dy)?.closest(".plot g[data-name]");
      if (curve) return curve;
    }
    return null;
  };
  const light = (curve) => {
    const drawing = curve?.closest("svg"), name = curve?.dataset.name;
    for (const lit of all("g.lit")) if (lit.dataset.name !== name || lit.closest("svg") !== drawing) lit.classList.remove("lit");
    label.hidden = !curve;
    if (!curve) return;
    for (const same of all("g[data-name]", drawing)) if (same.dataset.name === name) same.classList.add("lit");
    label.textContent = name;
  };
  const point = (e) => {
    light(curve_at(e.clientX, e.clientY));
    label.style.left = Math.max(0, Math.min(e.clientX + 14, innerWidth - label.offsetWidth - 8)) + "px";
    label.style.top = e.clientY + 14 + "px";
  };
  for (const plot of all(".plot")) {
    plot.addEventListener("pointermove", point);
    plot.addEventListener("pointerdown", point);
    plot.addEventListener("pointerleave", () => light(null));
  }
})();
