// Values under the cursor, and switches for curves. The plots themselves are in the page, as study/report/log_plot.cpp drew them.
"use strict";
{
  /// On the screen: equal distances there are what the axis takes for equal.
  const distance = (mark, x) => {
    const { left, width } = mark.getBoundingClientRect();
    return Math.abs(left + width / 2 - x);
  };
  const nearest = (marks, x) => marks.reduce((best, mark) => (distance(mark, x) < distance(best, x) ? mark : best));

  /// A curve's row of the table, and `show(x)`, which fills it with the values next to a place of the window, or the last.
  const makeRow = (series, spread) => {
    const marks = [...series.querySelectorAll("[data-point]")];
    const cells = [0, 1, 2].map(() => ajar.element("td", { class: "number" }));
    const show = (x) => {
      const mark = marks.length === 0 || series.classList.contains("off") ? undefined : x === undefined ? marks.at(-1) : nearest(marks, x);
      for (const one of marks) one.classList.toggle("at", x !== undefined && one === mark);
      const [at, mean, low, high] = mark?.dataset.point.split(" ").map(Number) ?? [];
      const texts = mark ? [ajar.format(at, 3), ajar.format(mean), `${ajar.format(low, 3)} … ${ajar.format(high, 3)}`] : ["–", "–", "–"];
      cells.forEach((cell, i) => (cell.textContent = texts[i]));
    };
    const toggle = (event) => {
      for (const part of [series, spread]) part.classList.toggle("off", !event.target.checked);
      show();
    };
    const key = ajar.element("svg", { class: `key ${series.getAttribute("class")}`, viewBox: "0 -5 28 10", "aria-hidden": "true" },
      series.querySelector(".key").cloneNode(true));
    const name = ajar.element("label", {},
      ajar.element("input", { type: "checkbox", checked: true, onchange: toggle }), key, series.querySelector(".name").textContent);
    return { row: ajar.element("tr", {}, ajar.element("th", { scope: "row" }, name), ...cells), show, last: marks.at(-1) };
  };

  /// The lowest at its end comes first.
  const height = ({ last }) => (last ? Number(last.dataset.point.split(" ")[1]) : Infinity);

  ajar.startPlots = () => {
    for (const figure of document.querySelectorAll(".chart")) {
      const svg = figure.querySelector("svg");
      const spreads = svg.querySelectorAll(".spread");
      const rows = [...svg.querySelectorAll(".series")].map((series, i) => makeRow(series, spreads[i])).sort((a, b) => height(a) - height(b));
      const show = (x) => rows.forEach((row) => row.show(x));
      svg.addEventListener("pointermove", (event) => show(event.clientX));
      svg.addEventListener("pointerleave", () => show());
      const header = ["Method", ...[...svg.querySelectorAll(".axis-title")].map((title) => title.textContent), "Band"];
      figure.append(ajar.element("div", { class: "scroll" }, ajar.element("table", { class: "data readout" },
        ajar.element("thead", {}, ajar.element("tr", {}, ...header.map((text, i) => ajar.element("th", { scope: "col", class: i > 0 ? "number" : undefined }, text)))),
        ajar.element("tbody", {}, ...rows.map(({ row }) => row)))));
      show();
    }
  };
}
